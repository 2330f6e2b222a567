//! Tests of the files of `toytop bake --lang c --split` and `--arduino`: shared code, and compilation.

use super::c::WARNINGS;
use super::compiled::succeed;
use crate::{folder, run, sample, stderr};
use std::path::Path;
use std::process::Command;

/// Code and sines are in one object for any number of motions and users, and a header that needs no other file can be used beside them.
#[test]
fn shared_code_is_linked_once() {
    let folder = folder("bake_shared");
    let to = folder.to_str().expect("UTF-8");
    for (motion, name) in [("toy_top", "first_throw"), ("lagrange", "second_throw")] {
        let output = run(&["bake", &sample(motion), "--lang", "c", "--split", to, "--name", name]);
        assert!(output.status.success(), "{}", stderr(&output));
    }
    let alone = folder.join("toy_top.h");
    let output = run(&["bake", &sample("toy_top"), "--lang", "c", "-o", alone.to_str().expect("UTF-8")]);
    assert!(output.status.success(), "{}", stderr(&output));
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
    std::fs::write(&files[0], main).expect("the source");
    std::fs::write(&files[1], other).expect("the source");
    let program = folder.join("main");
    let mut command = Command::new("cc");
    succeed(command.args(["-std=c99", "-O0"]).args(WARNINGS).arg("-o").arg(&program).args(&files));
    succeed(&mut Command::new(&program));
    let bytes = std::fs::read(&program).expect("the program");
    let points = toytop::scalar::SINE_CONSTANTS.points;
    let sines: Vec<u8> = points.iter().flat_map(|sine| sine.to_le_bytes()).collect();
    let copies = bytes.windows(sines.len()).filter(|bytes| *bytes == sines).count();
    assert_eq!(copies, 1, "copies of the sines");
}

/// A library of Arduino is C99, with the same files.
#[test]
fn an_arduino_library_compiles() {
    let folder = folder("bake_arduino");
    let to = folder.to_str().expect("UTF-8");
    for name in ["toy_top", "lagrange"] {
        let output = run(&["bake", &sample(name), "--lang", "c", "--arduino", to]);
        assert!(output.status.success(), "{}", stderr(&output));
    }
    for name in ["toytop_baked", "toy_top", "top_lagrange"] {
        let source = folder.join(format!("src/{name}.c"));
        let object = folder.join("object.o");
        succeed(
            Command::new("cc").args(["-std=c99", "-c"]).args(WARNINGS).arg("-o").arg(&object).arg(&source),
        );
    }
    let properties = std::fs::read_to_string(folder.join("library.properties")).expect("the properties");
    assert!(properties.contains("name=ToytopBaked\n") && properties.contains("architectures=*"));
    let sketch = folder.join("examples/toy_top/toy_top.ino");
    let sketch = std::fs::read_to_string(sketch).expect("the sketch");
    // the part of Arduino's interface that the example needs
    let program = format!(
        "#include <cstdint>\nextern \"C\" unsigned long millis(void);\nvoid delay(int);\n\
         struct {{ void begin(long) {{}} void print(float) {{}} }} Serial;\n{sketch}"
    );
    let source = folder.join("sketch.cpp");
    std::fs::write(&source, program).expect("the source");
    let mut command = Command::new("g++");
    succeed(command.args(["-std=c++11", "-fsyntax-only", "-I"]).arg(folder.join("src")).arg(&source));
}

#[test]
fn folders_are_for_c_only() {
    for option in ["--split", "--arduino"] {
        let output = run(&["bake", &sample("toy_top"), option, "no_such_folder"]);
        assert_eq!(
            (output.status.code(), stderr(&output)),
            (Some(2), format!("error: {option}: needs --lang c\n").as_str())
        );
        assert!(!Path::new("no_such_folder").exists());
    }
}
