//! `cargo xtask`: all checks of the repository, on a machine that needs only rustup.

mod c;
mod checks;
// the library of the host has the chips, and takes long to build
#[allow(unreachable_pub)]
#[path = "../../src/commands/studies/budget/chips.rs"]
mod chip;
mod firmware;
mod process;
mod python;
mod size;
mod steps;
mod tools;

use std::process::ExitCode;

use anyhow::{Result, bail};

const USAGE: &str = "\
usage: cargo xtask VERB

  test [--all] [--only STEP]   runs the checks before every change, or every test, or one step; installs missing tools by rustup, apt-get or
                               cargo. The exit code is 1 if a step failed, and 2 if none failed but one could not run
  test --list                  lists the steps
  size                         prints the tokens of Rust by room, and fails where one is above its cap
  firmware NAME [--chip CHIP]  runs a program under QEMU and shows its log
  firmware NAME --overwrite    runs a program and writes its log as the expected one
  firmware --list              lists programs and chips
  nopanic --planted            shows that a panic does not link
  c-archive --target NAME [--to FOLDER]
                               writes archive, header and CMake files for programs in C; NAME is that of a folder, or all
  c-archive --list             lists these folders, by processor core and float ABI
  qemu CHIP ELF                runs an ELF and shows its log (the runner of firmware-examples/.cargo/config.toml)";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    run(&words).unwrap_or_else(|error| {
        eprintln!("{error:#}");
        ExitCode::FAILURE
    })
}

fn run(words: &[&str]) -> Result<ExitCode> {
    match words {
        ["test"] => return steps::run(|step| step.guards),
        ["test", "--all"] => return steps::run(|_| true),
        ["test", "--only", name] => return steps::run_one(name),
        ["test", "--list"] => steps::list(),
        ["size"] => print!("{}", size::check()?),
        ["firmware", "--list"] => firmware::list(),
        ["firmware", name] => return firmware::show(name, None),
        ["firmware", name, "--chip", chip] => return firmware::show(name, Some(chip)),
        ["firmware", name, "--overwrite"] => firmware::overwrite(name)?,
        ["qemu", chip, elf] => return firmware::qemu(chip, elf),
        ["nopanic", "--planted"] => println!("{}", firmware::planted()?),
        ["c-archive", "--list"] => c::list(),
        ["c-archive", "--target", target] => println!("{}", c::make(target, None)?),
        ["c-archive", "--target", target, "--to", folder] => println!("{}", c::make(target, Some(folder))?),
        ["help" | "--help" | "-h"] => println!("{USAGE}"),
        _ => bail!("{USAGE}"),
    }
    Ok(ExitCode::SUCCESS)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use yaml_rust2::{Yaml, YamlLoader};

    use crate::process::root;

    /// Programs that the runners have.
    const PROGRAMS: [&str; 8] = ["cargo", "rustup", "sudo", "python", "tar", "gh", "diff", ".ci/run"];
    /// Subcommands that cargo has, or that a workflow installs.
    const SUBCOMMANDS: [&str; 10] =
        ["test", "run", "package", "publish", "install", "xtask", "miri", "deny", "fuzz", "semver-checks"];

    /// Jobs and steps have what GitHub asks for, and every command, package and path in them exists.
    #[test]
    fn the_workflows_can_run() {
        let mut commands = 0;
        for entry in fs::read_dir(root().join(".github/workflows")).expect("workflows") {
            let path = entry.expect("a file").path();
            let text = fs::read_to_string(&path).expect("text");
            let workflow = &YamlLoader::load_from_str(&text).expect("YAML")[0];
            assert!(!workflow["on"].is_badvalue() && !workflow["permissions"].is_badvalue(), "{path:?}");
            let jobs = workflow["jobs"].as_hash().expect("jobs");
            for (name, job) in jobs {
                assert!(job["runs-on"].as_str().is_some(), "{name:?}");
                for needed in job["needs"].as_vec().into_iter().flatten() {
                    assert!(jobs.contains_key(needed), "{name:?} needs {needed:?}");
                }
                for step in job["steps"].as_vec().expect("steps") {
                    match (step["uses"].as_str(), step["run"].as_str()) {
                        (Some(action), None) => assert!(action.contains("@v"), "{action}"),
                        (None, Some(script)) => {
                            script.lines().for_each(check);
                            commands += script.lines().count();
                        }
                        _ => panic!("{name:?}: {step:?}"),
                    }
                }
            }
            assert!(!matches!(workflow["name"], Yaml::BadValue), "{path:?}");
        }
        assert!(commands > 15, "{commands} commands");
    }

    /// Whether the words of a command exist.
    fn check(command: &str) {
        let words: Vec<_> = command.split_whitespace().collect();
        assert!(PROGRAMS.contains(&words[0]), "{command}");
        assert!(!words[0].contains('/') || root().join(words[0]).is_file(), "{command}");
        let arguments: Vec<_> = words[1..].iter().filter(|word| !word.starts_with('+')).copied().collect();
        if words[0] == "cargo" {
            assert!(SUBCOMMANDS.contains(&arguments[0]), "{command}");
        }
        if arguments.first() == Some(&"xtask") {
            let verb = ["test --all", "c-archive --target all --to "];
            let rest = arguments[1..].join(" ");
            assert!(verb.iter().any(|verb| rest.starts_with(verb)), "{command}");
        }
        for pair in arguments.windows(2) {
            let manifests = ["core", "core/closed-forms", "core/fit", "tests"]
                .map(|folder| root().join(folder).join("Cargo.toml"));
            let names = |manifest| {
                fs::read_to_string(manifest)
                    .is_ok_and(|text| text.contains(&format!("name = \"{}\"\n", pair[1])))
            };
            match pair[0] {
                "-p" => assert!(manifests.iter().any(names), "{command}"),
                "--manifest-path" | "--config" => assert!(root().join(pair[1]).is_file(), "{command}"),
                _ => {}
            }
        }
    }
}
