//! Computing times of states by the core and by other methods, on this machine with this build.

pub mod methods;
pub mod ticks;
pub mod timing;

use crate::output::{Cell, Record};

/// Row of a table: the task that was timed, its time and its other cells.
pub struct Row {
    /// Name of the task.
    pub what: String,
    /// Time of the whole task, or of one tick, s.
    pub seconds: f64,
    /// Error of the orientation, rad.
    pub error: Option<f64>,
    /// Other cells.
    pub rest: Vec<String>,
}

impl Row {
    /// Record of the row.
    #[must_use]
    pub fn record(&self) -> Record {
        Record(vec![
            ("what", Cell::Text(self.what.trim().to_owned())),
            ("seconds", Cell::Number(self.seconds)),
            ("error_rad", self.error.into()),
        ])
    }
}
