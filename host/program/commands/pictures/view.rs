//! `toytop view`: a page for a browser.

use crate::arguments::options::ending_in;
use crate::commands::warnings::warnings;
use crate::files::whole_file;
use crate::terminal::report::Report;
use clap::Args;
use std::path::PathBuf;
use toytop_host::Failure;
use toytop_host::input::scenario::ScenarioFile;
use toytop_host::pictures::page;

/// Page for a browser that shows a top, with sliders for its launch
///
/// The page needs no network and no other file. It contains the core, which computes the motion that the sliders set.
#[derive(Args)]
#[command(
    after_help = "Example: toytop view host/scenarios/figure_3_loops.toml -o top.html\n         top.html#t=12.5 then shows that time\n         toytop view -o index.html   a page that begins with a toy top"
)]
pub struct ViewArgs {
    /// Scenario file of the first motion; by default a toy top
    scenario: Option<PathBuf>,
    /// Output file, whose name ends in .html or .htm
    #[arg(short, long, value_name = "FILE", value_parser = ending_in(&[".html", ".htm"]))]
    output: PathBuf,
}

pub fn run(arguments: &ViewArgs) -> Result<Report, Failure> {
    let start = match &arguments.scenario {
        Some(scenario) => ScenarioFile::read(scenario)?,
        None => page::toy_top(),
    };
    let scenario = start.scenario()?;
    let html = page::html(&start).map_err(|failure| failure.at(&scenario.name))?;
    whole_file::write("--output", &arguments.output, html.as_bytes())?;
    Ok(Report::default().with_notes(warnings(&[scenario])))
}
