//! Pictures and pages.
//!
//! | module | contents |
//! |---|---|
//! | [`plot`] | curve of the tip |
//! | [`span`] | motion over a span of time |
//! | [`charts`] | tilt and precession against time, potential |
//! | [`animation`] | the top in motion, frame by frame |
//! | [`camera`], [`sphere`] | space on paper; the axis on its sphere |
//! | [`figures`] | figures of the paper, and charts |
//! | [`view`] | page for a browser |

pub mod animation;
pub mod camera;
pub mod charts;
pub mod figures;
pub mod plot;
pub mod span;
pub mod sphere;
pub mod view;
