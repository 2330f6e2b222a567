//! Integrals along the half period in which u rises from e₁ to e₂.
//!
//! A place on it is the sine of the difference of χ from the nearer turning point. In it the integrands are algebraic, so that no digits
//! are lost where the nearest singularity is at a distance of a millionth. The panels of the quadrature grow by factors of 4 with the distance
//! from a turning point.

use super::integrals::{Integrands, TurningPoint};
use super::integrals::{Number, integrate};
use super::precise::{Precise, precise, to_f64, whole};

/// Time, and the advances of arg α and arg β without ±τt/2.
pub type Integrals = [Precise; 3];

/// Number of panels of an aperiodic motion towards its turning point: down to a sine of 4^-40, 8e-25.
const TOWARDS_THE_POLE: usize = 40;

/// Integrals from u = e₁ to u = e₂.
pub struct HalfPeriod {
    integrands: Integrands<Precise>,
    coarse: Integrands<f64>,
    panels: Vec<Panel>,
    /// Integrals over all panels.
    pub whole: Integrals,
    /// Whether u = e₂ is reached, which it is not in an aperiodic motion.
    pub arrives: bool,
}

struct Panel {
    end: TurningPoint,
    /// Sines at the beginning and at the end of the panel.
    sines: [Precise; 2],
    /// Integrals from u = e₁ to its beginning.
    passed: Integrals,
}

impl HalfPeriod {
    /// Half period of a motion in which u changes; the panels at the turning points are shorter by the factor 4 to the power `finer`.
    pub fn new(integrands: &Integrands<Precise>, coarse: &Integrands<f64>, finer: usize) -> Self {
        let [lower, upper] = [TurningPoint::Lower, TurningPoint::Upper].map(|end| coarse.depth(end));
        let mut rising = edges(lower, finer);
        rising.reverse();
        let falling = edges(upper, finer);
        let (mut panels, mut passed) = (Vec::new(), [(); 3].map(|()| whole(0)));
        for (end, edges) in [(TurningPoint::Lower, rising), (TurningPoint::Upper, falling)] {
            for pair in edges.windows(2) {
                let next = add(&passed, &integrals(integrands, end, [&pair[0], &pair[1]]));
                panels.push(Panel { end, sines: [pair[0].clone(), pair[1].clone()], passed });
                passed = next;
            }
        }
        let (integrands, coarse) = (integrands.clone(), coarse.clone());
        Self { integrands, coarse, panels, whole: passed, arrives: upper.is_some() }
    }

    /// Integrals from u = e₁ to a place.
    pub fn passed(&self, end: TurningPoint, sine: &Precise) -> Integrals {
        let beyond = |panel: &Panel| match end {
            TurningPoint::Lower => panel.end == TurningPoint::Upper || panel.sines[0] > *sine,
            TurningPoint::Upper => panel.end == TurningPoint::Upper && panel.sines[0] < *sine,
        };
        let panel = self.panel(beyond);
        add(&panel.passed, &integrals(&self.integrands, end, [&panel.sines[0], sine]))
    }

    /// Half phase at a time after u = e₁, and the integrals there. Beyond the last panel of an aperiodic motion, where |β| is below 1e-24,
    /// α turns at a constant rate.
    pub fn at(&self, time: &Precise) -> (TurningPoint, Precise, Integrals) {
        const NEWTON_STEPS: u32 = 4;
        /// Difference whose square is far below the errors that the truth is compared with, also in differences of neighbouring launches.
        const NEAR: f64 = 1e-18;
        let Panel { end, sines, passed } = self.panel(|panel| panel.passed[0] > *time);
        if !self.arrives && *time > self.whole[0] {
            let resting = time - &self.whole[0];
            let alpha = &self.whole[1] + &self.integrands.momenta[0] * (resting >> 1);
            return (*end, sines[1].clone(), [time.clone(), alpha, self.whole[2].clone()]);
        }
        let mut sine = precise(self.guess(*end, sines.each_ref().map(to_f64), to_f64(&(time - &passed[0]))));
        let mut steps = 0;
        loop {
            let [there, alpha, beta] = add(passed, &integrals(&self.integrands, *end, [&sines[0], &sine]));
            let [slowness, alpha_rate, beta_rate] = self.integrands.rates(*end, &sine);
            let step = (time - there) / slowness;
            let moved = forward(*end, step.clone());
            steps += 1;
            // the rest is so short that the integrals are linear on it
            if to_f64(&step).abs() <= NEAR * to_f64(&sine) || steps == NEWTON_STEPS {
                let passed = [time.clone(), alpha + alpha_rate * &step, beta + beta_rate * step];
                return (*end, sine + moved, passed);
            }
            sine += moved;
        }
    }

    /// Sine at a time after the beginning of a panel, by Newton's method in `f64`, with bisection where a step leaves the bracket.
    fn guess(&self, end: TurningPoint, [first, last]: [f64; 2], time: f64) -> f64 {
        const STEPS: u32 = 100;
        let (mut before, mut after) = (first, last);
        let mut sine = 0.5 * (first + last);
        for _ in 0..STEPS {
            let behind = time - integrals(&self.coarse, end, [&first, &sine])[0];
            *if behind > 0.0 { &mut before } else { &mut after } = sine;
            let next = sine + forward(end, behind / self.coarse.rates(end, &sine)[0]);
            let inside = (next - before) * (next - after) <= 0.0;
            let next = if inside { next } else { 0.5 * (before + after) };
            let step = next - sine;
            sine = next;
            if step.abs() <= 1e-15 * sine {
                break;
            }
        }
        sine
    }

    /// Last panel before the first one that is beyond a place.
    fn panel(&self, beyond: impl Fn(&Panel) -> bool) -> &Panel {
        let count = self.panels.partition_point(|panel| !beyond(panel));
        &self.panels[count.saturating_sub(1)]
    }
}

/// Sines at the ends of the panels of one turning point, from √½ to 0, or to the last panel if the turning point is never reached.
fn edges(depth: Option<f64>, finer: usize) -> Vec<Precise> {
    let halfway = precise(0.5).sqrt();
    let panels = depth.map_or(TOWARDS_THE_POLE, |depth| {
        (0.5 * (to_f64(&halfway) / (2.0 * depth)).log2()).ceil().max(0.0) as usize + finer
    });
    let shorter = std::iter::successors(Some(halfway), |edge| Some(edge.clone() >> 2)).take(panels + 1);
    shorter.chain(depth.map(|_| whole(0))).collect()
}

/// Integrals between two places of a panel.
fn integrals<R: Number>(integrands: &Integrands<R>, end: TurningPoint, sines: [&R; 2]) -> [R; 3] {
    integrate(sines, |sine| integrands.rates(end, sine)).map(|integral| forward(end, integral))
}

/// Change along the half period of a change of the sine: near u = e₂ the sine falls.
fn forward<R: Number>(end: TurningPoint, change: R) -> R {
    if end == TurningPoint::Lower { change } else { R::from(0) - change }
}

fn add(a: &Integrals, b: &Integrals) -> Integrals {
    [0, 1, 2].map(|i| &a[i] + &b[i])
}
