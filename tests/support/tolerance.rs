//! Tolerances of the test suite for errors that accumulate along a motion, or are collected over many motions. The
//! rounding of a single identity has its tolerance where it is tested.
//!
//! A budget is two-sided: the worst error over all cases of a test must stay below `most`, and must reach `most /
//! 30`. A bound far above every error would not fail if the code, or the test, stopped working.

/// Budget for the error of one quantity in one scalar.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    /// Largest error allowed.
    pub most: f64,
}

/// Largest quotient of the bound and the worst error of a test.
const SLACK: f64 = 30.0;

impl Budget {
    const fn of(most: f64) -> Self {
        Self { most }
    }

    /// Checks the worst error of a whole test.
    ///
    /// # Panics
    /// If the error exceeds the budget, is far below it, or is NaN.
    pub fn check(self, what: &str, worst: f64) {
        assert!(worst <= self.most, "{what}: {worst:.1e}, allowed {:.1e}", self.most);
        assert!(worst >= self.most / SLACK, "{what}: {worst:.1e}, so {:.1e} is too lax a bound", self.most);
    }
}

/// Errors of samples of an ephemeris in `f32`: of ω, u and u', relative to the greatest rate; of the tip in the type of lengths and
/// rates, and of the tip in the scalar itself, relative to the length.
pub const SAMPLE_F32: [Budget; 3] = [Budget::of(2.5e-6), Budget::of(3e-7), Budget::of(3e-7)];
/// Errors of samples, as [`SAMPLE_F32`], in fixed point of 32 bits.
pub const SAMPLE_Q31: [Budget; 3] = [Budget::of(8e-7), Budget::of(3e-7), Budget::of(4e-8)];
/// Errors of samples, as [`SAMPLE_F32`], in fixed point of 16 bits.
pub const SAMPLE_Q15: [Budget; 3] = [Budget::of(3e-3), Budget::of(1e-3), Budget::of(1e-3)];

/// Greatest difference between the quantities of a sample in f64 and those of its attitude state.
pub const ATTITUDE_SAMPLE: Budget = Budget::of(2e-15);
/// Greatest difference between the stepper in f64, at a millisecond a step, and the samples of an ephemeris over 200 steps.
pub const STEPPER_SAMPLE: Budget = Budget::of(2e-14);

/// Errors of u, of u' relative to the greatest rate, and of the tip relative to its length, in f64 over three
/// periods; error of ω at the start.
pub const ATTITUDE_F64: [Budget; 4] =
    [Budget::of(2e-15), Budget::of(1e-14), Budget::of(2e-15), Budget::of(2e-13)];

/// Errors of l, n and h from branch points or a state, against 30 digits, relative to the largest of the three.
pub const CONSTANTS: Budget = Budget::of(4e-16);
/// Errors of the nutation period (relative) and of the phase advances over it (rad), for inputs exact in f64.
pub const PERIOD: Budget = Budget::of(4e-16);
/// Errors of period and phase advances for inputs rounded to f64, times the smallest difference, to which they are
/// most sensitive.
pub const PERIOD_ROUNDED: Budget = Budget::of(3e-16);

/// Orientation error (rad) of the stepper over three periods, 4096 steps a period, f64, for inputs exact in f64 and
/// e₃ - e₂ > 1e-3.
pub const STEPPER_F64: Budget = Budget::of(3e-13);
/// Error of the stepper near the separatrix, times e₃ - e₂.
pub const STEPPER_F64_SEPARATRIX: Budget = Budget::of(3e-16);
/// Error of the stepper at A/(ps) = 1/16, where the nutation is sixteen times as fast near the vertical, so that 4096
/// steps are coarse.
pub const STEPPER_F64_SMALL_A: Budget = Budget::of(1e-11);
/// Orientation error (rad) of the stepper over three periods, 1024 steps a period, f32.
pub const STEPPER_F32: Budget = Budget::of(6e-6);
/// Errors of u, and of u' relative to its size, over three periods in f64.
pub const REDUCED_F64: Budget = Budget::of(3e-13);
/// Error of the tip curve in units of s, over three periods in f64.
pub const TIP_F64: Budget = Budget::of(3e-13);
/// Error of the continued tip angle over three periods in f64.
pub const TIP_ANGLE_F64: Budget = Budget::of(3e-13);

