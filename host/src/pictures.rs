//! Pictures of a motion: its geometry, drawings of it, and the page for a browser.
//!
//! | module | contents |
//! |---|---|
//! | [`span`] | motion over a span of time |
//! | [`curve`] | curve of the tip, bounds between which the axis stays |
//! | `drawing` | drawings as SVG, PNG and GIF, which only the program makes |
//! | [`page`] | page for a browser |

pub mod span;

pub mod curve;

#[cfg(feature = "program")]
pub mod drawing;
pub mod page;
