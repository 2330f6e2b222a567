//! What the test suite allows errors that add up along a motion, or are gathered over many of them, in one table. What a
//! single identity may round off stands inline, where it is tested.
//!
//! A budget is two-sided: the worst error over all cases of a test must stay below `most`, and must reach `most / 30`.
//! A bound that nothing comes near would not notice when the code, or the test, stopped working.

/// What is allowed for one quantity in one scalar.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    /// Worst error allowed.
    pub most: f64,
}

/// How far below its bound the worst case of a test may stay.
const SLACK: f64 = 30.0;

impl Budget {
    const fn of(most: f64) -> Self {
        Self { most }
    }

    /// Checks the worst case of a whole test.
    ///
    /// # Panics
    /// If the budget is exceeded, never approached, or not a number.
    pub fn check(self, what: &str, worst: f64) {
        assert!(worst <= self.most, "{what}: {worst:.1e}, allowed {:.1e}", self.most);
        assert!(worst >= self.most / SLACK, "{what}: {worst:.1e}, so {:.1e} is too lax a bound", self.most);
    }
}

/// u, u', ω and the tip from a moment of an ephemeris in `f32`, as shares of the greatest rate and of the length: from the pose,
/// the tip in `f32`, and the tip in the scalar itself.
pub const MOMENT_F32: [Budget; 3] = [Budget::of(6e-7), Budget::of(3e-7), Budget::of(3e-7)];
/// The same in fixed point of 32 bits.
pub const MOMENT_Q31: [Budget; 3] = [Budget::of(6e-7), Budget::of(3e-7), Budget::of(4e-8)];
/// The same in fixed point of 16 bits.
pub const MOMENT_Q15: [Budget; 3] = [Budget::of(1e-3); 3];

/// u, u' as a share of the greatest rate and the tip as a share of its length, in f64 over three periods; ω at the start.
pub const MOMENT_F64: [Budget; 4] =
    [Budget::of(2e-15), Budget::of(2e-15), Budget::of(2e-15), Budget::of(2e-13)];

/// l, n, h from branch points or a state, against 30 digits; relative to the largest of them.
pub const CONSTANTS: Budget = Budget::of(4e-16);
/// The nutation period, relative, and the phase advances in it (rad), inputs exact in f64.
pub const PERIOD: Budget = Budget::of(1e-14);
/// The same, inputs rounded to f64: times the smallest difference, which the rounding changes most.
pub const PERIOD_ROUNDED: Budget = Budget::of(3e-16);

/// Orientation (rad) over three periods, 4096 steps a period, f64, inputs exact in f64 and e₃ - e₂ > 1e-3.
pub const STEPPER_F64: Budget = Budget::of(3e-13);
/// The same near the separatrix, times e₃ - e₂.
pub const STEPPER_F64_SEPARATRIX: Budget = Budget::of(3e-16);
/// The same at A/(ps) = 1/16, where the nutation runs through the vertical sixteen times as fast: 4096 steps are few.
pub const STEPPER_F64_SMALL_A: Budget = Budget::of(1e-11);
/// Orientation (rad) over three periods, 1024 steps a period, f32.
pub const STEPPER_F32: Budget = Budget::of(6e-6);
/// u, and u' relative to its size, over three periods in f64.
pub const REDUCED_F64: Budget = Budget::of(3e-13);
/// The tip curve in units of s, over three periods in f64.
pub const TIP_F64: Budget = Budget::of(3e-13);
/// The tip angle, continued, over three periods in f64.
pub const TIP_ANGLE_F64: Budget = Budget::of(3e-13);

