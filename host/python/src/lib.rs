//! Python package `toytop`: the exact motion of a spinning top as arrays of `NumPy`.
//!
//! | module | contents |
//! |---|---|
//! | [`arguments`] | numbers of arguments, their refusals, and arrays for Python |
//! | [`interrupt`] | computations without the interpreter's lock, which Ctrl-C ends |
//! | [`samples`] | columns of samples: a motion at given times |
//! | [`top`] | numbers of a top |
//! | [`motion`] | a motion: its tables, constants, events, partial derivatives and closed form |
//! | [`launch`] | launches of a top |
//! | [`many`] | motions on all cores |
//! | [`fit`] | from samples of sensors to a launch, and back |
//! | [`score`] | errors of an integrator |
//!
//! Computations run without the interpreter's lock, and every class is immutable, so that threads can share objects.

mod arguments;
mod interrupt;
mod samples;
mod top;

mod motion;

mod launch;
mod many;

mod fit;
mod score;

use pyo3::prelude::*;

/// Compiled part of toytop. Import from toytop instead.
#[pymodule(gil_used = false)]
mod _toytop {
    #[pymodule_export]
    use super::fit::{FittedLaunch, fit, simulate};
    #[pymodule_export]
    use super::many::{constant_of_many, launch_many, sample_many};
    #[pymodule_export]
    use super::motion::{ClosedFormCore, MotionCore};
    #[pymodule_export]
    use super::samples::Sampler;
    #[pymodule_export]
    use super::score::{order, score};
    #[pymodule_export]
    use super::top::TopCore;
    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "the name is Python's")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
    #[pymodule_export]
    const PARTIAL_NAMES: [&str; 10] = toytop_fit::Sensitivity::NAMES;
}
