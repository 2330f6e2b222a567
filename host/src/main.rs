//! `toytop`: parse, run, print, exit code.

use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;
use toytop_host::{Failure, Report, run};

/// Exit code where a bound is missed or the output cannot be written.
const NOT_GOOD: u8 = 1;

fn main() -> ExitCode {
    match run(std::env::args_os()).and_then(|report| print(&report)) {
        Ok(code) => code,
        Err(failure) => {
            // stderr may be closed; there is nobody left to tell
            let _ = writeln!(io::stderr(), "error: {failure}");
            ExitCode::from(failure.exit_code())
        }
    }
}

/// Everything was computed before this: what is printed is whole.
fn print(report: &Report) -> Result<ExitCode, Failure> {
    for note in &report.notes {
        let _ = writeln!(io::stderr(), "{note}");
    }
    let mut stdout = io::stdout().lock();
    match stdout.write_all(report.text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::Output(error)),
        // a reader that has seen enough (`| head`) is no failure
        _ => Ok(if report.missed { ExitCode::from(NOT_GOOD) } else { ExitCode::SUCCESS }),
    }
}
