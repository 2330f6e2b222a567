//! Public behaviour, against independent truth. One binary, one module an idea.

mod aperiodic;
mod baked;
mod bounds;
#[cfg(feature = "host")]
mod cayley_klein;
mod closed_forms;
mod conditioning;
mod dependencies;
mod e3_equals_e4;
mod elliptic;
mod ephemeris;
mod fixed_point;
mod fixed_stepper;
mod found;
#[cfg(feature = "host")]
mod full;
mod group;
mod hostile;
#[cfg(feature = "host")]
mod hyperelliptic;
mod interop;
mod invariants;
mod lagrange;
#[cfg(feature = "host")]
mod lagrangian;
mod long_ticks;
mod moebius;
mod moments;
mod order;
mod paper;
mod precession;
mod properties;
mod refusals;
mod regimes;
mod stages;
mod tip;
#[cfg(feature = "host")]
mod tip_curve;
