//! Tip angle of an ephemeris: the sum of its mean, which is linear in time, and of a periodic part from the table.
//!
//! Between u = e₁ and u = e₂ the periodic part is the argument of the tabulated αβ, continued from segment to segment;
//! on the other half of the period it is the negative of this argument. For a slender top αβ may wind around 0 many
//! times, so the crossings of the negative real axis are counted at the centres of the segments.

use core::ops::Range;

use crate::complex::Complex;
use crate::ephemeris::clock::TipClock;
use crate::ephemeris::evaluation::{EphemerisScalar, ValuesAndSlopes};
use crate::ephemeris::storage::EphemerisView;
use crate::ephemeris::table::{LocatedSegment, locate};
use crate::motion::Motion;
use crate::phase::Phase;
use crate::scalar::{Float, Real, Ring, Scalar};

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Mean rate of the tip angle in turns per unit time; 0 where the axis is vertical at all times. The rate times t
    /// determines how often a tip angle, which is known modulo 2^32 turns, has passed that number.
    #[must_use]
    pub fn mean_tip_angle_rate(&self) -> f64 {
        let [ticks_per_time, _] = self.clock.ticks_per_time;
        Phase::from_words(self.clock.tip.step).to_f64() * ticks_per_time
    }

    /// Periodic part of the tip angle at a nutation phase, given by the 64 leading bits of its fraction of a turn.
    /// Cost: an arctangent, and a complex product for every segment between u = e₁ and the phase.
    pub(crate) fn periodic_tip_angle(&self, nutation: u64) -> Phase {
        self.signed_part(nutation) + self.tabulated_angle(nutation)
    }

    /// Continues the argument of αβ over some of the segments between u = e₁ and the start of a motion. Returns whether it has
    /// reached the segment of the start.
    ///
    /// * `nutation`: nutation phase at t = 0
    pub(crate) fn wind(&self, nutation: Phase, progress: &mut WindingProgress) -> bool {
        /// Number of segments in a slice of a set-up.
        const SEGMENTS: usize = 16;
        let LocatedSegment { number, .. } = self.located(nutation.fraction());
        let end = (number + 1).min(progress.segments + SEGMENTS);
        let mut winding = progress.winding.cast();
        self.continue_over(progress.segments..end, &mut winding);
        *progress = WindingProgress { winding: winding.cast(), segments: end };
        end > number
    }

    /// Sets the mean tip angle so that the tip angle at t = 0 is the argument of c in (-1/2, 1/2] turn.
    ///
    /// * `start`: nutation phase, A and B at t = 0
    /// * `progress`: continued argument at the segment of the start
    pub(crate) fn start_tip_angle(
        &mut self,
        motion: &Motion,
        [nutation, a, b]: [Phase; 3],
        progress: &WindingProgress,
    ) {
        let nutation = nutation.fraction();
        let quarter_turn = Phase::QUARTER.times(self.clock.tip.quarter.into());
        // only the half turns count, and the arctangent in `f64` is needed elsewhere
        let winding = self.winding_in(&self.located(nutation), progress.winding.cast());
        let tabulated = winding.cast::<f64>().angle_on(nutation);
        // the whole turns come from the table, and the rest from the motion's phases, because near the centre the
        // table's angle is inexact
        let argument = motion.tip_angle_at_start();
        let exact = argument - a - b - if is_falling(nutation) { -quarter_turn } else { quarter_turn };
        let TipClock { quarter, passes, .. } = self.clock.tip;
        let off = exact - tabulated;
        // where the curve passes through the centre, the radius has a sign, which half a turn of the angle changes
        let off = if quarter != 0 || passes != 0 { half_turn_remainder(off) } else { off.principal() };
        let tabulated = tabulated + off;
        self.clock.tip.start = (argument - self.signed_part(nutation) - tabulated).words();
    }

    /// Half a turn per period for each parameter that passes through 0. The slow phases contain it, and the tip angle
    /// does not.
    fn signed_part(&self, nutation: u64) -> Phase {
        Phase::from_bits(i128::from(nutation as i64) << 31).times(self.clock.tip.passes.into())
    }

    /// Argument of the tabulated αβ, continued from u = e₁, where it is 0.
    fn tabulated_angle(&self, nutation: u64) -> Phase {
        let found = self.located(nutation);
        let mut winding = Winding::START;
        self.continue_over(0..found.number + 1, &mut winding);
        self.winding_in(&found, winding).angle_on(nutation)
    }

    /// Segment at a nutation phase.
    fn located(&self, nutation: u64) -> LocatedSegment<'_, R> {
        let share = (nutation ^ ((nutation as i64) >> 63) as u64) << 1;
        locate::<R>(&self.cells, &self.segments, share)
    }

    /// Continues the argument of αβ over the centres of these segments.
    fn continue_over(&self, segments: Range<usize>, winding: &mut Winding<R::Wide>) {
        for segment in self.segments.get(segments).unwrap_or_default() {
            let [centre, ..] = segment.as_ref() else { continue };
            let product = self.turned_back(centre.map(|coefficient| R::number(coefficient, 0)));
            if !self.is_at_limit(product) {
                winding.reach(product);
            }
        }
    }

    /// Tabulated αβ at a place on a segment, from that at the centre of the segment.
    fn winding_in(&self, found: &LocatedSegment<'_, R>, mut winding: Winding<R::Wide>) -> Winding<R::Wide> {
        let x = R::Wide::from_f64(found.x as f64 / (1_u64 << 63) as f64);
        let numbers = |(power, row): (usize, &[R::Coefficient; 4])| row.map(|c| R::number(c, power));
        let ValuesAndSlopes(value, slope) =
            ValuesAndSlopes::at(found.terms.iter().enumerate().rev().map(numbers), x);
        if !self.is_at_limit(self.turned_back(value)) {
            winding.reach(self.direction(value, slope, x));
        }
        winding
    }

    /// Whether αβ of an aperiodic motion is so close to its limit 0 that its argument counts as that of the limit. The
    /// two differ by about |αβ|², and the rounding of the table changes the argument by more.
    fn is_at_limit(&self, product: Complex<R::Wide>) -> bool {
        let limit = R::ROUNDING + R::Wide::ROUNDING;
        self.clock.horizon.is_some() && product.norm_squared() < R::Wide::from_f64(limit)
    }

    /// Direction of αβ, turned as by [`EphemerisView::turned_back`]. Where αβ is so near 0 that it has no correct digit, it is
    /// the direction in which αβ moves away from 0, or from which it moves to 0.
    fn direction(&self, value: [R::Wide; 4], slope: [R::Wide; 4], x: R::Wide) -> Complex<R::Wide> {
        let product = self.turned_back(value);
        let ([alpha, beta], [alpha_slope, beta_slope]) = (complex(value), complex(slope));
        let change = self.rotated_back(alpha_slope * beta + alpha * beta_slope);
        let least_modulus = LEAST_MODULUS * (R::ROUNDING + R::Wide::ROUNDING);
        if product.norm_squared() > R::Wide::from_f64(least_modulus * least_modulus) {
            product
        } else if x < R::Wide::ZERO {
            change
        } else {
            -change
        }
    }

    /// αβ of tabulated values, turned so that at u = e₁ it leaves along the positive real axis.
    fn turned_back(&self, values: [R::Wide; 4]) -> Complex<R::Wide> {
        let [alpha, beta] = complex(values);
        self.rotated_back(alpha * beta)
    }

    fn rotated_back(&self, product: Complex<R::Wide>) -> Complex<R::Wide> {
        match self.clock.tip.quarter {
            0 => product,
            1.. => -product.times_i(),
            _ => product.times_i(),
        }
    }
}

