//! `toytop view`: a page for a browser.

use super::options::ending_in;
use super::{Report, warnings};
use crate::Failure;
use crate::input::scenario::ScenarioFile;
use crate::output::whole_file;
use crate::pictures::view;
use clap::Args;
use std::path::PathBuf;

/// `toytop view`
#[derive(Args)]
pub struct ViewArgs {
    /// Scenario file of the motion that the page begins with; without it, the page begins with a toy top
    scenario: Option<PathBuf>,
    /// Output file, whose name ends in .html or .htm
    #[arg(short, long, value_name = "FILE", value_parser = ending_in(".html or .htm"))]
    output: PathBuf,
}

pub fn run(arguments: &ViewArgs) -> Result<Report, Failure> {
    let start = match &arguments.scenario {
        Some(scenario) => ScenarioFile::read(scenario)?,
        None => view::toy_top()?,
    };
    let scenario = start.scenario()?;
    let page = view::page(&start).map_err(|failure| failure.with_context(&scenario.name))?;
    whole_file::write("--output", &arguments.output, page.as_bytes())?;
    Ok(Report::default().with_notes(warnings(&[scenario]), false))
}
