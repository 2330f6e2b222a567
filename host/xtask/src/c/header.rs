//! Header for C, which cbindgen makes from the sources, and which every compiler and standard accepts without a warning.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

use super::archive::target_dir;
use super::compile;
use crate::process::{root, run};

/// Program that includes the header twice and uses its macros.
const PROGRAM: &str = "#include <toytop.h>
#include <toytop.h>
static toytop_table_q31 table;
static uint64_t larger[TOYTOP_TABLE_F32_SIZE_OF(128) / 8];
int main(void) {
    toytop_error error;
    toytop_settings settings = {{1000, 1}, 0, 0.0, 0, 0, 0};
    toytop_status status = toytop_q31_set_up(&table, sizeof table, 0, &settings, &error);
    if (status != TOYTOP_OK) status = error.status;
    return status == TOYTOP_NULL_POINTER && larger[0] == 0 && sizeof larger == 10496 ? 0 : 1;
}
";

/// Pages, each with what makes its first program in C complete, and with what it prints. At tick 0, w is cos(0.35/2).
const PAGES: [(&str, &str, &str); 2] = [
    ("README.md", "", "0.984727 "),
    (
        "core/c/README.md",
        "int main(void) {
    toytop_error why;
    if (launch(&why)) return 1;
    SysTick_Handler();
    return 0;
}
",
        "",
    ),
];

/// Pages with the sources of their first programs in C, which are written to a folder.
pub(super) fn programs_of_pages(folder: &Path) -> Result<Vec<(&'static str, PathBuf, &'static str)>> {
    let written = |(index, (page, main, prints)): (usize, (&'static str, &str, &'static str))| {
        let source = folder.join(format!("page_{index}.c"));
        fs::write(&source, first_program(page)? + main)?;
        Ok((page, source, prints))
    };
    PAGES.into_iter().enumerate().map(written).collect()
}

/// First program in C of a page.
fn first_program(page: &str) -> Result<String> {
    let text = fs::read_to_string(root().join(page))?;
    let (_, rest) = text.split_once("```c\n").with_context(|| format!("{page}: no program in C"))?;
    let (program, _) = rest.split_once("```").with_context(|| format!("{page}: a program without end"))?;
    Ok(program.to_owned())
}

/// Compiles a program that includes the header with each compiler in each standard.
pub(crate) fn check() -> Result<String> {
    let folder = target_dir().join("header");
    fs::create_dir_all(&folder)?;
    let include = root().join("core/c/include");
    let mut count = 0;
    for (compilers, suffix, standards, warning) in [
        (["gcc", "clang"], "c", ["c99", "c11", "c17"], "-Wstrict-prototypes"),
        (["g++", "clang++"], "cpp", ["c++11", "c++14", "c++17"], "-Wold-style-cast"),
    ] {
        let source = folder.join(format!("header.{suffix}"));
        fs::write(&source, PROGRAM)?;
        for compiler in compilers {
            for standard in standards {
                let mut command = compile(compiler, standard, &include);
                run(command.args([warning, "-c", "-o"]).arg(folder.join("header.o")).arg(&source))?;
                count += 1;
            }
        }
    }
    Ok(format!("{count} pairs of compiler and standard accept the header"))
}
