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
/// ephemeris. [`Motion::launch`] is a loop over them. Most of the work is the quadrature of the period, whose number of slices
/// depends on the motion: 9 nodes for a fast top, 33 for a slow one, some 190 where e₃ - e₂ is about 1e-18, and two thirds of that for
/// `f32` and fixed point ([`for_scalar`](Launch::for_scalar)). It grows with the logarithm of the least difference between e₂ and a
/// branch point beyond it.
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
    quadrature: Option<Quadrature<R::Rates>>,
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
            (Stage::LowerPair(mut search), _) => {
                self.stage = search.proceed().map_or(Stage::LowerPair(search), Stage::UpperPair);
            }
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
            (Stage::StartRates, Some(_)) => {
                self.stage = Stage::SlowPhases(parameters_and_rates::<R::Rates>(&self.state))
            }
            (Stage::SlowPhases(parameters), Some(motion)) => {
                motion.start_slow_phases(parameters, self.quadrature.as_ref().map(Quadrature::law));
                self.stage = Stage::Ended(Ok(()));
            }
            (Stage::Ended(_), _) => {}
            // every stage after the branch points has a motion
            (_, None) => self.stage = Stage::Axis,
        }
    }

    #[inline(never)] // the stack frames of the stages must not add up
    fn begin_branch_points(&mut self) {
        match BranchPoints::begin(&self.top, &self.integrals, &self.point) {
            Ok(Roots::LowerPair(search)) => self.stage = Stage::LowerPair(search),
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
        Self::launch_for::<f64>(top, state)
    }

    /// Motion from a state, for ephemerides in a scalar. For `f32` and fixed point the mean rates have some 60 correct bits, which
    /// cost a chip a third of the 120 bits that [`launch`](Self::launch) computes. Their error is part of
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
