//! Files that tests give to the program; every test uses names of its own.

use std::path::{Path, PathBuf};

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
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.toml"));
    std::fs::write(&path, content).expect("the file is written");
    path.to_str().expect("the path is UTF-8").to_owned()
}

/// Scenario file of a motion for which no table is large enough: A/(ps) = 1e-6 near both verticals.
pub(crate) fn needle(name: &str) -> String {
    scenario(name, &slender([-0.999_999, 0.999_999, 1.18], ["6e-7", "5.5e-7"]))
}

/// Scenario file of the repository.
pub(crate) fn sample(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios").join(format!("{name}.toml"));
    path.to_str().expect("the path is UTF-8").to_owned()
}
