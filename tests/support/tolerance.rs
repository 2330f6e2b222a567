//! Greatest errors that the tests allow, by the file of the test.
//!
//! They are two-sided: see [`check`](crate::check). The numbers of a list are in the order of the names that its test gives to `check_all`.
//!
//! Their scale is a rounding: 1.1e-16 in `f64`, 6e-8 in `f32`, 5e-10 in `I2F30`, 3e-5 in `I2F14`. An error may be larger by the condition of
//! the problem near a degenerate motion, by the magnitude of a rate, or by the number of steps.

#![allow(missing_docs, reason = "a name is the subject of the test and the quantity")]

// closed_forms/elliptic_functions_against_mpmath.rs
pub const ELLIPTIC_LN_SIGMA: f64 = 4e-16;
pub const ELLIPTIC_SIGMA: f64 = 4e-16;
pub const ELLIPTIC_HALF_PERIODS: f64 = 1.2e-16;
pub const ELLIPTIC_SN_CN_DN_AM: f64 = 1.2e-16;
pub const ELLIPTIC_K: f64 = 1.2e-16;
pub const ELLIPTIC_P_AND_ZETA: [f64; 3] = [1.2e-16; 3];

// closed_forms/methods_agree.rs
pub const METHODS_AGREE_EXACT_INPUTS: f64 = 1e-15;
pub const METHODS_AGREE_ROUNDED_INPUTS: f64 = 5e-14;
pub const METHODS_AGREE_AFTER_1E9_PERIODS: f64 = 1e-15;
pub const METHODS_AGREE_CLOSED_FORM_AND_TABLE: f64 = 2e-15;
pub const METHODS_AGREE_CLOSED_FORM_AND_STEPPER: f64 = 1e-13;
pub const METHODS_AGREE_TOWARDS_THE_CORNERS: f64 = 1e-14;

// closed_forms/spinning_bodies_without_torque.rs
pub const SPINNING_BODIES: f64 = 5e-15;
pub const SMALL_ANGULAR_MOMENTUM: f64 = 3e-15;

// closed_forms/hyperelliptic_integrals.rs
pub const HYPERELLIPTIC_R_U: f64 = 5e-15;
pub const HYPERELLIPTIC_W_AND_DT: f64 = 5e-14;
pub const HYPERELLIPTIC_D_LOG_AND_DPHI: f64 = 5e-15;
pub const HYPERELLIPTIC_AROUND_THE_CUT: f64 = 1e-14;

// closed_forms/residues.rs
pub const RESIDUES_TABLES_1_AND_2: f64 = 1e-14;
pub const RESIDUES_T_INFINITY: f64 = 1e-14;

// closed_forms/against_mpmath.rs
pub const AGAINST_MPMATH_FORMULAS: f64 = 3e-15;
pub const AGAINST_MPMATH_SEVERAL_DIFFERENCES_SMALL_TOGETHER: f64 = 1e-15;
pub const AGAINST_MPMATH_PER_PERIOD: f64 = 5e-14;

// motion/impulses_against_momentum_balances.rs
pub const IMPULSES_BALANCES: [f64; 2] = [1e-13, 5e-15];
pub const IMPULSES_WITHOUT_EFFECT: f64 = 2e-15;

// table/events_against_dense_search.rs
pub const EVENTS_F64: [f64; 3] = [6e-15, 6e-15, 2e-16];
pub const EVENTS_F32: [f64; 3] = [3e-7, 3e-7, 2e-11];
pub const EVENTS_Q31: [f64; 3] = [2.1e-8, 2.1e-8, 1e-12];
pub const EVENTS_Q15: [f64; 3] = [3e-4, 3e-3, 4e-8];
/// Time in s. The tip angle grows with the cube of the time, so that its rounding shifts an instant by 1e-6 s.
pub const EVENTS_AT_A_CUSP: f64 = 2e-6;

