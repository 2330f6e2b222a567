//! Motion whose period is integrated once, and the ticks of its table.

use crate::equations::dot;
use core::f64::consts::PI;
use core::ops::Deref;
use toytop::scalar::Float;
use toytop::{Motion, PeriodAdvance, Regime, Tick};

/// Greatest distance of a time from t = 0, ticks. A tick that is given by its number may be any one of 64 bits.
pub const MAX_TICKS: f64 = (1_u64 << 62) as f64;

/// Motion with its period, which is integrated once.
#[derive(Clone, Copy)]
pub struct MotionWithPeriod {
    motion: Motion,
    advance: Option<PeriodAdvance>,
}

impl MotionWithPeriod {
    /// Motion with its period, which is integrated here.
    pub fn new(motion: Motion) -> Self {
        Self { motion, advance: motion.period_advance() }
    }

    /// Period and advances, as [`Motion::period_advance`] computes them.
    pub fn advance(&self) -> Option<PeriodAdvance> {
        self.advance
    }

    /// Period, s; NaN where there is none.
    pub fn period(&self) -> f64 {
        self.advance.map_or(f64::NAN, |advance| advance.period)
    }

    /// Nutation period of a motion that nutates, T₀ of any other, s.
    pub fn characteristic_time(&self) -> f64 {
        match self.advance {
            Some(advance) if self.regime() == Regime::Nutating => advance.period,
            _ => natural_time(self),
        }
    }

    /// Ticks in a unit of time, a power of two: at least a thousand in a period, and more than one in a turn.
    pub fn ticks_per_time(&self) -> f64 {
        /// A [`Tick`] has 32 bits on both sides.
        const MOST: f64 = (1_u32 << 31) as f64;
        let omega = self.attitude_at_launch().omega();
        let fastest = Float::sqrt(dot(omega, omega)).max(1000.0 / self.characteristic_time());
        let mut rate = MOST.recip();
        while rate < fastest.min(MOST) {
            rate *= 2.0;
        }
        rate
    }

    /// Greatest distance of a time from t = 0, s.
    pub fn furthest_time(&self) -> f64 {
        MAX_TICKS / self.ticks_per_time()
    }

    /// Greatest distance from t = 0 at which a closed form is evaluated, s. Where e₃ = e₄ holds up to rounding, its error grows by up to
    /// 5e-14 rad in a period.
    pub fn furthest_time_of_closed_form(&self) -> f64 {
        1e12 * self.characteristic_time()
    }

    /// Tick of this rate.
    pub fn tick(&self) -> Tick {
        let rate = self.ticks_per_time();
        let tick = if rate >= 1.0 { Tick::hertz(rate as u32) } else { Tick::ratio(1, rate.recip() as u32) };
        tick.expect("a power of two from 2^-31 to 2^31")
    }

    /// Advance of an angle in a period; exactly 0 if l = n = 0, where the axis stays in a vertical plane.
    pub(crate) fn advance_of(&self, angle: fn(&PeriodAdvance) -> f64) -> f64 {
        let integrals = self.first_integrals();
        match self.advance {
            Some(_) if integrals.l == 0.0 && integrals.n == 0.0 => 0.0,
            advance => advance.as_ref().map_or(f64::NAN, angle),
        }
    }

    /// Advance of the tip angle in a period, rad; NaN where the axis is vertical.
    pub fn phi_per_period(&self) -> f64 {
        if self.regime().is_vertical() { f64::NAN } else { self.advance_of(|advance| advance.phi_radians) }
    }
}

impl Deref for MotionWithPeriod {
    type Target = Motion;

    fn deref(&self) -> &Motion {
        &self.motion
    }
}

/// Natural time T₀ = 2π √((A/p + s)/g) of the top for motions that have no period, s. Without torque it is the time in which
/// the axis turns once about the angular momentum, and 1 for a body at rest.
pub(crate) fn natural_time(motion: &MotionWithPeriod) -> f64 {
    let top = motion.top();
    if top.is_torque_free() {
        return motion.advance.map_or(1.0, |advance| advance.period);
    }
    let length = top.transverse_inertia() / top.mass_moment() + top.com_height();
    2.0 * PI * Float::sqrt(length / top.gravity())
}
