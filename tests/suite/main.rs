//! Public behaviour, against independent truth. One binary, one module an idea.

mod aperiodic;
mod baked;
mod cayley_klein;
mod closed_forms;
mod conditioning;
mod e3_equals_e4;
mod elliptic;
mod ephemeris;
mod fixed_point;
mod full;
mod group;
mod hyperelliptic;
mod interop;
mod invariants;
mod lagrange;
mod lagrangian;
mod moebius;
mod order;
mod paper;
mod precession;
mod properties;
mod refusals;
mod regimes;
mod stages;
mod tip;
mod tip_curve;
