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
pub mod column;
#[cfg(feature = "program")]
pub mod npy;
#[cfg(feature = "parquet")]
pub mod parquet;
#[cfg(feature = "program")]
pub mod sheet;
#[cfg(feature = "program")]
pub mod stream;
