//! The text of a scenario file.

use super::input::Input;
use super::invariants;
use toytop_host::input::scenario::Scenario;

pub(super) fn run(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    match Scenario::parse("fuzz.toml", &text) {
        Ok(scenario) => invariants::motion(&scenario.motion, &mut Input::new(&[])),
        Err(error) => {
            let error = error.to_string();
            assert!(error.starts_with("fuzz.toml: ") && !error.contains('\n'), "{error:?}");
        }
    }
}
