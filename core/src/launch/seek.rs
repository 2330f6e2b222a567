//! Where a motion starts on the half period that an ephemeris tabulates.

use super::Motion;
use super::motion::Course;
use super::rates::rise_time;
use crate::nutation::gudermannian;
use crate::nutation::series::Expansion;
use crate::real::{Float, Scalar};
use crate::turns::Turns;

/// What the march through the half period looks for.
pub(super) struct Seek {
    /// sin and cos of the half phase, folded into [0, 1/4] turn.
    sine: f64,
    cosine: f64,
    /// Whether it starts on the falling half.
    mirrored: bool,
    /// Half turns of χ that were folded away.
    folded: i64,
    /// The phase of a start above the end of the march, where u = 1 to rounding.
    beyond: Option<f64>,
}

impl Seek {
    pub(super) fn new(motion: &Motion, half_period: f64) -> Self {
        match motion.course() {
            Course::Aperiodic(v) => {
                let (sine, cosine) = gudermannian(Float::abs(v));
                let phase = rise_time(&motion.law().cast(), Float::abs(v)) / (2.0 * half_period);
                let beyond = (phase > 0.5).then_some(phase);
                Self { sine, cosine, mirrored: v < 0.0, folded: 0, beyond }
            }
            Course::Nutating(chi) => {
                let (folded, rest) = chi.halves();
                let mirrored = rest > Turns::QUARTER;
                let (folded, rest) = if mirrored { (folded + 1, Turns::HALF - rest) } else { (folded, rest) };
                let (sine, cosine) = f64::sine_cosine(rest);
                Self { sine, cosine, mirrored, folded, beyond: None }
            }
            Course::Steady(_) => Self { sine: 0.0, cosine: 1.0, mirrored: false, folded: 0, beyond: None },
        }
    }

    /// The x of the start, if it lies in this segment (or the segment is the last).
    pub(super) fn within(&self, expansion: &Expansion, last: bool) -> Option<f64> {
        // sin(χ - χ₀) as a series
        let (mut ahead, cosine) = (*expansion.sine.coefficients(), expansion.cosine.coefficients());
        ahead.iter_mut().zip(cosine).for_each(|(s, c)| *s = *s * self.cosine - c * self.sine);
        let value = |x: f64| ahead.iter().rev().fold((0.0, 0.0), |(f, slope), c| (f * x + c, slope * x + f));
        if value(1.0).0 < 0.0 && !last {
            return None;
        }
        const NEWTON_STEPS: usize = 8;
        Some((0..NEWTON_STEPS).fold(0.0, |x: f64, _| {
            let (f, slope) = value(x);
            if slope > 0.0 { (x - f / slope).clamp(-1.0, 1.0) } else { x }
        }))
    }

    /// Nutation phase and mean slow phases at t = 0, from the phase and θ found on the half period.
    pub(super) fn start(&self, motion: &Motion, phase: f64, theta: [Turns; 2]) -> [Turns; 3] {
        let [alpha, beta] = motion.phases();
        let sense = if self.mirrored { -1.0 } else { 1.0 };
        let phase = self.beyond.unwrap_or(phase);
        let half_turns = Turns::HALF.times(self.folded);
        let [alpha_theta, beta_theta] = theta.map(|theta| if self.mirrored { -theta } else { theta });
        [Turns::new(sense * phase), alpha + half_turns - alpha_theta, beta + half_turns - beta_theta]
    }
}
