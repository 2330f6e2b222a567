//! Tests of tables in C by `toytop bake`, compiled by all installed compilers: they give the bits of the crate in every standard, also
//! where a compiler would fuse products and sums.

use super::expected_bits::{Case, RATES, RUNS, assert_lines, cases};
use super::rust::{bake, name};
use crate::command::{finished, folder, read, sample, toytop, write};
use std::path::Path;
use std::process::Command;

/// Name of the table of a case, of two words, because a single word could belong to C.
fn table(case: &Case) -> String {
    let name = name(case);
    if name.contains('_') { name } else { format!("top_{name}") }
}

/// Installed compilers of these names.
fn installed(names: &[&'static str]) -> Vec<&'static str> {
    let works = |name: &&str| {
        Command::new(name).arg("--version").output().is_ok_and(|output| output.status.success())
    };
    names.iter().copied().filter(works).collect()
}

const WARNINGS: [&str; 6] = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"];

/// Flags with which a compiler fuses products and sums unless the source prevents it; on a machine without fused multiply-add they have
/// little effect.
fn flags_with_fused_products() -> Vec<&'static str> {
    let mut flags = vec!["-O3", "-ffp-contract=fast"];
    #[cfg(target_arch = "x86_64")]
    if std::is_x86_feature_detected!("fma") && std::is_x86_feature_detected!("avx2") {
        flags.extend(["-mfma", "-mavx2"]);
    }
    flags
}

/// Installed C compilers with fused products.
fn builds_with_fused_products() -> Vec<(&'static str, Vec<&'static str>)> {
    let compilers = installed(&["gcc", "clang"]);
    assert!(!compilers.is_empty(), "no C compiler");
    compilers.into_iter().map(|compiler| (compiler, flags_with_fused_products())).collect()
}

/// Installed compilers of C and C++ with each standard and all warnings.
fn builds_by_standard() -> Vec<(&'static str, Vec<&'static str>)> {
    let languages = [
        (["gcc", "clang"], "c", ["-std=c99", "-std=c11", "-std=c17"]),
        (["g++", "clang++"], "c++", ["-std=c++11", "-std=c++14", "-std=c++17"]),
    ];
    let mut builds = Vec::new();
    for (names, language, standards) in languages {
        for compiler in installed(&names) {
            let flags = |standard| [vec!["-x", language, standard, "-O1"], WARNINGS.to_vec()].concat();
            builds.extend(standards.map(|standard| (compiler, flags(standard))));
        }
    }
    builds
}

/// Output of a program by each of these compilers with their flags.
fn printed(folder: &Path, source: &str, builds: &[(&str, Vec<&str>)]) -> Vec<String> {
    let [code, program] = ["main.c", "main"].map(|name| folder.join(name));
    std::fs::write(&code, source).expect("the source");
    let run = |(compiler, flags): &(&str, Vec<&str>)| {
        finished(Command::new(compiler).args(flags).arg("-o").arg(&program).arg(&code)).ok();
        finished(&mut Command::new(&program)).ok()
    };
    builds.iter().map(run).collect()
}

/// Program that prints the numbers of every table as the bits of doubles, those of fixed point without its unit.
fn program(cases: &[Case]) -> String {
    let (singles, runs, length) = RUNS;
    let mut includes = String::new();
    let mut main = String::new();
    for case in cases {
        let (table, scalar) = (table(case), case.scalar);
        // a second inclusion has no effect
        includes += &format!("#include \"{table}.h\"\n#include \"{table}.h\"\n");
        let [number, rate, unit] = match scalar {
            "f64" => ["double", "double", "1"],
            "f32" => ["float", "float", "1"],
            "q15" => ["int16_t", "float", "16384"],
            _ => ["int32_t", "float", "1073741824"],
        };
        main += &format!(
            "    if (!toytop_intact_{scalar}(&{table})) return 1;
    state = 1;
    for (uint32_t k = 0; k < {singles}; k++) {{
        int64_t tick = next_tick(k);
        toytop_sample_{scalar} m = toytop_at_tick_{scalar}(&{table}, tick);
        ROW(toytop_at(&{table}.clock, tick), m, {number}, {unit});
    }}
    for (uint32_t k = 0; k < {runs}; k++) {{
        toytop_cursor at = toytop_at(&{table}.clock, next_tick(k + 20));
        for (int i = 0; i < {length}; i++) {{
            toytop_cursor now = at;
            toytop_sample_{scalar} m = toytop_next_{scalar}(&{table}, &at);
            ROW(now, m, {number}, {unit});
        }}
    }}
    state = 1;
    for (uint32_t k = 0; k < {RATES}; k++) {{
        int64_t tick = next_tick(k);
        toytop_cursor at = toytop_at(&{table}.clock, tick);
        toytop_sample_{scalar} now = toytop_at_tick_{scalar}(&{table}, tick);
        {number} q[4];
        {rate} fixed[3], body[3];
        toytop_quaternion_{scalar}(&now, q);
        toytop_omega_{scalar}(&{table}, &at, fixed);
        toytop_omega_body_{scalar}(&{table}, &at, body);
        PRINT(q, 4, {unit});
        PRINT(fixed, 3, 1);
        PRINT(body, 3, 1);
        turning_point(&{table}.clock, tick);
    }}
"
        );
    }
    format!(
        "#include <inttypes.h>
#include <stdio.h>
#include <string.h>
{includes}
#define PRINT(numbers, count, unit) for (int j = 0; j < count; j++) print((double)numbers[j] / unit)
#define ROW(at, m, number, unit) do {{ \
    number numbers[7]; \
    memcpy(numbers, &m, sizeof numbers); \
    printf(\"%\" PRIx64 \" \", (at).phase[0].leading); \
    PRINT(numbers, 7, unit); \
    puts(\"\"); \
}} while (0)
static uint64_t state;
static int64_t next_tick(uint32_t k) {{
    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (int64_t)state >> (k % 61);
}}
static void print(double number) {{
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    printf(\"%\" PRIx64 \" \", bits);
}}
static void turning_point(const toytop_clock *clock, int64_t tick) {{
    int upper;
    if (toytop_next_turning_point(clock, tick, &tick, &upper)) printf(\"%\" PRId64 \" %d\\n\", tick, upper);
    else printf(\"-\\n\");
}}
int main(void) {{
{main}    return 0;
}}
"
    )
}

/// Headers that need no other file give the crate's numbers in every standard of C and C++.
#[test]
fn c_gives_the_same_bits() {
    let (whole, cases) = (folder("bake_c"), cases());
    for case in &cases {
        bake(case, "c", &format!("bake_c/{}.h", table(case)));
    }
    let builds = [builds_by_standard(), builds_with_fused_products()].concat();
    let outputs = printed(&whole, &program(&cases), &builds);
    assert_lines(&outputs[0], &cases, |case| case.expected().lines);
    for (index, output) in outputs.iter().enumerate() {
        assert!(*output == outputs[0], "build {index} has other bits: {builds:?}");
    }

    // a changed bit of the table is detected, and a changed number of segments without a look beyond the table
    let text = read("bake_c/toy_top.h");
    let coefficients = "toy_top_coefficients[125][4] = {";
    let (head, rows) = text.split_once(coefficients).expect("the table");
    let changed_row = format!("{head}{coefficients}{}", rows.replacen(", ", ", 1", 1));
    for changed in [changed_row, text.replacen("25u, 5u, ~125u", "4121u, 5u, ~125u", 1)] {
        assert_ne!(changed, text);
        write("bake_c/toy_top.h", changed);
        let flags = ["-std=c99", "-fsanitize=address", "-o", "bake_c/main", "bake_c/main.c"];
        finished(Command::new("cc").args(flags)).ok();
        let run = finished(&mut Command::new(whole.join("main")));
        assert!(run.code == Some(1) && run.err.is_empty(), "{}", run.err);
    }
}

/// The compiler refuses the second of two motions from files of one name.
#[test]
fn two_tables_of_one_name_do_not_compile() {
    let folder = folder("bake_one_name");
    let text = read(&sample("lagrange"));
    for (place, tilt) in [("a", "21.0"), ("b", "20.0")] {
        std::fs::create_dir(folder.join(place)).expect("a folder");
        let file = format!("bake_one_name/{place}/top.toml");
        write(&file, text.replace("tilt_deg = 20.0", &format!("tilt_deg = {tilt}")));
        toytop(format!("bake {file} --lang c -o bake_one_name/{place}/top.h")).ok();
    }
    let compiled = |includes: &str| {
        let main = "int main(void) { return toytop_intact_f32(&top_top) - 1; }\n";
        write("bake_one_name/main.c", format!("{includes}{main}"));
        finished(Command::new("cc").args(["-std=c99", "-o", "bake_one_name/main", "bake_one_name/main.c"]))
    };
    compiled("#include \"a/top.h\"\n#include \"a/top.h\"\n").ok();
    let refused = compiled("#include \"a/top.h\"\n#include \"b/top.h\"\n");
    assert_ne!(refused.code, Some(0));
    assert!(refused.err.contains("two different tables have the name top_top"), "{}", refused.err);
    let other = read("bake_one_name/a/top.h")
        .replace("define TOYTOP_CLOCK ", "define TOYTOP_CLOCK 1")
        .replace("TOP_TOP", "OTHER");
    write("bake_one_name/a/other.h", other);
    let refused = compiled("#include \"a/other.h\"\n#include \"b/top.h\"\n");
    assert!(refused.err.contains("two versions of toytop"), "{}", refused.err);
}
