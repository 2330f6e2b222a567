//! Input of a computation.
//!
//! | module | contents |
//! |---|---|
//! | [`text_file`] | text of a file |
//! | `csv_rows` | columns and rows of CSV files |
//! | `units` | numbers with units |
//! | `section` | table of a TOML file |
//! | [`scenario`], [`builtin`] | motion from a TOML file; motions that need no file |

pub mod text_file;

pub(crate) mod csv_rows;

mod units;

pub(crate) mod section;

pub mod scenario;

pub mod builtin;
