//! `toytop view`: a page for a browser.

use super::{Report, unreal};
use crate::Failure;
use crate::cli::ViewArgs;
use crate::input::scenario::Scenario;
use crate::output::whole_file;
use crate::pictures::view::{self, Start};

pub(super) fn run(arguments: &ViewArgs) -> Result<Report, Failure> {
    let path = &arguments.output;
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    if ending != "html" && ending != "htm" {
        return Err(Failure::Input(format!("--output: {}: must end in .html or .htm", path.display())));
    }
    let start = match &arguments.scenario {
        Some(scenario) => Start { keys: Scenario::keys(scenario)?, scenario: Scenario::read(scenario)? },
        None => Start::toy_top()?,
    };
    let page = view::page(&start, view::CORE).map_err(|failure| failure.of(&start.scenario.name))?;
    whole_file::write("--output", path, page.as_bytes())?;
    let report = Report::default().with_remarks(unreal(&[start.scenario]), false);
    Ok(if view::CORE.is_empty() { report.with_remarks([view::NOT_LIVE.to_owned()], false) } else { report })
}
