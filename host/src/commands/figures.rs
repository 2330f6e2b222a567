//! `toytop figures`: figures 2 and 3 of the paper, u against time, and errors against time.

use super::Report;
use crate::Failure;
use crate::cli::FiguresArgs;
use crate::output::whole_file;
use crate::pictures::figures;
use crate::pictures::plot::Form;

pub(super) fn run(arguments: &FiguresArgs) -> Result<Report, Failure> {
    let folder = &arguments.output;
    std::fs::create_dir_all(folder).map_err(|error| whole_file::refused("--output", folder, error))?;
    let mut text = String::new();
    for picture in figures::all()? {
        for (ending, form) in [("svg", Form::Svg), ("png", Form::Png)] {
            let path = folder.join(format!("{}.{ending}", picture.name));
            whole_file::write("--output", &path, &picture.encoded(form)?)?;
            text.push_str(&format!("{}\n", path.display()));
        }
    }
    Ok(Report { text, ..Report::default() })
}
