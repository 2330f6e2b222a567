//! Constants of a motion by name, with their meanings, and words for its regime and its tip curve.

use crate::motion_with_period::{MotionWithPeriod, natural_time};
use crate::start::{axis_at_start, momentum};
use Unit::{Any, Si};
use core::f64::consts::PI;
use toytop::scalar::{Float, Real};
use toytop::{Level, Motion, Regime, TipClass};

/// Unit of a quantity.
#[derive(Clone, Copy)]
pub enum Unit {
    /// Unit with a mass, a length or a time, to which a scenario without units gives no name.
    Si(&'static str),
    /// Unit of an angle or a ratio, which every scenario has; empty for a number without unit.
    Any(&'static str),
}

impl Unit {
    /// Name in SI.
    pub fn name(self) -> &'static str {
        let (Self::Si(name) | Self::Any(name)) = self;
        name
    }
}

/// Constant of a motion.
#[derive(Clone, Copy)]
pub struct Constant {
    /// Key of its value.
    pub name: &'static str,
    /// Unit; in a scenario without units, s is the unit of time.
    pub unit: Unit,
    /// Definition, in words.
    pub meaning: &'static str,
    /// Function of the motion.
    pub value: Value,
}

/// Function of a motion whose value is a number.
pub type NumberOf = fn(&MotionWithPeriod) -> f64;

/// Value of a constant.
#[derive(Clone, Copy)]
pub enum Value {
    /// Number; NaN where the motion does not have it.
    Number(NumberOf),
    /// Word.
    Word(fn(&MotionWithPeriod) -> &'static str),
}

const fn number(name: &'static str, unit: Unit, meaning: &'static str, value: NumberOf) -> Constant {
    Constant { name, unit, meaning, value: Value::Number(value) }
}

const fn word(
    name: &'static str,
    meaning: &'static str,
    value: fn(&MotionWithPeriod) -> &'static str,
) -> Constant {
    Constant { name, unit: Any(""), meaning, value: Value::Word(value) }
}

/// Names and functions of all constants that are numbers, with the numbers of the top and of the start.
pub fn number_constants() -> impl Iterator<Item = (&'static str, NumberOf)> {
    let numbers = CONSTANTS.iter().filter_map(|constant| match constant.value {
        Value::Number(value) => Some((constant.name, value)),
        Value::Word(_) => None,
    });
    numbers.chain(NUMBERS_OF_TOP_AND_START)
}

/// Constants of a motion, as `toytop constants` prints them.
pub static CONSTANTS: [Constant; 28] = [
    number("l", Si("kg m^2/s"), "Angular momentum about the vertical", |motion| motion.first_integrals().l),
    number("n", Si("kg m^2/s"), "Angular momentum about the symmetry axis, C spin + K", |motion| {
        motion.first_integrals().n
    }),
    number(
        "h",
        Si("kg m^2/s^2"),
        "Energy; the potential energy is 0 where the centre of mass is at the height of the tip",
        |motion| motion.first_integrals().h,
    ),
    number("e1", Any(""), "Least cosine of the tilt", |motion| motion.branch_points().e1),
    number("e2", Any(""), "Greatest cosine of the tilt", |motion| motion.branch_points().e2),
    number(
        "e3",
        Any(""),
        "Third root, at least 1, of the cubic whose other roots are e1 and e2; infinite without torque",
        |motion| motion.branch_points().e3,
    ),
    number(
        "e4",
        Any(""),
        "Measure √(1 + A/(p s)) of the effect of the sliding tip; none for a held tip or a free body",
        |motion| motion.top().e4().unwrap_or(f64::NAN),
    ),
    number("one_plus_e1", Any(""), "Sum 1 + e1, without the rounding of e1", |motion| {
        motion.branch_points().one_plus_e1
    }),
    number("one_minus_e2", Any(""), "Difference 1 - e2, without the rounding of e2", |motion| {
        motion.branch_points().one_minus_e2
    }),
    number("e2_minus_e1", Any(""), "Difference e2 - e1, without the rounding of either", |motion| {
        motion.branch_points().e2_minus_e1
    }),
    number("e3_minus_e2", Any(""), "Difference e3 - e2, without the rounding of either", |motion| {
        motion.branch_points().e3_minus_e2
    }),
    number("e3_minus_one", Any(""), "Difference e3 - 1, without the rounding of e3", |motion| {
        motion.branch_points().e3_minus_one
    }),
    word(
        "regime",
        "Kind of motion: nutating, regular_precession, sleeping_stable, sleeping_unstable, hanging, aperiodic",
        |motion| regime(motion.regime()),
    ),
    number(
        "period",
        Si("s"),
        "Nutation period; where the tilt is constant, that of a small nutation; none where no motion nearby is periodic",
        |motion| motion.period(),
    ),
    number(
        "alpha_turns",
        Any("turns a period"),
        "Advance of the argument of the Cayley-Klein parameter α in a period, whole turns included",
        |motion| motion.advance_of(|advance| advance.alpha_turns),
    ),
    number(
        "beta_turns",
        Any("turns a period"),
        "Advance of the argument of the Cayley-Klein parameter β in a period, whole turns included",
        |motion| motion.advance_of(|advance| advance.beta_turns),
    ),
    number(
        "phi_per_period",
        Any("rad a period"),
        "Advance of the tip angle in a period; none where the axis is vertical",
        |motion| motion.phi_per_period(),
    ),
    word(
        "tip_class",
        "Class of the curve of the tip: smooth, cusp, loops, circle, through_origin, spiral, point",
        |motion| tip_class(motion.tip_class()),
    ),
    number(
        "min_normal_force",
        Any("weights"),
        "Least normal force of the plane, below 0 where a real top leaves it; none for a held tip or a free body",
        |motion| motion.min_normal_force().unwrap_or(f64::NAN),
    ),
    number(
        "min_tilt_deg",
        Any("degrees"),
        "Least tilt, the angle of the axis from the upward vertical",
        |motion| tilts(motion)[0],
    ),
    number("max_tilt_deg", Any("degrees"), "Greatest tilt", |motion| tilts(motion)[1]),
    number("nutation_hz", Si("1/s"), "Number of nutations in a second", |motion| 1.0 / motion.period()),
    number(
        "mean_precession_deg_per_s",
        Si("degrees/s"),
        "Mean rate of the axis about the vertical",
        |motion| 360.0 * mean_precession(motion),
    ),
    number("mean_precession_rpm", Si("turns/min"), "Mean rate of the axis about the vertical", |motion| {
        60.0 * mean_precession(motion)
    }),
    number("spin_deg_per_s", Si("degrees/s"), "Component of the angular velocity along the axis", |motion| {
        360.0 * spin(motion)
    }),
    number("spin_rpm", Si("turns/min"), "Component of the angular velocity along the axis", |motion| {
        60.0 * spin(motion)
    }),
    number(
        "critical_spin_deg_per_s",
        Si("degrees/s"),
        "Spin above which an upright top is stable, (2√(A p g) - K)/C",
        |motion| 360.0 * critical_spin(motion),
    ),
    number(
        "critical_spin_rpm",
        Si("turns/min"),
        "Spin above which an upright top is stable, (2√(A p g) - K)/C",
        |motion| 60.0 * critical_spin(motion),
    ),
];

/// Constants that only the page and Python print: numbers of the top and of the motion at t = 0.
static NUMBERS_OF_TOP_AND_START: [(&str, NumberOf); 20] = [
    // 0 sliding, 1 fixed, 2 free
    ("support", |motion| f64::from(motion.top().support() as u8)),
    ("A", |motion| motion.top().transverse_inertia()),
    ("C", |motion| motion.top().axial_inertia()),
    ("s", |motion| motion.top().com_height()),
    ("p", |motion| motion.top().mass_moment()),
    ("g", |motion| motion.top().gravity()),
    ("K", |motion| motion.top().rotor_momentum()),
    ("sign_l_plus_n", |motion| motion.signs().l_plus_n.as_i32().into()),
    ("sign_l_minus_n", |motion| motion.signs().l_minus_n.as_i32().into()),
    ("natural_time", |motion| natural_time(motion)),
    ("tilt", |motion| axis_at_start(motion)[0]),
    ("azimuth", |motion| axis_at_start(motion)[1]),
    ("spin", |motion| motion.first_integrals().spin),
    ("precession", |motion| axis_at_start(motion)[2]),
    ("nutation", |motion| axis_at_start(motion)[3]),
    ("critical_spin", |motion| 2.0 * PI * critical_spin(motion)),
    ("lift_off_u", |motion| Level::lift_off(motion).map_or(f64::NAN, |level| level.u())),
    ("m_x", |motion| momentum(motion)[0]),
    ("m_y", |motion| momentum(motion)[1]),
    ("m_z", |motion| momentum(motion)[2]),
];

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
fn mean_precession(motion: &MotionWithPeriod) -> f64 {
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
