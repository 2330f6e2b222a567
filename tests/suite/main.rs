//! Tests of public behaviour against independent results: one binary, one module per subject.

mod aperiodic;
mod baked;
mod bounds;
#[cfg(feature = "host")]
mod cayley_klein;
mod clock_change;
mod closed_forms;
mod conditioning;
mod dependencies;
mod e3_equals_e4;
mod elliptic;
mod ephemeris;
mod events;
mod far_ticks;
mod fit;
mod fit_drift;
mod fixed_point;
mod found;
#[cfg(feature = "host")]
mod full;
mod group;
mod hostile;
#[cfg(feature = "host")]
mod hyperelliptic;
mod impulse;
mod interop;
mod invariants;
mod lagrange;
#[cfg(feature = "host")]
mod lagrangian;
mod layout;
mod long_ticks;
mod moebius;
mod normal_force;
mod order;
mod paper;
mod precession;
mod properties;
mod rates;
mod refusals;
mod regimes;
mod samples;
#[cfg(feature = "host")]
mod sensitivity;
mod set_up;
mod small_together;
mod stages;
mod tip;
mod tip_angle;
#[cfg(feature = "host")]
mod tip_curve;
mod tops;
