//! Tests of `toytop plot`: contents of the picture, and complete files.

use super::{RELEASE, TOP, branch_points, folder, needle, run, sample, scenario, stderr, stdout};
use std::path::{Path, PathBuf};

fn entries(folder: &PathBuf) -> usize {
    std::fs::read_dir(folder).expect("a folder").count()
}

fn plot(file: &str, to: &Path) -> std::process::Output {
    run(&["plot", file, "-o", to.to_str().expect("UTF-8")])
}

fn svg(file: &str, to: &Path) -> String {
    let output = plot(file, to);
    assert_eq!((output.status.code(), stdout(&output)), (Some(0), ""), "{file}: {}", stderr(&output));
    std::fs::read_to_string(to).expect("the picture")
}

/// Points of every line of this colour, in pixels from the middle of the frame.
fn lines(svg: &str, color: &str) -> Vec<Vec<[f64; 2]>> {
    const MIDDLE: [f64; 2] = [352.0, 372.0];
    let points = |path: &str| -> Vec<[f64; 2]> {
        let (_, rest) = path.split_once("d=\"M ").expect("a path");
        let (digits, _) = rest.split_once('"').expect("a path");
        let place = |pair: &str| {
            let (x, y) = pair.trim().split_once(' ').expect("x y");
            [x.parse::<f64>().expect("x") - MIDDLE[0], y.parse::<f64>().expect("y") - MIDDLE[1]]
        };
        digits.split('L').map(place).collect()
    };
    let whole = |path: &'_ str| path.split_once('>').map(|(path, _)| path.to_owned());
    let of_color = |path: &String| path.contains(&format!("stroke=\"{color}\""));
    svg.split("<path ").skip(1).filter_map(whole).filter(of_color).map(|path| points(&path)).collect()
}

fn radii(points: &[[f64; 2]]) -> impl Iterator<Item = f64> {
    points.iter().map(|[x, y]| x.hypot(*y))
}

/// Each case is a scenario, parts of the caption, radii of the circles over s, and whether the curve returns to the first circle.
#[test]
fn the_curve_lies_between_its_circles() {
    let rho = |e: f64| (1.0 - e * e).sqrt();
    let loops = sample("figure_3_loops");
    let level = scenario("plot_level", &branch_points([-0.3, 0.6, 1.4], 1));
    let circle = scenario("plot_circle", &branch_points([0.5, 0.5, 1.7], -1));
    let centre = scenario("plot_centre", &branch_points([0.1, 1.0, 1.4], 1));
    let spiral = scenario("plot_spiral", &branch_points([0.2, 1.0, 1.0], 1));
    let cases: [(&str, &str, &[f64], f64); 5] = [
        (&loops, "loops, 5 periods: e₁ = 0.7, e₂ = 0.9, e₃ = 3", &[rho(0.7), rho(0.9)], rho(0.9)),
        (&level, "smooth, 3 periods: e₁ = -0.3, e₂ = 0.6, e₃ = 1.4", &[rho(0.3), rho(0.6), 1.0], rho(0.6)),
        (&circle, "circle: e₁ = 0.5, e₂ = 0.5, e₃ = 1.7", &[rho(0.5)], rho(0.5)),
        (&centre, "through origin, 3 periods: e₁ = 0.1, e₂ = 1, e₃ = 1.4", &[rho(0.1)], 0.0),
        (&spiral, "spiral: e₁ = 0.2, e₂ = 1, e₃ = 1", &[rho(0.2)], 0.0),
    ];
    let folder = folder("plot_between");
    for (index, (file, caption, circles, least)) in cases.into_iter().enumerate() {
        let picture = svg(file, &folder.join(format!("{index}.svg")));
        assert!(picture.contains(&format!(">{caption}<")), "{caption} is not in {picture}");
        let most = circles.iter().fold(0.0_f64, |most, radius| most.max(*radius));
        // the frame is 560 pixels wide, and 1.18 times as far from the middle as the largest radius
        let scale = 280.0 / (1.18 * most);
        let mut bounds: Vec<f64> =
            lines(&picture, "#8a8a8a").iter().flat_map(|line| radii(line).collect::<Vec<_>>()).collect();
        assert!(
            bounds.iter().all(|r| circles.iter().any(|circle| (r - scale * circle).abs() < 0.02)),
            "{caption}"
        );
        bounds.sort_by(f64::total_cmp);
        bounds.dedup_by(|a, b| (*a - *b).abs() < 0.1);
        assert_eq!(bounds.len(), circles.len(), "{caption}: {bounds:?}");
        let curves = lines(&picture, "#1f4e8c");
        let [curve] = &curves[..] else { panic!("{caption}: {} curves", curves.len()) };
        let [low, high] = radii(curve).fold([f64::INFINITY, 0.0], |[low, high], r| [low.min(r), high.max(r)]);
        assert!(
            (low - scale * least).abs() < 1.2 && (high - scale * most).abs() < 0.1,
            "{caption}: {low} {high}"
        );
        let longest = curve.windows(2).map(|pair| (pair[0][0] - pair[1][0]).hypot(pair[0][1] - pair[1][1]));
        assert!(longest.fold(0.0, f64::max) < 30.0 && curve.len() > 60, "{caption}");
    }
    assert_eq!(entries(&folder), 5, "nothing is left beside the pictures");
}