/// Error of the tip angle of an ephemeris as a distance of the tip, in units of s: f64, f32, q31, q15.
pub const TIP_ANGLE: [Budget; 4] = [Budget::of(1e-14), Budget::of(1e-7), Budget::of(6e-9), Budget::of(3e-4)];

/// Errors of events in f64: of u at a crossing, of the tip angle as a distance in units of s, and of a turning point's time in periods.
pub const EVENTS_F64: [Budget; 3] = [Budget::of(6e-15), Budget::of(6e-15), Budget::of(2e-16)];
/// Errors of events in f32, as [`EVENTS_F64`]. Set-up follows the motion to a fraction of the error that the scalar allows, so that a
/// turning point is less exact than in f64.
pub const EVENTS_F32: [Budget; 3] = [Budget::of(3e-7), Budget::of(3e-7), Budget::of(2e-11)];
/// Errors of events in fixed point of 32 bits, as [`EVENTS_F64`].
pub const EVENTS_Q31: [Budget; 3] = [Budget::of(2.1e-8), Budget::of(2.1e-8), Budget::of(1e-12)];
/// Errors of events in fixed point of 16 bits, as [`EVENTS_F64`].
pub const EVENTS_Q15: [Budget; 3] = [Budget::of(3e-4), Budget::of(3e-3), Budget::of(4e-8)];

/// Orientation error of the ephemeris in f64 at any time, for inputs exact in f64, with the rounding of the phases at the start.
pub const EPHEMERIS_F64: Budget = Budget::of(1e-14);
/// Orientation error of the ephemeris in f32 at any time.
pub const EPHEMERIS_F32: Budget = Budget::of(2.5e-7);
/// Change of the orientation (rad) over 2e-12 of time across a border of two segments in f64.
pub const CONTINUITY: Budget = Budget::of(2e-11);
/// Change of ω over 2e-12 of time across a border of two segments in f64.
pub const CONTINUITY_OF_RATES: Budget = Budget::of(2e-11);
/// Error of the ephemeris in f64 of a motion launched again from the attitude state of a sample, over 10 000 ticks.
pub const RELAUNCH: Budget = Budget::of(5e-14);
/// Difference of a table with a changed tick and the unchanged table, divided by the sum of their bounds.
pub const OF_THE_BOUND: Budget = Budget::of(1.0);
/// Change of ω by an impulse, and the reaction to it, relative, against forces that act for 1e-9 s and for half of that,
/// extrapolated.
pub const IMPULSE: Budget = Budget::of(1e-12);
/// Difference of the closed form and the stepper over 6000 steps of 1e-2, dominated by the fourth-order error of the
/// stepper.
pub const RISE_STEPPER: Budget = Budget::of(1e-11);
/// Orientation error of the ephemeris in fixed point of 32 bits at any time.
pub const EPHEMERIS_Q31: Budget = Budget::of(1e-8);
/// Orientation error of the ephemeris in fixed point of 16 bits at any time.
pub const EPHEMERIS_Q15: Budget = Budget::of(3e-4);
/// Defect of the norm, | |α|² + |β|² - 1 |, after 10⁶ steps in f64.
pub const NORM_F64: Budget = Budget::of(2e-15);
/// Defect of the norm after 10⁶ steps in f32.
pub const NORM_F32: Budget = Budget::of(1e-6);
/// Errors of l, n, h recomputed from α, β and their rates after 10⁶ steps in f64, relative to the largest of the
/// three.
pub const INVARIANTS_F64: Budget = Budget::of(1e-14);
/// Errors of l, n, h recomputed after 10⁶ steps in f32.
pub const INVARIANTS_F32: Budget = Budget::of(5e-6);
/// Orientation error after changing steps forward and back in f64.
pub const REVERSAL_F64: Budget = Budget::of(1e-14);
/// Error of state -> constants -> state in f64, over the condition number of the launch.
pub const ROUND_TRIP: Budget = Budget::of(2e-14);
/// Errors of identities of the group SU(2), f64.
pub const GROUP: Budget = Budget::of(3e-15);

