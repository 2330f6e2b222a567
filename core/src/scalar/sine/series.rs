//! Power series of sine and cosine, for numbers of any type.

use super::rotate_quarter_turns;
use crate::phase::Phase;
use crate::scalar::{Extended, Float};

/// Sine and cosine of an angle of at most π/4 in size, in rad, each with the relative error of a few roundings.
///
/// * `pause`: called before each term
#[inline(never)]
pub fn sine_cosine_series<F: Float>(angle: F, pause: &mut dyn FnMut()) -> (F, F) {
    /// Number of terms after which the next is below 2^-128.
    const TERMS: u32 = 32;
    let [mut sine, mut cosine, mut term] = [F::ZERO, F::ONE, F::ONE];
    let least = angle.abs() * F::from_f64(0.1 * F::OPERATION_ERROR);
    for k in 1..TERMS {
        pause();
        term = term * angle / F::from_f64(k.into());
        match k % 4 {
            0 => cosine = cosine + term,
            1 => sine = sine + term,
            2 => cosine = cosine - term,
            _ => sine = sine - term,
        }
        if term.abs() <= least {
            break;
        }
    }
    (sine, cosine)
}

/// (sin 2πx, cos 2πx) of a phase of x turns, relatively exact also near the zeros.
pub fn exact_sine_cosine(phase: Phase) -> (Extended, Extended) {
    let (quadrant, remainder) = phase.quadrant();
    let angle = Extended::from(remainder) * Extended::TWO_PI;
    rotate_quarter_turns(quadrant, sine_cosine_series(angle, &mut || {}))
}
