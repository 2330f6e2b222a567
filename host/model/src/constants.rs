//! Constants of the motion by name, in the order in which the page receives them.

use crate::equations::cross;
use core::array::from_fn;
use core::cell::OnceCell;
use core::f64::consts::PI;
use core::ops::Deref;
use toytop::scalar::{Float, Real, Ring};
use toytop::{AttitudeState, Motion, PeriodAdvance, Regime, Stepper};

/// Constant by its name and its function; NaN where it does not exist.
pub type Constant = (&'static str, fn(&MotionConstants) -> f64);

/// Motion whose constants are asked for. Its period takes a quadrature, which runs once, and only if a constant needs it.
pub struct MotionConstants {
    motion: Motion,
    advance: OnceCell<Option<PeriodAdvance>>,
}

impl MotionConstants {
    /// Constants of a motion.
    pub fn new(motion: Motion) -> Self {
        Self { motion, advance: OnceCell::new() }
    }

    fn advance(&self) -> Option<PeriodAdvance> {
        *self.advance.get_or_init(|| self.period_advance())
    }

    /// Period, s; NaN where there is none.
    pub fn period(&self) -> f64 {
        self.advance().map_or(f64::NAN, |advance| advance.period)
    }

    /// Nutation period of a motion that nutates, T₀ of any other, s.
    pub fn nutation_period(&self) -> f64 {
        match self.advance() {
            Some(advance) if self.regime() == Regime::Nutating => advance.period,
            _ => natural_time(self),
        }
    }

    /// Advance of an angle in a period. It is exactly 0 where l = n = 0: the axis then stays in a vertical plane, and the arguments of α and β
    /// are constant, which quadratures reach only up to rounding.
    pub fn turning(&self, of: fn(&PeriodAdvance) -> f64) -> f64 {
        let integrals = self.first_integrals();
        match self.advance() {
            Some(_) if integrals.l == 0.0 && integrals.n == 0.0 => 0.0,
            advance => advance.as_ref().map_or(f64::NAN, of),
        }
    }
}

impl Deref for MotionConstants {
    type Target = Motion;

    fn deref(&self) -> &Motion {
        &self.motion
    }
}

/// All constants of a motion.
pub const CONSTANTS: [Constant; 34] = [
    // 0 sliding, 1 fixed, 2 free
    ("support", |motion| f64::from(motion.top().support() as u8)),
    ("A", |motion| motion.top().transverse_inertia()),
    ("C", |motion| motion.top().axial_inertia()),
    ("s", |motion| motion.top().com_height()),
    ("p", |motion| motion.top().mass_moment()),
    ("g", |motion| motion.top().gravity()),
    ("K", |motion| motion.top().rotor_momentum()),
    ("e1", |motion| motion.branch_points().e1),
    ("e2", |motion| motion.branch_points().e2),
    ("e3", |motion| motion.branch_points().e3),
    ("e4", |motion| motion.top().e4().unwrap_or(f64::NAN)),
    ("one_plus_e1", |motion| motion.branch_points().one_plus_e1),
    ("one_minus_e2", |motion| motion.branch_points().one_minus_e2),
    ("e2_minus_e1", |motion| motion.branch_points().e2_minus_e1),
    ("e3_minus_one", |motion| motion.branch_points().e3_minus_one),
    ("l", |motion| motion.first_integrals().l),
    ("n", |motion| motion.first_integrals().n),
    ("h", |motion| motion.first_integrals().h),
    ("sign_l_plus_n", |motion| motion.signs().l_plus_n.factor().into()),
    ("sign_l_minus_n", |motion| motion.signs().l_minus_n.factor().into()),
    ("period", |motion| motion.period()),
    ("alpha_turns", |motion| motion.turning(|advance| advance.alpha_turns)),
    ("beta_turns", |motion| motion.turning(|advance| advance.beta_turns)),
    ("phi_per_period", |motion| motion.turning(PeriodAdvance::phi_per_period)),
    ("min_normal_force", |motion| motion.min_normal_force().unwrap_or(f64::NAN)),
    ("natural_time", |motion| natural_time(motion)),
    ("tilt", |motion| axis_at_start(motion)[0]),
    ("azimuth", |motion| axis_at_start(motion)[1]),
    ("spin", |motion| motion.first_integrals().spin),
    ("precession", |motion| axis_at_start(motion)[2]),
    ("nutation", |motion| axis_at_start(motion)[3]),
    ("m_x", |motion| momentum(motion)[0]),
    ("m_y", |motion| momentum(motion)[1]),
    ("m_z", |motion| momentum(motion)[2]),
];

/// Natural time T₀ = 2π √((A/p + s)/g) of the top for motions that have no period, s. Without torque it is the time in which
/// the axis turns once about the angular momentum, and 1 for a body at rest.
pub fn natural_time(motion: &Motion) -> f64 {
    let top = motion.top();
    if top.is_torque_free() {
        return motion.period_advance().map_or(1.0, |advance| advance.period);
    }
    let length = top.transverse_inertia() / top.mass_moment() + top.com_height();
    2.0 * PI * Float::sqrt(length / top.gravity())
}

/// Nutation period of a motion that nutates, T₀ of any other, s.
pub fn period(motion: &Motion) -> f64 {
    MotionConstants::new(*motion).nutation_period()
}

fn at_start(motion: &Motion) -> AttitudeState<f64> {
    Stepper::new(motion).attitude_state()
}

/// Tilt and azimuth of the axis at t = 0, rad, and their rates, rad/s. Where the axis is vertical the azimuth
/// rate is 0, and the tilt rate is that of leaving the vertical.
fn axis_at_start(motion: &Motion) -> [f64; 4] {
    let state = at_start(motion);
    let ([x, y, _], [rx, ry, rz]) = (state.axis(), cross(state.omega(), state.axis()));
    let (level, u) = (Float::sqrt(x * x + y * y), state.u());
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
    let (r, n) = (state.axis(), motion.first_integrals().n);
    let swing = cross(r, cross(state.omega(), r));
    from_fn(|i| motion.top().transverse_inertia() * swing[i] + n * r[i])
}
