//! What `toytop bake` writes, compiled by the system's C compiler and by cargo: it gives the bits of the crate.

use super::cases::{Case, RUNS, assert_equal, cases};
use crate::{folder, run, sample, stderr, stdout};
use std::path::Path;
use std::process::{Command, Output};

fn bake(case: &Case, lang: &str, to: &Path) {
    let tick = format!("{}/{}", case.tick[0], case.tick[1]);
    let to = to.to_str().expect("UTF-8");
    let arguments = ["bake", &case.file, "--scalar", case.scalar, "--size", case.size, "--lang", lang];
    let output = run(&[&arguments[..], &["--tick", &tick, "-o", to]].concat());
    assert_eq!((output.status.code(), stdout(&output)), (Some(0), ""), "{}", stderr(&output));
    let note = stderr(&output).lines().next().expect("a note");
    assert!(
        note.contains(&format!(": {}x", case.size)) && note.contains(&format!(" in {}, ", case.scalar)),
        "{note}"
    );
}

fn name(case: &Case) -> String {
    Path::new(&case.file).file_stem().expect("a name").to_str().expect("UTF-8").to_lowercase()
}

fn succeed(command: &mut Command) -> Output {
    let output = command.output().expect("it runs");
    assert!(output.status.success(), "{command:?}: {}", stderr(&output));
    output
}

