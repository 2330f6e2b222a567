//! The times asked for: a list on the command line, or a file of numbers.

use crate::cli::TimesArgs;
use crate::{Failure, whole_file};
use std::path::Path;

/// The times in the order asked, at least one, all finite.
///
/// # Errors
/// [`Failure::Input`]: an unreadable file, or an entry that is no finite number.
pub fn read(arguments: &TimesArgs) -> Result<Vec<f64>, Failure> {
    match (&arguments.times, &arguments.times_file) {
        (Some(list), _) => list.split(',').map(|entry| time(entry, "--times")).collect(),
        (None, Some(path)) => from_file(path),
        (None, None) => Err(Failure::Input("--times or --times-file is required".into())),
    }
}

/// Some five million times, MiB.
const LARGEST_FILE: u64 = 64;

fn from_file(path: &Path) -> Result<Vec<f64>, Failure> {
    let name = path.display();
    let text = whole_file::read(&name.to_string(), path, LARGEST_FILE)?;
    let mut times = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let entry = line.split('#').next().unwrap_or_default().trim();
        if !entry.is_empty() {
            times.push(time(entry, &format!("{name}: line {}", index + 1))?);
        }
    }
    if times.is_empty() {
        return Err(Failure::Input(format!("{name}: must hold at least one time, one finite number a line")));
    }
    Ok(times)
}

fn time(entry: &str, place: &str) -> Result<f64, Failure> {
    match entry.trim().parse::<f64>() {
        Ok(time) if time.is_finite() => Ok(time),
        _ => Err(Failure::Input(format!("{place}: {:?} must be a finite number", entry.trim()))),
    }
}
