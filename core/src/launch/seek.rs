//! Where a motion starts on the half period that an ephemeris tabulates.

use super::Motion;
use super::motion::Course;
use super::rates::rise_time;
use super::start::chi;
use crate::nutation::series::Expansion;
use crate::nutation::{Nutation, gudermannian};
use crate::real::{DoubleDouble, Float};
use crate::turns::Turns;

/// What the march through the half period looks for.
pub(super) struct Seek {
    /// The half phase, folded into [0, 1/4] turn.
    chi: Turns,
    /// Whether it starts on the falling half.
    mirrored: bool,
    /// Half turns of χ that were folded away.
    folded: i64,
    /// The phase of a start above the end of the march, where u = 1 to rounding.
    beyond: Option<Turns>,
}

impl Seek {
    pub(super) fn new(motion: &Motion, law: &Nutation<DoubleDouble>, half_period: f64) -> Self {
        match motion.course() {
            Course::Aperiodic(v) => {
                let (sine, cosine) = gudermannian(Float::abs(v));
                let phase = rise_time(&law.cast(), Float::abs(v)) / (2.0 * half_period);
                let beyond = (phase > 0.5).then_some(Turns::new(phase));
                Self { chi: chi(sine, cosine), mirrored: v < 0.0, folded: 0, beyond }
            }
            Course::Nutating(start) => {
                let (folded, rest) = start.halves();
                let mirrored = rest > Turns::QUARTER;
                let (folded, chi) = if mirrored { (folded + 1, Turns::HALF - rest) } else { (folded, rest) };
                Self { chi, mirrored, folded, beyond: None }
            }
            Course::Steady(_) => Self { chi: Turns::ZERO, mirrored: false, folded: 0, beyond: None },
        }
    }

    /// The x of the start, if it lies in this segment (or the segment is the last).
    pub(super) fn within(&self, expansion: &Expansion, last: bool) -> Option<f64> {
        let miss = |x: f64| (expansion.chi_at(x) - self.chi).to_radians();
        if miss(1.0) < 0.0 && !last {
            return None;
        }
        const NEWTON_STEPS: usize = 8;
        Some((0..NEWTON_STEPS).fold(0.0, |x: f64, _| {
            let slope = expansion.chi_slope(x);
            if slope > 0.0 { (x - miss(x) / slope).clamp(-1.0, 1.0) } else { x }
        }))
    }

    /// Nutation phase and mean slow phases at t = 0, from the phase and θ found on the half period.
    pub(super) fn start(&self, motion: &Motion, phase: Turns, theta: [Turns; 2]) -> [Turns; 3] {
        let [alpha, beta] = motion.phases();
        let mirror = |phase: Turns| if self.mirrored { -phase } else { phase };
        let phase = mirror(self.beyond.unwrap_or(phase));
        let half_turns = Turns::HALF.times(self.folded);
        let [alpha_theta, beta_theta] = theta.map(mirror);
        [phase, alpha + half_turns - alpha_theta, beta + half_turns - beta_theta]
    }
}
