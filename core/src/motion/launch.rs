//! Launch of a motion from a state, in slices of bounded work.

use core::task::Poll;

use crate::complex::Complex;
use crate::constants::{
    BranchPoints, Conditioning, FirstIntegrals, LowerPair, LowerPairSearch, MovingAxis, ReducedPoint, Roots,
};
use crate::error::ParameterError;
use crate::mean_motion::{Integrals, Quadrature};
use crate::motion::Motion;
use crate::scalar::{Extended, RateNumber, Scalar};
use crate::state::State;
use crate::su2::OrientationRate;
use crate::top::Top;

/// Launch of a motion from a state, in slices of bounded work: see [`SetUp`](crate::SetUp), which does the same for the
/// ephemeris. (What a fit finds is a [`fit::Launch`](crate::fit::Launch).) [`Motion::launch`] runs all slices in a loop. Most of the work is
/// the quadrature of the period, whose number of nodes depends on the motion: 9 for a fast top, 33 for a slow one, some 190 where e₃ - e₂
/// is about 1e-18. For `f32` and fixed point ([`for_scalar`](Launch::for_scalar)) it is two thirds of this. The number grows with the
/// logarithm of the least difference between e₂ and a branch point beyond it.
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
pub struct Launch<R: Scalar = f64> {
    top: Top,
    state: State,
    stage: Stage,
    integrals: FirstIntegrals<Extended>,
    point: ReducedPoint<Extended>,
    quadrature: Quadrature<R::Rates>,
    /// Whether the motion needs the quadrature.
    has_quadrature: bool,
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
    /// Branch points and regime, or the cubic for the lower two branch points.
    BranchPoints,
    /// Search for the lower two branch points.
    LowerPair(LowerPairSearch<Extended>),
    /// The other branch points.
    UpperPair(LowerPair<Extended>),
    /// Regime, and the other constants.
    Constants(BranchPoints<Extended>),
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
    /// No work, because the state has no motion, or the motion is complete.
    Ended(Result<(), ParameterError>),
}

impl Launch {
    /// Launch of a motion from a state. The numbers of the state count as exact.
    #[must_use]
    pub fn new(top: &Top, state: &State) -> Self {
        Self::for_scalar(top, state)
    }
}

impl<R: Scalar> Launch<R> {
    /// Launch of a motion for ephemerides in a scalar: see [`Motion::launch_for`].
    #[must_use]
    pub fn for_scalar(top: &Top, state: &State) -> Self {
        Self {
            top: *top,
            state: *state,
            stage: Stage::Axis,
            integrals: FirstIntegrals::ZERO,
            point: ReducedPoint::ZERO,
            quadrature: Quadrature::NONE,
            has_quadrature: false,
            motion: None,
        }
    }

    /// Begins the launch from another state in the same memory, for a program that keeps it in a static because the stack is small.
    pub fn restart(&mut self, top: &Top, state: &State) {
        (self.top, self.state) = (*top, *state);
        (self.stage, self.has_quadrature, self.motion) = (Stage::Axis, false, None);
    }

    /// Motion, once [`poll`](Self::poll) has returned that it is ready.
    #[must_use]
    pub fn motion(&self) -> Option<&Motion> {
        self.motion.as_ref().filter(|_| matches!(self.stage, Stage::Ended(Ok(()))))
    }

    /// Does the next slice of the work. Calls after the result change nothing and return it again.
    ///
    /// # Errors
    /// See [`Motion::launch`].
    #[inline(never)]
    pub fn poll(&mut self) -> Poll<Result<Motion, ParameterError>> {
        match (self.proceed(), &self.motion) {
            (Poll::Ready(Ok(())), Some(motion)) => Poll::Ready(Ok(*motion)),
            (Poll::Ready(Err(error)), _) => Poll::Ready(Err(error)),
            _ => Poll::Pending,
        }
    }

    /// Does the next slice of the work like [`poll`](Self::poll), without a copy of the motion on the stack: [`motion`](Self::motion) is
    /// the result.
    ///
    /// # Errors
    /// See [`Motion::launch`].
    #[inline(never)]
    pub fn proceed(&mut self) -> Poll<Result<(), ParameterError>> {
        match (&self.stage, &self.motion) {
            (Stage::Ended(result), _) => return Poll::Ready(*result),
            (Stage::Axis, _) => self.find_axis(),
            (Stage::Integrals(_), _) => self.find_integrals(),
            (Stage::BranchPoints, _) => self.begin_branch_points(),
            (Stage::LowerPair(_), _) => self.find_lower_pair(),
            (Stage::UpperPair(_), _) => self.complete_branch_points(),
            (Stage::Constants(_), _) => self.find_constants(),
            (Stage::Conditioning, Some(_)) => self.find_conditioning(),
            (Stage::Quadrature, Some(_)) => self.begin_quadrature(),
            (Stage::Nodes, Some(_)) => self.add_node(),
            (Stage::Mean(_), Some(_)) => self.find_mean(),
            (Stage::Nutation, Some(_)) => self.start_nutation(),
            (Stage::StartRates, Some(_)) => self.find_start_rates(),
            (Stage::SlowPhases(_), Some(_)) => self.start_slow_phases(),
            // no stage after the constants is without a motion
            (_, None) => self.stage = Stage::Axis,
        }
        Poll::Pending
    }
}

