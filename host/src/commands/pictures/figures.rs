//! `toytop figures`: the curves of figures 2 and 3 of the paper, as `plot` draws them.

use super::Report;
use crate::Failure;
use crate::input::builtin;
use crate::output::whole_file;
use crate::pictures::span::{MOST_CYCLES, Span};
use crate::pictures::{drawing, tip};
use clap::Args;
use std::path::PathBuf;

/// `toytop figures`
#[derive(Args)]
pub struct FiguresArgs {
    /// Folder to write to, which is created if it does not exist
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
}

pub fn run(arguments: &FiguresArgs) -> Result<Report, Failure> {
    let folder = &arguments.output;
    std::fs::create_dir_all(folder).map_err(|error| whole_file::refused("--output", folder, error))?;
    let mut text = String::new();
    for scenario in builtin::figures() {
        let span = Span::new(&scenario.motion, None, MOST_CYCLES)?;
        let scene = tip::draw(&scenario, &span);
        let path = folder.join(scenario.name.replace([' ', '='], "_") + ".svg");
        drawing::write("--output", &path, &scene, None)?;
        text.push_str(&format!("{}\n", path.display()));
    }
    Ok(text.into())
}
