//! Failures of a command, with their exit codes.

use std::fmt;
use std::io;

/// Reason why a command has no result, which is displayed as one line.
#[derive(Clone, Debug)]
pub struct Failure {
    exit_code: u8,
    /// Names of what the reason is about, from the outside in: an option or a file, a line or a key.
    pub path: Vec<String>,
    /// Reason, with the allowed values.
    pub reason: String,
}

impl Failure {
    fn new(exit_code: u8, reason: impl Into<String>) -> Self {
        Self { exit_code, path: Vec::new(), reason: reason.into() }
    }

    /// Bad input; the reason states the allowed values. Exit code 2.
    pub fn input(reason: impl Into<String>) -> Self {
        Self::new(2, reason)
    }

    /// Method that does not apply to this motion, with the reason. Exit code 3.
    pub fn method(reason: impl Into<String>) -> Self {
        Self::new(3, reason)
    }

    /// Result that cannot be written. Exit code 1.
    pub fn output(error: io::Error) -> Self {
        Self::new(1, format!("cannot write the output: {error}"))
    }

    /// Other program, such as cargo or QEMU, that is missing or failed. Exit code 1.
    pub fn tool(reason: impl Into<String>) -> Self {
        Self::new(1, reason)
    }

    /// Failure whose message begins with the name of an option, a file, a motion or a key.
    pub fn at(mut self, name: impl Into<String>) -> Self {
        self.path.insert(0, name.into());
        self
    }

    /// Exit code of the process.
    pub fn exit_code(&self) -> u8 {
        self.exit_code
    }
}

/// Bad input for this reason.
impl From<String> for Failure {
    fn from(reason: String) -> Self {
        Self::input(reason)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: String = self.path.iter().map(|name| format!("{name}: ")).collect();
        f.write_str(&one_line(&(names + &self.reason)))
    }
}

impl std::error::Error for Failure {}

/// Message in one line of limited length, because file names and TOML keys may contain line breaks and be very long.
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

/// Beginning of a text of the input, short enough for a message.
pub fn excerpt(text: &str) -> String {
    const MAX_LENGTH: usize = 60;
    let beginning: String = text.chars().take(MAX_LENGTH).collect();
    if beginning.len() < text.len() { format!("{beginning}...") } else { beginning }
}
