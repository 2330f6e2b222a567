//! Greatest rate of a release that a top can have.

use super::{SLOW, Section};
use crate::Failure;
use toytop::{Motion, Release, State, Top};

/// Failure for a release that is too fast. It names the greatest of its rates and, if the top can have the other ones, the limit of this
/// one.
pub fn too_fast(section: &Section<'_>, top: &Top, release: &Release) -> Failure {
    let rates = [("spin", release.spin), ("precession", release.precession), ("nutation", release.nutation)];
    let greater = |a: (&'static str, f64), b: (&'static str, f64)| if b.1.abs() > a.1.abs() { b } else { a };
    let (key, value) = rates.into_iter().fold(rates[0], greater);
    let exists = |size: f64| {
        let rate = size.copysign(value);
        let release = match key {
            "spin" => Release { spin: rate, ..*release },
            "precession" => Release { precession: rate, ..*release },
            _ => Release { nutation: rate, ..*release },
        };
        State::release(&release).is_ok_and(|state| Motion::launch(top, &state).is_ok())
    };
    let limit = limit(value.abs(), exists).map_or_else(String::new, |limit| {
        format!("at most {limit:e} rad/s in size with the other numbers of this file, ")
    });
    section.refuse(key, &format!("must be {limit}{SLOW}"))
}

/// Greatest size below `high` with which there is a motion, rounded down to three digits; `None` if there is none even near 0.
fn limit(mut high: f64, exists: impl Fn(f64) -> bool) -> Option<f64> {
    /// Least limit that is found, in units of the rate that was refused.
    const LEAST: f64 = 1e-24;
    /// Halvings of the logarithm of the ratio, after which the limit has more than three digits.
    const HALVINGS: usize = 20;
    let mut low = LEAST * high;
    if !exists(low) {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = (low * high).sqrt();
        *if exists(middle) { &mut low } else { &mut high } = middle;
    }
    let unit = 10_f64.powi(low.log10().floor() as i32 - 2);
    // the decimal nearest to the product, so that it is printed with three digits
    let limit = format!("{:.2e}", (low / unit).floor() * unit).parse().ok()?;
    exists(limit).then_some(limit)
}
