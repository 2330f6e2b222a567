//! Launch of a motion: its constants and its start, from a state or from branch points.

use core::task::Poll;

use crate::complex::Complex;
use crate::constants::{
    BranchPoints, Conditioning, FirstIntegrals, LowerPair, MovingAxis, ReducedPoint, Regime, Roots, Signs,
};
use crate::error::{ParameterError, finite, require};
use crate::mean_motion::{Integrals, MeanMotion, Quadrature};
use crate::motion::start::{chi, half_phase, half_turns, slow_phase};
use crate::motion::{Motion, NutationVariable, Start};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring, Scalar};
use crate::state::State;
use crate::su2::OrientationRate;
use crate::top::{Quantities, Top};

/// Launch of a motion from a state, in slices of bounded work: see [`SetUp`](crate::SetUp), which does the same for the
/// ephemeris. [`Motion::launch`] is a loop over them. Most of the work is the quadrature of the period, whose number of slices
/// depends on the motion: 9 nodes for a fast top, 33 for a slow one, some 160 where e₃ - e₂ is 1e-15. It grows with the logarithm of
/// e₃ - e₂ alone.
///
/// ```
/// use toytop::{Launch, Motion, Release, State, Top, TopParameters};
/// # let top = Top::sliding(&TopParameters {
/// #     transverse_inertia: 3.0e-5,
/// #     axial_inertia: 2.0e-5,
/// #     com_height: 0.03,
/// #     mass: 0.05,
/// #     ..TopParameters::default()
/// # })?;
/// # let state = State::release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() })?;
/// let mut launch = Launch::new(&top, &state);
/// let motion = loop {
///     if let core::task::Poll::Ready(motion) = launch.poll() {
///         break motion?;
///     }
///     // feed the watchdog
/// };
/// assert_eq!(motion, Motion::launch(&top, &state)?);
/// # Ok::<(), toytop::ParameterError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Launch {
    top: Top,
    state: State,
    stage: Stage,
    integrals: FirstIntegrals<Extended>,
    point: ReducedPoint<Extended>,
    quadrature: Option<Quadrature>,
    /// Motion so far, once its branch points are known.
    motion: Option<Motion>,
}

/// Stage of a launch.
#[derive(Clone, Copy, Debug)]
enum Stage {
    /// Axis and angular velocity.
    Axis,
    /// First integrals, and the point of the reduced curve.
    Integrals(MovingAxis<Extended>),
    /// Branch points and regime, or the lower two branch points only.
    BranchPoints,
    /// The other branch points, and the regime.
    UpperPair(LowerPair<Extended>),
    /// Rounding errors of the constants, and the mean motion if it needs no quadrature.
    Conditioning,
    /// Beginning of the quadrature.
    Quadrature,
    /// Nodes of the quadrature.
    Nodes,
    /// Mean motion, from the integrals over a period.
    Mean(Integrals),
    /// Nutation variable at t = 0.
    Nutation,
    /// Rates of α and β at t = 0.
    StartRates,
    /// Slow phases at t = 0, from α and β and their rates.
    SlowPhases([[Complex<f64>; 2]; 2]),
    /// Nothing, because the state has no motion, or the motion is complete.
    Ended(Result<(), ParameterError>),
}

impl Launch {
    /// Launch of a motion from a state. The numbers of the state count as exact.
    #[must_use]
    pub fn new(top: &Top, state: &State) -> Self {
        Self {
            top: *top,
            state: *state,
            stage: Stage::Axis,
            integrals: FirstIntegrals::ZERO,
            point: ReducedPoint::ZERO,
            quadrature: None,
            motion: None,
        }
    }

    /// Does the next slice of the work. Calls after the result change nothing and return it again.
    ///
    /// # Errors
    /// See [`Motion::launch`].
    #[inline(never)]
    pub fn poll(&mut self) -> Poll<Result<Motion, ParameterError>> {
        match (self.stage, &self.motion) {
            (Stage::Ended(Ok(())), Some(motion)) => return Poll::Ready(Ok(*motion)),
            (Stage::Ended(Err(error)), _) => return Poll::Ready(Err(error)),
            _ => self.proceed(),
        }
        Poll::Pending
    }

