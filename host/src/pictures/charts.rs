//! Charts of curves over two axes.
//!
//! | module | contents |
//! |---|---|
//! | `chart` | curves over linear or logarithmic axes |
//! | `motion` | tilt and precession against time, potential |
//! | `fit` | residuals of a fit, error of its prediction |
//! | `heat_map` | column of a sweep over two axes |

pub mod chart;
pub mod fit;
pub mod heat_map;
pub mod motion;
