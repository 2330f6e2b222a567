//! Tests of tables in Rust by `toytop bake`, compiled by cargo: they give the bits of the crate.

use super::cases::{Case, RUNS, assert_equal, cases};
use crate::{folder, run, stderr, stdout};
use std::path::Path;
use std::process::{Command, Output};

pub(super) fn bake(case: &Case, lang: &str, to: &Path) {
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

pub(super) fn name(case: &Case) -> String {
    Path::new(&case.file).file_stem().expect("a name").to_str().expect("UTF-8").to_lowercase()
}

pub(super) fn succeed(command: &mut Command) -> Output {
    let output = command.output().expect("it runs");
    assert!(output.status.success(), "{command:?}: {}", stderr(&output));
    output
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
    // the versions of dependencies that this workspace uses
    std::fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock")).expect("the lock file");
    let mut main = "macro_rules! print { ($sample:expr, $($tip:tt)*) => {{
    let sample = $sample;
    let (phi, c) = (sample.orientation(), sample.$($tip)*);
    let numbers = [phi.alpha.re, phi.alpha.im, phi.beta.re, phi.beta.im, phi.u(), c.re, c.im];
    println!(\"{:x} {}\", sample.nutation_phase().to_bits() >> 32, numbers.map(|x| format!(\"{:x}\", x.to_bits())).join(\" \"));
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
        cargo.env("CARGO_PROFILE_DEV_DEBUG", "0").env("CARGO_INCREMENTAL", "0");
        cargo
    };
    let printed = succeed(&mut cargo("run"));
    assert_equal(stdout(&printed), &cases);

    let module = folder.join("src/toy_top.rs");
    let text = std::fs::read_to_string(&module).expect("the module");
    let (head, rows) = text.split_once("segments: [").expect("the table");
    std::fs::write(&module, format!("{head}segments: [{}", rows.replacen(", ", ", 1", 1)))
        .expect("the module");
    // not `check`, which evaluates a static only where a type depends on it, and would need the dependencies once more
    let refused = cargo("build").output().expect("cargo runs");
    assert!(!refused.status.success());
    assert!(stderr(&refused).contains("crc32: the numbers were changed"), "{}", stderr(&refused));
}
