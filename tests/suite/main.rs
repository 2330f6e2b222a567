//! Tests of public behaviour against independent results: one binary, one module per subject.

/// SU(2) in floating and in fixed point, its two actions on the sphere, and conversions.
mod rotations {
    mod cayley_klein_relations;
    mod conversions_against_nalgebra;
    mod exponential;
    mod moebius_is_adjoint;
}

/// From a launch to the stepper: constants, kinds of motion, first integrals, the tip.
mod motion {
    mod every_stage_against_reference_motions;
    mod first_integrals_and_symmetries;
    mod impulses_against_momentum_balances;
    #[cfg(feature = "host")]
    mod lagrangian_against_newton_euler;
    mod least_normal_force_against_mpmath;
    pub(crate) mod random_tops;
    mod regimes_are_recognised;
    mod sleeping_and_aperiodic_motions;
    mod small_differences_of_branch_points;
    mod stepper_is_of_fourth_order;
    mod tip_curve_has_its_class;
    mod tops_beyond_the_paper;
}

/// Tables: accuracy in every scalar, their clock, their events, their memory.
mod table {
    mod baked_data_are_exact_or_refused;
    mod events_against_dense_search;
    mod rates_against_closed_forms;
    mod samples_against_reference_motions;
    mod set_up_in_place;
    mod ticks_of_any_length_and_epoch;
    mod tip_angle_against_reference_motions;
    mod ways_to_read_agree;
}

/// Sections 3 to 5 of the paper: curves, integrals and closed forms.
mod closed_forms {
    mod against_mpmath;
    mod aperiodic_at_extreme_times;
    mod elliptic_functions_against_mpmath;
    #[cfg(feature = "host")]
    mod hyperelliptic_integrals;
    mod lagrange_top_is_the_limit;
    mod methods_agree;
    #[cfg(feature = "host")]
    mod quadrature_against_reference_motions;
    mod regular_precession;
    #[cfg(feature = "host")]
    mod residues;
    mod spinning_bodies_without_torque;
}

/// Launches found from measurements, and partial derivatives.
mod fit {
    mod blocks_and_single_precision;
    #[cfg(feature = "host")]
    mod derivatives_against_differences;
    mod launches_from_ambiguous_readings;
    mod launches_from_simulated_sensors;
    mod losses_of_rotation_are_found;
    mod saturated_and_refused_readings;
    mod simulated_sensors;
}

/// Refused input, and input of the fuzzer.
mod errors {
    mod fuzz_regressions;
    mod fuzz_targets_do_not_panic;
    mod parameters_out_of_range;
}

/// Files, dependencies, and the page that maps the paper to tests.
mod structure {
    mod layout;
    mod page_of_the_paper;
}
