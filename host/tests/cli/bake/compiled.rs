//! Tests of tables in Rust by `toytop bake`, compiled by cargo: they give the bits of the crate.

use super::cases::{Case, RUNS, assert_lines, cases};
use crate::command::{finished, folder, read, toytop, write};
use std::path::Path;
use std::process::Command;

/// Writes the table of a case.
pub(super) fn bake(case: &Case, lang: &str, to: &str) {
    let Case { scalar, size, .. } = case;
    let run = toytop(format!("bake {} --lang {lang} -o {to}", case.arguments()));
    let note = run.err.lines().next().unwrap_or_default();
    assert!(note.contains(&format!(": {size}x")) && note.contains(&format!(" in {scalar}, ")), "{note}");
    assert_eq!(run.ok(), "");
}

pub(super) fn name(case: &Case) -> String {
    Path::new(&case.file).file_stem().expect("a name").to_str().expect("UTF-8").to_lowercase()
}

#[test]
fn rust_gives_the_same_bits_and_a_changed_number_does_not_compile() {
    let (folder, cases) = (folder("bake_rust"), cases());
    let (singles, runs, length) = RUNS;
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    std::fs::create_dir(folder.join("src")).expect("a folder");
    let core = root.join("core").canonicalize().expect("core");
    write(
        "bake_rust/Cargo.toml",
        format!(
            "[package]\nname = \"baked\"\nedition = \"2024\"\n[dependencies]\ntoytop = {{ path = {core:?}, features = [\"fixed\"] }}\n[workspace]\n"
        ),
    );
    // the versions of dependencies that this workspace uses
    std::fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock")).expect("the lock file");
    let mut main = "macro_rules! row { ($sample:expr, ($($u:tt)*), ($($tip:tt)*)) => {{
    let sample = $sample;
    let (phi, u, c) = (sample.orientation(), sample.$($u)*, sample.$($tip)*);
    let numbers = [phi.alpha.re, phi.alpha.im, phi.beta.re, phi.beta.im, u, c.re, c.im];
    print!(\"{:x} \", sample.nutation_phase().to_bits() >> 32);
    for x in numbers {
        print!(\"{:x} \", f64::from(x).to_bits());
    }
    println!();
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
        let u = if case.scalar == "f32" { "pose().u" } else { "orientation().u()" };
        let tip = if case.scalar.starts_with('q') { "orientation().tip_over_s()" } else { "tip()" };
        bake(case, "rust", &format!("bake_rust/src/{name}.rs"));
        modules += &format!("mod {name};\n");
        main += &format!(
            "    let table = &{name}::{};
    let mut state = 1;
    for k in 0..{singles} {{
        row!(table.at_tick(next_tick(&mut state, k)), ({u}), ({tip}));
    }}
    for k in 0..{runs} {{
        let mut cursor = table.cursor(next_tick(&mut state, k + 20));
        for _ in 0..{length} {{
            row!(cursor.next(table), ({u}), ({tip}));
        }}
    }}
",
            name.to_uppercase()
        );
    }
    write("bake_rust/src/main.rs", modules + &main + "}\n");
    let cargo = |command: &str| {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args([command, "--quiet", "--offline", "--manifest-path", "bake_rust/Cargo.toml"]);
        cargo.env("CARGO_TARGET_DIR", folder.join("target")).env("RUSTFLAGS", "-D warnings");
        cargo.env("CARGO_PROFILE_DEV_DEBUG", "0").env("CARGO_INCREMENTAL", "0");
        finished(&mut cargo)
    };
    assert_lines(&cargo("run").ok(), &cases, |case| case.truth()[0].clone());

    let text = read("bake_rust/src/toy_top.rs");
    let (head, rows) = text.split_once("segments: [").expect("the table");
    write("bake_rust/src/toy_top.rs", format!("{head}segments: [{}", rows.replacen(", ", ", 1", 1)));
    // not `check`, which evaluates a static only where a type depends on it, and would need the dependencies once more
    let refused = cargo("build");
    assert_ne!(refused.code, Some(0));
    assert!(refused.err.contains("crc32: the numbers were changed"), "{}", refused.err);
}
