//! Pictures of a motion: its geometry, and the page for a browser.
//!
//! | module | contents |
//! |---|---|
//! | [`span`] | motion over a span of time |
//! | [`curve`] | curve of the tip, bounds between which the axis stays |
//! | [`page`] | page for a browser |

pub mod span;

pub mod curve;

pub mod page;
