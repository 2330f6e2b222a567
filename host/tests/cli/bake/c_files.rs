//! Tests of the files of `toytop bake --lang c --split`: shared code, and compilation.

use super::c::WARNINGS;
use crate::command::{finished, toytop, write};
use crate::folder;
use std::process::Command;

/// Code and sines are in one object for any number of motions and users, and a header that needs no other file can be used beside them.
#[test]
fn shared_code_is_linked_once() {
    let folder = folder("bake_shared");
    for line in [
        "@toy_top --split bake_shared --name first_throw",
        "@lagrange --split bake_shared --name second_throw",
        "@toy_top -o bake_shared/toy_top.h",
    ] {
        toytop(format!("bake --lang c {line}")).ok();
    }
    let user = "#include \"first_throw.h\"\n#include \"second_throw.h\"\n#include \"toy_top.h\"\n";
    let main = format!("{user}float other(void);
int main(void) {{
    float sum = toytop_at_tick_f32(&first_throw, 1).u + toytop_at_tick_f32(&second_throw, 1).u;
    return sum == other() && FIRST_THROW_RATE == 1000.0 && FIRST_THROW_ERROR < 2e-7 && TOY_TOP_SEGMENTS == 25 ? 0 : 1;
}}
");
    let other = format!(
        "{user}float other(void);
float other(void) {{ return toytop_at_tick_f32(&toy_top, 1).u + toytop_at_tick_f32(&second_throw, 1).u; }}
"
    );
    let files = ["main.c", "other.c", "first_throw.c", "second_throw.c", "toytop_baked.c"]
        .map(|name| folder.join(name));
    write("bake_shared/main.c", main);
    write("bake_shared/other.c", other);
    let program = folder.join("main");
    let mut command = Command::new("cc");
    finished(command.args(["-std=c99", "-O0"]).args(WARNINGS).arg("-o").arg(&program).args(&files)).ok();
    finished(&mut Command::new(&program)).ok();
    let bytes = std::fs::read(&program).expect("the program");
    let sines: Vec<u8> = toytop::scalar::sine::SINES.iter().flat_map(|sine| sine.to_le_bytes()).collect();
    let copies = bytes.windows(sines.len()).filter(|bytes| *bytes == sines).count();
    assert_eq!(copies, 1, "copies of the sines");
}
