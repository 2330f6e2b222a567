//! Examples in C, which are built and run, and whose bits are compared with `toytop state`.

use std::fs;
use std::io::{Read, read_to_string};
use std::path::{Path, PathBuf};
use std::process::{ChildStderr, ChildStdout, Command};

use anyhow::{Context, Result, bail};
use toytop_chips::chip::{self, REPEATABLE};

use super::archive::{make, target_dir};
use super::compile;
use super::header::programs_of_pages;
use crate::checks;
use crate::process::{root, run};

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

/// Test of the host example and of the programs of the pages by gcc with the archive, as pkg-config names it, and by
/// clang with the shared library.
pub(crate) fn on_host() -> Result<String> {
    let (archives, [sources, made]) = (archives("host")?, folders()?);
    let pages = programs_of_pages(&made)?;
    let mut lines = 0;
    let shared = archives.join("lib/host-shared");
    let flags = Command::new("pkg-config")
        .args(["--cflags", "--libs", "toytop"])
        .env("PKG_CONFIG_PATH", archives.join("lib/pkgconfig"))
        .output()?;
    let archive: Vec<_> = str::from_utf8(&flags.stdout)?.split_whitespace().collect();
    let rpath = format!("-Wl,-rpath,{0} -L{0} -ltoytop", shared.display());
    for (compiler, library) in [("gcc", archive), ("clang", rpath.split(' ').collect())] {
        let program = made.join(compiler);
        let printed = |source: &Path| {
            let mut command = compile(compiler, "c99", &archives.join("include"));
            command.args(["-O2", "-o"]).arg(&program).arg(source);
            run(command.args(&library).arg("-lm"))?;
            run(&mut Command::new(&program))
        };
        for (page, source, prints) in &pages {
            let output = printed(source).with_context(|| format!("{page}: its program in C"))?;
            if !output.starts_with(prints) {
                bail!("{page}: its program in C prints {output}");
            }
        }
        lines = compare(&printed(&sources.join("host.c"))?)?;
    }
    Ok(format!("gcc and clang: {lines} lines have the bits of `toytop state`; the programs of the pages run"))
}

/// Test of the example for the Cortex-M4F, without any library, under QEMU.
pub(crate) fn on_chip() -> Result<String> {
    let (archives, [sources, made]) = (archives("cortex-m4-hard")?, folders()?);
    let (sources, elf) = (sources.join("cortex-m4f"), made.join("cortex-m4f"));
    let mut command = compile("clang", "c11", &archives.join("include"));
    command
        .args("--target=thumbv7em-none-eabihf -mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16".split(' '));
    command.args("-O2 -ffreestanding -nostdlib -fuse-ld=lld -T".split(' ')).arg(sources.join("chip.ld"));
    command.arg("-o").arg(&elf).args(["main.c", "chip.c"].map(|file| sources.join(file)));
    run(command.arg(archives.join("lib/cortex-m4-hard/libtoytop.a")).arg("-Wl,--gc-sections"))?;
    check_size(&elf)?;

    let read = |stdout: ChildStdout, stderr: ChildStderr| read_to_string(stdout.chain(stderr));
    let (status, output) = chip::M4F.emulate(&elf, &REPEATABLE, read)?;
    let output = output?;
    let last_line = output.lines().last().unwrap_or_default();
    if !status.success() || last_line != "interrupts 1000, exchanges 1, failures 0, no jump" {
        bail!("{output}{status}: the last line is not as expected");
    }
    let lines = compare(&output)?;
    Ok(format!("{lines} lines have the bits of `toytop state`; {last_line}"))
}

/// Checks that the page of costs has the flash and RAM of the example, in KB.
fn check_size(elf: &Path) -> Result<()> {
    const ROW: &str = "| [`core/c/examples/cortex-m4f`](../../core/c/examples/cortex-m4f) |";
    let sizes = run(Command::new("size").arg(elf))?;
    let numbers = sizes.lines().nth(1).context("a line of sizes")?.split_whitespace().take(3);
    let [text, data, bss] = numbers.map(str::parse).collect::<Result<Vec<u32>, _>>()?[..] else {
        bail!("{sizes}: must hold text, data and bss")
    };
    let [flash, ram] = [text + data, data + bss].map(|bytes| bytes.div_ceil(1000));
    let row = format!("{ROW} {flash} | {ram} |");
    let page = fs::read_to_string(root().join("host/docs/costs.md"))?;
    if !page.lines().any(|line| line == row) {
        bail!("host/docs/costs.md must have the row\n{row}");
    }
    Ok(())
}

/// Test of the host example by CMake: by its sources, and by what these install.
pub(crate) fn cmake() -> Result<String> {
    let [sources, made] = folders()?;
    let installed = made.join("installed");
    for way in ["add_subdirectory", "find_package"] {
        let build = made.join(way);
        let mut configure = Command::new("cmake");
        configure.arg("-S").arg(&sources).arg("-B").arg(&build).arg(format!("-DTOYTOP_BY={way}"));
        run(configure.arg(format!("-DCMAKE_PREFIX_PATH={}", installed.display())))?;
        run(Command::new("cmake").arg("--build").arg(&build))?;
        compare(&run(&mut Command::new(build.join("host")))?)?;
        run(Command::new("cmake").arg("--install").arg(&build).arg("--prefix").arg(&installed))?;
    }
    Ok("add_subdirectory, install, and find_package of what was installed".into())
}

/// Number of lines of an example's output, which are compared with `toytop state`. A line is a scalar, a tick, and bits of alpha, beta and
/// the tip; after a line "state", the motion is that from this state.
fn compare(printed: &str) -> Result<usize> {
    let program = checks::program()?;
    let mut scenario = root().join("host/scenarios/toy_top.toml");
    let mut lines = 0;
    for line in printed.lines() {
        let words: Vec<_> = line.split(' ').collect();
        match words[..] {
            [scalar @ ("f32" | "f64" | "q31"), tick, ref bits @ ..] => {
                let expected = state(&program, &scenario, scalar, tick)?;
                if bits != expected {
                    bail!("{line}, but `toytop state` prints {}", expected.join(" "));
                }
                lines += 1;
            }
            ["state", _, ref bits @ ..] => scenario = scenario_from(&scenario, bits)?,
            _ => {}
        }
    }
    if lines < 6 || !scenario.ends_with("struck.toml") {
        bail!("{printed}\n{lines} lines of bits, and a state after them, are too few");
    }
    Ok(lines)
}

/// Bits of alpha, beta and the tip by `toytop state` at a tick.
fn state(program: &Path, scenario: &Path, scalar: &str, tick: &str) -> Result<Vec<String>> {
    let mut command = Command::new(program);
    command.arg("state").arg(scenario).arg(format!("--ticks={tick}"));
    command.args(["--hertz", "1000", "--scalar", scalar, "--columns", "alpha,beta,tip", "--format", "csv"]);
    let output = run(&mut command)?;
    let row = output.lines().skip_while(|line| !line.starts_with("alpha_re,")).nth(1).context("a row")?;
    let bits = |(place, number): (usize, f64)| match (scalar, place) {
        ("f64", _) => format!("{:016x}", number.to_bits()),
        ("q31", 0..4) => format!("{:08x}", (number * f64::from(1 << 30)) as i32),
        _ => format!("{:08x}", (number as f32).to_bits()),
    };
    let numbers = row.split(',').take(6).map(str::parse).collect::<Result<Vec<f64>, _>>()?;
    Ok(numbers.into_iter().enumerate().map(bits).collect())
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