/// Stages, each a function that is not inlined, so that their stack frames are not in use at one time.
impl<R: Scalar> Launch<R> {
    #[inline(never)]
    fn find_axis(&mut self) {
        self.stage = Stage::Integrals(MovingAxis::of(&self.state));
    }

    #[inline(never)]
    fn find_integrals(&mut self) {
        let Stage::Integrals(axis) = &self.stage else { return };
        (self.integrals, self.point) = FirstIntegrals::with_point(&self.top, axis);
        self.stage = Stage::BranchPoints;
    }

    #[inline(never)]
    fn begin_branch_points(&mut self) {
        self.stage = match BranchPoints::begin(&self.top, &self.integrals, &self.point) {
            Ok(Roots::LowerPair(search)) => Stage::LowerPair(search),
            Ok(Roots::All(e)) => Stage::Constants(e),
            Err(error) => Stage::Ended(Err(error)),
        };
    }

    #[inline(never)]
    fn find_lower_pair(&mut self) {
        let Stage::LowerPair(search) = &mut self.stage else { return };
        if let Some(pair) = search.proceed() {
            self.stage = Stage::UpperPair(pair);
        }
    }

    #[inline(never)]
    fn complete_branch_points(&mut self) {
        let Stage::UpperPair(pair) = &self.stage else { return };
        self.stage = match BranchPoints::complete(pair, &self.integrals, &self.point) {
            Ok(e) => Stage::Constants(e),
            Err(error) => Stage::Ended(Err(error)),
        };
    }

    #[inline(never)]
    fn find_constants(&mut self) {
        let Stage::Constants(e) = self.stage else { return };
        self.motion = Some(Motion::with_constants(&self.top, &self.integrals, &self.point, e));
        self.stage = Stage::Conditioning;
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
        self.quadrature.begin(&motion.law());
        self.has_quadrature = true;
        self.stage = Stage::Nodes;
    }

    #[inline(never)]
    fn add_node(&mut self) {
        if let Some(integrals) = self.quadrature.proceed() {
            self.stage = Stage::Mean(integrals);
        }
    }

    #[inline(never)]
    fn find_mean(&mut self) {
        let (Stage::Mean(integrals), Some(motion)) = (&self.stage, &mut self.motion) else { return };
        motion.mean = Some(motion.mean_of(integrals));
        self.stage = Stage::Nutation;
    }

    #[inline(never)]
    fn start_nutation(&mut self) {
        let Some(motion) = &mut self.motion else { return };
        motion.start_nutation(&self.point);
        self.stage = Stage::StartRates;
    }

    #[inline(never)]
    fn find_start_rates(&mut self) {
        self.stage = Stage::SlowPhases(parameters_and_rates::<R::Rates>(&self.state));
    }

    #[inline(never)]
    fn start_slow_phases(&mut self) {
        let (Stage::SlowPhases(parameters), Some(motion)) = (&self.stage, &mut self.motion) else { return };
        motion.start_slow_phases(*parameters, self.has_quadrature.then_some(self.quadrature.law()));
        self.stage = Stage::Ended(Ok(()));
    }
}

impl Motion {
    /// Motion from a state. The numbers of the state count as exact. Set-up computes in extended precision, so the stored
    /// constants have the error of one `f64` rounding. [`Launch`] does the same in slices.
    ///
    /// # Errors
    /// `omega`: so large that e₃ would exceed 1e14.
    pub fn launch(top: &Top, state: &State) -> Result<Self, ParameterError> {
        Self::launch_for::<f64>(top, state)
    }

    /// Motion from a state, for ephemerides in a scalar. For `f32` and fixed point the mean rates have some 60 correct bits, for which
    /// a chip needs a third of the time of the 120 bits that [`launch`](Self::launch) computes. Their error is part of
    /// [`error_bound`](crate::Ephemeris::error_bound). The other constants are the same.
    ///
    /// # Errors
    /// See [`launch`](Self::launch).
    #[inline(never)] // a launch must not remain on the stack during the work that follows
    pub fn launch_for<R: Scalar>(top: &Top, state: &State) -> Result<Self, ParameterError> {
        let mut launch = Launch::<R>::for_scalar(top, state);
        loop {
            if let Poll::Ready(result) = launch.poll() {
                return result;
            }
        }
    }
}

/// Parameters α and β of a state, each with its rate.
#[inline(never)]
fn parameters_and_rates<N: RateNumber>(state: &State) -> [[Complex<f64>; 2]; 2] {
    let (phi, omega) = state.exact::<N>();
    let phi = phi.normalised();
    let rate = OrientationRate::from_fixed(&phi, omega);
    [(phi.alpha, rate.alpha), (phi.beta, rate.beta)].map(|(z, z_dot)| [z, z_dot].map(to_f64))
}

fn to_f64<N: RateNumber>(z: Complex<N>) -> Complex<f64> {
    Complex::new(z.re.to_f64(), z.im.to_f64())
}