/// Relative errors of ℘, ℘', ζ against 30 digits: the rounding of the result, 2^-53.
pub const WEIERSTRASS: Budget = Budget::of(1.2e-16);
/// Errors of ln σ and σ in units of 1 + |ln σ| (+ |z ζ|), including the rounding of the expected value to `f64`.
pub const LN_SIGMA: Budget = Budget::of(4e-16);
/// Relative errors of sn, cn, dn, am against 30 digits.
pub const JACOBI: Budget = Budget::of(1.2e-16);
/// Relative errors of ω, |ω'|, η, η' and K against 30 digits.
pub const HALF_PERIODS: Budget = Budget::of(1.2e-16);

/// Errors of the closed forms against the reference vectors with exact inputs: orientation in rad, u, u' relative to
/// its size. In this order: constant tilt, aperiodic, e₃ = e₄, Lagrange.
pub const CLOSED_FORMS: [Budget; 4] =
    [Budget::of(1e-15), Budget::of(1e-15), Budget::of(1e-15), Budget::of(1e-15)];
/// Orientation errors (rad) of the closed forms where the inputs are rounded to f64.
pub const CLOSED_FORMS_ROUNDED: Budget = Budget::of(5e-14);
/// Orientation error (rad) of the closed forms after up to 10⁹ periods.
pub const CLOSED_FORM_FAR_OUT: Budget = Budget::of(1e-15);
/// Difference of closed form and ephemeris over about fifty units of time.
pub const CLOSED_FORM_EPHEMERIS: Budget = Budget::of(2e-15);
/// Difference of closed form and ephemeris within some periods and after a million, with several differences of the
/// branch points down to 1e-12 and e₃ up to 1e12.
pub const CLOSED_FORM_CORNERS: Budget = Budget::of(1e-14);
/// Orientation error (rad) of a closed form against 30 digits, up to 1e7 s, where several differences of the branch
/// points are small together.
pub const CLOSED_FORM_SMALL_TOGETHER: Budget = Budget::of(1e-15);
/// Orientation error of a closed form per period where e₃ and e₄ differ within the tolerance.
pub const CLOSED_FORM_NEARLY_EQUAL: Budget = Budget::of(5e-14);
/// Difference of closed form and stepper, 2048 steps a unit of time.
pub const CLOSED_FORM_STEPPER: Budget = Budget::of(1e-13);
/// Errors of l, n, h recomputed from the attitude state of a closed form, relative to their sizes.
pub const CLOSED_FORM_INTEGRALS: Budget = Budget::of(2e-15);
/// Difference of the paper's formulas, written out in f64, and core (rad).
pub const AS_THE_PAPER_HAS_IT: Budget = Budget::of(1e-13);
/// Errors of the paper's equations at one instant in f64, relative to the size of their terms.
pub const EQUATIONS: Budget = Budget::of(5e-15);
/// Errors of l, n, h from the Lagrangian along the path of the full solver, relative to the largest of the three.
pub const FULL_INTEGRALS: Budget = Budget::of(1e-13);
/// Errors of the curves at instants of the full solution, away from turning points.
pub const CURVE_ON_PATH: Budget = Budget::of(5e-14);
/// Errors of contour integrals in f64, 512 nodes.
pub const CONTOUR: Budget = Budget::of(1e-14);

/// Errors of the stepper in f64 and in f32 for tops that the paper does not contain, with 2048 steps in the unit of time, over 9 units:
/// of the orientation (rad), and of ω relative to its greatest length.
pub const TOPS_STEPPER: [[Budget; 2]; 2] =
    [[Budget::of(1e-14), Budget::of(1e-14)], [Budget::of(3e-6), Budget::of(3e-6)]];
/// Errors of closed forms for tops that the paper does not contain: of the orientation (rad), and of ω relative to its greatest length.
pub const TOPS_CLOSED_FORMS: [Budget; 2] = [Budget::of(2e-15), Budget::of(2e-15)];
/// Error of the derivatives of a motion by its launch and top, up to 10⁶ periods, relative to each derivative.
pub const SENSITIVITY: Budget = Budget::of(1e-10);
