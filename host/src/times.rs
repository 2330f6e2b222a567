//! The times asked for: a list on the command line, or a file of numbers.

use crate::Failure;
use crate::cli::TimesArgs;
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

fn from_file(path: &Path) -> Result<Vec<f64>, Failure> {
    let name = path.display();
    let text = std::fs::read_to_string(path).map_err(|error| Failure::Input(format!("{name}: {error}")))?;
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
