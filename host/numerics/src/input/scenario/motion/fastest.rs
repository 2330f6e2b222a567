//! Greatest rate of a release that a top can have.

use super::{SLOW, Section};
use crate::Failure;
use toytop::{Motion, Release, State, Top};

/// Rate of a release: its key, its value, and the release with another value of it.
struct Rate {
    key: &'static str,
    value: f64,
    with: fn(&Release, f64) -> Release,
}

/// Failure for a release that is too fast. It names the greatest of its rates and, if the top can have the other ones, the limit of this
/// one.
pub(super) fn too_fast(section: &Section<'_>, top: &Top, release: &Release) -> Failure {
    let rates = [
        Rate { key: "spin", value: release.spin, with: |release, spin| Release { spin, ..*release } },
        Rate {
            key: "precession",
            value: release.precession,
            with: |release, precession| Release { precession, ..*release },
        },
        Rate {
            key: "nutation",
            value: release.nutation,
            with: |release, nutation| Release { nutation, ..*release },
        },
    ];
    let [spin, precession, nutation] = &rates;
    let greater = |a, b| if rate_of(b) > rate_of(a) { b } else { a };
    let rate = greater(greater(spin, precession), nutation);
    let limit = limit(top, release, rate).map_or_else(String::new, |limit| {
        format!("at most {limit:e} rad/s in size with the other numbers of this file, ")
    });
    section.refuse(rate.key, &format!("must be {limit}{SLOW}"))
}

fn rate_of(rate: &Rate) -> f64 {
    rate.value.abs()
}

/// Greatest size of a rate with which there is a motion, rounded down to three digits; `None` if there is none even without this rate.
fn limit(top: &Top, release: &Release, rate: &Rate) -> Option<f64> {
    /// Least limit that is found, in units of the rate that was refused.
    const LEAST: f64 = 1e-24;
    /// Halvings of the logarithm of the ratio, after which the limit has more than three digits.
    const HALVINGS: usize = 20;
    let exists = |size: f64| {
        let state = State::release(&(rate.with)(release, size.copysign(rate.value)));
        state.is_ok_and(|state| Motion::launch(top, &state).is_ok())
    };
    let mut high = rate.value.abs();
    let mut low = LEAST * high;
    if !exists(low) {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = (low * high).sqrt();
        if exists(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    let unit = 10_f64.powi(low.log10().floor() as i32 - 2);
    // the decimal nearest to the product, so that it is printed with three digits
    let limit = format!("{:.2e}", (low / unit).floor() * unit).parse().ok()?;
    exists(limit).then_some(limit)
}
