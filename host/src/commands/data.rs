//! Commands on samples of sensors and on the output of integrators.

pub mod benchmark;
pub mod fit;
pub mod score;
pub mod simulate;

use super::motion::times;
use super::{Report, options};
