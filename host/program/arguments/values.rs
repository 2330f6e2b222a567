//! Numbers of the command line: one number in a range, or a list or a range of values.

use std::ops::RangeInclusive;
use std::str::FromStr;
use toytop_host::output::significant;
use toytop_host::random::Random;

/// All finite numbers.
pub const FINITE: RangeInclusive<f64> = f64::MIN..=f64::MAX;
/// All finite numbers above 0.
pub const POSITIVE: RangeInclusive<f64> = LEAST_POSITIVE..=f64::MAX;
/// Least number above 0.
pub const LEAST_POSITIVE: f64 = f64::from_bits(1);

/// Parser of a number in a range.
pub fn number(range: RangeInclusive<f64>) -> impl Fn(&str) -> Result<f64, String> + Clone {
    move |text| {
        let number = text.trim().parse().ok().filter(|number| range.contains(number));
        number.ok_or_else(|| {
            let [low, high] = [range.start(), range.end()].map(|end| significant(*end, 17));
            match (*range.start(), *range.end()) {
                (f64::MIN, _) => "must be a finite number".to_owned(),
                (LEAST_POSITIVE, f64::MAX) => "must be a number above 0".to_owned(),
                (LEAST_POSITIVE, _) => format!("must be a number above 0, at most {high}"),
                _ => format!("must be a number from {low} to {high}"),
            }
        })
    }
}

/// Values of one number, from a text such as `0.7`, `0.7,0.8,0.9`, `0.1..0.9`, `0.1..0.9/17` or `log:1e-3..1e3/7`.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// List of numbers.
    List(Vec<f64>),
    /// Range from `low` to `high`.
    Range {
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
        /// Whether values are spread evenly in the logarithm.
        log: bool,
        /// Number of values, both ends included; `None` for a continuous range.
        count: Option<u32>,
    },
}

impl Values {
    /// Range from `low` to `high`.
    ///
    /// * `names`: what the command line calls `low`, `high` and `count`
    ///
    /// # Errors
    /// Condition that the numbers do not meet.
    pub fn range(
        [low, high]: [f64; 2],
        log: bool,
        count: Option<u32>,
        names: [&str; 3],
    ) -> Result<Self, String> {
        let [low_name, high_name, count_name] = names;
        if low == high && count == Some(1) {
            return Ok(Self::List(vec![low]));
        }
        if low >= high {
            return Err(format!("{low_name} must be below {high_name}"));
        }
        if log && low <= 0.0 {
            return Err(format!("{low_name} must be above 0 with log:"));
        }
        if count.is_some_and(|count| count < 2) {
            return Err(format!("{count_name} must be a whole number from 2 to 4294967295"));
        }
        Ok(Self::Range { low, high, log, count })
    }

    /// Whether every number between the ends is a value.
    pub fn is_continuous(&self) -> bool {
        matches!(self, Self::Range { count: None, .. })
    }

    /// Number of values; 1 for a continuous range.
    pub fn count(&self) -> u64 {
        match self {
            Self::List(numbers) => numbers.len() as u64,
            Self::Range { count, .. } => count.map_or(1, u64::from),
        }
    }

    /// Value with this index, which is below [`count`](Self::count). A continuous range has the lower end.
    pub fn at(&self, index: u64) -> f64 {
        match self {
            Self::List(numbers) => numbers[index as usize],
            _ => self.between(index as f64 / (self.count().max(2) - 1) as f64),
        }
    }

    /// Number between the ends, at this fraction of the range.
    fn between(&self, fraction: f64) -> f64 {
        let [low, high] = self.least_and_greatest();
        let between = |low: f64, high: f64| low + (high - low) * fraction;
        // rounding must neither change the ends nor pass them
        match fraction {
            0.0 => low,
            1.0 => high,
            _ if matches!(self, Self::Range { log: true, .. }) => {
                between(low.ln(), high.ln()).exp().clamp(low, high)
            }
            _ => between(low, high).clamp(low, high),
        }
    }

    /// Random value.
    pub fn draw(&self, random: &mut Random) -> f64 {
        let fraction = random.uniform();
        if self.is_continuous() {
            return self.between(fraction);
        }
        self.at((fraction * self.count() as f64) as u64)
    }