    /// Nutation period, and the rotations about the vertical and about the axis in it, without the start of the motion.
    pub(crate) fn turns_in_period(&mut self) -> Option<(f64, [Phase; 2])> {
        while !matches!(self.stage, Stage::Nutation | Stage::Ended(_)) {
            self.proceed();
        }
        self.motion.as_ref().and_then(Motion::turns_in_period)
    }

    /// Does the next slice of the work, if there is one left.
    #[inline(never)]
    fn proceed(&mut self) {
        match (self.stage, &mut self.motion) {
            (Stage::Axis, _) => self.stage = Stage::Integrals(MovingAxis::of(&self.state)),
            (Stage::Integrals(axis), _) => {
                (self.integrals, self.point) = FirstIntegrals::with_point(&self.top, &axis);
                self.stage = Stage::BranchPoints;
            }
            (Stage::BranchPoints, _) => self.begin_branch_points(),
            (Stage::UpperPair(pair), _) => {
                self.end_branch_points(BranchPoints::complete(&pair, &self.integrals, &self.point));
            }
            (Stage::Conditioning, Some(_)) => self.find_conditioning(),
            (Stage::Quadrature, Some(_)) => self.begin_quadrature(),
            (Stage::Nodes, Some(_)) => {
                // without a quadrature the motion has no period
                let Some(quadrature) = &mut self.quadrature else { return self.stage = Stage::Nutation };
                if let Some(integrals) = quadrature.proceed() {
                    self.stage = Stage::Mean(integrals);
                }
            }
            (Stage::Mean(integrals), Some(motion)) => {
                motion.mean = Some(motion.mean_of(&integrals));
                self.stage = Stage::Nutation;
            }
            (Stage::Nutation, Some(motion)) => {
                motion.start_nutation(&self.point);
                self.stage = Stage::StartRates;
            }
            (Stage::StartRates, Some(_)) => self.stage = Stage::SlowPhases(parameters_and_rates(&self.state)),
            (Stage::SlowPhases(parameters), Some(motion)) => {
                motion.start_slow_phases(parameters);
                self.stage = Stage::Ended(Ok(()));
            }
            (Stage::Ended(_), _) => {}
            // no stage after the branch points is without a motion
            (_, None) => self.stage = Stage::Axis,
        }
    }

    #[inline(never)] // the stack frames of the stages must not add up
    fn begin_branch_points(&mut self) {
        match BranchPoints::begin(&self.top, &self.integrals, &self.point) {
            Ok(Roots::LowerPair(pair)) => self.stage = Stage::UpperPair(pair),
            Ok(Roots::All(e)) => self.end_branch_points(Ok(e)),
            Err(error) => self.end_branch_points(Err(error)),
        }
    }

    fn end_branch_points(&mut self, branch_points: Result<BranchPoints<Extended>, ParameterError>) {
        match branch_points {
            Ok(e) => {
                self.motion = Some(Motion::with_constants(&self.top, &self.integrals, &self.point, e));
                self.stage = Stage::Conditioning;
            }
            Err(error) => self.stage = Stage::Ended(Err(error)),
        }
    }

    #[inline(never)]
    fn find_conditioning(&mut self) {
        let Self { top, state, integrals, point, motion: Some(motion), .. } = self else { return };
        motion.conditioning = Conditioning::of_state(top, integrals, point, &motion.e, state.speed());
        motion.mean = motion.uniform_mean(point, integrals);
        let needs_quadrature = motion.mean.is_none() && motion.has_period();
        self.stage = if needs_quadrature { Stage::Quadrature } else { Stage::Nutation };
    }

    #[inline(never)]
    fn begin_quadrature(&mut self) {
        let Some(motion) = &self.motion else { return };
        self.quadrature = Some(Quadrature::new(&motion.law()));
        self.stage = Stage::Nodes;
    }
}

