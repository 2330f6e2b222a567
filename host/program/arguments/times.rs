//! Times at which a motion is computed: times or ticks on the command line, or a file of times.

use crate::arguments::values::{FINITE, Values, counted_values, number};
use clap::{ArgGroup, Args};
use std::path::{Path, PathBuf};
use toytop_host::input::text_file;
use toytop_host::motion::times::require_within;
use toytop_host::{Failure, excerpt};

/// Times of `toytop state`: exactly one of --times, --times-file, --ticks and --from.
#[derive(Args)]
#[group(skip)]
#[command(group = ArgGroup::new("instants").required(true).args(["times", "times_file", "ticks", "from"]))]
pub struct TimesArgs {
    /// Times, s, in any order: T1,T2,... or LOW..HIGH/COUNT, both ends included; log:LOW..HIGH/COUNT is even in the logarithm
    #[arg(long, value_name = "T1,T2,...", value_parser = counted_values, allow_hyphen_values = true)]
    pub times: Option<Values>,
    /// File with one time, s, in each line; # starts a comment
    #[arg(long, value_name = "FILE")]
    pub times_file: Option<PathBuf>,
    /// Ticks of an interrupt in place of times: N1,N2,... or FIRST..LAST
    #[arg(long, value_name = "N1,N2,...", allow_hyphen_values = true)]
    pub ticks: Option<String>,
    /// First of --count evenly spaced times, s
    #[arg(long, value_name = "T", value_parser = number(FINITE), allow_hyphen_values = true, requires_all = ["to", "count"])]
    pub from: Option<f64>,
    /// Last of these times, s
    #[arg(long, value_name = "T", value_parser = number(FINITE), allow_hyphen_values = true, requires = "from")]
    pub to: Option<f64>,
    /// Number of these times
    #[arg(long, value_name = "N", requires = "from")]
    pub count: Option<u32>,
}

/// Times in the order of the request, at least one.
pub struct Times {
    /// Option that states them, in messages.
    pub stated_by: String,
    /// Times, s.
    pub seconds: Vec<f64>,
    /// Ticks of these times, with --ticks only.
    pub ticks: Vec<i64>,
}

/// Greatest number of times.
const MAX_TIMES: u64 = 10_000_000;

impl Times {
    /// Times of the command line.
    ///
    /// * `hertz`: tick rate `[A, B]`, A ticks in B seconds
    ///
    /// # Errors
    /// [`Failure::input`]: an unreadable file, an entry that is no finite number, or no tick.
    pub fn read(arguments: &TimesArgs, hertz: [u32; 2]) -> Result<Self, Failure> {
        match arguments {
            TimesArgs { times: Some(values), .. } => Self::new("--times".to_owned(), values),
            TimesArgs { times_file: Some(path), .. } => Self::read_file(path),
            TimesArgs { ticks: Some(text), .. } => Self::parse_ticks(text, hertz),
            TimesArgs { from: Some(from), to: Some(to), count, .. } => {
                let values = Values::range([*from, *to], false, *count, ["--from", "--to", "--count"]);
                let values = values.map_err(Failure::input)?;
                Self::new("--from, --to, --count".to_owned(), &values)
            }
            _ => Err(Failure::input("must have --times, --times-file, --ticks or --from")),
        }
    }

    /// Ticks of a text `N1,N2,...` or `FIRST..LAST`, as an interrupt counts them.
    fn parse_ticks(text: &str, hertz: [u32; 2]) -> Result<Self, Failure> {
        let refused = |reason| Failure::input(reason).at(excerpt(text)).at("--ticks");
        let allowed = "must be N1,N2,... or FIRST..LAST, whole numbers of 64 bits";
        let numbers =
            |separator| text.split(separator).map(|number: &str| number.trim().parse().ok()).collect();
        let range = text.contains("..");
        let listed: Option<Vec<i64>> = numbers(if range { ".." } else { "," });
        let ticks = match listed.as_deref() {
            Some([first, last]) if range && first <= last => {
                require_count(last.abs_diff(*first).saturating_add(1)).map_err(refused)?;
                (*first..=*last).collect()
            }
            Some(ticks) if !range => ticks.to_vec(),
            _ => return Err(refused(allowed.to_owned())),
        };
        let [ticks_per, duration] = hertz.map(f64::from);
        let seconds = ticks.iter().map(|tick| *tick as f64 * duration / ticks_per).collect();
        Ok(Self { stated_by: "--ticks".to_owned(), seconds, ticks })
    }

    fn read_file(path: &Path) -> Result<Self, Failure> {
        /// Size of the largest file, MiB: [`MAX_TIMES`] lines of 25 bytes.
        const MAX_FILE_MIB: u64 = 256;
        let name = path.display().to_string();
        let text = text_file::read(&name, path, MAX_FILE_MIB)?;
        let mut times = Vec::new();
        for (index, line) in text.lines().enumerate() {
            let entry = line.split('#').next().unwrap_or_default().trim();
            if !entry.is_empty() {
                let refused = |reason: String| {
                    let line = format!("line {}: {:?}", index + 1, excerpt(entry));
                    Failure::input(reason).at(line).at(&name)
                };
                times.push(number(FINITE)(entry).map_err(refused)?);
            }
        }
        if times.is_empty() {
            return Err(Failure::input("must hold at least one time, one finite number a line").at(name));
        }
        Self::new(format!("--times-file: {name}"), &Values::List(times))
    }

    /// Times of values with a number; `stated_by` is the option, in messages.
    ///
    /// # Errors
    /// [`Failure::input`]: too many times.
    pub fn new(stated_by: String, values: &Values) -> Result<Self, Failure> {
        require_count(values.count()).map_err(|reason| Failure::input(reason).at(&stated_by))?;
        let seconds = (0..values.count()).map(|index| values.at(index)).collect();
        Ok(Self { stated_by, seconds, ticks: Vec::new() })
    }

    /// Refuses times further from t = 0 than `most`, s; `method` ends the message.
    ///
    /// # Errors
    /// [`Failure::input`].
    pub fn require_within(&self, most: f64, method: &str) -> Result<(), Failure> {
        require_within(self.seconds.iter().copied(), most, &format!(" s{method}"))
            .map_err(|failure| failure.at(&self.stated_by))
    }
}

fn require_count(count: u64) -> Result<(), String> {
    if count > MAX_TIMES { Err(format!("{count} times: must be at most {MAX_TIMES}")) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_exact_fractions_of_a_second() {
        let ticks = |text: &str| Times::parse_ticks(text, [44100, 2]);
        let run = ticks("-2..2").unwrap();
        assert_eq!(run.ticks, [-2, -1, 0, 1, 2]);
        assert_eq!((run.seconds[0], run.seconds[4]), (-4.0 / 44100.0, 4.0 / 44100.0));
        let list = ticks("7,-99, 3").unwrap();
        assert_eq!((list.ticks[1], list.seconds[1], list.seconds.len()), (-99, -198.0 / 44100.0, 3));
    }
}
