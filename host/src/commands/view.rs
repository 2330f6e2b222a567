//! `toytop view`: a motion as a page for a browser.

use super::{Report, unreal};
use crate::Failure;
use crate::cli::ViewArgs;
use crate::input::scenario::Scenario;
use crate::output::whole_file;
use crate::pictures::view;

pub(super) fn run(arguments: &ViewArgs) -> Result<Report, Failure> {
    let path = &arguments.output;
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    if ending != "html" && ending != "htm" {
        return Err(Failure::Input(format!("--output: {}: must end in .html", path.display())));
    }
    let scenario = Scenario::read(&arguments.scenario)?;
    let page = view::page(&scenario).map_err(|failure| failure.of(&scenario.name))?;
    whole_file::write("--output", path, page.as_bytes())?;
    Ok(Report::default().with_remarks(unreal(&[scenario]), false))
}
