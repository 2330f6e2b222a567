//! `toytop figures`: the curves of figures 2 and 3 of the paper, as `plot` draws them.

use crate::arguments::options::not_stdout;
use crate::commands::pictures::plot::tip;
use crate::drawing;
use crate::files::whole_file;
use crate::terminal::report::Report;
use clap::Args;
use std::path::PathBuf;
use toytop_host::Failure;
use toytop_host::input::builtin;
use toytop_host::motion::evaluator::MotionEvaluator;
use toytop_host::pictures::{MAX_CYCLES, MotionSpan};

/// Curves of figures 2 and 3 of the paper, as SVG
#[derive(Args)]
#[command(after_help = "Example: toytop figures -o figures")]
pub struct FiguresArgs {
    /// Folder to write to, which is created if it does not exist
    #[arg(short, long, value_name = "DIR", value_parser = not_stdout)]
    output: PathBuf,
}

pub fn run(arguments: &FiguresArgs) -> Result<Report, Failure> {
    let folder = &arguments.output;
    std::fs::create_dir_all(folder).map_err(|error| whole_file::refused("--output", folder, error))?;
    let mut text = String::new();
    for scenario in builtin::figures() {
        let span = MotionSpan::new(MotionEvaluator::of_scenario(&scenario)?, None, MAX_CYCLES)?;
        let scene = tip::draw(&scenario, &span);
        let path = folder.join(scenario.name.replace([' ', '='], "_") + ".svg");
        drawing::write("--output", &path, &scene, None)?;
        text.push_str(&format!("{}\n", path.display()));
    }
    Ok(text.into())
}