#[test]
fn c_gives_the_same_bits() {
    let (folder, cases) = (folder("bake_c"), cases());
    let (singles, runs, length) = RUNS;
    let mut source = "#include <stdio.h>\n#include <stdint.h>\n".to_owned();
    let mut main = String::new();
    for case in &cases {
        let (name, scalar) = (name(case), case.scalar);
        bake(case, "c", &folder.join(format!("{name}.h")));
        // twice: once is enough
        source += &format!("#include \"{name}.h\"\n#include \"{name}.h\"\n");
        let [word, format] = match scalar {
            "f64" => ["uint64_t", "PRIx64"],
            "q15" => ["uint16_t", "PRIx16"],
            _ => ["uint32_t", "PRIx32"],
        };
        // one word might be one of C's
        let table = if name.contains('_') { name.clone() } else { format!("top_{name}") };
        main += &format!(
            "    if (!toytop_intact_{scalar}(&{table})) return 1;
    state = 1;
    for (uint32_t k = 0; k < {singles}; k++) {{
        int64_t tick = next_tick(k);
        toytop_sample_{scalar} m = toytop_at_tick_{scalar}(&{table}, tick);
        PRINT({word}, {format}, toytop_at(&{table}.clock, tick), m);
    }}
    for (uint32_t k = 0; k < {runs}; k++) {{
        int64_t first = k < 2 ? {table}.clock.horizon[k] - 9 : next_tick(k + 20);
        toytop_cursor at = toytop_at(&{table}.clock, first);
        for (int i = 0; i < {length}; i++) {{
            toytop_cursor now = at;
            toytop_sample_{scalar} m = toytop_next_{scalar}(&{table}, &at);
            PRINT({word}, {format}, now, m);
        }}
    }}
"
        );
    }
    source += "#include <inttypes.h>
#define PRINT(word, format, at, m) do { \\
    word bits[7]; \\
    memcpy(bits, &m, sizeof bits); \\
    printf(\"%\" PRIx64 \" \", (at).phase[0].leading); \\
    for (int j = 0; j < 7; j++) printf(\"%\" format \"%c\", bits[j], j < 6 ? ' ' : '\\n'); \\
} while (0)
static uint64_t state;
static int64_t next_tick(uint32_t k) {
    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (int64_t)state >> (k % 61);
}
int main(void) {
";
    source += &main;
    source += "    return 0;\n}\n";
    let [code, program] = ["main.c", "main"].map(|name| folder.join(name));
    std::fs::write(&code, source).expect("the source");
    let flags = ["-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror", "-O2", "-ffp-contract=off", "-o"];
    succeed(Command::new("cc").args(flags).arg(&program).arg(&code));
    let printed = succeed(&mut Command::new(&program));
    assert_equal(stdout(&printed), &cases);

    // a bit changed in the table is told
    let header = folder.join("toy_top.h");
    let text = std::fs::read_to_string(&header).expect("the header");
    let (head, rows) = text.split_once("toy_top_coefficients[125][4] = {").expect("the table");
    let changed = format!("{head}toy_top_coefficients[125][4] = {{{}", rows.replacen(", ", ", 1", 1));
    std::fs::write(&header, changed).expect("the header");
    succeed(Command::new("cc").args(flags).arg(&program).arg(&code));
    assert_eq!(Command::new(&program).output().expect("it runs").status.code(), Some(1));
}

/// A compiler of C or C++ that is installed, a standard, and what it needs for the bits.
fn compilers() -> Vec<(&'static str, &'static str)> {
    let there = |name: &&str| {
        Command::new(name).arg("--version").output().is_ok_and(|output| output.status.success())
    };
    let c = ["cc", "clang"].into_iter().filter(there).flat_map(|name| ["c99", "c11"].map(|std| (name, std)));
    let cpp = ["g++", "clang++"].into_iter().filter(there);
    c.chain(cpp.flat_map(|name| ["c++11", "c++14", "c++17"].map(|std| (name, std)))).collect()
}

/// Every standard takes a header of every scalar without a warning, and reads the same numbers.
#[test]
fn c_and_cpp_of_every_standard_read_the_same_numbers() {
    let folder = folder("bake_standards");
    let (mut includes, mut checks) = (String::new(), String::new());
    for (motion, scalar) in
        [("toy_top", "f32"), ("figure_3_loops", "f64"), ("lagrange", "q31"), ("sleeping", "q15")]
    {
        let to = folder.join(format!("{motion}.h"));
        let output = run(&[
            "bake",
            &sample(motion),
            "--scalar",
            scalar,
            "--lang",
            "c",
            "-o",
            to.to_str().expect("UTF-8"),
        ]);
        assert!(output.status.success(), "{}", stderr(&output));
        includes += &format!("#include \"{motion}.h\"\n");
        let name = if motion.contains('_') { motion.to_owned() } else { format!("top_{motion}") };
        checks += &format!(
            "    if (!toytop_intact_{scalar}(&{name})) return 1;
    {{ toytop_cursor at = toytop_at(&{name}.clock, -3);
      for (int i = 0; i < 9; i++) {{
        toytop_sample_{scalar} m = toytop_next_{scalar}(&{name}, &at);
        unsigned char bytes[sizeof m];
        memcpy(bytes, &m, sizeof m);
        for (unsigned j = 0; j < sizeof m; j++) printf(\"%02x\", bytes[j]);
      }} }}\n"
        );
    }
    let code = format!("#include <stdio.h>\n{includes}int main(void) {{\n{checks}    return 0;\n}}\n");
    let mut printed = Vec::new();
    let compilers = compilers();
    assert!(compilers.iter().any(|(name, _)| *name == "cc"), "no C compiler");
    for (compiler, standard) in compilers {
        let source = folder.join(if standard.starts_with("c++") { "main.cpp" } else { "main.c" });
        std::fs::write(&source, &code).expect("the source");
        let program = folder.join(format!("{compiler}_{standard}"));
        let mut command = Command::new(compiler);
        command.arg(format!("-std={standard}")).args([
            "-Wall",
            "-Wextra",
            "-Wpedantic",
            "-Wconversion",
            "-Wshadow",
        ]);
        command.args(["-Werror", "-O1", "-ffp-contract=off", "-o"]).arg(&program).arg(&source);
        succeed(&mut command);
        printed.push(stdout(&succeed(&mut Command::new(&program))).to_owned());
    }
    assert!(printed[0].len() > 1000 && printed.iter().all(|text| *text == printed[0]));
}

/// Two motions from files of one name: the compiler refuses the second, instead of leaving it out.
#[test]
fn two_tables_of_one_name_do_not_compile() {
    let folder = folder("bake_one_name");
    for (place, other) in [("a", ["tilt_deg = 20.0", "tilt_deg = 21.0"]), ("b", ["", ""])] {
        let text = std::fs::read_to_string(sample("lagrange")).expect("the sample");
        std::fs::create_dir(folder.join(place)).expect("a folder");
        let [file, header] = ["top.toml", "top.h"].map(|name| folder.join(place).join(name));
        std::fs::write(&file, text.replace(other[0], other[1])).expect("the scenario");
        let [file, header] = [&file, &header].map(|path| path.to_str().expect("UTF-8"));
        assert!(run(&["bake", file, "--lang", "c", "-o", header]).status.success());
    }
    let source = folder.join("main.c");
    let compiled = |includes: &str| {
        std::fs::write(
            &source,
            format!("{includes}int main(void) {{ return toytop_intact_f32(&top_top) - 1; }}\n"),
        )
        .expect("the source");
        let program = folder.join("main");
        Command::new("cc").arg("-std=c99").arg("-o").arg(program).arg(&source).output().expect("it runs")
    };
    assert!(compiled("#include \"a/top.h\"\n#include \"a/top.h\"\n").status.success());
    let refused = compiled("#include \"a/top.h\"\n#include \"b/top.h\"\n");
    assert!(!refused.status.success());
    assert!(stderr(&refused).contains("two different tables have the name top_top"), "{}", stderr(&refused));
}

#[test]
fn rust_gives_the_same_bits_and_a_changed_number_does_not_compile() {
    let (folder, cases) = (folder("bake_rust"), cases());
    let (singles, runs, length) = RUNS;
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    std::fs::create_dir(folder.join("src")).expect("a folder");
    let core = root.join("core").canonicalize().expect("core");
    std::fs::write(
        folder.join("Cargo.toml"),
        format!(
            "[package]\nname = \"baked\"\nedition = \"2024\"\n[dependencies]\ntoytop = {{ path = {core:?}, features = [\"fixed\"] }}\n[workspace]\n"
        ),
    )
    .expect("the manifest");
    // the versions that this workspace has already
    std::fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock")).expect("the lock file");
    let mut main = "macro_rules! print { ($moment:expr, $($tip:tt)*) => {{
    let moment = $moment;
    let (phi, c) = (moment.orientation(), moment.$($tip)*);
    let numbers = [phi.alpha.re, phi.alpha.im, phi.beta.re, phi.beta.im, phi.u(), c.re, c.im];
    println!(\"{:x} {}\", moment.nutation_phase().to_bits() >> 32, numbers.map(|x| format!(\"{:x}\", x.to_bits())).join(\" \"));
}} }
fn next_tick(state: &mut u64, k: u32) -> i64 {
    *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*state as i64) >> (k % 61)
}
fn main() {
"
    .to_owned();
    let mut modules = String::new();
    for case in &cases {
        let name = name(case);
        let tip = if case.scalar.starts_with('q') { "orientation().tip_over_s()" } else { "tip()" };
        bake(case, "rust", &folder.join(format!("src/{name}.rs")));
        modules += &format!("mod {name};\n");
        main += &format!(
            "    let table = &{name}::{};
    let mut state = 1;
    for k in 0..{singles} {{
        print!(table.at_tick(next_tick(&mut state, k)), {tip});
    }}
    let horizon = table.to_baked().clock.horizon.unwrap_or_default();
    for k in 0..{runs} {{
        let first = horizon.get(k as usize).map_or_else(|| next_tick(&mut state, k + 20), |end| end - 9);
        let mut cursor = table.cursor(first);
        for _ in 0..{length} {{
            print!(cursor.next(table), {tip});
        }}
    }}
",
            name.to_uppercase()
        );
    }
    std::fs::write(folder.join("src/main.rs"), modules + &main + "}\n").expect("the source");
    let cargo = |command: &str| {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args([command, "--quiet", "--offline"]).current_dir(&folder);
        cargo.env("CARGO_TARGET_DIR", folder.join("target")).env("RUSTFLAGS", "-D warnings");
        cargo
    };
    let printed = succeed(&mut cargo("run"));
    assert_equal(stdout(&printed), &cases);

    let module = folder.join("src/toy_top.rs");
    let text = std::fs::read_to_string(&module).expect("the module");
    let (head, rows) = text.split_once("segments: [").expect("the table");
    std::fs::write(&module, format!("{head}segments: [{}", rows.replacen(", ", ", 1", 1)))
        .expect("the module");
    let refused = cargo("check").output().expect("cargo runs");
    // a static is evaluated by `build`, and by `check` too where its type is checked
    let refused =
        if refused.status.success() { cargo("build").output().expect("cargo runs") } else { refused };
    assert!(!refused.status.success());
    assert!(stderr(&refused).contains("crc32: the numbers were changed"), "{}", stderr(&refused));
}
