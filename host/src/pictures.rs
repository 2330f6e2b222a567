//! Geometry of a motion for pictures, and the page for a browser.
//!
//! | module | contents |
//! |---|---|
//! | [`span`] | motion over a span of time |
//! | [`curve`] | curve of the tip, bounds between which the axis stays |
//! | [`view`] | page for a browser |

pub mod curve;
pub mod span;
pub mod view;
