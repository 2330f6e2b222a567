//! A bar on stderr for what takes over a second; nothing where stderr is no terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::{IsTerminal, Write, stderr};
use std::time::{Duration, Instant};

/// Work done, out of a known total.
#[derive(Debug)]
pub struct Progress {
    bar: ProgressBar,
    started: Instant,
    possible: bool,
    /// Where stderr is no terminal and a log is wanted: the time of the last line.
    lines: Option<Instant>,
    unit: &'static str,
}

/// Time between two lines.
const BETWEEN_LINES: Duration = Duration::from_secs(30);

/// Work that is done sooner shows no bar.
const PATIENCE: Duration = Duration::from_secs(1);

impl Progress {
    /// `total` units of work ahead, named by `unit`. Nothing is drawn yet.
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

    /// The same, and where stderr is no terminal a line every half minute, for a log.
    #[must_use]
    pub fn logged(total: u64, unit: &'static str) -> Self {
        let mut progress = Self::new(total, unit);
        progress.lines = (!progress.possible).then(Instant::now);
        progress
    }

    /// So much more is done.
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