    /// Least and greatest value.
    pub fn least_and_greatest(&self) -> [f64; 2] {
        match self {
            Self::List(numbers) => least_and_greatest(numbers.iter().copied()),
            Self::Range { low, high, .. } => [*low, *high],
        }
    }
}

/// Least and greatest of numbers.
pub fn least_and_greatest(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

/// Parser of values with a number: a list, or a range with a count.
pub fn counted_values(text: &str) -> Result<Values, String> {
    let values: Values = text.parse()?;
    let allowed = "must be X,Y,... or LOW..HIGH/COUNT or log:LOW..HIGH/COUNT";
    (!values.is_continuous()).then_some(values).ok_or_else(|| allowed.to_owned())
}

const FORMS: &str =
    "must be a finite number, X,Y,... or LOW..HIGH or LOW..HIGH/COUNT (log:LOW..HIGH: even in the logarithm)";

impl FromStr for Values {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| number(FINITE)(text).map_err(|_| FORMS.to_owned());
        let (log, rest) = text.strip_prefix("log:").map_or((false, text), |rest| (true, rest));
        let Some((low, rest)) = rest.split_once("..") else {
            return Ok(Self::List(text.split(',').map(number).collect::<Result<_, _>>()?));
        };
        let (high, count) = rest.split_once('/').map_or((rest, None), |(high, count)| (high, Some(count)));
        // an unparsable count is refused below, as 0 is
        let count = count.map(|count| count.trim().parse().unwrap_or(0));
        Self::range([number(low)?, number(high)?], log, count, ["LOW", "HIGH", "COUNT"])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(text: &str) -> Values {
        text.parse().unwrap()
    }

    #[test]
    fn a_number_out_of_range_is_refused_with_the_range() {
        assert_eq!(number(-1.0..=0.5)(" 0.5 "), Ok(0.5));
        assert_eq!(number(1.0..=f64::INFINITY)("inf"), Ok(f64::INFINITY));
        for (range, text, reason) in [
            (FINITE, "inf", "must be a finite number"),
            (POSITIVE, "0", "must be a number above 0"),
            (LEAST_POSITIVE..=1e9, "2e9", "must be a number above 0, at most 1e9"),
            (0.1..=600.0, "nan", "must be a number from 0.1 to 600"),
        ] {
            assert_eq!(number(range)(text), Err(reason.to_owned()));
        }
    }

    #[test]
    fn a_grid_has_both_ends_and_even_steps() {
        let all = |text: &str| {
            let values = values(text);
            (0..values.count()).map(|i| values.at(i)).collect::<Vec<_>>()
        };
        assert_eq!(all("0.7"), [0.7]);
        assert_eq!(all("0.7,-1, 1e3"), [0.7, -1.0, 1e3]);
        assert_eq!(all("-1..1/5"), [-1.0, -0.5, 0.0, 0.5, 1.0]);
        let third = all("0..0.3/4");
        assert_eq!((third.len(), third[0], third[3]), (4, 0.0, 0.3));
        let log = all("log:1e-3..1e3/3");
        assert!(log[0] == 1e-3 && log[2] == 1e3 && (log[1] - 1.0).abs() < 1e-15, "{log:?}");
    }

    #[test]
    fn what_is_drawn_lies_within_and_reaches_everywhere() {
        for (text, distinct) in [("log:0.1..0.3", 1000), ("-0.3..0.7", 1000), ("1,2,3", 3), ("0..1/11", 11)] {
            let values = values(text);
            let [low, high] = values.least_and_greatest();
            let mut drawn: Vec<_> = (0..1000).map(|i| values.draw(&mut Random::new(1, i))).collect();
            assert!(drawn.iter().all(|x| (low..=high).contains(x)), "{text}");
            drawn.sort_by(f64::total_cmp);
            let middle = drawn[500];
            let fair = if text.starts_with("log") { (low * high).sqrt() } else { 0.5 * (low + high) };
            assert!((middle - fair).abs() <= 0.05 * (high - low), "{text}: {middle}");
            drawn.dedup();
            assert_eq!(drawn.len(), distinct, "{text}");
        }
    }
}