#[test]
fn png_and_constant_motions() {
    let folder = folder("plot_png");
    for name in ["sleeping", "lagrange", "toy_top"] {
        let to = folder.join(format!("{name}.PNG"));
        assert_eq!(plot(&sample(name), &to).status.code(), Some(0));
        let bytes = std::fs::read(&to).expect("the picture");
        assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
        let size = |at: usize| u32::from_be_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
        assert_eq!([size(16), size(20)], [1304, 1420]);
        assert!(bytes.ends_with(b"IEND\xaeB`\x82"));
    }
    let resting = svg(&sample("sleeping"), &folder.join("sleeping.svg"));
    assert!(resting.contains(">point: e₁ = 1, e₂ = 1, e₃ = ") && !resting.contains("#8a8a8a"));
    assert!(
        lines(&resting, "#1f4e8c").iter().all(|line| radii(line).all(|r| r < 0.1)),
        "a point is no circle"
    );
    let held = svg(&sample("lagrange"), &folder.join("lagrange.svg"));
    assert!(held.contains(">axis<") && !held.contains(">tip<"), "the tip of a held top stays");
    let curve = "tip held: seen from above, the end of a unit vector along the axis";
    assert!(held.contains(curve) && !resting.contains("unit vector"), "what is drawn is said");
    // l = n
    assert!(resting.contains(">l + n &gt; 0, l - n = 0,") && held.contains(">l + n &gt; 0, l - n &lt; 0,"));
}

