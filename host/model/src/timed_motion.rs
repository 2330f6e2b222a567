//! Constants of a motion by name, words for its regime and its tip curve, and the ticks of its table.

use crate::equations::{cross, dot};
use core::array::from_fn;
use core::f64::consts::PI;
use core::ops::Deref;
use toytop::scalar::{Float, Real, Ring};
use toytop::{AttitudeState, Level, Motion, PeriodAdvance, Regime, Stepper, Tick, TipClass};

/// Constant of a motion.
#[derive(Clone, Copy)]
pub struct Constant {
    /// Key of its value.
    pub name: &'static str,
    /// Unit in SI; in a scenario without units, s is the unit of time.
    pub unit: &'static str,
    /// Function of the motion.
    pub value: Value,
}

/// Value of a constant.
#[derive(Clone, Copy)]
pub enum Value {
    /// Number; NaN where the motion does not have it.
    Number(fn(&TimedMotion) -> f64),
    /// Word.
    Word(fn(&TimedMotion) -> &'static str),
}

const fn number(name: &'static str, unit: &'static str, value: fn(&TimedMotion) -> f64) -> Constant {
    Constant { name, unit, value: Value::Number(value) }
}

const fn word(name: &'static str, value: fn(&TimedMotion) -> &'static str) -> Constant {
    Constant { name, unit: "", value: Value::Word(value) }
}

/// Names and functions of all constants that are numbers, with the numbers of the top and of the start.
pub fn number_constants() -> impl Iterator<Item = (&'static str, fn(&TimedMotion) -> f64)> {
    CONSTANTS.iter().chain(&TOP_AND_START).filter_map(|constant| match constant.value {
        Value::Number(value) => Some((constant.name, value)),
        Value::Word(_) => None,
    })
}

/// Constants of a motion, as `toytop constants` prints them.
pub static CONSTANTS: [Constant; 28] = [
    number("l", "kg m^2/s", |motion| motion.first_integrals().l),
    number("n", "kg m^2/s", |motion| motion.first_integrals().n),
    number("h", "kg m^2/s^2", |motion| motion.first_integrals().h),
    number("e1", "", |motion| motion.branch_points().e1),
    number("e2", "", |motion| motion.branch_points().e2),
    number("e3", "", |motion| motion.branch_points().e3),
    number("e4", "", |motion| motion.top().e4().unwrap_or(f64::NAN)),
    number("one_plus_e1", "", |motion| motion.branch_points().one_plus_e1),
    number("one_minus_e2", "", |motion| motion.branch_points().one_minus_e2),
    number("e2_minus_e1", "", |motion| motion.branch_points().e2_minus_e1),
    number("e3_minus_e2", "", |motion| motion.branch_points().e3_minus_e2),
    number("e3_minus_one", "", |motion| motion.branch_points().e3_minus_one),
    word("regime", |motion| regime(motion.regime())),
    number("period", "s", |motion| motion.period()),
    number("alpha_turns", "turns a period", |motion| motion.advance_of(|advance| advance.alpha_turns)),
    number("beta_turns", "turns a period", |motion| motion.advance_of(|advance| advance.beta_turns)),
    number("phi_per_period", "rad a period", |motion| motion.phi_per_period()),
    word("tip_class", |motion| tip_class(motion.tip_class())),
    number("min_normal_force", "weights", |motion| motion.min_normal_force().unwrap_or(f64::NAN)),
    number("min_tilt_deg", "degrees", |motion| tilts(motion)[0]),
    number("max_tilt_deg", "degrees", |motion| tilts(motion)[1]),
    number("nutation_hz", "1/s", |motion| 1.0 / motion.period()),
    number("mean_precession_deg_per_s", "degrees/s", |motion| 360.0 * mean_precession(motion)),
    number("mean_precession_rpm", "turns/min", |motion| 60.0 * mean_precession(motion)),
    number("spin_deg_per_s", "degrees/s", |motion| 360.0 * spin(motion)),
    number("spin_rpm", "turns/min", |motion| 60.0 * spin(motion)),
    number("critical_spin_deg_per_s", "degrees/s", |motion| 360.0 * critical_spin(motion)),
    number("critical_spin_rpm", "turns/min", |motion| 60.0 * critical_spin(motion)),
];

/// Numbers of the top and of the motion at t = 0.
static TOP_AND_START: [Constant; 20] = [
    // 0 sliding, 1 fixed, 2 free
    number("support", "", |motion| f64::from(motion.top().support() as u8)),
    number("A", "kg m^2", |motion| motion.top().transverse_inertia()),
    number("C", "kg m^2", |motion| motion.top().axial_inertia()),
    number("s", "m", |motion| motion.top().com_height()),
    number("p", "kg m", |motion| motion.top().mass_moment()),
    number("g", "m/s^2", |motion| motion.top().gravity()),
    number("K", "kg m^2/s", |motion| motion.top().rotor_momentum()),
    number("sign_l_plus_n", "", |motion| motion.signs().l_plus_n.as_i32().into()),
    number("sign_l_minus_n", "", |motion| motion.signs().l_minus_n.as_i32().into()),
    number("natural_time", "s", natural_time),
    number("tilt", "rad", |motion| axis_at_start(motion)[0]),
    number("azimuth", "rad", |motion| axis_at_start(motion)[1]),
    number("spin", "rad/s", |motion| motion.first_integrals().spin),
    number("precession", "rad/s", |motion| axis_at_start(motion)[2]),
    number("nutation", "rad/s", |motion| axis_at_start(motion)[3]),
    number("critical_spin", "rad/s", |motion| 2.0 * PI * critical_spin(motion)),
    number("lift_off_u", "", |motion| Level::lift_off(motion).map_or(f64::NAN, |level| level.u())),
    number("m_x", "kg m^2/s", |motion| momentum(motion)[0]),
    number("m_y", "kg m^2/s", |motion| momentum(motion)[1]),
    number("m_z", "kg m^2/s", |motion| momentum(motion)[2]),
];

/// Greatest number of ticks from t = 0 at which a table is evaluated. They are counted in 64 bits.
pub const MAX_TICKS: f64 = (1_u64 << 62) as f64;

/// Motion with its period, which is integrated once.
#[derive(Clone, Copy)]
pub struct TimedMotion {
    motion: Motion,
    advance: Option<PeriodAdvance>,
}

impl TimedMotion {
    /// Motion with its period, which is integrated here.
    pub fn new(motion: Motion) -> Self {
        Self { motion, advance: motion.period_advance() }
    }

