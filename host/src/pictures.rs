//! Pictures and pages.
//!
//! | module | contents |
//! |---|---|
//! | [`curve`] | curve of the tip between its bounding circles |
//! | `drawing` | frame of a picture, texts, files |
//! | `tip` | picture of the curve of the tip |
//! | `chart` | curves over logarithmic axes |
//! | `heat_map` | a quantity over two axes |
//! | [`view`] | page for a browser |

#[cfg(feature = "program")]
pub(crate) mod chart;
pub mod curve;
#[cfg(feature = "program")]
pub(crate) mod drawing;
#[cfg(feature = "program")]
pub(crate) mod heat_map;
#[cfg(feature = "program")]
pub(crate) mod tip;
pub mod view;
