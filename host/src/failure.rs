//! Failures of a command, with their exit codes.

use std::fmt;
use std::io;
use toytop::ParameterError;

/// Reason why a command has no result, which is displayed as one line.
#[derive(Clone, Debug)]
pub struct Failure {
    /// Kind, which determines the exit code.
    pub kind: FailureKind,
    /// Names of what the reason is about, from the outside in: an option or a file, a line or a key.
    path: Vec<String>,
    /// Reason, with the allowed values.
    pub reason: String,
}

/// Kind of a failure. Its number is the exit code of the process.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FailureKind {
    /// A result cannot be written, or another program is missing or failed.
    System = 1,
    /// The input is not allowed.
    Input = 2,
    /// The method does not apply to this motion.
    Method = 3,
}

impl Failure {
    fn new(kind: FailureKind, reason: impl Into<String>) -> Self {
        Self { kind, path: Vec::new(), reason: reason.into() }
    }

    /// Bad input; the reason states the allowed values. Exit code 2.
    pub fn input(reason: impl Into<String>) -> Self {
        Self::new(FailureKind::Input, reason)
    }

    /// Method that does not apply to this motion, with the reason. Exit code 3.
    pub fn method(reason: impl Into<String>) -> Self {
        Self::new(FailureKind::Method, reason)
    }

    /// Result that cannot be written. Exit code 1.
    pub fn output(error: io::Error) -> Self {
        Self::new(FailureKind::System, format!("cannot write the output: {error}"))
    }

    /// Other program, file of the program or thread that is missing or failed. Exit code 1.
    pub fn tool(reason: impl Into<String>) -> Self {
        Self::new(FailureKind::System, reason)
    }

    /// Failure whose message begins with the name of an option, a file, a motion or a key.
    pub fn at(mut self, name: impl Into<String>) -> Self {
        self.path.insert(0, name.into());
        self
    }

    /// First name of the message; empty where it has none.
    pub fn name(&self) -> &str {
        self.path.first().map_or("", |name| name)
    }

    /// Failure whose first name is replaced where it is one of these: (old name, new name).
    pub fn renamed<O: AsRef<str>, N: Into<String>>(
        mut self,
        names: impl IntoIterator<Item = (O, N)>,
    ) -> Self {
        if let Some(name) = self.path.first_mut()
            && let Some((_, new)) = names.into_iter().find(|(old, _)| old.as_ref() == name)
        {
            *name = new.into();
        }
        self
    }
}

/// Bad input: a parameter that core refuses.
impl From<ParameterError> for Failure {
    fn from(error: ParameterError) -> Self {
        Self::input(format!("must be {}", error.allowed())).at(error.parameter())
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
