//! Progress bar on stderr for work that takes more than a second; there is none where stderr is no terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressFinish, ProgressStyle};

/// Progress of work with a known total. The bar disappears with it.
pub struct Progress(ProgressBar);

impl Progress {
    /// Progress of `total` units of work, named `unit`.
    pub fn new(total: u64, unit: &'static str) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {human_pos}/{human_len} {msg}, {eta} left")
        {
            bar.set_style(style);
        }
        Self(bar.with_message(unit).with_finish(ProgressFinish::AndClear))
    }

    /// Adds units of finished work.
    pub fn add(&self, units: u64) {
        self.0.inc(units);
        if self.0.is_hidden() && self.0.elapsed().as_secs() >= 1 {
            self.0.set_draw_target(ProgressDrawTarget::stderr());
        }
    }
}
