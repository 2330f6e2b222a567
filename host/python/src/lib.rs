//! Python package `toytop`: the exact motion of a spinning top as arrays of `NumPy`.
//!
//! | module | contents |
//! |---|---|
//! | [`error`] | what is refused, as exceptions |
//! | [`arrays`] | numbers in from Python, and out |
//! | [`top`] | `Top`, and the ways to a motion |
//! | [`definition`] | how a motion was given, to full precision, and as a scenario file |
//! | [`motion`], [`constants`] | `Motion`: at any time, and what does not change |
//! | [`samples`] | `Samples`: a motion at given times |
//! | [`point`] | one instant that no table holds |
//! | [`closed_form`], [`reference`] | other ways to an instant |
//! | [`many`], [`releases`] | `many`: motions on all cores |
//! | [`score`] | `score`: errors of an integrator |
//! | [`page`] | pictures for a notebook |
//!
//! Everything that computes does so without the interpreter's lock, and every class is immutable: threads share them freely.

mod arrays;
mod closed_form;
mod constants;
mod definition;
mod error;
mod many;
mod motion;
mod page;
mod point;
mod reference;
mod releases;
mod samples;
mod score;
mod top;

use pyo3::prelude::*;

/// Compiled part of toytop. Import from toytop instead.
#[pymodule(gil_used = false)]
mod _toytop {
    #[pymodule_export]
    use super::closed_form::PyClosedForm;
    #[pymodule_export]
    use super::many::{Many, many};
    #[pymodule_export]
    use super::motion::PyMotion;
    #[pymodule_export]
    use super::page::Page;
    #[pymodule_export]
    use super::samples::Samples;
    #[pymodule_export]
    use super::score::{Score, order, score};
    #[pymodule_export]
    use super::top::PyTop;
}
