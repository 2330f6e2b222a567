//! In a browser: the evaluator gives the crate's bits, and the page shows the crate's orientation, without an error.
//!
//! Run by `cargo xtask test --only browser`, which provides Chromium and names it in `CHROMIUM`.

use super::{element, folder, view};
use crate::bake::cases::{Case, RUNS, assert_equal, cases};
use crate::{run, sample, samples, stdout};
use serde_json::Value;
use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;
use toytop::{Complex, Ephemeris, Orientation, Tick};
use toytop_host::input::scenario::Scenario;
use toytop_host::pictures::view::EVALUATOR;

/// The document as Chromium leaves it, and what it wrote to the console.
fn browse(page: &Path, width: u32) -> (String, Vec<String>) {
    let program = std::env::var("CHROMIUM").unwrap_or_else(|_| "chromium".to_owned());
    let profile = page.with_extension("profile");
    let mut command = Command::new(&program);
    command.args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"]);
    command.args(["--disable-background-networking", "--disable-component-update", "--disable-sync"]);
    command.args([
        "--enable-logging=stderr",
        "--timeout=120000",
        "--virtual-time-budget=20000",
        "--dump-dom",
    ]);
    command.arg(format!("--user-data-dir={}", profile.display()));
    command.arg(format!("--window-size={width},900"));
    let output = command.arg(format!("file://{}", page.display())).output();
    let output = output.unwrap_or_else(|error| panic!("{program}: {error}"));
    let log = String::from_utf8_lossy(&output.stderr);
    let console = log.lines().filter(|line| line.contains("CONSOLE")).map(str::to_owned).collect();
    (stdout(&output).to_owned(), console)
}

/// What a script wrote into the element `probe`.
fn probed(page: &Path, width: u32) -> String {
    let (document, console) = browse(page, width);
    assert_eq!(console, [""; 0], "{}", page.display());
    assert!(document.contains("id=\"probe\""), "{}: no result in {document}", page.display());
    element(&document, "probe").replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
}

