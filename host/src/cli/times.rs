//! Times at which a motion is computed: times or ticks on the command line, or a file of times.

use super::TimesArgs;
use crate::Failure;
use crate::output::{shown, whole_file};
use crate::sweep::axis::Axis;
use std::path::Path;

/// Times in the order of the request, at least one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Instants {
    /// List of times, s.
    Times(Vec<f64>),
    /// Range over which times are spread, s, and their number.
    Spread(Axis, u64),
    /// Ticks of a clock.
    Ticks(Ticks),
}

/// Ticks of a clock, as an interrupt counts them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ticks {
    numbers: Numbers,
    /// Tick rate of A ticks in B seconds.
    pub(crate) rate: [u32; 2],
}

#[derive(Clone, Debug, PartialEq)]
enum Numbers {
    List(Vec<i64>),
    /// All ticks from the first to the last.
    Run(i64, i64),
}

impl Instants {
    /// Number of times.
    #[must_use]
    pub(crate) fn count(&self) -> u64 {
        match self {
            Self::Times(times) => times.len() as u64,
            Self::Spread(_, places) => *places,
            Self::Ticks(ticks) => match &ticks.numbers {
                Numbers::List(numbers) => numbers.len() as u64,
                Numbers::Run(first, last) => last.abs_diff(*first) + 1,
            },
        }
    }

    /// Time of this index, s.
    #[must_use]
    pub(crate) fn time(&self, index: u64) -> f64 {
        match self {
            Self::Times(times) => times.get(index as usize).copied().unwrap_or(f64::NAN),
            Self::Spread(axis, _) => axis.at(index),
            Self::Ticks(ticks) => {
                let [ticks_there, seconds] = ticks.rate.map(f64::from);
                ticks.number(index) as f64 * seconds / ticks_there
            }
        }
    }

    /// List of all times, s.
    ///
    /// # Errors
    /// [`Failure::Input`]: too many to be held at once; the message does not name the option.
    pub(crate) fn times(&self) -> Result<Vec<f64>, Failure> {
        const MOST: u64 = 5_000_000;
        match self.count() {
            count if count <= MOST => Ok((0..count).map(|index| self.time(index)).collect()),
            count => Err(Failure::Input(format!("{count} times: must be at most {MOST} with this --method"))),
        }
    }

    /// Greatest distance from t = 0, s.
    #[must_use]
    pub(crate) fn furthest(&self) -> f64 {
        let ends = match self {
            Self::Times(times) => {
                return times.iter().fold(0.0, |most, t| if t.abs() > f64::abs(most) { *t } else { most });
            }
            _ => [self.time(0), self.time(self.count() - 1)],
        };
        match self {
            Self::Ticks(Ticks { numbers: Numbers::List(numbers), .. }) => (0..numbers.len() as u64)
                .map(|i| self.time(i))
                .fold(0.0, |most, t| if t.abs() > f64::abs(most) { t } else { most }),
            _ if ends[0].abs() > ends[1].abs() => ends[0],
            _ => ends[1],
        }
    }
}

impl Ticks {
    /// Number of the tick of this index.
    #[must_use]
    pub(crate) fn number(&self, index: u64) -> i64 {
        match &self.numbers {
            Numbers::List(numbers) => numbers.get(index as usize).copied().unwrap_or_default(),
            Numbers::Run(first, _) => first.wrapping_add_unsigned(index),
        }
    }
}

/// Option that states the times, with its file if it has one.
#[must_use]
pub(crate) fn option(arguments: &TimesArgs) -> String {
    match (&arguments.times_file, &arguments.ticks) {
        (Some(path), _) => format!("--times-file: {}", path.display()),
        (None, Some(_)) => "--ticks".to_owned(),
        (None, None) => "--times".to_owned(),
    }
}