impl Motion {
    /// Motion from a state. The numbers of the state count as exact. Set-up computes in extended precision, so the stored
    /// constants have the error of one `f64` rounding. [`Launch`] does the same in slices.
    ///
    /// # Errors
    /// `omega`: so large that e₃ would exceed 1e14.
    pub fn launch(top: &Top, state: &State) -> Result<Self, ParameterError> {
        let mut launch = Launch::new(top, state);
        loop {
            if let Poll::Ready(result) = launch.poll() {
                return result;
            }
        }
    }

    /// Nutation period, and the rotations about the vertical and about the axis in it.
    pub(crate) fn turns_in_period(&self) -> Option<(f64, [Phase; 2])> {
        let mean = self.mean_motion()?;
        Some((mean.advance.period.to_f64(), mean.turns(self.half_tau())))
    }

    /// Motion through a point of the reduced curve, without its mean motion and its start.
    fn with_constants(
        top: &Top,
        integrals: &FirstIntegrals<Extended>,
        point: &ReducedPoint<Extended>,
        e: BranchPoints<Extended>,
    ) -> Self {
        let signs = integrals.signs();
        Self {
            top: *top,
            signs,
            e,
            integrals: *integrals,
            regime: Regime::of(&e, signs, point.rests_upright()),
            nutation: NutationVariable::Nutating(Phase::ZERO),
            phases: [Phase::ZERO; 2],
            conditioning: Conditioning::default(),
            mean: None,
        }
    }

    /// Nutation variable at a point of the reduced curve.
    #[inline(never)] // the stack frames of set-up must not add up
    fn start_nutation(&mut self, point: &ReducedPoint<Extended>) {
        if self.stands_still() {
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
            NutationVariable::Aperiodic(libm::asinh(sine / cosine))
        } else {
            NutationVariable::Nutating(chi(sine, cosine))
        };
    }

    /// Slow phases at a state, whose nutation variable is known.
    #[inline(never)]
    fn start_slow_phases(&mut self, [alpha, beta]: [[Complex<f64>; 2]; 2]) {
        if self.is_steady() {
            self.phases = [alpha, beta].map(|[z, _]| Phase::from_radians(z.arg()));
            return;
        }
        let directions = self.directions_at_start();
        let mut rates = self.law().cast().rates(directions.sine, directions.cosine);
        let half_tau = self.half_tau().to_f64();
        (rates.alpha, rates.beta) = (rates.alpha + half_tau, rates.beta - half_tau);
        let brackets = self.brackets();
        self.phases = [
            slow_phase(&brackets.alpha, &directions, [rates.nutation, rates.alpha], alpha),
            slow_phase(&brackets.beta, &directions, [rates.nutation, rates.beta], beta),
        ];
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

    /// Whether the nutation has a period, which a quadrature tells.
    fn has_period(&self) -> bool {
        !self.top.is_torque_free() && self.e.e3_minus_e2 > Extended::ZERO
    }

    fn computed_mean(&self) -> Option<MeanMotion> {
        self.has_period().then(|| {
            let mut quadrature = Quadrature::new(&self.law());
            loop {
                if let Some(integrals) = quadrature.proceed() {
                    return self.mean_of(&integrals);
                }
            }
        })
    }

    fn mean_of(&self, integrals: &Integrals) -> MeanMotion {
        MeanMotion::of(integrals, &self.e, self.signs, self.half_tau())
    }

    /// Mean motion without torque: the axis goes round the angular momentum m at the rate |m|/A. `None` with a torque, and for
    /// m = 0.
    fn uniform_mean(
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

/// Parameters α and β of a state, each with its rate.
#[inline(never)]
fn parameters_and_rates(state: &State) -> [[Complex<f64>; 2]; 2] {
    let (phi, omega) = state.exact::<Extended>();
    let phi = phi.normalised();
    let rate = OrientationRate::from_fixed(&phi, omega);
    [(phi.alpha, rate.alpha), (phi.beta, rate.beta)].map(|(z, z_dot)| [z, z_dot].map(to_f64))
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
