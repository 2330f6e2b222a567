//! The page in a browser: it shows the core's results to the bit, and its controls work without an error.
//!
//! Run by `cargo xtask test --only browser`, which provides Chromium and names it in `CHROMIUM`.

mod addresses;
mod controls;
mod sentences;

use super::{element, folder, view};
use crate::command::{list, sample};
use serde_json::Value;
use std::path::Path;
use std::process::Command;
use std::sync::{Mutex, MutexGuard, PoisonError};
use toytop::{Complex, Motion, Orientation};
use toytop_host::input::scenario::Scenario;
use toytop_model::motion_with_period::MotionWithPeriod;
use toytop_page::page_motion::PageMotion;

/// The document at the end of a minute of Chromium's virtual time, and the lines of its console.
fn browse(page: &Path, width: u32, fragment: &str) -> (String, Vec<String>) {
    let program = std::env::var("CHROMIUM").unwrap_or_else(|_| "chromium".to_owned());
    let profile = page.with_extension("profile");
    let mut command = Command::new(&program);
    command.args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"]);
    command.args(["--disable-background-networking", "--disable-component-update", "--disable-sync"]);
    command.args([
        "--enable-logging=stderr",
        "--timeout=120000",
        "--virtual-time-budget=60000",
        "--dump-dom",
    ]);
    command.arg(format!("--user-data-dir={}", profile.display()));
    command.arg(format!("--window-size={width},900"));
    let output = command.arg(format!("file://{}{fragment}", page.display())).output();
    let output = output.unwrap_or_else(|error| panic!("{program}: {error}"));
    let log = String::from_utf8_lossy(&output.stderr);
    let console = log.lines().filter(|line| line.contains("CONSOLE")).map(str::to_owned).collect();
    (String::from_utf8(output.stdout).expect("UTF-8"), console)
}

/// Frames as timers, because Chromium's virtual time runs ahead while nothing is to be done, and does not wait for frames.
const FRAMES: &str =
    "window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 16);";

/// Scripts that a probe runs after that of the page.
const SCRIPTS: [&str; 2] = [include_str!("browser/probes.js"), include_str!("browser/controls.js")];

/// Result of a call of a function of [`SCRIPTS`]. It goes through the element `probe`.
fn probe(page: &Path, call: &str, width: u32, fragment: &str) -> Value {
    let html = std::fs::read_to_string(page).expect("the page");
    let probe = format!(
        "<pre id=\"result\"></pre><script>{}
addEventListener(\"load\", async () => {{
  await ready;
  await settled();
  const results = await {call};
  element(\"result\").textContent = JSON.stringify(results);
  element(\"result\").id = \"probe\";
}});
</script></body>",
        SCRIPTS.join("\n")
    );
    let html = html.replace("<head>", &format!("<head><script>{FRAMES}</script>")).replace("</body>", &probe);
    let probed_page = page.with_extension("probe.html");
    std::fs::write(&probed_page, html).expect("writable");
    let (document, console) = browse(&probed_page, width, fragment);
    assert_eq!(console, [""; 0], "{}", page.display());
    assert!(document.contains("id=\"probe\""), "{}: no result in {document}", page.display());
    let text = element(&document, "probe").replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
    serde_json::from_str(&text).expect("JSON")
}

fn complex(value: &Value) -> Complex<f64> {
    let part = |i: usize| value[i].as_f64().expect("a number");
    Complex::new(part(0), part(1))
}

/// The core's table of a motion, with the capacity of the page's table. It is too large for the stack of a test.
fn core_of(motion: &Motion) -> MutexGuard<'static, PageMotion> {
    static TABLE: Mutex<PageMotion> = Mutex::new(PageMotion::EMPTY);
    let mut table = TABLE.lock().unwrap_or_else(PoisonError::into_inner);
    table.set_up(&MotionWithPeriod::new(*motion)).expect("it fits");
    table
}

/// Asserts that the numbers that the page shows are the core's to the bit.
fn assert_core(shown: &Value, core: &PageMotion, t: f64) -> Orientation<f64> {
    let (phi, tip) = core.at(t);
    let [x, y, z] = phi.axis();
    assert_eq!([complex(&shown["alpha"]), complex(&shown["beta"])], [phi.alpha, phi.beta], "{t}");
    assert_eq!([0, 1, 2].map(|i| shown["axis"][i].as_f64()), [x, y, z].map(Some), "{t}");
    assert_eq!((shown["u"].as_f64(), complex(&shown["tip"])), (Some(phi.u().clamp(-1.0, 1.0)), tip), "{t}");
    phi
}

#[test]
#[ignore = "a browser: cargo xtask test --only browser"]
fn the_page_shows_what_the_core_says() {
    let folder = folder("view_shown");
    for (name, expected) in [
        ("toy_top", ["nutation period", "0.07596 s"]),
        ("lagrange", ["spin", "150 rad/s = 1432 rpm"]),
        ("figure_3_loops", ["least normal force", "0.64706 weights"]),
    ] {
        let file = sample(name);
        let page = folder.join(format!("{name}.html"));
        view(&[&file], &page);
        let core = core_of(&Scenario::read(Path::new(&file)).expect("a scenario").motion);
        // also far from t = 0, and in the past
        let times = [0.3125, -2.5, 1_000_000.75];
        let shown = probe(&page, &format!("shownAt({times:?})"), 1200, "");
        let shown = list(&shown);
        assert_eq!(shown.len(), times.len());
        for (shown, t) in shown.iter().zip(times) {
            assert_eq!(shown["t"].as_f64(), Some(t), "{name}");
            let phi = assert_core(shown, &core, t);
            // the matrix with which the top is drawn
            for (column, body) in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].into_iter().enumerate()
            {
                for (row, expected) in phi.adjoint(body).into_iter().enumerate() {
                    let drawn = shown["columns"][column][row].as_f64().expect("a number");
                    assert!((drawn - expected).abs() < MATRIX, "{name}: {drawn} for {expected}");
                }
            }
            let written = format!("{:.6}", phi.u()).replace('-', "−");
            assert_eq!(shown["facts"]["u"].as_str(), Some(&*written), "{name}");
            let [fact, value] = expected;
            assert_eq!(shown["facts"][fact], value, "{name}");
            for colours in list(&shown["colours"]) {
                assert!(colours.as_u64() > Some(MANY_COLOURS), "{name}: an empty picture: {shown}");
            }
        }
    }
}

/// Greatest rounding of an element of a matrix.
const MATRIX: f64 = 1e-15;
/// Number of colours that a picture with smooth lines exceeds; an empty one has one colour.
const MANY_COLOURS: u64 = 40;

/// An error on a page reaches the console that the tests read.
#[test]
#[ignore = "a browser: cargo xtask test --only browser"]
fn an_error_on_a_page_is_seen() {
    let page = folder("view_error").join("error.html");
    for script in ["absent();", "console.error('bad')", "new Image().src = 'nowhere.png'"] {
        let html = format!(
            "<!DOCTYPE html><meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'\"><script>{script}</script>"
        );
        std::fs::write(&page, html).expect("writable");
        let (_, console) = browse(&page, 800, "");
        assert_eq!(console.len(), 1, "{script}: {console:?}");
    }
}
