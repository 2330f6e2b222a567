//! Progress bar on stderr for work that takes more than a second; there is none where stderr is no terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::sync::Once;
use std::time::{Duration, Instant};

/// Progress of work with a known total.
pub struct Progress {
    bar: ProgressBar,
    started: Instant,
    shown: Once,
}

/// Time before the bar is shown.
const PATIENCE: Duration = Duration::from_secs(1);

impl Progress {
    /// Progress of `total` units of work, named `unit`.
    pub fn new(total: u64, unit: &'static str) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {human_pos}/{human_len} {msg}, {eta} left")
        {
            bar.set_style(style);
        }
        bar.set_message(unit);
        Self { bar, started: Instant::now(), shown: Once::new() }
    }

    /// Adds units of finished work.
    pub fn add(&self, units: u64) {
        self.bar.inc(units);
        if self.started.elapsed() > PATIENCE {
            self.shown.call_once(|| self.bar.set_draw_target(ProgressDrawTarget::stderr()));
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