    /// Period and advances, as [`Motion::period_advance`] computes them.
    pub fn period_advance(&self) -> Option<PeriodAdvance> {
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
        let omega = at_start(self).omega();
        let fastest = Float::sqrt(dot(omega, omega)).max(1000.0 / self.characteristic_time());
        let mut rate = MOST.recip();
        while rate < fastest.min(MOST) {
            rate *= 2.0;
        }
        rate
    }

    /// Greatest distance from t = 0 at which the table can be evaluated, s.
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
    fn advance_of(&self, angle: fn(&PeriodAdvance) -> f64) -> f64 {
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

impl Deref for TimedMotion {
    type Target = Motion;

    fn deref(&self) -> &Motion {
        &self.motion
    }
}

/// Least and greatest tilt of the axis, degrees.
pub fn tilts(motion: &Motion) -> [f64; 2] {
    let e = motion.branch_points();
    let tilt = |one_plus_e: f64, one_minus_e: f64| {
        2.0 * Real::atan2(Float::sqrt(one_minus_e), Float::sqrt(one_plus_e)).to_degrees()
    };
    match motion.regime() {
        Regime::Hanging => [180.0; 2],
        regime if regime.is_vertical() => [0.0; 2],
        _ => [tilt(2.0 - e.one_minus_e2, e.one_minus_e2), tilt(e.one_plus_e1, 2.0 - e.one_plus_e1)],
    }
}

/// Mean rate of the axis about the vertical, turns/s.
fn mean_precession(motion: &TimedMotion) -> f64 {
    motion.phi_per_period() / (2.0 * PI * motion.period())
}

/// Component of the angular velocity along the axis, turns/s.
fn spin(motion: &Motion) -> f64 {
    motion.first_integrals().spin / (2.0 * PI)
}

/// Spin above which an upright axis is stable, turns/s: there e₃ > 1, because n² > 4 A p g, where n = C spin + K.
fn critical_spin(motion: &Motion) -> f64 {
    let top = motion.top();
    let momentum = 2.0 * Float::sqrt(top.transverse_inertia() * top.mass_moment() * top.gravity())
        - top.rotor_momentum();
    momentum / top.axial_inertia() / (2.0 * PI)
}

/// Natural time T₀ = 2π √((A/p + s)/g) of the top for motions that have no period, s. Without torque it is the time in which
/// the axis turns once about the angular momentum, and 1 for a body at rest.
pub(crate) fn natural_time(motion: &TimedMotion) -> f64 {
    let top = motion.top();
    if top.is_torque_free() {
        return motion.period_advance().map_or(1.0, |advance| advance.period);
    }
    let length = top.transverse_inertia() / top.mass_moment() + top.com_height();
    2.0 * PI * Float::sqrt(length / top.gravity())
}

fn at_start(motion: &Motion) -> AttitudeState<f64> {
    Stepper::new(motion).attitude_state()
}

/// Tilt and azimuth of the axis at t = 0, rad, and their rates, rad/s. Where the axis is vertical, the azimuth rate is 0, and the tilt rate
/// is the speed at which the axis leaves the vertical.
fn axis_at_start(motion: &Motion) -> [f64; 4] {
    let state = at_start(motion);
    let (axis, u) = (state.orientation.axis(), state.orientation.u().clamp(-1.0, 1.0));
    let ([x, y, _], [rx, ry, rz]) = (axis, cross(state.omega(), axis));
    let level = Float::sqrt(x * x + y * y);
    let [precession, nutation] = if level > 0.0 {
        [(x * ry - y * rx) / level.squared(), (x * rx + y * ry) / level * u - rz * level]
    } else {
        [0.0, Float::sqrt(rx * rx + ry * ry)]
    };
    [Real::atan2(level, u), Real::atan2(y, x), precession, nutation]
}

/// Angular momentum m = A r × r' + n r of a body on which no torque acts, kg m²/s; NaN where one does.
fn momentum(motion: &Motion) -> [f64; 3] {
    if !motion.top().is_torque_free() {
        return [f64::NAN; 3];
    }
    let state = at_start(motion);
    let (r, n) = (state.orientation.axis(), motion.first_integrals().n);
    let swing = cross(r, cross(state.omega(), r));
    from_fn(|i| motion.top().transverse_inertia() * swing[i] + n * r[i])
}

/// Word for a regime: `nutating`, `regular_precession`, ...
pub fn regime(regime: Regime) -> &'static str {
    match regime {
        Regime::Nutating => "nutating",
        Regime::SlowPrecession | Regime::FastPrecession => "regular_precession",
        Regime::SleepingStable => "sleeping_stable",
        Regime::SleepingUnstable => "sleeping_unstable",
        Regime::Hanging => "hanging",
        Regime::Aperiodic => "aperiodic",
        _ => "unknown",
    }
}

/// Word for a class of tip curve: `smooth`, `cusp`, `loops`, ...
pub fn tip_class(class: TipClass) -> &'static str {
    match class {
        TipClass::Smooth => "smooth",
        TipClass::Cusp => "cusp",
        TipClass::Loops => "loops",
        TipClass::Circle => "circle",
        TipClass::ThroughOrigin => "through_origin",
        TipClass::Spiral => "spiral",
        TipClass::Point => "point",
        _ => "unknown",
    }
}