/// Every kind of picture has names and units at its axes, in SI and without units.
#[test]
fn every_kind_names_its_axes() {
    let folder = folder("plot_kinds");
    let to = folder.join("kind.svg");
    let drawn = |name: &str, more: &[&str]| {
        let file = sample(name);
        let output = run(&[&["plot", &file, "-o", to.to_str().expect("UTF-8")], more].concat());
        assert_eq!(output.status.code(), Some(0), "{name} {more:?}: {}", stderr(&output));
        std::fs::read_to_string(&to).expect("the picture")
    };
    let cases: [(&str, &[&str], &[&str]); 14] = [
        ("toy_top", &[], &["x, mm", "y, mm", "t = 0 to 1.215 s", "start, direction"]),
        ("figure_3_loops", &[], &["x in units of s", "y in units of s", "t = 0 to 17.41<"]),
        ("toy_top", &["--times", "0.5..0.75"], &["t = 0.5 to 0.75 s"]),
        ("toy_top", &["--times", "1e6..1000000.2"], &["t = 1e6 to 1.0000002e6 s"]),
        ("figure_3_loops", &[], &[">lowest: tilt 45.57°<", ">highest: tilt 25.84°<"]),
        (
            "lagrange",
            &["--kind", "axis"],
            &["the axis on the unit sphere", "lowest: tilt 27.55°", "tip held<", "up"],
        ),
        ("toy_top", &["--kind", "tilt"], &["t, s", "tilt, degrees", ">least: 20.00°<", ">greatest: 22.23°<"]),
        ("figure_3_loops", &["--kind", "tilt"], &[">t<", "tilt, degrees"]),
        (
            "toy_top",
            &["--kind", "precession"],
            &["azimuth of the axis, degrees", "its mean: 296.3 degrees/s"],
        ),
        (
            "toy_top",
            &["--kind", "potential"],
            &["effective potential minus the energy h, mJ", "turning points"],
        ),
        (
            "sleeping",
            &["--kind", "potential"],
            &["tilt, degrees", "effective potential", ">tilt of the motion<"],
        ),
        ("pendulum", &["--kind", "potential"], &[">turning point<"]),
        ("sleeping", &[], &["The axis is vertical for ever: the tip rests.", ">start<"]),
        // an azimuth that is constant but for roundings stands in the middle of a degree on each side
        ("pendulum", &["--kind", "precession"], &["its mean: 0 degrees/s", ">-0.5<", ">0.5<"]),
    ];
    for (name, more, parts) in cases {
        let svg = drawn(name, more);
        for part in parts {
            assert!(svg.contains(part), "{name} {more:?}: {part}");
        }
    }
    // a picture of another width has the same layout
    let svg = drawn("toy_top", &["--size", "1304"]);
    assert!(
        svg.starts_with("<svg") && svg.contains("width=\"1304\" height=\"1420\" viewBox=\"0 0 652 710\""),
        "{}",
        &svg[..200]
    );
    let png = folder.join("small.png");
    let output = run(&["plot", &sample("toy_top"), "--size", "163", "-o", png.to_str().expect("UTF-8")]);
    let bytes = std::fs::read(&png).expect("the picture");
    assert_eq!((output.status.code(), &bytes[16..20]), (Some(0), &163_u32.to_be_bytes()[..]));
    for (more, code, part) in [
        (&["--kind", "precession"][..], 3, "sleeping: the axis is vertical at all times"),
        (&["--times", "2..1"], 2, "must be LOW..HIGH"),
        (&["--kind", "tilt", "--times", "0..1e300"], 2, "--times: 1e300 must be within"),
        (&["--size", "5"], 2, "--size"),
        (&["--kind", "top"], 2, "tip, axis, tilt, precession, potential"),
    ] {
        let output = run(&[&["plot", &sample("sleeping"), "-o", to.to_str().expect("UTF-8")], more].concat());
        assert_eq!(output.status.code(), Some(code), "{more:?}: {}", stderr(&output));
        assert!(stderr(&output).contains(part), "{}", stderr(&output));
    }
}

/// A curve with fewer than 32 points in a nutation period (75.96 ms) would show an alias of the motion.
#[test]
fn a_curve_has_points_in_every_period() {
    let to = folder("plot_points").join("long.svg");
    for (kind, color, times, least) in [
        ("tilt", "#0072b2", "-11..11.7", 9562),
        ("precession", "#0072b2", "5..27", 9267),
        ("tip", "#1f4e8c", "0..75", 63_193),
    ] {
        let times = format!("--times={times}");
        let file = sample("toy_top");
        let output = run(&["plot", &file, "--kind", kind, &times, "-o", to.to_str().expect("UTF-8")]);
        assert_eq!(output.status.code(), Some(0), "{kind}: {}", stderr(&output));
        let svg = std::fs::read_to_string(&to).expect("the picture");
        let points = lines(&svg, color).iter().map(Vec::len).max();
        assert!(points >= Some(least), "{kind}: {points:?}");
    }
}

