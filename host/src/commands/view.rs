//! `toytop view`: a motion as a page for a browser.

use super::{Report, lift_off};
use crate::cli::ViewArgs;
use crate::scenario::Scenario;
use crate::{Failure, view, whole_file};

pub(super) fn run(arguments: &ViewArgs) -> Result<Report, Failure> {
    let path = &arguments.output;
    let refused =
        |reason: &dyn std::fmt::Display| Failure::Input(format!("--output: {}: {reason}", path.display()));
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    if ending != "html" && ending != "htm" {
        return Err(refused(&"must end in .html"));
    }
    let scenario = Scenario::read(&arguments.scenario)?;
    let page = view::page(&scenario).map_err(|failure| failure.of(&scenario.name))?;
    whole_file::write(path, page.as_bytes()).map_err(|error| refused(&error))?;
    Ok(Report::default().with_remarks(lift_off(&[scenario]), false))
}
