//! Examples in C, which are built and run, and whose bits are compared with those of `toytop state`.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use anyhow::{Context, Result, bail};

use super::archive::{make, target_dir};
use super::header::programs_of_pages;
use crate::process::{root, run, run_within};
use crate::tools;
use crate::{chip, host};

const WARNINGS: [&str; 6] = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"];

/// Folder of the archives, after the requested one is made.
fn archives(wanted: &str) -> Result<PathBuf> {
    make(wanted, None)?;
    Ok(target_dir())
}

/// Folder of the sources, and folder of the programs.
fn folders() -> Result<[PathBuf; 2]> {
    let made = target_dir().join("examples");
    fs::create_dir_all(&made)?;
    Ok([root().join("core/c/examples"), made])
}

/// Test of the host example and of the programs of the pages by gcc and by clang.
pub(crate) fn on_host() -> Result<String> {
    let (archives, [sources, made]) = (archives("host")?, folders()?);
    let pages = programs_of_pages(&made)?;
    let mut lines = 0;
    for compiler in ["gcc", "clang"] {
        let program = made.join(compiler);
        let printed = |source: &Path| {
            let mut command = Command::new(compiler);
            command.args(["-std=c99", "-O2"]).args(WARNINGS).arg("-I").arg(archives.join("include"));
            command.arg("-o").arg(&program).arg(source);
            run(command.arg(archives.join("lib/host/libtoytop.a")).arg("-lm"))?;
            run(&mut Command::new(&program))
        };
        for (page, source) in &pages {
            printed(source).with_context(|| format!("{page}: its program in C"))?;
        }
        lines = compare(&printed(&sources.join("host.c"))?)?;
    }
    Ok(format!("gcc and clang: {lines} lines have the bits of `toytop state`; the programs of the pages run"))
}

/// Test of the example for the Cortex-M4F, without any library, under QEMU.
pub(crate) fn on_chip() -> Result<String> {
    tools::qemu()?;
    let (archives, [sources, made]) = (archives("cortex-m4-hard")?, folders()?);
    let (sources, elf) = (sources.join("cortex-m4f"), made.join("cortex-m4f"));
    let mut command = Command::new("clang");
    command.args([
        "--target=thumbv7em-none-eabihf",
        "-mcpu=cortex-m4",
        "-mfloat-abi=hard",
        "-mfpu=fpv4-sp-d16",
    ]);
    command.args(["-std=c11", "-O2", "-ffreestanding", "-nostdlib", "-fuse-ld=lld"]).args(WARNINGS);
    command.arg("-I").arg(archives.join("include")).arg("-T").arg(sources.join("chip.ld"));
    command.arg("-o").arg(&elf).args(["main.c", "chip.c"].map(|file| sources.join(file)));
    run(command.arg(archives.join("lib/cortex-m4-hard/libtoytop.a")).arg("-Wl,--gc-sections"))?;

    let mut qemu = chip::named("m4f")?.qemu(&elf);
    let ended = run_within(qemu.args(["-icount", "shift=0,sleep=off"]), Duration::from_secs(60))?;
    if !ended.success {
        bail!("{}\nthe program failed", ended.output.trim_end());
    }
    let said = ended.output.lines().last().unwrap_or_default().to_owned();
    if said != "interrupts 1000, exchanges 1, failures 0, no jump" {
        bail!("{}\nthe last line is not as expected", ended.output.trim_end());
    }
    let lines = compare(&ended.output)?;
    Ok(format!("{lines} lines have the bits of `toytop state`; {said}"))
}

/// Test of the host example by CMake, in both ways.
pub(crate) fn cmake() -> Result<String> {
    let (archives, [sources, made]) = (archives("host")?, folders()?);
    for way in ["find_package", "add_subdirectory"] {
        let build = made.join(way);
        let mut configure = Command::new("cmake");
        configure.arg("-S").arg(&sources).arg("-B").arg(&build).arg(format!("-DTOYTOP_BY={way}"));
        run(configure.arg(format!("-Dtoytop_DIR={}", archives.join("lib/cmake/toytop").display())))?;
        run(Command::new("cmake").arg("--build").arg(&build))?;
        compare(&run(&mut Command::new(build.join("host")))?)?;
    }
    Ok("find_package and add_subdirectory".into())
}

