//! Launch of a motion: its constants and its start, from a state or from branch points.

use crate::complex::Complex;
use crate::constants::{BranchPoints, Conditioning, FirstIntegrals, Regime, Signs};
use crate::error::{ParameterError, finite, require};
use crate::mean_motion::MeanMotion;
use crate::motion::start::{chi, half_phase, half_turns, slow_phase};
use crate::motion::{Motion, NutationVariable, Start};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring, Scalar};
use crate::state::State;
use crate::su2::OrientationRate;
use crate::top::{Quantities, Top};

impl Motion {
    /// Motion from a state. The numbers of the state count as exact. Set-up computes in extended precision, so the stored
    /// constants have the error of one `f64` rounding.
    ///
    /// # Errors
    /// `omega`: so large that e₃ would exceed 1e14.
    pub fn launch(top: &Top, state: &State) -> Result<Self, ParameterError> {
        let (integrals, point) = FirstIntegrals::with_point(top, state);
        let signs = integrals.signs();
        let e = BranchPoints::of_point(top, &integrals, &point)?;
        let regime = Regime::of(&e, signs, point.rests_upright());

        let (phi, omega) = state.exact::<Extended>();
        let phi = phi.normalised();
        let rate = OrientationRate::from_fixed(&phi, omega);
        let [alpha, beta] =
            [(phi.alpha, rate.alpha), (phi.beta, rate.beta)].map(|(z, z_dot)| [z, z_dot].map(to_f64));
        let mut motion = Self {
            top: *top,
            signs,
            e,
            integrals,
            regime,
            nutation: NutationVariable::Nutating(Phase::ZERO),
            phases: [Phase::ZERO; 2],
            conditioning: Conditioning::of_state(top, &integrals, &point, &e, state.speed()),
            mean: None,
        };
        let momentum = point.momentum(motion.quantities().a, integrals.n);
        motion.mean =
            if top.is_torque_free() { motion.uniform_mean(momentum) } else { motion.computed_mean() };
        if motion.stands_still() {
            motion.nutation = motion.steady_nutation();
            motion.phases = [alpha, beta].map(|[z, _]| Phase::from_radians(z.arg()));
            return Ok(motion);
        }
        let Quantities { a, s, p, g, .. } = motion.quantities();
        let pair = if top.is_torque_free() {
            [(a * point.udot / momentum).squared(), Extended::ONE]
        } else {
            let d = a / p + s * point.one_minus_u * point.one_plus_u;
            [d * point.udot.squared() / g.doubled(), point.one_minus_u + e.e3_minus_one]
        };
        let (sine, cosine) = half_phase(&e, &point, pair, regime == Regime::Aperiodic);
        motion.nutation = if regime == Regime::Aperiodic {
            NutationVariable::Aperiodic(libm::asinh(sine / cosine))
        } else {
            NutationVariable::Nutating(chi(sine, cosine))
        };
        let directions = motion.directions_at_start();
        let mut rates = motion.law().cast().rates(directions.sine, directions.cosine);
        let half_tau = motion.half_tau().to_f64();
        (rates.alpha, rates.beta) = (rates.alpha + half_tau, rates.beta - half_tau);
        let brackets = motion.brackets();
        motion.phases = [
            slow_phase(&brackets.alpha, &directions, [rates.nutation, rates.alpha], alpha),
            slow_phase(&brackets.beta, &directions, [rates.nutation, rates.beta], beta),
        ];
        Ok(motion)
    }

    /// Motion from branch points -1 <= e₁ <= e₂ <= 1 <= e₃ (which count as exact), the signs of l + n and l - n, and
    /// the phases at t = 0.
    ///
    /// # Errors
    /// `e1`, `e2`, `e3`: not finite or not in this order; `nutation_phase`, `arg_alpha`, `arg_beta`: not finite or
    /// beyond ±1e6 rad; `e3` also where no torque acts, because branch points then tell no rate, and where the axial rate
    /// (n - K)/C exceeds 1e24 per unit of time, or C = 0 and the branch points do not have n = K.
    pub fn from_branch_points(
        top: &Top,
        e: [f64; 3],
        signs: Signs,
        start: &Start,
    ) -> Result<Self, ParameterError> {
        require(
            !top.is_torque_free(),
            "e3",
            "left out without torque, where it is infinite and branch points tell no rate: give a state or a release",
        )?;
        let [e1, e2, e3] = e;
        let e = BranchPoints::exact(e1, e2, e3)?;
        let Start { theta, arg_alpha, arg_beta } = *start;
        for (name, angle) in [("theta", theta), ("arg_alpha", arg_alpha), ("arg_beta", arg_beta)] {
            finite(name, angle)?;
            require(Float::abs(angle) <= 1e6, name, "between -1e6 and 1e6 rad")?;
        }
        let integrals = e.integrals_in(top, signs);
        require(
            has_axial_rate(top, &integrals),
            "e3",
            "such that (n - rotor_momentum)/axial_inertia is at most 1e24 rad/s, and n = rotor_momentum for a rod",
        )?;
        let chi = half_turns(theta);
        let upright = chi.halves().1 == Phase::QUARTER;
        let regime = Regime::of(&e, signs, upright);
        let given = [arg_alpha, arg_beta].map(|angle| Extended::from(angle).in_turns().to_phase());
        let mut motion = Self {
            top: *top,
            signs,
            e,
            integrals,
            regime,
            nutation: NutationVariable::Nutating(chi),
            phases: given,
            conditioning: Conditioning::default(),
            mean: None,
        };
        motion.mean = motion.computed_mean();
        if motion.stands_still() {
            motion.nutation = motion.steady_nutation();
            return Ok(motion);
        }
        if regime == Regime::Aperiodic {
            let (sine, cosine) = f64::sine_cosine(chi);
            motion.nutation = NutationVariable::Aperiodic(libm::asinh(sine / cosine));
        }
        let directions = motion.directions_at_start();
        let brackets = motion.brackets();
        let [alpha, beta] = given;
        motion.phases =
            [alpha - brackets.alpha.argument(&directions), beta - brackets.beta.argument(&directions)];
        Ok(motion)
    }

    fn computed_mean(&self) -> Option<MeanMotion> {
        let has_period = self.e.e3_minus_e2 > Extended::ZERO;
        has_period.then(|| MeanMotion::of(&self.law(), &self.e, self.signs, self.half_tau()))
    }

    /// Mean motion without torque: the axis goes round the angular momentum, of this magnitude, at the rate |m|/A.
    fn uniform_mean(&self, momentum: Extended) -> Option<MeanMotion> {
        (momentum > Extended::ZERO).then(|| {
            let period = Extended::TWO_PI * self.quantities().a / momentum;
            MeanMotion::uniform(period, &self.e, self.signs, self.half_tau())
        })
    }
}

/// Whether the axial rate (n - K)/C is a number: within 1e24 per unit of time, and n = K to the rounding of `f64` where C
/// is 0.
fn has_axial_rate(top: &Top, integrals: &FirstIntegrals<Extended>) -> bool {
    const FASTEST: f64 = 1e24;
    let (FirstIntegrals { n, spin, .. }, Quantities { c, k, .. }) =
        (integrals, Quantities::<Extended>::of(top));
    let size = integrals.l_plus_n.abs() + integrals.l_minus_n.abs() + k.abs();
    let balanced = (*n - k).abs() <= size * Extended::from(f64::EPSILON);
    if c > Extended::ZERO { spin.abs() <= Extended::from(FASTEST) } else { balanced }
}

fn to_f64(z: Complex<Extended>) -> Complex<f64> {
    Complex::new(z.re.to_f64(), z.im.to_f64())
}
