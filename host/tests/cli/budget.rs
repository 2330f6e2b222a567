//! Tests of `toytop budget`.

use super::{run, stderr, stdout};
use std::path::Path;
use toytop_host::budget::{Limits, with_front_table, with_table};

/// `cargo xtask test --only budget` runs this test, and provides compilers and QEMU.
#[test]
#[ignore = "minutes of emulation: cargo xtask test --only budget"]
fn every_call_is_within_its_budget() {
    let output = run(&["budget", "--check"]);
    assert_eq!(output.status.code(), Some(0), "{}{}", stdout(&output), stderr(&output));
    assert!(stdout(&output).ends_with("within budget\n"), "{}", stdout(&output));
}

#[test]
fn pages_have_the_tables_of_the_budgets() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("a folder of the repository");
    let text = |name: &str| std::fs::read_to_string(root.join(name)).expect(name);
    let limits = Limits::parse(&text("firmware-examples/budgets.toml")).expect("budgets");
    let [costs, front] = ["host/docs/costs.md", "README.md"].map(text);
    let fresh =
        [with_table(&costs, &limits), with_front_table(&front, &limits)].map(|page| page.expect("a place"));
    assert_eq!([costs, front], fresh, "how to renew them: the head of firmware-examples/budgets.toml");
}

#[test]
fn bad_input_is_refused_in_one_line() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml");
    for (arguments, named) in [
        (&["--chip", "m5"][..], "m0plus, m4f, m7, m33, riscv"),
        (&["--clock", "0"], "a number above 0"),
        (&["--elf", file], "--chip"),
        (&["--elf", file, "--chip", "m4f"], "Cargo.toml"),
        (&["--check", "--accept"], "--accept"),
        (&["--check", "--size"], "--size"),
    ] {
        let output = run(&[&["budget"], arguments].concat());
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(stdout(&output).is_empty(), "{arguments:?}");
        let said = stderr(&output);
        assert!(said.lines().count() == 1 && said.contains(named), "{arguments:?}: {said}");
    }
}
