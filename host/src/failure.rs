//! Failures of a command, with their exit codes.

use std::fmt;
use std::io;

/// Reason why a command has no result, which is displayed as one line.
#[derive(Debug)]
pub enum Failure {
    /// Bad input: the line names the file or the option, and the allowed values. Exit code 2.
    Input(String),
    /// Bad value of a key in a file, or a key that is unknown or missing. Exit code 2.
    Key {
        /// Name of the file.
        file: String,
        /// Table that the key belongs to.
        table: String,
        /// Key.
        key: String,
        /// Reason, with the allowed values.
        reason: String,
    },
    /// Method that does not apply to this motion, with the reason. Exit code 3.
    Method(String),
    /// Result that cannot be written. Exit code 1.
    Output(io::Error),
    /// Other program, such as cargo or QEMU, that is missing or failed. Exit code 1.
    Tool(String),
}

/// Refusal of the value of a parameter or key.
pub struct Refusal {
    /// Name of the parameter or key.
    pub name: &'static str,
    /// Reason, with the allowed values.
    pub reason: String,
}

impl Refusal {
    /// Refusal of a parameter or key for this reason.
    pub fn new(name: &'static str, reason: impl Into<String>) -> Self {
        Self { name, reason: reason.into() }
    }
}

impl Failure {
    /// Exit code of the process.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Output(_) | Self::Tool(_) => 1,
            Self::Input(_) | Self::Key { .. } => 2,
            Self::Method(_) => 3,
        }
    }

    /// Failure whose message begins with a name. A failure of the output has no message to change.
    pub fn with_context(self, name: &str) -> Self {
        let named = |message: String| format!("{name}: {message}");
        match self {
            Self::Input(message) => Self::Input(named(message)),
            Self::Method(message) => Self::Method(named(message)),
            Self::Tool(message) => Self::Tool(named(message)),
            Self::Key { file, table, key, reason } => Self::Key { file: named(file), table, key, reason },
            output @ Self::Output(_) => output,
        }
    }

    /// Failure whose message begins with the motion's name, if a method does not apply to the motion, or otherwise with the option.
    pub fn with_option_or_motion(self, option: &str, motion: &str) -> Self {
        let name = if matches!(self, Self::Method(_)) { motion } else { option };
        self.with_context(name)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let message = match self {
            Self::Input(message) | Self::Method(message) | Self::Tool(message) => message.clone(),
            Self::Output(error) => format!("cannot write the output: {error}"),
            Self::Key { file, table, key, reason } => {
                format!("{file}: {}.{}: {reason}", excerpt(table), excerpt(key))
            }
        };
        f.write_str(&one_line(&message))
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
