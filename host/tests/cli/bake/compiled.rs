//! What `toytop bake` writes, compiled by the system's C compiler and by cargo: it gives the bits of the crate.

use super::cases::{Case, RUNS, assert_equal, cases};
use crate::{folder, run, stderr, stdout};
use std::path::Path;
use std::process::{Command, Output};

fn bake(case: &Case, lang: &str, to: &Path) {
    let tick = format!("{}/{}", case.tick[0], case.tick[1]);
    let to = to.to_str().expect("UTF-8");
    let arguments = ["bake", &case.file, "--scalar", case.scalar, "--size", case.size, "--lang", lang];
    let output = run(&[&arguments[..], &["--tick", &tick, "-o", to]].concat());
    assert_eq!((output.status.code(), stdout(&output)), (Some(0), ""), "{}", stderr(&output));
    let note = stderr(&output).lines().next().expect("a note");
    assert!(note.contains(&format!("{} in {}", case.size, case.scalar)), "{note}");
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
        toytop_moment_{scalar} m = toytop_at_tick_{scalar}(&{table}, tick);
        PRINT({word}, {format}, toytop_at(&{table}.clock, tick), m);
    }}
    for (uint32_t k = 0; k < {runs}; k++) {{
        int64_t first = k < 2 ? {table}.clock.horizon[k] - 9 : next_tick(k + 20);
        toytop_cursor at = toytop_at(&{table}.clock, first);
        for (int i = 0; i < {length}; i++) {{
            toytop_cursor now = at;
            toytop_moment_{scalar} m = toytop_next_{scalar}(&{table}, &at);
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
    let mut main = "macro_rules! print { ($moment:expr) => {{
    let moment = $moment;
    let (phi, c) = moment.phi_and_tip();
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
        bake(case, "rust", &folder.join(format!("src/{name}.rs")));
        modules += &format!("mod {name};\n");
        main += &format!(
            "    let table = &{name}::{};
    let mut state = 1;
    for k in 0..{singles} {{
        print!(table.at_tick(next_tick(&mut state, k)));
    }}
    let horizon = table.to_baked().horizon.unwrap_or_default();
    for k in 0..{runs} {{
        let first = horizon.get(k as usize).map_or_else(|| next_tick(&mut state, k + 20), |end| end - 9);
        let mut cursor = table.cursor(first);
        for _ in 0..{length} {{
            print!(cursor.next());
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
    let (head, rows) = text.split_once("coefficients: [").expect("the table");
    std::fs::write(&module, format!("{head}coefficients: [{}", rows.replacen(", ", ", 1", 1)))
        .expect("the module");
    let refused = cargo("check").output().expect("cargo runs");
    // a static is evaluated by `build`, and by `check` too where its type is checked
    let refused =
        if refused.status.success() { cargo("build").output().expect("cargo runs") } else { refused };
    assert!(!refused.status.success());
    assert!(stderr(&refused).contains("checksum: the numbers were changed"), "{}", stderr(&refused));
}
