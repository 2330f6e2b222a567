//! From place to place: the integrals over χ, and the place of a time.

use super::{Dd, Exact, Point};
use crate::study::trigonometry::{cis, quarter_turn};
use std::f64::consts::FRAC_PI_2;
use toytop::Complex;
use toytop::real::{Float, Ring};

impl Exact<'_> {
    /// d(t, arg α, arg β)/dχ without the drift, at so much beyond so many quarter turns.
    fn integrand(&self, quarter: f64, beyond: Dd) -> [Dd; 3] {
        let Complex { re, im } = cis(beyond);
        let (sine, cosine) = if is_even(quarter) { (im, re) } else { (re, im) };
        let [one_plus_u, one_minus_u, slowness] = self.law_at(sine, cosine);
        let turning = |momentum: Dd, complement: Dd| {
            if momentum == Dd::ZERO { Dd::ZERO } else { momentum / complement * slowness }
        };
        let [alpha, beta] = self.momenta;
        [slowness, turning(alpha, one_plus_u), turning(beta, one_minus_u)]
    }

    /// From a point on to a larger, or back to a smaller, χ.
    ///
    /// Places are told by how far they are beyond the nearest turning point: the depth there may be far less than what
    /// double-double tells apart beside π/2.
    #[must_use]
    pub fn go(&self, from: &Point, chi: Dd) -> Point {
        let (low, high, sense) =
            if chi < from.chi { (chi, from.chi, -Dd::ONE) } else { (from.chi, chi, Dd::ONE) };
        let mut sums = [Dd::ZERO; 3];
        // halfway, to rounding, counts as the one ahead
        let mut quarter = (low.to_f64() / FRAC_PI_2 + (0.5 + 1e-9)).floor();
        let mut beyond = low - quarter_turn() * quarter.into();
        loop {
            let last = high - quarter_turn() * quarter.into();
            if beyond >= last {
                break;
            }
            let next = Dd::from(self.panel_end(quarter, beyond.to_f64()));
            let next = if next > beyond && next < last { next } else { last };
            let panel = self.rule.integrate([beyond, next], |beyond| self.integrand(quarter, beyond));
            sums.iter_mut().zip(panel).for_each(|(sum, part)| *sum = *sum + part);
            beyond = next;
            if beyond.to_f64() >= (0.5 - 1e-9) * FRAC_PI_2 {
                quarter += 1.0;
                beyond = beyond - quarter_turn();
            }
        }
        let [t, alpha, beta] = sums.map(|sum| sense * sum);
        let [turned_alpha, turned_beta] = from.turned;
        Point { chi, t: from.t + t, turned: [turned_alpha + alpha, turned_beta + beta] }
    }

    /// A panel is no longer than what lies between it and the nearest turning point, or than the depth there.
    fn panel_end(&self, quarter: f64, beyond: f64) -> f64 {
        let [bottom, top] = self.depths;
        let depth = if is_even(quarter) { bottom } else { top };
        if beyond >= 0.0 {
            (2.0 * beyond).max(depth).min(0.5 * FRAC_PI_2)
        } else if -beyond <= depth * (1.0 + 1e-9) {
            0.0
        } else {
            (0.5 * beyond).min(-depth)
        }
    }

    /// One nutation period after the start; of no meaning for an aperiodic motion.
    #[must_use]
    pub fn period(&self) -> Point {
        let start = Point { chi: Dd::ZERO, ..self.start() };
        let half = self.go(&start, quarter_turn());
        let [alpha, beta] = half.turned;
        Point {
            chi: quarter_turn().doubled(),
            t: half.t.doubled(),
            turned: [alpha.doubled(), beta.doubled()],
        }
    }

    /// So many periods after a point.
    #[must_use]
    pub fn later(&self, point: &Point, period: &Point, periods: f64) -> Point {
        let on = |now: Dd, step: Dd| now + step * periods.into();
        let ([alpha, beta], [alpha_step, beta_step]) = (point.turned, period.turned);
        Point {
            chi: on(point.chi, period.chi),
            t: on(point.t, period.t),
            turned: [on(alpha, alpha_step), on(beta, beta_step)],
        }
    }

    /// The point at a time close to that of a point; `place` is the same place in the first period.
    #[must_use]
    pub fn at_time(&self, point: &Point, place: Dd, t: f64) -> Point {
        const NEWTON_STEPS: u32 = 4;
        let here = Point { chi: place, t: point.t, turned: point.turned };
        let mut moved = here;
        for _ in 0..NEWTON_STEPS {
            let [_, _, slowness] = self.law(moved.chi);
            moved = self.go(&here, moved.chi + (Dd::from(t) - moved.t) / slowness);
        }
        Point { chi: point.chi + (moved.chi - place), ..moved }
    }

    /// The point of a time, found from a point before or after it: Newton's steps, halved where they leave the bracket of χ.
    #[must_use]
    pub fn seek(&self, from: &Point, t: f64, [low, high]: [f64; 2]) -> Point {
        const STEPS: u32 = 200;
        let (mut low, mut high) = (low, high);
        let mut point = *from;
        for _ in 0..STEPS {
            let behind = Dd::from(t) - point.t;
            let chi = point.chi.to_f64();
            if behind < Dd::ZERO {
                high = high.min(chi)
            } else {
                low = low.max(chi)
            }
            let [_, _, slowness] = self.law(point.chi);
            let step = behind / slowness;
            let there = (point.chi + step).to_f64();
            if step.to_f64().abs() < 1e-15 {
                break;
            }
            let next =
                if low < there && there < high { point.chi + step } else { (0.5 * (low + high)).into() };
            point = self.go(&point, next);
        }
        point
    }
}

/// χ is a multiple of a half turn: u is e₁ there.
fn is_even(quarter: f64) -> bool {
    quarter.rem_euclid(2.0) == 0.0
}
