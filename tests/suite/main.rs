//! Tests of public behaviour against independent results: one binary, one module per subject.

/// SU(2) in floating and in fixed point, its two actions on the sphere, and conversions.
mod rotations {
    mod cayley_klein;
    mod group;
    mod interop;
    mod moebius;
}

/// From a launch to the stepper: constants, kinds of motion, first integrals, the tip.
mod motion {
    mod conditioning;
    mod conservation;
    mod each_stage;
    mod impulse;
    #[cfg(feature = "host")]
    mod lagrangian;
    mod normal_force;
    mod other_tops;
    pub(crate) mod random_tops;
    mod regimes;
    mod stepper_order;
    mod tip_curve;
    mod vertical;
}

/// Tables: accuracy in every scalar, their clock, their events, their memory.
mod table {
    mod baked;
    mod clock;
    mod event_times;
    mod rates;
    mod samples;
    mod set_up;
    mod tip_angle;
    mod truth;
}

/// Sections 3 to 5 of the paper: curves, integrals and closed forms.
mod closed_forms {
    mod against_mpmath;
    mod aperiodic;
    mod elliptic;
    mod free_body;
    #[cfg(feature = "host")]
    mod hyperelliptic;
    mod lagrange;
    mod methods_agree;
    #[cfg(feature = "host")]
    mod poles;
    mod precession;
    #[cfg(feature = "host")]
    mod quadrature;
}

/// Launches found from measurements, and partial derivatives.
mod fit {
    mod drift;
    mod first_guesses;
    mod saturated_and_refused;
    #[cfg(feature = "host")]
    mod sensitivity;
    mod sensors;
    mod simulated;
    mod tracking;
}

/// Refused input, and input of the fuzzer.
mod errors {
    mod fuzz_regressions;
    mod random_bytes;
    mod refusals;
}

/// Files, dependencies, and the page that maps the paper to tests.
mod structure {
    mod layout;
    mod paper;
}
