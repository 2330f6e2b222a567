//! Pictures and pages.
//!
//! | module | contents |
//! |---|---|
//! | [`span`] | motion over a span of time |
//! | [`curve`] | curve of the tip, bounds between which the axis stays |
//! | `drawing` | axes, colours, texts and lines; files of pictures |
//! | `tip` | picture of the curve of the tip |
//! | `space` | the axis on its sphere; animation of the top |
//! | `chart` | curves over linear or logarithmic axes |
//! | `charts` | tilt and precession against time, effective potential |
//! | `fit` | residuals of a fit, error of its prediction |
//! | `heat_map` | a quantity over two axes |
//! | [`view`] | page for a browser |

#[cfg(feature = "program")]
pub(crate) mod chart;
#[cfg(feature = "program")]
pub(crate) mod charts;
pub mod curve;
#[cfg(feature = "program")]
pub(crate) mod drawing;
#[cfg(feature = "program")]
pub(crate) mod fit;
#[cfg(feature = "program")]
pub(crate) mod heat_map;
#[cfg(feature = "program")]
pub(crate) mod space;
pub mod span;
#[cfg(feature = "program")]
pub(crate) mod tip;
pub mod view;