/// α and β from their parts.
fn complex<R>([re_alpha, im_alpha, re_beta, im_beta]: [R; 4]) -> [Complex<R>; 2] {
    [Complex::new(re_alpha, im_alpha), Complex::new(re_beta, im_beta)]
}

/// Value of |αβ|, in roundings of the scalar, below which its argument counts as unknown. Unless another
/// error is chosen, that of a table is at most four roundings.
const LEAST_MODULUS: f64 = 64.0;

/// Difference of a phase and the nearest multiple of half a turn.
fn half_turn_remainder(phase: Phase) -> Phase {
    Phase::from_bits(phase.times(2).principal().to_bits() >> 1)
}

/// Whether u falls at a nutation phase. Without their mean rotation α and β are then the conjugates of the tabulated
/// values.
fn is_falling(nutation: u64) -> bool {
    (nutation as i64) < 0
}

/// Argument of αβ, continued over the first segments of a table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WindingProgress {
    winding: Winding<f64>,
    /// Number of these segments.
    segments: usize,
}

impl WindingProgress {
    pub(crate) const NONE: Self = Self { winding: Winding::START, segments: 0 };
}

/// Argument of a complex number that moves by less than half a turn at a time, continued from 0.
#[derive(Clone, Copy, Debug)]
struct Winding<R> {
    z: Complex<R>,
    turns: i64,
}

impl<R: Real> Winding<R> {
    const START: Self = Self { z: Complex::ONE, turns: 0 };

    /// Conversion to a wider type and back.
    fn cast<S: Real>(&self) -> Winding<S> {
        let Complex { re, im } = self.z;
        let cast = |x: R| S::from_f64(x.to_f64());
        Winding { z: Complex::new(cast(re), cast(im)), turns: self.turns }
    }

    /// Continues the argument to z; z = 0 has no argument and changes nothing.
    fn reach(&mut self, z: Complex<R>) {
        if z == Complex::ZERO {
            return;
        }
        let anticlockwise = self.z.re * z.im - self.z.im * z.re > R::ZERO;
        match (self.z.im < R::ZERO, z.im < R::ZERO) {
            (false, true) if anticlockwise => self.turns += 1,
            (true, false) if !anticlockwise => self.turns -= 1,
            _ => {}
        }
        self.z = z;
    }

    /// Argument at this nutation phase; on the second half of the period it is the negative one.
    fn angle_on(&self, nutation: u64) -> Phase {
        let angle = Phase::from_radians(self.z.arg().to_f64()) + Phase::ONE.times(self.turns);
        if is_falling(nutation) { -angle } else { angle }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_argument_is_continued_through_any_number_of_turns() {
        for sense in [1.0, -1.0] {
            let mut winding = Winding::<f64>::START;
            for step in 1..40 {
                let angle = sense * 0.9 * f64::from(step);
                winding.reach(Complex::new(angle.cos(), angle.sin()));
                assert!((winding.angle_on(0).to_radians() - angle).abs() < 1e-12, "{angle}");
            }
        }
    }
}
