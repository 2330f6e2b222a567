//! Why a command gives no result, and the exit code that says so.

use std::fmt;
use std::io;

/// No result. Displayed as one line.
#[derive(Debug)]
pub enum Failure {
    /// Bad input: the line names file, key and what is allowed. Exit code 2.
    Input(String),
    /// The method does not apply to this motion: the line says why. Exit code 3.
    Method(String),
    /// The result cannot be written. Exit code 1.
    Output(io::Error),
    /// Another program that this one needs (cargo, QEMU) is missing, or failed. Exit code 1.
    Tool(String),
}

impl Failure {
    /// The process's exit code.
    #[must_use]
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Output(_) | Self::Tool(_) => 1,
            Self::Input(_) => 2,
            Self::Method(_) => 3,
        }
    }

    /// Failure with the name of its object in front.
    #[must_use]
    pub fn of(self, name: &str) -> Self {
        match self {
            Self::Input(message) => Self::Input(format!("{name}: {message}")),
            Self::Method(message) => Self::Method(format!("{name}: {message}")),
            Self::Tool(message) => Self::Tool(format!("{name}: {message}")),
            output @ Self::Output(_) => output,
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let message = match self {
            Self::Input(message) | Self::Method(message) | Self::Tool(message) => message.clone(),
            Self::Output(error) => format!("cannot write the output: {error}"),
        };
        f.write_str(&one_line(&message))
    }
}

impl std::error::Error for Failure {}

/// File names and TOML keys may hold line breaks, and 100 KB; a message may not.
fn one_line(message: &str) -> String {
    const ENDS: usize = 500;
    let escape = |c: char| if c.is_control() { c.escape_default().to_string() } else { c.into() };
    let characters: Vec<char> = message.chars().collect();
    let text = |part: &[char]| part.iter().copied().map(escape).collect::<String>();
    match characters.len() {
        len if len > 3 * ENDS => text(&characters[..ENDS]) + " ... " + &text(&characters[len - ENDS..]),
        _ => text(&characters),
    }
}
