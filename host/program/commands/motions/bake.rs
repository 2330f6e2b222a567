//! `toytop bake`: the table of a motion as a file for another program, a Rust module or a C header with its evaluator.
//!
//! Both contain the numbers of a [`Baked`](toytop::Baked) of any size, with format version and checksum. A Rust module in which a
//! number was changed does not compile; the C header has a function that checks the numbers. Both give the bits of the crate.
//!
//! C code for fixed point and `f32` works in integers, so that the compiler cannot change its bits. Code for `f64` has a barrier after each
//! product, so that no compiler fuses it with a sum.

mod c;
mod rust;

use crate::arguments::options::hertz;
use crate::commands::warnings::warnings;
use crate::files::{file_or_stdout, whole_file};
use crate::terminal::report::Report;
use c::header;
use clap::{Args, ValueEnum};
use fixed::types::{I2F14, I2F30};
use rust::module;
use std::path::PathBuf;
use toytop::{ErrorBound, Table, TableScalar, TableSettings, Tick};
use toytop_host::input::scenario::Scenario;
use toytop_host::motion::Scalar;
use toytop_host::motion::evaluator::{BoxedTable, SEGMENTS};
use toytop_host::{Failure, FailureKind};

/// Table of a motion as a constant for firmware: Rust or C
///
/// A table in C contains the code that evaluates it.
#[derive(Args)]
#[command(
    after_help = "Example: toytop bake top.toml --hertz 8000 -o src/top.rs         a static; it does not compile if a bit was changed\n         toytop bake top.toml --lang c --hertz 44100/2 -o top.h   C99 or C++11, with the same results to the bit"
)]
pub struct BakeArgs {
    /// Scenario file
    scenario: PathBuf,
    /// Scalar type of the results
    #[arg(long, default_value = "f32")]
    scalar: Scalar,
    /// Language of the table
    #[arg(long, default_value = "rust")]
    lang: Language,
    /// Segments: 25, 48 or a power of two from 8 to 4096; the default is 25 in f32, 48 in f64, 32 in q31, 16 in q15, more if the motion needs them
    #[arg(long, value_name = "N")]
    segments: Option<u32>,
    /// Ticks in a second: N, or A/B for A ticks in B seconds
    #[arg(long, value_name = "N", default_value = "1000", value_parser = hertz)]
    hertz: [u32; 2],
    /// Name of the table; by default the name of the scenario file
    #[arg(long, value_name = "NAME")]
    name: Option<String>,
    /// Output file; without it, stdout
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Language that `bake` writes.
#[derive(Clone, PartialEq, ValueEnum)]
pub enum Language {
    /// Module with one static
    Rust,
    /// Header with the table and the code that evaluates it
    C,
}

pub fn run(arguments: &BakeArgs) -> Result<Report, Failure> {
    whole_file::require_other("--output", arguments.output.as_deref(), &[Some(&arguments.scenario)])?;
    let scenario = Scenario::read(&arguments.scenario)?;
    let [ticks, seconds] = arguments.hertz;
    let tick = Tick::ratio(ticks, seconds).map_err(|error| Failure::from(error).at("--hertz"))?;
    let title = TableTitle {
        name: arguments.name.clone().unwrap_or_else(|| scenario.name.clone()),
        tick: if seconds == 1 { format!("{ticks} Hz") } else { format!("{ticks}/{seconds} Hz") },
        scalar: arguments.scalar,
    };
    // by default the sizes of `TableF64`, `TableF32`, `TableQ31` and `TableQ15`
    let [text, summary] = match arguments.scalar {
        Scalar::F64 => baked(arguments, &scenario, tick, &title, 48, Table::<f64>::crc32),
        Scalar::F32 => baked(arguments, &scenario, tick, &title, 25, Table::<f32>::crc32),
        Scalar::Q31 => baked(arguments, &scenario, tick, &title, 32, Table::<I2F30>::crc32),
        Scalar::Q15 => baked(arguments, &scenario, tick, &title, 16, Table::<I2F14>::crc32),
    }?;
    file_or_stdout::write(arguments.output.as_deref(), |out| out.write_all(text.as_bytes()))?;
    Ok(Report::default().with_notes(std::iter::once(summary).chain(warnings(&[scenario]))))
}

/// Text of the file, and the line that states the scalar, the size and the error bound of the table in it.
///
/// * `least`: default of `--segments`
fn baked<R: TableScalar<Coefficient: Into<f64>>>(
    arguments: &BakeArgs,
    scenario: &Scenario,
    tick: Tick,
    title: &TableTitle,
    least: u32,
    crc32: fn(&Table<R>) -> u32,
) -> Result<[String; 2], Failure> {
    let segments = arguments.segments.map_or(least..=*SEGMENTS.end(), |segments| segments..=segments);
    let table =
        BoxedTable::new(&scenario.motion, &TableSettings::new(tick), segments).map_err(|failure| {
            let no_such_size = failure.kind == FailureKind::Input;
            failure.at(if no_such_size { "--segments" } else { &scenario.name })
        })?;
    let table = table.table();
    let text = match arguments.lang {
        Language::Rust => module(title, table, crc32(table)),
        Language::C => header(title, table, crc32(table)),
    };
    let ErrorBound { constant, per_tick } = table.error_bound();
    let summary = format!(
        "{}: {}x{} in {}, {} bytes, {}; orientation within {constant:.1e} rad + {per_tick:.1e} rad a tick",
        title.name,
        table.capacity(),
        R::TERMS,
        title.scalar.name(),
        size_of_val(table.segments()),
        title.tick,
    );
    Ok([text, summary])
}

/// Description of the motion of a table, for the comment of a file.
pub struct TableTitle {
    /// Name of the scenario.
    pub name: String,
    /// Length of a tick, as text.
    pub tick: String,
    /// Scalar type.
    pub scalar: Scalar,
}

impl TableTitle {
    /// Identifier in lower case: letters and digits of ASCII are kept, any other letter or digit becomes `u` and its code, and everything
    /// between becomes one underscore.
    pub fn identifier(&self) -> String {
        let mut identifier = String::new();
        for c in self.name.chars() {
            match c {
                _ if c.is_ascii_alphanumeric() => identifier.push(c.to_ascii_lowercase()),
                _ if c.is_alphanumeric() => identifier += &format!("u{:04x}", u32::from(c)),
                _ if identifier.is_empty() || identifier.ends_with('_') => {}
                _ => identifier.push('_'),
            }
        }
        let identifier = identifier.trim_end_matches('_');
        if identifier.starts_with(|c: char| c.is_ascii_lowercase()) {
            identifier.to_owned()
        } else {
            format!("top_{identifier}")
        }
    }

