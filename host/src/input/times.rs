//! The times asked for: a list on the command line, or a file of numbers.

use crate::Failure;
use crate::cli::TimesArgs;
use crate::output::whole_file;
use crate::sweep::axis::Axis;
use std::path::Path;

/// The times in the order asked, at least one, all finite.
///
/// # Errors
/// [`Failure::Input`]: an unreadable file, or an entry that is no finite number.
pub fn read(arguments: &TimesArgs) -> Result<Vec<f64>, Failure> {
    match (&arguments.times, &arguments.times_file) {
        (Some(spread), _) if spread.contains("..") => evenly(spread),
        (Some(list), _) => list.split(',').map(|entry| time(entry, "--times")).collect(),
        (None, Some(path)) => from_file(path),
        (None, None) => Err(Failure::Input("--times or --times-file is required".into())),
    }
}

/// `LOW..HIGH/PLACES`.
fn evenly(spread: &str) -> Result<Vec<f64>, Failure> {
    const MOST: u32 = 5_000_000;
    let refused = |reason: &str| Failure::Input(format!("--times: {spread}: {reason}"));
    match spread.parse().map_err(|reason: String| refused(&reason))? {
        axis @ Axis::Grid(_, places) if places <= MOST => {
            Ok((0..places).map(|place| axis.at(place.into())).collect())
        }
        Axis::Grid(..) => Err(refused(&format!("PLACES must be at most {MOST}"))),
        _ => Err(refused("must be T1,T2,... or LOW..HIGH/PLACES")),
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spread_evenly_with_both_ends() {
        assert_eq!(evenly("-1..1/5").unwrap(), [-1.0, -0.5, 0.0, 0.5, 1.0]);
        let third = evenly("0..0.3/4").unwrap();
        assert_eq!((third.len(), third[0], third[3]), (4, 0.0, 0.3));
        for refused in ["0..1", "1..0/3", "0..1/1", "0..1/5000001", "0..x/3"] {
            let message = evenly(refused).unwrap_err().to_string();
            assert!(message.starts_with(&format!("--times: {refused}: ")), "{message}");
        }
    }
}