/// JavaScript that makes `printed` of the moments that [`Case::truth`] has.
fn evaluation(cases: &[Case]) -> String {
    let (singles, runs, length) = RUNS;
    let mut tables = String::new();
    for Case { file, scalar, size, tick: [ticks, seconds], .. } in cases {
        let tick = format!("{ticks}/{seconds}");
        let words = ["bake", file, "--scalar", scalar, "--size", size, "--tick", &tick, "--lang", "json"];
        writeln!(tables, "{},", stdout(&run(&words)).trim_end()).expect("memory");
    }
    format!(
        "\"use strict\";\n{EVALUATOR}
const bits = new DataView(new ArrayBuffer(4));
const hexadecimal = (x) => (bits.setFloat32(0, x), bits.getUint32(0).toString(16));
const lines = [];
const print = (table, tick) => {{
  const {{ nutation, alpha, beta, u, tip }} = momentAt(table, tick);
  lines.push([nutation.toString(16), ...[...alpha, ...beta, u, ...tip].map(hexadecimal)].join(\" \"));
}};
for (const table of [{tables}].map(readTable)) {{
  let state = 1n;
  const next = (k) => {{
    state = BigInt.asUintN(64, state * 6364136223846793005n + 1442695040888963407n);
    return BigInt.asIntN(64, state) >> BigInt(k % 61);
  }};
  for (let k = 0; k < {singles}; k++) print(table, next(k));
  for (let k = 0; k < {runs}; k++) {{
    const first = k < 2 ? (table.horizon || [0n, 0n])[k] - 9n : next(k + 20);
    for (let i = 0n; i < {length}n; i++) print(table, first + i);
  }}
}}
const printed = lines.join(\"\\n\");
"
    )
}

#[test]
#[ignore = "a browser: cargo xtask test --only browser"]
fn the_evaluator_gives_the_bits_of_the_crate() {
    let folder = folder("view_bits");
    let mut cases = cases();
    cases.retain(|case| case.scalar == "f32");
    let script = evaluation(&cases);
    let page = folder.join("bits.html");
    let show = "document.getElementById(\"probe\").textContent = printed;";
    std::fs::write(&page, format!("<!DOCTYPE html><pre id=\"probe\"></pre><script>{script}{show}</script>"))
        .expect("writable");
    assert_equal(&probed(&page, 800), &cases);
    let mut engines = "Chromium".to_owned();

    let program = folder.join("bits.js");
    std::fs::write(&program, script + "console.log(printed);").expect("writable");
    match Command::new("node").arg(&program).output() {
        Ok(output) => {
            assert_equal(stdout(&output), &cases);
            engines += " and node";
        }
        Err(_) => engines += " (node is not here)",
    }
    println!("evaluated by {engines}");
}

/// Goes to each time by the address, and says what is shown then.
const SHOWN: &str = "
const results = [];
for (const t of TIMES) {
  location.hash = `t=${t}`;
  await settled();
  const { tick, moment, rotate } = shown;
  const columns = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(rotate);
  const text = Object.fromEntries([\"u\", \"alpha\", \"tilt\"].map((id) => [id, element(id).textContent]));
  results.push({ t: state.t, tick, alpha: moment.alpha, beta: moment.beta, columns, text, colours: colours() });
}
return results;
";

/// What the page and its controls do; every line is a sentence that must be true.
const CONTROLS: &str = "
const facts = {};
const key = (target, key) => target.dispatchEvent(new KeyboardEvent(\"keydown\", { key, bubbles: true }));
const set = (id, value, event) => {
  element(id).value = value;
  element(id).dispatchEvent(new Event(event));
};
const [main] = document.querySelectorAll(\"canvas\");
facts[\"it plays by itself\"] = state.playing && state.t > 0;
element(\"play\").click();
await settled();
const paused = state.t;
facts[\"the button pauses and says what it does now\"] = !state.playing && element(\"play\").getAttribute(\"aria-label\") === \"Play\";
await settled();
facts[\"a pause is one\"] = state.t === paused;
key(document.body, \" \");
await settled();
facts[\"space plays\"] = state.playing && state.t > paused;
set(\"position\", \"0.25\", \"input\");
await settled();
facts[\"the slider sets the time and pauses\"] = !state.playing && Math.abs(state.t - 0.25 * scene.span) < 1e-9;
facts[\"the slider says the time\"] = element(\"position\").getAttribute(\"aria-valuetext\").endsWith(\" s\");
const before = picture(main);
key(main, \"ArrowLeft\");
await settled();
facts[\"an arrow turns the picture\"] = picture(main) !== before;
set(\"speed\", \"3\", \"input\");
facts[\"the slider sets the speed\"] = Math.abs(state.speed - 8 * scene.speed) < 1e-12;
set(\"time\", \"1e6\", \"change\");
await settled();
facts[\"the field takes any time\"] = state.t === 1e6 && shown.tick === 1e6 * rate;
facts[\"the slider's range follows\"] = Number(element(\"position\").value) <= 1 && state.page === Math.floor(1e6 / scene.span);
set(\"time\", \"soon\", \"change\");
await settled();
facts[\"what is no time changes nothing\"] = state.t === 1e6;
key(document.body, \"Home\");
await settled();
facts[\"Home goes back\"] = state.t === 0;
const named = (e) => e.getAttribute(\"aria-label\") || (e.labels && e.labels.length > 0);
facts[\"everything has a name\"] = [...document.querySelectorAll(\"canvas, button, input\")].every(named);
facts[\"nothing is wider than the window\"] = document.documentElement.scrollWidth <= innerWidth;
return facts;
";

/// Chromium's clock runs ahead where nothing is to be done, and does not wait for frames: here they are timers.
const FRAMES: &str =
    "window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 16);";

/// The page with a script behind its own, whose result goes into the element `probe`.
fn probe(page: &Path, script: &str, width: u32) -> Value {
    let html = std::fs::read_to_string(page).expect("the page");
    let probe = format!(
        "<pre id=\"result\"></pre><script>
const settled = () => new Promise((done) => setTimeout(done, 200));
const pixels = (canvas) => {{
  const {{ width, height }} = canvas;
  const copy = new OffscreenCanvas(width, height).getContext(\"2d\", {{ willReadFrequently: true }});
  copy.drawImage(canvas, 0, 0);
  return copy.getImageData(0, 0, width, height).data;
}};
const picture = (canvas) => pixels(canvas).reduce((hash, byte) => (Math.imul(hash, 31) + byte) | 0, 0);
const colours = () => [...document.querySelectorAll(\"canvas\")].map((canvas) => new Set(new Uint32Array(pixels(canvas).buffer)).size);
addEventListener(\"load\", async () => {{
  await settled();
  const results = await (async () => {{{script}}})();
  element(\"result\").textContent = JSON.stringify(results);
  element(\"result\").id = \"probe\";
}});
</script></body>"
    );
    let html = html.replace("<head>", &format!("<head><script>{FRAMES}</script>")).replace("</body>", &probe);
    let probed_page = page.with_extension("probe.html");
    std::fs::write(&probed_page, html).expect("writable");
    serde_json::from_str(&probed(&probed_page, width)).expect("JSON")
}

fn complex(value: &Value) -> Complex<f64> {
    let part = |i: usize| value[i].as_f64().expect("a number");
    Complex::new(part(0), part(1))
}

#[test]
#[ignore = "a browser: cargo xtask test --only browser"]
fn the_page_shows_what_the_core_says() {
    let folder = folder("view_shown");
    for name in ["toy_top", "lagrange", "figure_3_loops"] {
        let file = sample(name);
        let page = folder.join(format!("{name}.html"));
        let table: Value = serde_json::from_str(element(&view(&file, &page), "table")).expect("JSON");
        let (document, console) = browse(&page, 1200);
        assert!(console.is_empty() && element(&document, "tilt").ends_with('°'), "{name}: {console:?}");
        let hertz = table["ticks_per_time"][0].as_f64().expect("a number");
        let motion = Scenario::read(Path::new(&file)).expect("a scenario").motion;
        let tick = Tick::hertz(hertz as u32).expect("a tick");
        let core = Ephemeris::<f32, 25>::new(&motion, tick).expect("it fits");
        // far out and in the past, too
        let times = "[0.3125, -2.5, 1000000.75]";
        let shown = probe(&page, &SHOWN.replace("TIMES", times), 1200);
        let truth = samples(&file, times.trim_matches(['[', ']']), &[]);
        assert_eq!(shown.as_array().map(Vec::len), Some(3));
        for (shown, truth) in shown.as_array().expect("an array").iter().zip(&truth) {
            let t = truth["t"].as_f64().expect("a time");
            assert_eq!((shown["t"].as_f64(), shown["tick"].as_f64()), (Some(t), Some(t * hertz)), "{name}");
            let phi = core.at_tick((t * hertz) as i64).orientation();
            let wide = |z: Complex<f32>| Complex::new(f64::from(z.re), f64::from(z.im));
            let phi = Orientation { alpha: wide(phi.alpha), beta: wide(phi.beta) };
            assert_eq!((complex(&shown["alpha"]), complex(&shown["beta"])), (phi.alpha, phi.beta), "{name}");
            let [alpha, beta] = ["alpha", "beta"].map(|key| complex(&shown[key]) - complex(&truth[key]));
            let error = 2.0 * (alpha.norm_squared() + beta.norm_squared()).sqrt();
            assert!(error < ORIENTATION, "{name}: {error:e} rad at {t}");
            // the matrix that everything is drawn with
            for (column, body) in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].into_iter().enumerate()
            {
                for (row, expected) in phi.adjoint(body).into_iter().enumerate() {
                    let drawn = shown["columns"][column][row].as_f64().expect("a number");
                    assert!((drawn - expected).abs() < MATRIX, "{name}: {drawn} for {expected}");
                }
            }
            let written = format!("{:.6}", phi.u()).replace('-', "−");
            assert_eq!(shown["text"]["u"].as_str(), Some(&*written), "{name}");
            for colours in shown["colours"].as_array().expect("three pictures") {
                assert!(colours.as_u64() > Some(MANY_COLOURS), "{name}: an empty picture: {shown}");
            }
        }
    }
}

/// f32 at any time, rad, with the truth's own error.
const ORIENTATION: f64 = 2.5e-7;
/// The page has u as an f32.
const MATRIX: f64 = 1.2e-7;
/// A picture has them, by lines drawn smoothly; an empty one has one.
const MANY_COLOURS: u64 = 50;

#[test]
#[ignore = "a browser: cargo xtask test --only browser"]
fn the_page_does_what_its_controls_say() {
    let folder = folder("view_controls");
    for (name, width) in [("toy_top", 1200), ("figure_3_cusp", 500)] {
        let page = folder.join(format!("{name}.html"));
        view(&sample(name), &page);
        let facts = probe(&page, CONTROLS, width);
        let facts = facts.as_object().expect("facts");
        assert_eq!(facts.len(), 14, "{facts:?}");
        for (fact, holds) in facts {
            assert_eq!(holds, true, "{name}: {fact}");
        }
    }
}

/// What this suite would not notice of itself: an error on a page is one here.
#[test]
#[ignore = "a browser: cargo xtask test --only browser"]
fn an_error_on_a_page_is_seen() {
    let page = folder("view_error").join("error.html");
    for script in ["absent();", "console.error('bad')", "new Image().src = 'nowhere.png'"] {
        let html = format!(
            "<!DOCTYPE html><meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'\"><script>{script}</script>"
        );
        std::fs::write(&page, html).expect("writable");
        let (_, console) = browse(&page, 800);
        assert_eq!(console.len(), 1, "{script}: {console:?}");
    }
}