/// Number of lines of an example's output, which are compared with `toytop state`. A line is a scalar, a tick,
/// and bits of alpha, beta and the tip; after a line "state", the motion is that from this state.
fn compare(printed: &str) -> Result<usize> {
    let program = host::program()?;
    let mut scenario = root().join("host/scenarios/toy_top.toml");
    let (mut lines, mut part) = (0, Vec::new());
    for line in printed.lines().chain(["end"]) {
        let words: Vec<_> = line.split(' ').collect();
        match words[..] {
            ["f32" | "f64" | "q31", tick, ..] => part.push((words[0], tick.parse()?, words[2..].to_vec())),
            ["state", _, ..] => {
                lines += compare_part(&program, &scenario, &part)?;
                part.clear();
                scenario = scenario_from(&scenario, &words[2..])?;
            }
            ["end"] => lines += compare_part(&program, &scenario, &part)?,
            _ => {}
        }
    }
    if lines < 6 || !scenario.ends_with("struck.toml") {
        bail!("{printed}\n{lines} lines of bits, and a state after them, are too few");
    }
    Ok(lines)
}

/// Scalar, tick and bits.
type Line<'a> = (&'a str, i64, Vec<&'a str>);

fn compare_part(program: &Path, scenario: &Path, part: &[Line<'_>]) -> Result<usize> {
    let mut by_scalar: BTreeMap<&str, Vec<&Line<'_>>> = BTreeMap::new();
    part.iter().for_each(|line| by_scalar.entry(line.0).or_default().push(line));
    for (scalar, lines) in by_scalar {
        let ticks: Vec<_> = lines.iter().map(|(_, tick, _)| tick.to_string()).collect();
        let expected = state(program, scenario, scalar, &ticks.join(","))?;
        if expected.len() != lines.len() {
            bail!("{scalar}: {} rows for {} ticks", expected.len(), lines.len());
        }
        for ((_, tick, bits), expected) in lines.iter().zip(&expected) {
            if bits != expected {
                let (bits, expected) = (bits.join(" "), expected.join(" "));
                bail!("{scalar} at tick {tick}: {bits}, but `toytop state` prints {expected}");
            }
        }
    }
    Ok(part.len())
}

/// Bits of alpha, beta and the tip by `toytop state`, at ticks separated by commas.
fn state(program: &Path, scenario: &Path, scalar: &str, ticks: &str) -> Result<Vec<Vec<String>>> {
    let words = format!(
        "state {} --ticks={ticks} --hertz 1000 --scalar {scalar} \
         --columns alpha,beta,tip --format csv",
        scenario.display()
    );
    let mut command = Command::new(program);
    let output = run(command.args(words.split_whitespace()))?;
    let bits = |(place, number): (usize, f64)| match (scalar, place) {
        ("f64", _) => format!("{:016x}", number.to_bits()),
        ("q31", 0..4) => format!("{:08x}", (number * f64::from(1 << 30)) as i32),
        _ => format!("{:08x}", (number as f32).to_bits()),
    };
    let mut rows = Vec::new();
    for row in output.lines().skip_while(|line| !line.starts_with("alpha_re,")).skip(1) {
        let numbers = row.split(',').map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        rows.push(numbers.into_iter().enumerate().map(bits).collect());
    }
    Ok(rows)
}

/// Scenario of the same top with a state, given by the bits of its numbers.
fn scenario_from(before: &Path, bits: &[&str]) -> Result<PathBuf> {
    let numbers: Vec<f64> = bits
        .iter()
        .map(|word| u64::from_str_radix(word, 16).map(f64::from_bits))
        .collect::<Result<_, _>>()?;
    let text = fs::read_to_string(before)?;
    let (top, _) = text.split_once("[motion]").context("a motion")?;
    let [alpha, beta, omega] = [&numbers[..2], &numbers[2..4], &numbers[4..]].map(|part| format!("{part:?}"));
    let motion = format!("[motion]\nkind = \"state\"\nalpha = {alpha}\nbeta = {beta}\nomega = {omega}\n");
    let path = target_dir().join("examples/struck.toml");
    fs::write(&path, format!("{top}{motion}"))?;
    Ok(path)
}