/// More periods than a frame can show are refused before anything is computed; the longest time that the message allows is drawn.
#[test]
fn more_periods_than_a_picture_can_show_are_refused() {
    let folder = folder("plot_periods");
    let to = folder.join("long.svg");
    let spiral = scenario("plot_rises", &branch_points([0.2, 1.0, 1.0], 1));
    let circle = scenario("plot_turns", &branch_points([0.5, 0.5, 1.7], -1));
    let top = sample("toy_top");
    let cases = [
        (&top, "tilt", "0..76", "0..76: must span at most 300 nutation periods (22.78 s) for --kind tilt"),
        (
            &top,
            "precession",
            "1e6..2e6",
            "1e6..2e6: must span at most 300 nutation periods (22.78 s) for --kind precession",
        ),
        (&top, "tip", "0..1e6", "0..1e6: must span at most 1000 nutation periods (75.96 s)"),
        (&top, "axis", "-38..38", "-38..38: must span at most 1000 nutation periods (75.96 s)"),
        (&top, "potential", "0..1", "not for --kind potential"),
        (
            &spiral,
            "tilt",
            "0..1e5",
            "0..1e5: must span at most 300 times 2 pi sqrt((A/p + s)/g) (2544 s) for --kind tilt",
        ),
        (&circle, "tip", "0..1e5", "0..1e5: must span at most 1000 turns about the vertical (12180 s)"),
    ];
    let drawn = |file: &str, kind: &str, times: &str| {
        let times = format!("--times={times}");
        run(&["plot", file, "--kind", kind, &times, "-o", to.to_str().expect("UTF-8")])
    };
    for (file, kind, times, reason) in cases {
        let output = drawn(file, kind, times);
        assert_eq!((output.status.code(), stdout(&output)), (Some(2), ""), "{kind} {times}");
        assert_eq!(stderr(&output), format!("error: --times: {reason}\n"));
        assert_eq!(entries(&folder), 0, "{kind} {times}");
        let Some((_, longest)) = reason.rsplit_once(" (") else { continue };
        let longest = longest.split([' ', ')']).next().expect("a time");
        let output = drawn(file, kind, &format!("0..{longest}"));
        assert_eq!(output.status.code(), Some(0), "{kind} {longest}: {}", stderr(&output));
        std::fs::remove_file(&to).expect("the picture");
    }
    let help = run(&["plot", "--help"]);
    assert!(
        stdout(&help).contains("1000 nutation periods") && stdout(&help).contains("300"),
        "{}",
        stdout(&help)
    );
}

/// Far from t = 0 the labels of the axes have few digits, because they count from the first time and whole turns.
#[test]
fn an_axis_far_from_zero_counts_from_its_beginning() {
    let to = folder("plot_far").join("far.svg");
    let file = sample("toy_top");
    for (kind, times, titles) in [
        ("tilt", "1000000..1000000.2", &["t - 1000000 s"][..]),
        (
            "precession",
            "-1000000.5..-1000000",
            &["t + 1000000.5 s", "azimuth of the axis + 822946 turns, degrees"],
        ),
        ("tilt", "100..100.2", &["t, s"]),
    ] {
        let times = format!("--times={times}");
        let output = run(&["plot", &file, "--kind", kind, &times, "-o", to.to_str().expect("UTF-8")]);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        let svg = std::fs::read_to_string(&to).expect("the picture");
        let texts: Vec<_> =
            svg.split("</text>").filter_map(|part| part.rsplit_once('>')).map(|(_, text)| text).collect();
        for title in titles {
            assert!(texts.contains(title), "{times}: {title}: {texts:?}");
        }
        let ticks: Vec<_> = texts.iter().filter(|text| text.parse::<f64>().is_ok()).collect();
        assert!(ticks.len() > 5 && ticks.iter().all(|tick| tick.len() < 7), "{ticks:?}");
    }
}

/// The arrow is on the curve and points in the direction of the tip's motion.
#[test]
fn the_arrow_points_along_the_curve() {
    let folder = folder("plot_arrow");
    for name in ["toy_top", "figure_3_loops", "lagrange"] {
        let picture = svg(&sample(name), &folder.join(format!("{name}.svg")));
        let curve = lines(&picture, "#1f4e8c").remove(0);
        let [arrow] = &lines(&picture, "#c0392b")[..] else { panic!("{name}: one arrow") };
        let [left, tip, right] = arrow[..] else { panic!("{name}: two arms") };
        let away = |p: &[f64; 2], q: &[f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]);
        let at = curve.iter().position(|point| away(point, &tip) < 0.05).expect("the arrow is on the curve");
        let behind = [0.5 * (left[0] + right[0]) - tip[0], 0.5 * (left[1] + right[1]) - tip[1]];
        let came = [curve[at - 1][0] - tip[0], curve[at - 1][1] - tip[1]];
        let cosine = (behind[0] * came[0] + behind[1] * came[1])
            / (behind[0].hypot(behind[1]) * came[0].hypot(came[1]));
        assert!(cosine > 0.99, "{name}: {cosine}");
    }
}

