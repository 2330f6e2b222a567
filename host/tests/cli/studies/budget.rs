//! `toytop budget`.

use crate::command::{all_refused, repository, write};
use std::path::PathBuf;
use toytop_host::budget::{Limits, OF_LIMITS};
use toytop_host::output::doc_markers::Page;

#[test]
fn pages_have_the_tables_of_the_budgets() {
    let file = |name: &str| PathBuf::from(repository(name));
    let limits = Limits::read(&file("firmware-examples/budgets.toml")).expect("budgets");
    for (name, mark, text) in OF_LIMITS {
        let page = Page::read(&file(name), mark).expect("a place");
        assert!(
            page.has(&text(&limits)),
            "{name}: how to renew it: the head of firmware-examples/budgets.toml"
        );
    }
}

#[test]
fn bad_input_is_refused_in_one_line() {
    write("no_program.elf", "");
    all_refused(
        "budget",
        &[
            ("--chip m5", "m0plus, m4f, m7, m33, riscv"),
            ("--clock 0", "a number above 0"),
            ("--elf no_program.elf", "--chip"),
            ("--elf no_program.elf --chip m4f", "no_program.elf"),
            ("--check --accept", "--accept"),
            ("--check --size", "--size"),
        ],
    );
}
