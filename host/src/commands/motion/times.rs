//! Times at which a motion is computed: times or ticks on the command line, or a file of times.

use crate::Failure;
use crate::input::axis::{Axis, ends};
use crate::input::finite;
use crate::output::{shown, whole_file};
use clap::Args;
use std::path::{Path, PathBuf};

/// Times of `toytop state`: exactly one of the four ways.
#[derive(Args)]
#[group(skip)]
pub struct TimesArgs {
    /// Times, s, separated by commas, in any order; they may be negative. LOW..HIGH/PLACES spreads times evenly, both ends included,
    /// log:LOW..HIGH/PLACES evenly in the logarithm
    #[arg(long, value_name = "T1,T2,...", allow_hyphen_values = true)]
    pub times: Option<String>,
    /// File with one time, s, in each line; # starts a comment
    #[arg(long, value_name = "FILE")]
    pub times_file: Option<PathBuf>,
    /// Ticks of a clock, as an interrupt counts them, in place of times: N1,N2,... or FIRST..LAST
    #[arg(long, value_name = "N1,N2,...", allow_hyphen_values = true)]
    pub ticks: Option<String>,
    /// First of --count times that are spread evenly, s
    #[arg(long, value_name = "T", allow_hyphen_values = true, requires_all = ["to", "count"])]
    pub from: Option<f64>,
    /// Last of these times, s
    #[arg(long, value_name = "T", allow_hyphen_values = true, requires = "from")]
    pub to: Option<f64>,
    /// Number of these times
    #[arg(long, value_name = "N", requires = "from")]
    pub count: Option<u32>,
}

/// Times in the order of the request, at least one.
pub struct Instants {
    /// Option that states them, in messages.
    option: String,
    /// Number of times.
    pub count: u64,
    /// Least and greatest time, s.
    ends: [f64; 2],
    /// Number of ticks, and the seconds in which they are, where the times are those of ticks.
    pub rate: Option<[u32; 2]>,
    /// Time, s, and tick of an index; the tick is 0 where times are not counted in ticks.
    pub at: Box<dyn Fn(u64) -> (f64, i64) + Send + Sync>,
}

impl Instants {
    /// Times of the command line.
    ///
    /// # Errors
    /// [`Failure::Input`]: an unreadable file, an entry that is no finite number, or no tick.
    pub fn read(arguments: &TimesArgs, rate: [u32; 2]) -> Result<Self, Failure> {
        match arguments {
            TimesArgs { times: Some(text), .. } => Self::parse(text),
            TimesArgs { times_file: Some(path), .. } => Self::read_file(path),
            TimesArgs { ticks: Some(text), .. } => Self::parse_ticks(text, rate),
            TimesArgs { from: Some(from), to: Some(to), count, .. } => {
                let axis = Axis::range(*from, *to, false, *count);
                let axis = axis.ok().filter(|_| from.is_finite() && to.is_finite()).ok_or_else(|| {
                    let allowed = "must be two finite times, --from first, and a number from 2";
                    Failure::Input(format!("--from, --to, --count: {allowed}"))
                })?;
                Ok(Self::from_axis(axis, "--from, --to".to_owned()))
            }
            _ => Err(Failure::Input("--times, --times-file, --ticks or --from is required".to_owned())),
        }
    }

    /// Times of a text `T1,T2,...` or `LOW..HIGH/PLACES`.
    ///
    /// # Errors
    /// [`Failure::Input`]: another text.
    pub fn parse(text: &str) -> Result<Self, Failure> {
        let refused = |reason: &str| Failure::Input(format!("--times: {}: {reason}", shown(text)));
        let axis = if text.contains("..") {
            text.parse().map_err(refused)?
        } else {
            Axis::List(text.split(',').map(|entry| time(entry, "--times")).collect::<Result<_, _>>()?)
        };
        if axis.count().is_none() {
            return Err(refused("must be T1,T2,... or LOW..HIGH/PLACES or log:LOW..HIGH/PLACES"));
        }
        Ok(Self::from_axis(axis, "--times".to_owned()))
    }

    /// Ticks of a text `N1,N2,...` or `FIRST..LAST`, as an interrupt counts them.
    fn parse_ticks(text: &str, rate: [u32; 2]) -> Result<Self, Failure> {
        let refused = || {
            let allowed = "must be N1,N2,... or FIRST..LAST, whole numbers of 64 bits";
            Failure::Input(format!("--ticks: {}: {allowed}", shown(text)))
        };
        let number = |text: &str| text.trim().parse::<i64>().map_err(|_| refused());
        let numbers = |separator: &str| text.split(separator).map(number).collect::<Result<Vec<_>, _>>();
        let [ticks, seconds] = rate.map(f64::from);
        let timed = move |tick: i64| (tick as f64 * seconds / ticks, tick);
        let list = if text.contains("..") { numbers("..")? } else { numbers(",")? };
        let (option, rate) = ("--ticks".to_owned(), Some(rate));
        let ends = ends(list.iter().map(|tick| timed(*tick).0));
        if !text.contains("..") {
            let (count, at) = (list.len() as u64, Box::new(move |index| timed(list[index as usize])));
            return Ok(Self { option, count, ends, rate, at });
        }
        match list[..] {
            [first, last] if first <= last && last.abs_diff(first) < u64::MAX => {
                let (count, at) =
                    (last.abs_diff(first) + 1, move |index| timed(first.wrapping_add_unsigned(index)));
                Ok(Self { option, count, ends, rate, at: Box::new(at) })
            }
            _ => Err(refused()),
        }
    }

