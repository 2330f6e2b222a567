//! `toytop bake`: the table of a motion as a file for another program.

use super::{Report, unreal};
use crate::Failure;
use crate::bake::{Label, Parts, arduino_files, header, module, object, split_files};
use crate::cli::{BakeArgs, Language};
use crate::input::scenario::Scenario;
use crate::motion::ephemeris::{default_or_smallest, of_size, smaller};
use crate::output::whole_file;
use std::path::Path;
use toytop::{ErrorBound, Tick};

pub(super) fn run(arguments: &BakeArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let folder = folder(arguments)?;
    let [ticks, seconds] = arguments.tick.unwrap_or([arguments.hertz, 1]);
    let tick = Tick::ratio(ticks, seconds).map_err(|error| Failure::Input(format!("--tick: {error}")))?;
    let Baked { parts, smaller } = baked(arguments, &scenario, tick).map_err(|failure| match failure {
        method @ Failure::Method(_) => method.of(&scenario.name),
        other => other,
    })?;
    let label = Label {
        name: arguments.name.clone().unwrap_or_else(|| scenario.name.clone()),
        tick: if seconds == 1 { format!("{ticks} Hz") } else { format!("{ticks}/{seconds} Hz") },
    };
    let mut report = Report::default();
    match folder {
        Some((option, folder, files)) => write_files(option, folder, &files(&label, &parts))?,
        None => {
            let text = match arguments.lang {
                Language::Rust => module(&label, &parts),
                Language::C => header(&label, &parts),
                Language::Json => object(&label, &parts),
            };
            match &arguments.output {
                None => report.text = text,
                Some(path) => whole_file::write("--output", path, text.as_bytes())?,
            }
        }
    }
    let remarks =
        std::iter::once(summary(&label, &parts) + &advice(smaller.as_ref())).chain(unreal(&[scenario]));
    Ok(report.with_remarks(remarks, false))
}

/// Function that makes the files of a folder, by their names in it.
type Files = fn(&Label, &Parts) -> Vec<(String, String)>;

/// Folder for several files, with its option and the function that makes them.
fn folder(arguments: &BakeArgs) -> Result<Option<(&'static str, &Path, Files)>, Failure> {
    let chosen = match (&arguments.split, &arguments.arduino) {
        (Some(folder), _) => Some(("--split", folder.as_path(), split_files as Files)),
        (None, Some(folder)) => Some(("--arduino", folder.as_path(), arduino_files as Files)),
        (None, None) => None,
    };
    if let Some((option, ..)) = chosen
        && arguments.lang != Language::C
    {
        return Err(Failure::Input(format!("{option}: needs --lang c")));
    }
    Ok(chosen)
}

/// Writes each file completely or not at all, and the files that all tables share first.
fn write_files(option: &str, folder: &Path, files: &[(String, String)]) -> Result<(), Failure> {
    for (name, text) in files {
        let path = folder.join(name);
        if let Some(parent) = path.parent() {
            std::fs::create_dir_all(parent).map_err(|error| whole_file::refused(option, parent, error))?;
        }
        whole_file::write(option, &path, text.as_bytes())?;
    }
    Ok(())
}

/// Table that is written, and the smallest one that would be enough, if that has fewer segments.
struct Baked {
    parts: Parts,
    smaller: Option<Parts>,
}

fn baked(arguments: &BakeArgs, scenario: &Scenario, tick: Tick) -> Result<Baked, Failure> {
    let (scalar, motion) = (arguments.scalar, &scenario.motion);
    let table = match arguments.size {
        Some(size) => of_size(scalar, size, motion, tick),
        None => default_or_smallest(scalar, motion, tick),
    }?;
    let parts = table.parts().ok_or_else(|| {
        let scalar = scalar.name();
        Failure::Input(format!("--scalar: {scalar}: must be f64, f32, q31 or q15 with bake"))
    })?;
    let smaller = smaller(scalar, motion, tick, &*table).and_then(|table| table.parts());
    Ok(Baked { parts, smaller })
}

/// End of the summary that names the size of a smaller table with the same error bound.
fn advice(smaller: Option<&Parts>) -> String {
    smaller.map_or_else(String::new, |parts| {
        let [segments, _] = parts.size;
        format!("; --size {segments} would be enough ({} bytes)", parts.table_bytes())
    })
}

/// Line that states the scalar, the size and the error bound of the table that was written.
fn summary(label: &Label, parts: &Parts) -> String {
    let ([segments, terms], ErrorBound { constant, per_tick }) = (parts.size, parts.error_bound);
    format!(
        "{}: {segments}x{terms} in {}, {} bytes, {}; orientation within {constant:.1e} rad + {per_tick:.1e} rad a tick",
        label.name,
        parts.scalar.name(),
        parts.table_bytes(),
        label.tick,
    )
}