/// Times of the command line.
///
/// # Errors
/// [`Failure::Input`]: an unreadable file, an entry that is no finite number, or no tick.
pub(crate) fn read(arguments: &TimesArgs, rate: [u32; 2]) -> Result<Instants, Failure> {
    match (&arguments.times, &arguments.times_file, &arguments.ticks) {
        (Some(spread), ..) if spread.contains("..") => evenly(spread),
        (Some(list), ..) => {
            list.split(',').map(|entry| time(entry, "--times")).collect::<Result<_, _>>().map(Instants::Times)
        }
        (None, Some(path), _) => from_file(path).map(Instants::Times),
        (None, None, Some(text)) => Ok(Instants::Ticks(Ticks { numbers: numbers(text)?, rate })),
        (None, None, None) => Err(Failure::Input("--times, --times-file or --ticks is required".into())),
    }
}

/// Times of a text `LOW..HIGH/PLACES`.
fn evenly(spread: &str) -> Result<Instants, Failure> {
    const MOST: u32 = 1_000_000_000;
    let refused = |reason: &str| Failure::Input(format!("--times: {}: {reason}", shown(spread)));
    match spread.parse().map_err(|reason: String| refused(&reason))? {
        axis @ Axis::Grid(_, places) if places <= MOST => Ok(Instants::Spread(axis, places.into())),
        Axis::Grid(..) => Err(refused(&format!("PLACES must be at most {MOST}"))),
        _ => Err(refused("must be T1,T2,... or LOW..HIGH/PLACES or log:LOW..HIGH/PLACES")),
    }
}

/// Tick numbers of a text `N1,N2,...` or `FIRST..LAST`.
fn numbers(text: &str) -> Result<Numbers, Failure> {
    let refused = || {
        let allowed = "must be N1,N2,... or FIRST..LAST, whole numbers of 64 bits";
        Failure::Input(format!("--ticks: {}: {allowed}", shown(text)))
    };
    let number = |text: &str| text.trim().parse::<i64>().map_err(|_| refused());
    match text.split_once("..") {
        None => text.split(',').map(number).collect::<Result<_, _>>().map(Numbers::List),
        Some((first, last)) => {
            let (first, last) = (number(first)?, number(last)?);
            let some = first <= last && last.abs_diff(first) < u64::MAX;
            if some { Ok(Numbers::Run(first, last)) } else { Err(refused()) }
        }
    }
}

/// Size of the largest file of times, MiB: some five million times.
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
        _ => Err(Failure::Input(format!("{place}: {:?} must be a finite number", shown(entry.trim())))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spread_evenly_with_both_ends() {
        assert_eq!(evenly("-1..1/5").unwrap().times().unwrap(), [-1.0, -0.5, 0.0, 0.5, 1.0]);
        let third = evenly("0..0.3/4").unwrap().times().unwrap();
        assert_eq!((third.len(), third[0], third[3]), (4, 0.0, 0.3));
        let log = evenly("log:0.01..100/3").unwrap().times().unwrap();
        assert!(log[0] == 0.01 && (log[1] - 1.0).abs() < 1e-14 && log[2] == 100.0, "{log:?}");
        assert_eq!(evenly("-3..1/5").unwrap().furthest(), -3.0);
        for refused in ["0..1", "1..0/3", "0..1/1", "0..1/1000000001", "0..x/3"] {
            let message = evenly(refused).unwrap_err().to_string();
            assert!(message.starts_with(&format!("--times: {refused}: ")), "{message}");
        }
    }

    #[test]
    fn ticks_are_exact_fractions_of_a_second() {
        let ticks =
            |text: &str| numbers(text).map(|numbers| Instants::Ticks(Ticks { numbers, rate: [44100, 2] }));
        let run = ticks("-2..2").unwrap();
        assert_eq!((run.count(), run.time(0), run.time(4)), (5, -4.0 / 44100.0, 4.0 / 44100.0));
        let list = ticks("7,-99, 3").unwrap();
        assert_eq!((list.count(), list.time(1), list.furthest()), (3, -198.0 / 44100.0, -198.0 / 44100.0));
        for refused in ["", "1.5", "2..1", "1,,2", "0..99999999999999999999"] {
            let message = ticks(refused).unwrap_err().to_string();
            assert!(message.starts_with(&format!("--ticks: {refused}: ")), "{message}");
        }
    }
}
