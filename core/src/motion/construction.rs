//! Construction of a motion: its constants, and its start from a point or from branch points.

use crate::cayley_klein::Brackets;
use crate::complex::Complex;
use crate::constants::{BranchPoints, Conditioning, FirstIntegrals, ReducedPoint, Regime, Signs};
use crate::error::{ParameterError, finite, require};
use crate::law::{Law, inverse_gudermannian};
use crate::mean_motion::{Integrals, MeanMotion, Quadrature};
use crate::motion::start::{chi, half_phase, half_turns, slow_phase};
use crate::motion::{Motion, NutationVariable, Start, stands_still, steady_tilt};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, RateNumber, Ring, Scalar};
use crate::top::{Quantities, Top};

impl Motion {
    /// Motion through a point of the reduced curve, without its mean motion and its start.
    pub(super) fn with_constants(
        top: &Top,
        integrals: &FirstIntegrals<Extended>,
        point: &ReducedPoint<Extended>,
        e: BranchPoints<Extended>,
    ) -> Self {
        let signs = integrals.signs();
        let regime = Regime::of(&e, signs, point.rests_upright());
        Self {
            top: *top,
            signs,
            e,
            integrals: *integrals,
            half_tau: half_tau(top, integrals),
            brackets: brackets(&e, signs, regime),
            regime,
            nutation: NutationVariable::Nutating(Phase::ZERO),
            phases: [Phase::ZERO; 2],
            conditioning: Conditioning::default(),
            mean: None,
        }
    }

    /// Nutation variable at a point of the reduced curve.
    #[inline(never)] // the stack frames of set-up must not add up
    pub(super) fn start_nutation(&mut self, point: &ReducedPoint<Extended>) {
        if stands_still(&self.e, self.regime) {
            self.nutation = self.steady_nutation();
            return;
        }
        let Quantities { a, s, p, g, .. } = self.quantities();
        let pair = if self.top.is_torque_free() {
            let momentum = point.momentum(a, self.integrals.n);
            [(a * point.udot / momentum).squared(), Extended::ONE]
        } else {
            let d = a / p + s * point.one_minus_u * point.one_plus_u;
            [d * point.udot.squared() / g.doubled(), point.one_minus_u + self.e.e3_minus_one]
        };
        let (sine, cosine) = half_phase(&self.e, point, pair, self.regime == Regime::Aperiodic);
        self.nutation = if self.regime == Regime::Aperiodic {
            NutationVariable::Aperiodic(inverse_gudermannian(sine, cosine))
        } else {
            NutationVariable::Nutating(chi(sine, cosine))
        };
    }

    /// Slow phases at a state, whose nutation variable is known.
    ///
    /// * `law`: law of the motion, if it has been computed
    #[inline(never)]
    pub(super) fn start_slow_phases<N: RateNumber>(
        &mut self,
        [alpha, beta]: [[Complex<f64>; 2]; 2],
        law: Option<&Law<N>>,
    ) {
        if self.is_steady() {
            self.phases = [alpha, beta].map(|[z, _]| Phase::from_radians(z.arg()));
            return;
        }
        let directions = self.directions_at_start();
        let law = law.map_or_else(|| self.law::<N>().cast(), Law::cast);
        let mut rates = law.rates(directions.sine, directions.cosine);
        let half_tau = self.half_tau().to_f64();
        (rates.alpha, rates.beta) = (rates.alpha + half_tau, rates.beta - half_tau);
        let brackets = &self.brackets;
        self.phases = [
            slow_phase(&brackets.alpha, &directions, [rates.nutation, rates.alpha], alpha),
            slow_phase(&brackets.beta, &directions, [rates.nutation, rates.beta], beta),
        ];
    }

    /// Motion from branch points -1 <= e₁ <= e₂ <= 1 <= e₃ (which count as exact), the signs of l + n and l - n, and
    /// the phases at t = 0.
    ///
    /// # Errors
    /// `e1`, `e2`, `e3`: not finite or not in this order; `theta`, `arg_alpha`, `arg_beta`: not finite or beyond
    /// ±1e6 rad; `e3` also where no torque acts, because branch points then determine no rate, and where the axial rate
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
            half_tau: half_tau(top, &integrals),
            brackets: brackets(&e, signs, regime),
            regime,
            nutation: NutationVariable::Nutating(chi),
            phases: given,
            conditioning: Conditioning::default(),
            mean: None,
        };
        motion.mean = motion.computed_mean();
        if stands_still(&motion.e, motion.regime) {
            motion.nutation = motion.steady_nutation();
            return Ok(motion);
        }
        if regime == Regime::Aperiodic {
            let (sine, cosine) = f64::sine_cosine(chi);
            motion.nutation = NutationVariable::Aperiodic(inverse_gudermannian(sine, cosine));
        }
        let directions = motion.directions_at_start();
        let brackets = &motion.brackets;
        let [alpha, beta] = given;
        motion.phases =
            [alpha - brackets.alpha.argument(&directions), beta - brackets.beta.argument(&directions)];
        Ok(motion)
    }

    /// Whether the nutation has a period that a quadrature has to determine.
    pub(super) fn has_period(&self) -> bool {
        !self.top.is_torque_free() && self.e.e3_minus_e2 > Extended::ZERO
    }

    fn computed_mean(&self) -> Option<MeanMotion> {
        self.has_period().then(|| {
            let mut quadrature = Quadrature::<Extended>::NONE;
            quadrature.begin(&self.law());
            loop {
                if let Some(integrals) = quadrature.proceed() {
                    return self.mean_of(&integrals);
                }
            }
        })
    }

    pub(super) fn mean_of(&self, integrals: &Integrals) -> MeanMotion {
        MeanMotion::of(integrals, &self.e, self.signs, self.half_tau())
    }

    /// Mean motion without torque: the axis rotates about the angular momentum m at the rate |m|/A. `None` with a torque, and
    /// for m = 0.
    pub(super) fn uniform_mean(
        &self,
        point: &ReducedPoint<Extended>,
        integrals: &FirstIntegrals<Extended>,
    ) -> Option<MeanMotion> {
        let a = self.quantities().a;
        let momentum = point.momentum(a, integrals.n);
        (self.top.is_torque_free() && momentum > Extended::ZERO)
            .then(|| self.mean_of(&Integrals::uniform(Extended::TWO_PI * a / momentum)))
    }
}

fn brackets(e: &BranchPoints<Extended>, signs: Signs, regime: Regime) -> Brackets<f64> {
    if stands_still(e, regime) {
        let (one_plus_u, one_minus_u) = steady_tilt(e, regime);
        Brackets::steady(one_plus_u, one_minus_u)
    } else {
        Brackets::swinging(e, signs)
    }
}

/// Half of τ: see [`Motion::half_tau`].
fn half_tau(top: &Top, integrals: &FirstIntegrals<Extended>) -> Extended {
    Quantities::of(top).tau(integrals.spin).halved()
}

/// Whether the axial rate (n - K)/C is finite: within 1e24 per unit of time, and n = K to the rounding of `f64` where C
/// is 0.
fn has_axial_rate(top: &Top, integrals: &FirstIntegrals<Extended>) -> bool {
    const FASTEST: f64 = 1e24;
    let (FirstIntegrals { n, spin, .. }, Quantities { c, k, .. }) =
        (integrals, Quantities::<Extended>::of(top));
    let size = integrals.l_plus_n.abs() + integrals.l_minus_n.abs() + k.abs();
    let balanced = (*n - k).abs() <= size * Extended::from(f64::EPSILON);
    if c > Extended::ZERO { spin.abs() <= Extended::from(FASTEST) } else { balanced }
}