    /// Identifier in C and C++. A name that may belong to the language or to a library (`int`, `time_t`, `toytop_f32`) has the prefix `top_`.
    pub fn c_name(&self) -> String {
        let name = self.identifier();
        let free = name.contains('_') && !name.ends_with("_t") && !name.starts_with("toytop_");
        if free { name } else { format!("top_{name}") }
    }

    /// Name and properties of the table for a comment, without characters that could end the comment.
    fn headline<R: TableScalar>(&self, table: &Table<R>) -> String {
        let printable = |c: &char| !c.is_control() && !['*', '/', '\\'].contains(c);
        let name: String = self.name.chars().filter(printable).collect();
        let ErrorBound { constant, per_tick } = table.error_bound();
        format!(
            "{name}, {}: {} x {} in {}; within {constant:.1e} rad + {per_tick:.1e} rad a tick",
            self.tick,
            table.capacity(),
            R::TERMS,
            self.scalar.name(),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_becomes_an_unused_identifier() {
        let named =
            |name: &str| TableTitle { name: name.to_owned(), tick: String::new(), scalar: Scalar::F32 };
        for (name, identifier, c_name) in [
            ("int", "int", "top_int"),
            ("Clock", "clock", "top_clock"),
            ("time_t", "time_t", "top_time_t"),
            ("toytop_f32", "toytop_f32", "top_toytop_f32"),
            ("toy_top", "toy_top", "toy_top"),
            ("2 tops", "top_2_tops", "top_2_tops"),
            ("_a__b_", "a_b", "a_b"),
            ("Kreisel ä", "kreisel_u00e4", "kreisel_u00e4"),
            ("Kreisel ö", "kreisel_u00f6", "kreisel_u00f6"),
            ("陀螺", "u9640u87ba", "top_u9640u87ba"),
            ("...", "top_", "top_"),
        ] {
            let title = named(name);
            assert_eq!([title.identifier(), title.c_name()], [identifier, c_name], "{name}");
        }
    }
}
