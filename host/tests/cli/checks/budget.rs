//! `toytop budget`.

use crate::command::{all_refused, write};

#[test]
fn wrong_arguments_are_refused() {
    write("no_program.elf", "");
    all_refused(
        "budget",
        &[
            ("--chip m5", "m0plus, m4f, m7, m33, riscv"),
            ("--clock 0", "a number above 0"),
            ("--elf no_program.elf", "--chip"),
            ("--elf no_program.elf --chip m4f", "no_program.elf"),
            ("--check --accept", "--accept"),
            ("--check --flash", "--flash"),
        ],
    );
}
