//! Tip angle: its mean, which is linear in time, plus a periodic part from the table.
//!
//! The periodic part is the argument of the tabulated ab while u rises, and its negative while u falls. Crossings of the negative real axis are
//! counted at the centres of the segments.

use crate::complex::Complex;
use crate::phase::Phase;
use crate::table::data::Table;
use crate::table::evaluation::{TableScalar, a_b_at_centre, tabulated_a_b};
use crate::table::read::located_segment::LocatedSegment;
use crate::table::read::sample::Sample;
use crate::table::time::Phases;
use crate::table::time::is_falling;

impl<R: TableScalar> Sample<'_, R> {
    /// Tip angle φ = arg c, continuous in time, modulo 2^32 turns; `None` for an axis that stays vertical.
    ///
    /// * At the launch it is in (-1/2, 1/2] turn.
    /// * Where the curve passes through the centre, φ is smooth and the radius changes its sign: c = ±|c| e^{iφ}.
    /// * Error: the orientation error over 2|αβ|.
    /// * Cost: an arctangent, and a complex product for every segment since u = e₁.
    #[must_use]
    pub fn tip_angle(&self) -> Option<Phase> {
        self.table.clock.tip_exists.then(|| self.tip_angle_unchecked())
    }

    pub(crate) fn tip_angle_unchecked(&self) -> Phase {
        let Self { table, phases: Phases { nutation, .. }, instant, .. } = *self;
        table.clock.mean_tip(instant, nutation) + table.tabulated_tip_angle(nutation, &mut || {})
    }
}

impl<R: TableScalar> Table<R> {
    /// Mean rate of the tip angle, rad/s; 0 for an axis that stays vertical.
    #[must_use]
    pub fn mean_tip_angle_rate(&self) -> f64 {
        let [ticks_per_time, _] = self.clock.ticks_per_time;
        if self.clock.tip_exists { self.clock.tip_increment().to_radians() * ticks_per_time } else { 0.0 }
    }

    /// Argument of the tabulated ab, followed from u = e₁ from segment centre to segment centre. Near ab = 0 it is the direction of the passage.
    pub(in crate::table) fn tabulated_tip_angle(&self, nutation: u64, pause: &mut dyn FnMut()) -> Phase {
        const SEGMENTS_PER_PAUSE: usize = 8;
        let LocatedSegment { rows, point, number } = self.segment_at(nutation);
        let mut argument = ContinuedArgument::ZERO;
        for (index, segment) in self.segments.iter().enumerate().take(number + 1) {
            let Some(constants) = segment.as_ref().first() else { continue };
            let [a, b] = a_b_at_centre(*constants);
            argument.continue_to(self.relative_to_start(a * b));
            if index % SEGMENTS_PER_PAUSE == SEGMENTS_PER_PAUSE - 1 {
                pause();
            }
        }
        pause();
        let [[a, b], [a_slope, b_slope]] = tabulated_a_b::<R>(rows, point);
        let product = a * b;
        let change = a_slope * b + a * b_slope;
        let least = MIN_MODULUS * R::ROUNDING * (a.norm_squared() + b.norm_squared());
        let is_near_zero = product.norm_squared() <= least * least;
        let direction = match (is_near_zero, point.x_q63 < 0) {
            (false, _) => product,
            (true, true) => change,
            (true, false) => -change,
        };
        argument.continue_to(self.relative_to_start(direction));
        let angle = argument.angle();
        if is_falling(nutation) { -angle } else { angle }
    }

    /// Product ab, turned so that at u = e₁ it leaves along the positive real axis.
    fn relative_to_start(&self, product: Complex<f64>) -> Complex<f64> {
        match self.clock.ab_quarter_turns_at_e1 {
            0 => product,
            1.. => -product.times_i(),
            _ => product.times_i(),
        }
    }
}

/// Value of |ab|, in roundings of the scalar, below which its argument is unknown.
const MIN_MODULUS: f64 = 64.0;

/// Argument of a number that turns by less than half a turn at a time: it continues from 0, and counts whole turns.
#[derive(Clone, Copy, Debug)]
struct ContinuedArgument {
    z: Complex<f64>,
    whole_turns: i64,
}

impl ContinuedArgument {
    const ZERO: Self = Self { z: Complex::new(1.0, 0.0), whole_turns: 0 };

    /// Continues the argument to z; 0 has no argument and changes nothing.
    fn continue_to(&mut self, z: Complex<f64>) {
        if z == Complex::ZERO {
            return;
        }
        let anticlockwise = self.z.re * z.im - self.z.im * z.re > 0.0;
        match (self.z.im < 0.0, z.im < 0.0) {
            (false, true) if anticlockwise => self.whole_turns += 1,
            (true, false) if !anticlockwise => self.whole_turns -= 1,
            _ => {}
        }
        self.z = z;
    }

    fn angle(&self) -> Phase {
        Phase::from_radians(self.z.arg()) + Phase::TURN * self.whole_turns
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_argument_is_continued_through_any_number_of_turns() {
        for sense in [1.0, -1.0] {
            let mut argument = ContinuedArgument::ZERO;
            for step in 1..40 {
                let angle = sense * 0.9 * f64::from(step);
                argument.continue_to(Complex::new(angle.cos(), angle.sin()));
                assert!((argument.angle().to_radians() - angle).abs() < 1e-12, "{angle}");
            }
        }
    }
}
