//! Integrals near one turning point, on panels whose lengths grow by factors of 4 with the distance from it.

use crate::truth::gauss::RULE;
use crate::truth::law::{End, Law, LawInF64};
use crate::truth::precise::{Precise, precise, to_f64};

/// Time, and the advances of arg α and arg β without ±τt/2.
pub(super) type Passed = [Precise; 3];

/// Number of panels of an aperiodic motion towards its turning point: down to a sine of 4^-40, 8e-25.
const TOWARDS_THE_POLE: usize = 40;

/// Integrals near one turning point.
#[derive(Clone, Debug)]
pub(super) struct Side {
    end: End,
    /// Ends of the panels as sines, in descending order from √½.
    edges: Vec<Precise>,
    /// Advances from the turning point to each edge, or, if the turning point is never reached, negative advances backward from √½.
    passed: Vec<Passed>,
    /// Whether the turning point is reached.
    reached: bool,
}

impl Side {
    /// Integrals with the nearest singularity at this distance; `None` if it is the turning point itself.
    pub(super) fn new(law: &Law, end: End, depth: Option<f64>, finer: usize) -> Self {
        let outermost = precise(0.5).sqrt();
        let panels = depth.map_or(TOWARDS_THE_POLE, |depth| {
            let octaves = (to_f64(&outermost) / (2.0 * depth)).log2();
            (0.5 * octaves).ceil().max(0.0) as usize + finer
        });
        let edges: Vec<_> =
            std::iter::successors(Some(outermost), |edge| Some(edge.clone() >> 2)).take(panels + 1).collect();
        let zero = || [(); 3].map(|()| precise(0.0));
        let mut side = Self { end, edges, passed: Vec::new(), reached: depth.is_some() };
        let pieces: Vec<_> =
            side.edges.windows(2).map(|pair| side.panel(law, [&pair[1], &pair[0]])).collect();
        side.passed = if side.reached {
            let innermost = side.panel(law, [&precise(0.0), &side.edges[panels]]);
            let mut passed = vec![innermost];
            pieces.iter().rev().for_each(|piece| passed.extend(passed.last().map(|last| sum(last, piece))));
            passed.reverse();
            passed
        } else {
            let mut passed = vec![zero()];
            pieces.iter().for_each(|piece| passed.extend(passed.last().map(|last| difference(last, piece))));
            passed
        };
        side
    }

    /// Whether the turning point is reached.
    pub(super) fn is_reached(&self) -> bool {
        self.reached
    }

    /// Advances from the turning point to halfway; 0 if it is never reached.
    pub(super) fn whole(&self) -> &Passed {
        &self.passed[0]
    }

    /// Sine and advances at the last edge before a turning point that is never reached.
    pub(super) fn last(&self) -> (&Precise, &Passed) {
        let last = self.edges.len() - 1;
        (&self.edges[last], &self.passed[last])
    }

    /// Advances from the turning point to a sine that is not negative.
    pub(super) fn passed(&self, law: &Law, beyond: &Precise) -> Passed {
        let (low, base) = self.below(self.panel_of(|i| self.edges[i] >= *beyond));
        sum(&base, &self.panel(law, [&low, beyond]))
    }

    /// Sine at a time after the turning point (a negative time if that is never reached), and the advances there.
    pub(super) fn at(&self, law: &Law, coarse: &LawInF64, time: &Precise) -> (Precise, Passed) {
        const NEWTON_STEPS: u32 = 4;
        /// Difference whose square is far below the errors that the truth is compared with.
        const NEAR: f64 = 1e-12;
        let outer = self.panel_of(|i| self.passed[i][0] >= *time);
        let (low, base) = self.below(outer);
        let ends = [to_f64(&low), to_f64(&self.edges[outer])];
        let mut beyond = precise(coarse.reach(self.end, ends, to_f64(&(time - &base[0]))));
        let mut steps = 0;
        loop {
            let [there, alpha, beta] = sum(&base, &self.panel(law, [&low, &beyond]));
            let [slowness, alpha_rate, beta_rate] = law.rates(self.end, &beyond);
            let step = (time - there) / slowness;
            steps += 1;
            // the rest is so short that the integrals are linear on it
            if to_f64(&step).abs() <= NEAR * to_f64(&beyond) || steps == NEWTON_STEPS {
                let passed = [time.clone(), alpha + alpha_rate * &step, beta + beta_rate * &step];
                return (beyond + step, passed);
            }
            beyond += step;
        }
    }

    /// Innermost panel whose outer edge has a property, which all edges further out have too.
    fn panel_of(&self, encloses: impl Fn(usize) -> bool) -> usize {
        (0..self.edges.len()).rev().find(|i| encloses(*i)).unwrap_or(0)
    }

    /// Inner edge of a panel, and the advances there.
    fn below(&self, outer: usize) -> (Precise, Passed) {
        match (self.edges.get(outer + 1), self.passed.get(outer + 1)) {
            (Some(edge), Some(passed)) => (edge.clone(), passed.clone()),
            _ if self.reached => (precise(0.0), [(); 3].map(|()| precise(0.0))),
            _ => (self.edges[outer].clone(), self.passed[outer].clone()),
        }
    }

    fn panel(&self, law: &Law, ends: [&Precise; 2]) -> Passed {
        RULE.integrate(ends, |beyond| law.rates(self.end, beyond))
    }
}

impl LawInF64 {
    /// Sine at which this time has passed from `low`, by Newton's method, with bisection where a step leaves the bracket.
    fn reach(&self, end: End, [low, high]: [f64; 2], time: f64) -> f64 {
        const STEPS: u32 = 100;
        let (mut least, mut most) = (low, high);
        let mut beyond = 0.5 * (low + high);
        for _ in 0..STEPS {
            let behind = time - RULE.integrate_in_f64([low, beyond], |x| self.slowness(end, x));
            if behind > 0.0 {
                least = beyond;
            } else {
                most = beyond;
            }
            let next = beyond + behind / self.slowness(end, beyond);
            let next = if (least..=most).contains(&next) { next } else { 0.5 * (least + most) };
            let step = next - beyond;
            beyond = next;
            if step.abs() <= 1e-15 * beyond {
                break;
            }
        }
        beyond
    }
}

/// Sum of advances a + b.
pub(super) fn sum(a: &Passed, b: &Passed) -> Passed {
    [0, 1, 2].map(|i| &a[i] + &b[i])
}

/// Difference of advances a - b.
pub(super) fn difference(a: &Passed, b: &Passed) -> Passed {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}
