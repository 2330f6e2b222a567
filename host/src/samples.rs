//! Samples of a motion as tables of chosen columns, written as they are computed.
//!
//! | module | contents |
//! |---|---|
//! | `column` | quantities of a sample |
//! | [`angles`] | Euler angles of an orientation |
//! | `sheet` | rows as CSV, JSON or an aligned table |
//! | `npy` | rows as a NumPy array |
//! | `parquet` | rows as Parquet (with the feature) |
//! | `stream` | blocks of rows, computed on all cores and written in order |

pub mod angles;
#[cfg(feature = "program")]
pub(crate) mod column;
#[cfg(feature = "program")]
pub(crate) mod npy;
#[cfg(feature = "parquet")]
pub(crate) mod parquet;
#[cfg(feature = "program")]
pub(crate) mod sheet;
#[cfg(feature = "program")]
pub(crate) mod stream;
