//! Progress bar on stderr for work that takes more than a second; there is none where stderr is no terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::{IsTerminal, Write, stderr};
use std::time::{Duration, Instant};

/// Progress of work with a known total.
#[derive(Debug)]
pub struct Progress {
    bar: ProgressBar,
    started: Instant,
    possible: bool,
    /// Time of the last line; `None` where stderr is a terminal, or no lines are wanted.
    lines: Option<Instant>,
    unit: &'static str,
}

/// Time between two lines of a log.
const BETWEEN_LINES: Duration = Duration::from_secs(30);

/// Time before the bar is shown.
const PATIENCE: Duration = Duration::from_secs(1);

impl Progress {
    /// Progress of `total` units of work, named `unit`.
    #[must_use]
    pub fn new(total: u64, unit: &'static str) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {human_pos}/{human_len} {msg}, {eta} left")
        {
            bar.set_style(style);
        }
        bar.set_message(unit);
        Self { bar, started: Instant::now(), possible: stderr().is_terminal(), lines: None, unit }
    }

    /// Progress as from [`Progress::new`], which writes a line every half minute where stderr is no terminal.
    #[must_use]
    pub fn logged(total: u64, unit: &'static str) -> Self {
        let mut progress = Self::new(total, unit);
        progress.lines = (!progress.possible).then(Instant::now);
        progress
    }

    /// Adds units of finished work.
    pub fn add(&mut self, units: u64) {
        self.bar.inc(units);
        if let Some(last) = &mut self.lines
            && last.elapsed() > BETWEEN_LINES
        {
            *last = Instant::now();
            let _ = writeln!(
                stderr(),
                "{} of {} {}",
                self.bar.position(),
                self.bar.length().unwrap_or(0),
                self.unit
            );
        }
        if self.possible && self.started.elapsed() > PATIENCE {
            self.possible = false;
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
