//! Public behaviour, against independent truth. One binary, one module an idea.

mod conditioning;
mod ephemeris;
mod fixed_point;
mod group;
mod interop;
mod invariants;
mod order;
mod properties;
mod refusals;
mod regimes;
mod stages;
mod tip;