/// The ephemeris in f64 at any time, inputs exact in f64 (the start's own rounding is in it).
pub const EPHEMERIS_F64: Budget = Budget::of(1e-14);
/// The same in f32.
pub const EPHEMERIS_F32: Budget = Budget::of(2.5e-7);
/// Orientation (rad) 1e-12 of time on either side of a border between two segments in f64.
pub const CONTINUITY: Budget = Budget::of(2e-11);
/// ω of the same.
pub const CONTINUITY_OF_RATES: Budget = Budget::of(2e-11);
/// Ephemeris in f64 of a motion launched anew from the pose of a moment, over 10 000 ticks.
pub const RELAUNCH: Budget = Budget::of(5e-14);
/// Ephemeris in f64 of an aperiodic motion against the stepper, 60 000 ticks of 1e-3.
pub const APERIODIC_STEPPER: Budget = Budget::of(5e-14);
/// The same in 6000 ticks of 1e-2, of which the stepper's error is of fourth order.
pub const RISE_STEPPER: Budget = Budget::of(1e-11);
/// The ephemeris in fixed point of 32 bits, at any time.
pub const EPHEMERIS_Q31: Budget = Budget::of(1e-8);
/// The same of 16 bits.
pub const EPHEMERIS_Q15: Budget = Budget::of(3e-4);
/// The stepper in fixed point, orientation (rad) over three periods, some thousand ticks a period or sixteen.
pub const STEPPER_Q31: Budget = Budget::of(8e-9);
/// The same after 10⁶ ticks, a thousand periods; nearly all of it at A/(ps) = 1/16, elsewhere a fifth or less.
pub const STEPPER_Q31_LONG: Budget = Budget::of(2e-6);
/// u of the same, read off by itself.
pub const U_Q31: Budget = Budget::of(4e-9);
/// Its tip curve in units of s.
pub const TIP_Q31: Budget = Budget::of(2.5e-8);
/// Its tip angle, continued, times |c|/2s.
pub const TIP_ANGLE_Q31: Budget = Budget::of(2.5e-8);
/// Forward 100 000 ticks, a thousand periods, and back: orientation.
pub const REVERSAL_Q31: Budget = Budget::of(3e-7);
/// | |α|² + |β|² - 1 | after 10⁶ steps.
pub const NORM_F64: Budget = Budget::of(2e-15);
/// The same in f32.
pub const NORM_F32: Budget = Budget::of(1e-6);
/// l, n, h recomputed from α, β and their rates after 10⁶ steps, relative to the largest of them.
pub const INVARIANTS_F64: Budget = Budget::of(1e-14);
/// The same in f32.
pub const INVARIANTS_F32: Budget = Budget::of(5e-6);
/// Forward and back with changing steps, orientation in f64.
pub const REVERSAL_F64: Budget = Budget::of(1e-14);
/// State -> constants -> state, f64: what one rounding of the state does, over the condition of the launch.
pub const ROUND_TRIP: Budget = Budget::of(2e-14);
/// Group facts of SU(2), f64.
pub const GROUP: Budget = Budget::of(3e-15);

/// ℘, ℘', ζ, σ against 30 digits, in units of |f| + |z f'|; ln σ in units of 1 + |ln σ| + |z ζ|.
pub const WEIERSTRASS: Budget = Budget::of(2e-15);
/// sn, cn, dn, am against 30 digits, in units of |f| + |u f'|.
pub const JACOBI: Budget = Budget::of(1e-15);
/// ω, |ω'| and K, relative; η and η' relative to the larger.
pub const HALF_PERIODS: Budget = Budget::of(1e-15);

/// Closed forms against the vectors (exact inputs): orientation in rad, u, u' relative to its size. Constant tilt,
/// aperiodic, e₃ = e₄, Lagrange.
pub const CLOSED_FORMS: [Budget; 4] =
    [Budget::of(1e-14), Budget::of(1e-14), Budget::of(1e-14), Budget::of(1e-14)];
/// Orientation (rad) of the same where the inputs are rounded to f64.
pub const CLOSED_FORMS_ROUNDED: Budget = Budget::of(5e-14);
/// Orientation (rad) far out, over the number of periods.
pub const CLOSED_FORM_PER_PERIOD: Budget = Budget::of(5e-15);
/// Closed form against ephemeris, over some fifty units of time.
pub const CLOSED_FORM_EPHEMERIS: Budget = Budget::of(1e-13);
/// The same over two periods, differences of the branch points down to 1e-12 and e₃ up to 1e12.
pub const CLOSED_FORM_CORNERS: Budget = Budget::of(2e-13);
/// Closed form against stepper, 2048 steps a unit of time.
pub const CLOSED_FORM_STEPPER: Budget = Budget::of(1e-13);
/// l, n, h recomputed from a closed form's pose, relative to their sizes.
pub const CLOSED_FORM_INTEGRALS: Budget = Budget::of(1e-13);
/// The paper's formulas as they stand, in f64, against core (rad).
pub const AS_THE_PAPER_HAS_IT: Budget = Budget::of(1e-13);
/// Central differences in double-double with a step of 1e-10: the square of the step, times the third derivative.
pub const DIFFERENCES: Budget = Budget::of(2e-19);
/// The same of what is quadratic, where only the rounding over the step is left.
pub const DIFFERENCES_OF_SQUARES: Budget = Budget::of(1e-20);
/// The paper's equations at one instant in f64, relative to the size of their terms.
pub const EQUATIONS: Budget = Budget::of(5e-15);
/// l, n, h by the Lagrangian along the full solver's path, relative to the largest of them.
pub const FULL_INTEGRALS: Budget = Budget::of(1e-13);
/// The curves at instants of the full solution, away from turning points.
pub const CURVE_ON_PATH: Budget = Budget::of(5e-14);
/// Contour integrals in f64, 512 nodes.
pub const CONTOUR: Budget = Budget::of(1e-14);
