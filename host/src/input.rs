//! Input of a computation.
//!
//! | module | contents |
//! |---|---|
//! | [`random`] | random numbers fixed by a seed |
//! | [`text_file`] | text of a file |
//! | `csv_rows` | columns and rows of CSV files |
//! | `units` | numbers with units |
//! | `section` | table of a TOML file |
//! | [`scenario`], [`builtin`] | motion from a TOML file; motions that need no file |

pub mod random;
pub mod text_file;

pub(crate) mod csv_rows;

mod units;

pub(crate) mod section;

pub mod scenario;

pub mod builtin;

use crate::Failure;

/// Refuses times further from t = 0 than `most`; `suffix` ends the message.
///
/// # Errors
/// [`Failure::input`].
pub fn require_within(times: impl IntoIterator<Item = f64>, most: f64, suffix: &str) -> Result<(), Failure> {
    let beyond = |t| Err(Failure::input(format!("{t:e} must be within ±{most:.1e}{suffix}")));
    times.into_iter().find(|t| t.abs() > most).map_or(Ok(()), beyond)
}

/// Finite number of a text.
pub fn finite(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|x: &f64| x.is_finite())
}
