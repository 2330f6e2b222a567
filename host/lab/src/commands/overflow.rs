//! `toytop-lab overflow`: fixed point for random motions in checked arithmetic.

use crate::cli::OverflowArgs;
use crate::overflow::{Tally, is_checked, tried};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::sync::Mutex;
use toytop_host::Failure;
use toytop_host::Report;
use toytop_host::output::progress::Progress;
use toytop_host::thread_pool;

pub(super) fn run(arguments: &OverflowArgs) -> Result<Report, Failure> {
    if !is_checked() {
        return Err(Failure::Input(
            "this build does not check for overflow: cargo run --release --config profile.release.overflow-checks=true -p toytop-lab -- overflow"
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
    let tally = thread_pool::of_all_cores()?.install(|| motions.map(one).reduce(Tally::default, Tally::and));
    drop(progress);
    let Tally { motions, refused, ticks, of_bound: [q31, q15], failures } = tally;
    let mut text = format!(
        "{motions} motions, seed {}: {ticks} ticks looked up, {refused} tables refused\n\
         error over stated bound, greatest: q31 {q31:.2}, q15 {q15:.2}\n\
         overflows and errors beyond their bounds: {}\n",
        arguments.seed,
        failures.len(),
    );
    for failure in &failures {
        text.push_str(&format!("FAILURE: {failure}\n"));
    }
    Ok(Report { text, missed: !failures.is_empty(), ..Report::default() })
}