// fit/derivatives_against_differences.rs
pub const DERIVATIVES: f64 = 1e-10;

// motion/first_integrals_and_symmetries.rs
pub const CONSERVATION_THERE_AND_BACK: f64 = 1e-14;
pub const CONSERVATION_L_N_H: f64 = 1e-14;
pub const CONSERVATION_F64: [f64; 2] = [2e-15, 1e-14];
pub const CONSERVATION_F32: [f64; 2] = [1e-6, 5e-6];

// motion/lagrangian_against_newton_euler.rs
pub const LAGRANGIAN_EQN_MOTION: f64 = 5e-15;
pub const LAGRANGIAN_L_N_H_ALONG_THE_FULL_SOLUTION: f64 = 1e-13;

// motion/tops_beyond_the_paper.rs
pub const BEYOND_THE_PAPER_STEPPER_F64: [f64; 2] = [1e-14; 2];
pub const BEYOND_THE_PAPER_STEPPER_F32: [f64; 2] = [3e-6; 2];
pub const BEYOND_THE_PAPER_TABLE: [f64; 2] = [2e-15; 2];

// motion/every_stage_against_reference_motions.rs
pub const EVERY_STAGE_L_N_H: f64 = 4e-16;
pub const EVERY_STAGE_PERIOD: [f64; 2] = [4e-16, 3e-16];
pub const STEPPER_F64: f64 = 3e-13;
pub const STEPPER_F64_SMALL_A: f64 = 1e-11;
/// Error times e₃ - e₂.
pub const STEPPER_F64_NEAR_SEPARATRIX: f64 = 3e-16;
pub const STEPPER_F32: f64 = 6e-6;
pub const EVERY_STAGE_REDUCED_MOTION_AND_TIP: [f64; 3] = [3e-13; 3];

// motion/tip_curve_has_its_class.rs
pub const TIP_CURVE_DERIVATIVES: [f64; 2] = [2e-3, 1e-3];

// rotations/cayley_klein_relations.rs
pub const CAYLEY_KLEIN_SU_2: f64 = 3e-15;
pub const CAYLEY_KLEIN_RELATIONS_OF_SECTION_3_4: f64 = 5e-15;

// rotations/moebius_is_adjoint.rs
pub const MOEBIUS: f64 = 3e-15;

// table/ways_to_read_agree.rs
pub const READ_AFTER_A_RELAUNCH: f64 = 5e-14;
pub const READ_QUANTITIES: [f64; 2] = [2e-15, 2e-14];
pub const READ_ACROSS_SEGMENTS: [f64; 2] = [2e-11; 2];

// table/ticks_of_any_length_and_epoch.rs
pub const TICKS_OF_TWO_LENGTHS: f64 = 1.0;

// table/tip_angle_against_reference_motions.rs
pub const TIP_ANGLE_F64: f64 = 1e-14;
pub const TIP_ANGLE_F32: f64 = 1e-7;
pub const TIP_ANGLE_Q31: f64 = 6e-9;
pub const TIP_ANGLE_Q15: f64 = 3e-4;

// table/samples_against_reference_motions.rs
pub const SAMPLES_F64: [f64; 8] = [2e-15, 2e-15, 2e-15, 2e-15, 2e-15, 1e-14, 2e-15, 2e-15];
pub const SAMPLES_F32: [f64; 8] = [2e-7, 2e-7, 2e-7, 2e-7, 1e-7, 2e-5, 2e-7, 2e-7];
pub const SAMPLES_Q31: [f64; 8] = [1e-8, 1e-8, 1e-8, 1e-8, 2e-8, 1e-6, 2e-7, 4e-8];
pub const SAMPLES_Q15: [f64; 8] = [3e-4, 3e-4, 3e-4, 3e-4, 3e-4, 3e-3, 1e-3, 1e-3];
pub const SAMPLES_OF_EVERY_VECTOR: [f64; 2] = [1e-11, 1e-8];