    fn read_file(path: &Path) -> Result<Self, Failure> {
        /// Size of the largest file, MiB: some five million times.
        const LARGEST: u64 = 64;
        let name = path.display();
        let text = whole_file::read(&name.to_string(), path, LARGEST)?;
        let mut times = Vec::new();
        for (index, line) in text.lines().enumerate() {
            let entry = line.split('#').next().unwrap_or_default().trim();
            if !entry.is_empty() {
                times.push(time(entry, &format!("{name}: line {}", index + 1))?);
            }
        }
        if times.is_empty() {
            return Err(Failure::Input(format!(
                "{name}: must hold at least one time, one finite number a line"
            )));
        }
        Ok(Self::from_axis(Axis::List(times), format!("--times-file: {name}")))
    }

    fn from_axis(axis: Axis, option: String) -> Self {
        let (count, ends) = (axis.size(), axis.ends());
        Self { option, count, ends, rate: None, at: Box::new(move |index| (axis.at(index), 0)) }
    }

    /// List of all times, s.
    ///
    /// # Errors
    /// [`Failure::Input`]: too many to be held at once.
    pub fn times(&self) -> Result<Vec<f64>, Failure> {
        const MOST: u64 = 5_000_000;
        if self.count > MOST {
            let reason = format!("{} times: must be at most {MOST} with this --method", self.count);
            return Err(Failure::Input(reason).of(&self.option));
        }
        Ok((0..self.count).map(|index| (self.at)(index).0).collect())
    }

    /// Refuses times further from t = 0 than `most`, s; `method` ends the message.
    ///
    /// # Errors
    /// [`Failure::Input`].
    pub fn require_within(&self, most: f64, method: &str) -> Result<(), Failure> {
        let beyond = |end: f64| {
            let reason = format!("{end:e} must be within ±{most:.1e} s{method}");
            Err(Failure::Input(reason).of(&self.option))
        };
        self.ends.into_iter().find(|end| end.abs() > most).map_or(Ok(()), beyond)
    }
}

fn time(entry: &str, place: &str) -> Result<f64, Failure> {
    finite(entry)
        .ok_or_else(|| Failure::Input(format!("{place}: {:?} must be a finite number", shown(entry.trim()))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spread_evenly_with_both_ends() {
        let all = |text: &str| Instants::parse(text).unwrap().times().unwrap();
        assert_eq!(all("-1..1/5"), [-1.0, -0.5, 0.0, 0.5, 1.0]);
        let third = all("0..0.3/4");
        assert_eq!((third.len(), third[0], third[3]), (4, 0.0, 0.3));
        let log = all("log:0.01..100/3");
        assert!(log[0] == 0.01 && (log[1] - 1.0).abs() < 1e-14 && log[2] == 100.0, "{log:?}");
        let far = Instants::parse("-3..1/5").unwrap();
        assert!(far.require_within(3.0, "").is_ok());
        assert_eq!(
            far.require_within(2.9, "").unwrap_err().to_string(),
            "--times: -3e0 must be within ±2.9e0 s"
        );
        for refused in ["0..1", "1..0/3", "0..1/1", "0..1/5000000000", "0..x/3"] {
            let message = Instants::parse(refused).err().unwrap().to_string();
            assert!(message.starts_with(&format!("--times: {refused}: ")), "{message}");
        }
    }

    #[test]
    fn ticks_are_exact_fractions_of_a_second() {
        let ticks = |text: &str| Instants::parse_ticks(text, [44100, 2]);
        let run = ticks("-2..2").unwrap();
        assert_eq!((run.count, (run.at)(0), (run.at)(4)), (5, (-4.0 / 44100.0, -2), (4.0 / 44100.0, 2)));
        let list = ticks("7,-99, 3").unwrap();
        assert_eq!((list.count, (list.at)(1)), (3, (-198.0 / 44100.0, -99)));
        for refused in ["", "1.5", "2..1", "1,,2", "0..99999999999999999999"] {
            let message = ticks(refused).err().unwrap().to_string();
            assert!(message.starts_with(&format!("--ticks: {refused}: ")), "{message}");
        }
    }
}