#[test]
fn a_picture_is_written_completely_or_not_at_all() {
    let folder = folder("plot_refused");
    let good = sample("toy_top");
    let missing = sample("no_such_file");
    let needle = needle("plot_needle");
    let cases = [
        (&good, "tip.jpg", 2, ".svg, .png, .pdf"),
        (&good, "tip", 2, ".svg, .png, .pdf"),
        (&good, "no/such/folder/tip.svg", 2, "no/such/folder/tip.svg"),
        (&missing, "tip.svg", 2, "no_such_file.toml"),
        (&needle, "tip.svg", 3, "plot_needle: no ephemeris"),
    ];
    for (file, name, code, part) in cases {
        let output = plot(file, &folder.join(name));
        let message = stderr(&output);
        assert_eq!((output.status.code(), stdout(&output)), (Some(code), ""), "{name}: {message}");
        assert!(message.contains(part) && message.matches('\n').count() == 1, "{name}: {message}");
        assert_eq!(entries(&folder), 0, "{name}");
    }
    // over an older picture
    let to = folder.join("tip.svg");
    std::fs::write(&to, "old").expect("writable");
    assert!(svg(&good, &to).starts_with("<svg"));
    let lift_off = scenario("plot_lift_off", &(TOP.to_owned() + RELEASE).replace("spin = 3.5", "spin = 35"));
    assert_eq!(plot(&lift_off, &to).status.code(), Some(0));
    assert_eq!(entries(&folder), 1);
}

/// One page, as large as the layout or so many points wide; a program without the feature says how to get it.
#[test]
fn a_picture_is_a_page_of_pdf() {
    let folder = folder("plot_pdf");
    let to = folder.join("tip.pdf");
    for (size, width) in [(None, "652 710]"), (Some("326"), "326 355]")] {
        let size = size.map_or(Vec::new(), |size| vec!["--size", size]);
        let file = sample("toy_top");
        let output = run(&[&["plot", &file, "-o", to.to_str().expect("UTF-8")][..], &size].concat());
        if cfg!(feature = "pdf") {
            assert_eq!((output.status.code(), stderr(&output)), (Some(0), ""));
            let bytes = std::fs::read(&to).expect("the page");
            // an optimised program writes no space before a bracket
            let text = String::from_utf8_lossy(&bytes).replace("/MediaBox[", "/MediaBox [");
            assert!(text.starts_with("%PDF-") && text.trim_end().ends_with("%%EOF"));
            assert!(
                text.contains("/Count 1") && text.contains(&format!("/MediaBox [0 0 {width}")),
                "{width}"
            );
        } else {
            assert_eq!(output.status.code(), Some(2));
            let reason =
                "tip.pdf: this program was built without the feature pdf (cargo build --features pdf); ";
            assert!(stderr(&output).starts_with("error: --output: ") && !to.exists());
            assert!(stderr(&output).contains(reason), "{}", stderr(&output));
        }
    }
}

/// Without a legend: the names stand to the right of the frame, each at the height at which its curve ends, apart from each other.
#[test]
fn curves_end_in_their_names() {
    let to = folder("plot_ends").join("tilt.svg");
    let file = sample("toy_top");
    let output = run(&["plot", &file, "--kind", "tilt", "-o", to.to_str().expect("UTF-8")]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let svg = std::fs::read_to_string(&to).expect("the picture");
    let place = |name: &str| -> [f64; 2] {
        let (before, _) = svg.split_once(&format!(">{name}")).expect("the name");
        let (_, tag) = before.rsplit_once("<text ").expect("its element");
        ["x=\"", "y=\""].map(|key| {
            let (_, rest) = tag.split_once(key).expect("a place");
            rest.split_once('"').expect("its end").0.parse().expect("a number")
        })
    };
    let [greatest, tilt, least] = ["greatest", "tilt<", "least"].map(place);
    assert!(
        greatest[0] == tilt[0] && tilt[0] == least[0] && tilt[0] > 500.0,
        "{greatest:?} {tilt:?} {least:?}"
    );
    // after whole periods the tilt ends at its least
    assert!(greatest[1] < 110.0 && tilt[1] - greatest[1] > 250.0);
    assert!((15.5..18.0).contains(&(least[1] - tilt[1]).abs()), "{tilt:?} {least:?}");
}

#[test]
fn the_readmes_picture_is_todays() {
    let to = folder("plot_readme").join("tip.svg");
    let readmes = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/tip.svg");
    let kept = std::fs::read_to_string(readmes).expect("the README's picture");
    assert_eq!(
        svg(&sample("figure_3_loops"), &to),
        kept,
        "toytop plot host/scenarios/figure_3_loops.toml -o host/docs/tip.svg"
    );
}
