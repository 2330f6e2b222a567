//! `toytop overflow`: fixed point on random motions in checked arithmetic.

use super::Report;
use crate::cli::OverflowArgs;
use crate::overflow::{Tally, is_checked, tried};
use crate::progress::Progress;
use crate::{Failure, cores};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::sync::Mutex;

pub(super) fn run(arguments: &OverflowArgs) -> Result<Report, Failure> {
    if !is_checked() {
        return Err(Failure::Input(
            "this build does not check for overflow: cargo run --release --config profile.release.overflow-checks=true --bin toytop -- overflow"
                .into(),
        ));
    }
    let progress = Mutex::new(Progress::new(arguments.motions, "motions"));
    let one = |stream| {
        let tally = tried(arguments.seed, stream, arguments.ticks);
        if let Ok(mut progress) = progress.lock() {
            progress.add(1);
        }
        tally
    };
    let motions = (0..arguments.motions).into_par_iter();
    let tally = cores::all()?.install(|| motions.map(one).reduce(Tally::default, Tally::and));
    drop(progress);
    let Tally { motions, refused, ticks, steps, strain: [q31, q15, stepper], failures } = tally;
    let mut text = format!(
        "{motions} motions, seed {}: {ticks} ticks looked up and {steps} stepped, {refused} tables refused\n\
         error over stated bound, greatest: q31 {q31:.2}, q15 {q15:.2}, stepper in q31 {stepper:.2}\n\
         overflows and errors beyond their bounds: {}\n",
        arguments.seed,
        failures.len(),
    );
    for failure in &failures {
        text.push_str(&format!("FAILURE: {failure}\n"));
    }
    Ok(Report { text, missed: !failures.is_empty(), ..Report::default() })
}
