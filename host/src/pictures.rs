//! Pictures and pages.
//!
//! | module | contents |
//! |---|---|
//! | [`plot`] | curve of the tip |
//! | `span` | motion over a span of time |
//! | `charts` | tilt and precession against time, potential |
//! | `animation` | animation of the top, frame by frame |
//! | `camera`, `sphere` | projection of space; the axis on its sphere |
//! | [`figures`] | figures of the paper, and charts |
//! | [`view`] | page for a browser |

#[cfg(feature = "program")]
pub(crate) mod animation;
#[cfg(feature = "program")]
mod camera;
#[cfg(feature = "program")]
pub(crate) mod charts;
#[cfg(feature = "program")]
pub mod figures;
pub mod plot;
#[cfg(feature = "program")]
pub(crate) mod span;
#[cfg(feature = "program")]
pub(crate) mod sphere;
pub mod view;
