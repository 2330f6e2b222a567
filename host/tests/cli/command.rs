//! Command lines of the program under test, and the files that they read and write.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

pub(crate) const PROGRAM: &str = env!("CARGO_BIN_EXE_toytop");
/// Folder in which every command runs.
pub(crate) const HERE: &str = env!("CARGO_TARGET_TMPDIR");

/// Exit code and output of a command.
pub(crate) struct Run {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

/// Words of a command line, separated by spaces; `@name` is a scenario of the repository.
fn words(line: &str) -> impl Iterator<Item = String> {
    line.split_whitespace().map(|word| word.strip_prefix('@').map_or_else(|| word.to_owned(), sample))
}

/// Command of a line, in the folder for its files.
pub(crate) fn command(line: &str) -> Command {
    let mut command = Command::new(PROGRAM);
    command.args(words(line)).current_dir(HERE);
    command
}

/// Empty folder in the folder of the commands.
pub(crate) fn folder(name: &str) -> PathBuf {
    let path = path(name);
    // the folder may exist from an earlier run
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir(&path).expect("a folder");
    path
}

/// Result of words, which may have spaces in them.
pub(crate) fn run(words: &[&str]) -> Run {
    finished(Command::new(PROGRAM).args(words))
}

/// Result of a command line.
pub(crate) fn toytop(line: impl AsRef<str>) -> Run {
    finished(&mut command(line.as_ref()))
}

/// Result of a script of Bash, in which `$@` is the command line.
pub(crate) fn bash(script: &str, line: impl AsRef<str>) -> Run {
    finished(Command::new("bash").args(["-c", script, "bash", PROGRAM]).args(words(line.as_ref())))
}

/// Result of any command.
pub(crate) fn finished(command: &mut Command) -> Run {
    let output = command.current_dir(HERE).output().expect("it runs");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    Run { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
}

impl Run {
    /// Stdout of a command that must succeed.
    pub(crate) fn ok(self) -> String {
        assert_eq!(self.code, Some(0), "{}{}", self.out, self.err);
        self.out
    }

    /// Checks a refusal: the exit code, nothing on stdout, and one line on stderr with parts that " ... " separates.
    pub(crate) fn refused(&self, code: i32, parts: &str) {
        let Self { out, err, .. } = self;
        assert_eq!((self.code, &**out, err.matches('\n').count()), (Some(code), "", 1), "{parts}: {err}");
        for part in parts.split(" ... ") {
            assert!(err.contains(part), "{part:?} is not in {err:?}");
        }
    }
}

/// Checks that commands are refused with exit code 2. Each row has the end of a command line, and parts of the message.
pub(crate) fn all_refused(start: &str, rows: &[(&str, &str)]) {
    for (end, parts) in rows {
        println!("{start} {end}");
        toytop(format!("{start} {end}")).refused(2, parts);
    }
}

/// JSON output of a command that must succeed.
pub(crate) fn json(line: impl AsRef<str>) -> Value {
    serde_json::from_str(&toytop(format!("{} --format json", line.as_ref())).ok()).expect("JSON")
}

/// Number in a JSON value.
pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// Entries of a JSON array.
pub(crate) fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value} is no array"))
}

/// Samples of `state` with these arguments.
pub(crate) fn samples(arguments: impl AsRef<str>) -> Vec<Value> {
    list(&json(format!("state {}", arguments.as_ref()))["samples"]).to_vec()
}

/// Numbers of an object under these keys; an array gives all of its numbers.
pub(crate) fn numbers(object: &Value, keys: &str) -> Vec<f64> {
    let values = keys.split(' ').flat_map(|key| match &object[key] {
        Value::Array(parts) => parts.iter().map(number).collect(),
        value => vec![number(value)],
    });
    values.collect()
}

/// CSV output of a command that must succeed: the names of the columns, and the rows.
pub(crate) struct CsvTable {
    pub names: String,
    pub rows: Vec<Vec<f64>>,
}

/// CSV output of a command that must succeed. An empty cell is NaN.
pub(crate) fn csv(line: &str) -> CsvTable {
    let text = toytop(format!("{line} --format csv")).ok();
    let (names, rows) = text.split_once('\n').expect("a header");
    let cell = |cell: &str| if cell.is_empty() { f64::NAN } else { cell.parse().expect("a number") };
    let rows = rows.lines().map(|row| row.split(',').map(cell).collect());
    CsvTable { names: names.to_owned(), rows: rows.collect() }
}

/// Path of a file in the folder of the commands.
pub(crate) fn path(name: &str) -> PathBuf {
    Path::new(HERE).join(name)
}

/// Text of a file in the folder of the commands, or of one with an absolute path.
pub(crate) fn read(name: &str) -> String {
    std::fs::read_to_string(path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Writes a file in the folder of the commands, and returns its name.
pub(crate) fn write(name: &str, content: impl AsRef<[u8]>) -> &str {
    std::fs::write(path(name), content).expect("the file is written");
    name
}

/// Number of files in a folder in the folder of the commands.
pub(crate) fn count(folder: &str) -> usize {
    std::fs::read_dir(path(folder)).expect("a folder").count()
}

/// Path of a file of the repository.
pub(crate) fn repository(path: &str) -> String {
    format!("{}/../{path}", env!("CARGO_MANIFEST_DIR"))
}

/// Text of a top, from which the cases start.
pub(crate) const TOP: &str = "[top]
mass_moment = 0.9
com_height = 0.6
transverse_inertia = 1.1
axial_inertia = 0.8
gravity = 1
";
pub(crate) const RELEASE: &str = "[motion]
kind = \"release\"
tilt_deg = 40
spin = 3.5
precession = 0.3
";

/// Text of a scenario with these branch points, and the signs 1 of l + n and `minus` of l - n.
pub(crate) fn branch_points([e1, e2, e3]: [f64; 3], minus: i32) -> String {
    format!(
        "{TOP}[motion]\nkind = \"branch_points\"\ne1 = {e1}\ne2 = {e2}\ne3 = {e3}\n\
         sign_l_plus_n = 1\nsign_l_minus_n = {minus}\n"
    )
}

/// Text of a scenario with these branch points, and a top with these moments of inertia, transverse and axial.
pub(crate) fn slender(e: [f64; 3], [transverse, axial]: [&str; 2]) -> String {
    branch_points(e, -1)
        .replace("inertia = 1.1", &format!("inertia = {transverse}"))
        .replace("inertia = 0.8", &format!("inertia = {axial}"))
}

/// Scenario file with this content.
pub(crate) fn scenario(name: &str, content: &str) -> String {
    format!("{HERE}/{}", write(&format!("{name}.toml"), content))
}

/// Scenario file of a motion for which no table is large enough: A/(ps) = 1e-6 near both verticals.
pub(crate) fn motion_without_table(name: &str) -> String {
    scenario(name, &slender([-0.999_999, 0.999_999, 1.18], ["6e-7", "5.5e-7"]))
}

/// Scenario file of the repository.
pub(crate) fn sample(name: &str) -> String {
    repository(&format!("host/scenarios/{name}.toml"))
}
