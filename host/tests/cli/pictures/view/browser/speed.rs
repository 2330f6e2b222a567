//! Time from a slider to its picture, which is printed and not judged: a busy machine is no bug.

use super::probed;
use crate::pictures::view::{folder, view};
use crate::sample;

/// Moves sliders one after the other and draws at once; the median and the least of the times, ms. It runs before the page
/// counts as loaded, because Chromium's time passes as usual then.
const TIMED: &str = "
ready.then(() => {
  const times = [];
  const reader = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
  for (let i = 0; i < 60; i++) {
    const [id, value] = [['tilt_deg', 0.1 + 0.004 * i], ['spin', 0.8 - 0.003 * i], ['mass', 0.4 + 0.002 * i]][i % 3];
    element(id).value = String(value);
    const before = performance.now();
    element(id).dispatchEvent(new Event('input', { bubbles: true }));
    // a picture is there when its pixels are, and what stands beside it when it has a place
    document.body.getBoundingClientRect();
    for (const canvas of document.querySelectorAll('canvas')) reader.drawImage(canvas, 0, 0, 1, 1);
    reader.getImageData(0, 0, 1, 1);
    times.push(performance.now() - before);
  }
  times.sort((a, b) => a - b);
  element('result').textContent = JSON.stringify([times[30], times[0]]);
  element('result').id = 'probe';
});
";

#[test]
#[ignore = "a browser: cargo xtask test --only browser"]
fn a_slider_is_followed_by_its_picture() {
    let page = folder("view_speed").join("speed.html");
    let html = view(&[&sample("toy_top")], &page);
    let probe = format!("<pre id=\"result\"></pre><script>{TIMED}</script></body>");
    std::fs::write(&page, html.replace("</body>", &probe)).expect("writable");
    let times = probed(&page, 1400, "", "--disable-sync");
    let [median, least]: [f64; 2] = serde_json::from_str(&times).expect("two times");
    assert!(median >= least && least > 0.0);
    println!("from slider to picture in {median:.1} ms, at best {least:.1} ms");
}
