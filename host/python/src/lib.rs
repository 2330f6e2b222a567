//! Python package `toytop`: the exact motion of a spinning top as arrays of `NumPy`.
//!
//! | module | contents |
//! |---|---|
//! | [`error`] | refusals as exceptions |
//! | [`arrays`] | arrays and columns of Python to and from numbers |
//! | [`interrupt`] | computations without the interpreter's lock, which Ctrl-C ends |
//! | [`samples`] | `Samples`: a motion at given times |
//! | [`motion`], [`constants`] | `Motion`: at any time, and its constants |
//! | [`launch`], [`top`] | launches, and `Top` |
//! | [`many`] | `many`: motions on all cores |
//! | [`events`] | times of turning points, tilts, directions, circles and lift-off |
//! | [`partials`] | partial derivatives, and impulses |
//! | [`other_methods`] | closed form and truth of a motion at a time |
//! | [`fit`], [`fitted`] | `fit` and `simulate`: from samples of sensors to a launch, and back |
//! | [`score`] | `score`: errors of an integrator |
//! | [`page`] | pictures for a notebook |
//!
//! Computations run without the interpreter's lock, and every class is immutable, so that threads can share objects.

mod arrays;
mod constants;
mod error;
mod events;
mod fit;
mod fitted;
mod interrupt;
mod launch;
mod many;
mod motion;
mod other_methods;
mod page;
mod partials;
mod samples;
mod score;
mod top;

use pyo3::prelude::*;

/// Compiled part of toytop. Import from toytop instead.
#[pymodule(gil_used = false)]
mod _toytop {
    #[pymodule_export]
    use super::fit::{fit, simulate};
    #[pymodule_export]
    use super::fitted::Fitted;
    #[pymodule_export]
    use super::many::{Many, many};
    #[pymodule_export]
    use super::motion::PyMotion;
    #[pymodule_export]
    use super::other_methods::PyClosedForm;
    #[pymodule_export]
    use super::page::Page;
    #[pymodule_export]
    use super::samples::Samples;
    #[pymodule_export]
    use super::score::{Score, order, score};
    #[pymodule_export]
    use super::top::PyTop;
    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "the name is Python's")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
