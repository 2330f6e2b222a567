//! Page for a browser that needs no other file: the core as WebAssembly, and scripts that draw the motions that it
//! computes.

use crate::Failure;
use crate::input::builtin::{FIGURES, TOY_TOP};
use crate::input::scenario::{ScenarioFile, keys_as_json};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};
use toytop_model::constants::CONSTANTS;
use toytop_page::TEMPLATE;
use toytop_page::exports::launch_names;
use toytop_page::page_motion::PageMotion;

/// The core as WebAssembly; empty in a program that was compiled without that target.
const CORE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/core.wasm"));

/// Toy top, with which a page starts without a scenario.
pub fn toy_top() -> ScenarioFile {
    ScenarioFile::parse("A spinning top", TOY_TOP).expect("a valid sample")
}

/// Page that starts with a motion.
///
/// # Errors
/// [`Failure::input`]: as [`ScenarioFile::scenario`]. [`Failure::tool`]: the program was compiled without WebAssembly. [`Failure::method`]: no table fits the motion.
pub fn html(start: &ScenarioFile) -> Result<String, Failure> {
    if CORE.is_empty() {
        let install = "rustup target add wasm32-unknown-unknown, then install toytop again";
        return Err(Failure::tool(format!("this toytop was compiled without the page: {install}")));
    }
    let scenario = start.scenario()?;
    if !PageMotion::fits(&scenario.motion) {
        return Err(Failure::method("no table: that of the page is too small for this motion"));
    }
    let data = json!({
        "name": scenario.name,
        "scenario": start.table,
        "constants": launch_names().collect::<Vec<_>>(),
        "meanings": CONSTANTS.iter().map(|constant| (constant.name, constant.meaning)).collect::<Value>(),
        "keys": keys_as_json(),
        "figures": FIGURES.map(|(figure, signs, e3s)| json!([figure, signs.l_minus_n.as_i32(), e3s])),
        "toy_top": toy_top().table,
    });
    // the last text may contain a name in braces, and no character that could end the element of a script
    Ok(TEMPLATE
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{core}}", &STANDARD.encode(CORE))
        .replace("{{name}}", &escaped(&scenario.name))
        .replace("{{data}}", &data.to_string().replace('<', "\\u003c")))
}

/// Text as it stands in HTML, without a brace.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('{', "&#123;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;
    use toytop::{InitialAngles, Motion, Orientation, Sign, Signs, Top, TopParameters};
    use toytop_model::motion_with_period::MotionWithPeriod;

    /// After a refusal the table has no motion, also if the motion before had a closed form.
    #[test]
    fn a_refused_motion_leaves_no_other() {
        static PAGE_MOTION: Mutex<PageMotion> = Mutex::new(PageMotion::EMPTY);
        let motion = |e| {
            let parameters = TopParameters {
                transverse_inertia: 1.1e-6,
                axial_inertia: 1e-6,
                com_height: 1.0,
                mass_moment: 1.0,
                gravity: 1.0,
                ..TopParameters::default()
            };
            let top = Top::sliding(&parameters).unwrap();
            let signs = Signs { l_minus_n: Sign::Minus, ..Signs::default() };
            let motion = Motion::from_branch_points(&top, e, signs, &InitialAngles::default());
            MotionWithPeriod::new(motion.unwrap())
        };
        let mut page_motion = PAGE_MOTION.lock().unwrap();
        page_motion.set_up(&motion([0.2, 1.0, 1.0])).unwrap();
        assert!(page_motion.error_bound()[0] < 1e-10);
        page_motion.set_up(&motion([-0.999_999, 0.999_999, 1.18])).unwrap_err();
        assert_eq!(
            (page_motion.at(0.5).0, page_motion.error_bound()),
            (Orientation::IDENTITY, [f64::INFINITY; 2])
        );
    }
}
