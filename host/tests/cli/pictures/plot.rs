//! `toytop plot`: contents of the pictures, and pictures that are complete or missing.

use crate::command::{
    all_refused, branch_points, count, folder, motion_without_table, path, read, repository, scenario, toytop,
};

/// Picture of this command line, in a file of this name.
fn svg(line: &str, to: &str) -> String {
    assert_eq!(toytop(format!("plot {line} -o {to}")).ok(), "");
    read(to)
}

/// Points of every line of this colour, in pixels from the middle of the frame.
pub(crate) fn lines(svg: &str, color: &str) -> Vec<Vec<[f64; 2]>> {
    const MIDDLE: [f64; 2] = [352.0, 372.0];
    let point = |pair: &str| {
        let (x, y) = pair.trim().split_once(' ').expect("x y");
        [x.parse::<f64>().expect("x") - MIDDLE[0], y.parse::<f64>().expect("y") - MIDDLE[1]]
    };
    let paths = svg.split("<path ").skip(1).filter_map(|path| path.split('>').next());
    let of_color = paths.filter(|path| path.contains(&format!("stroke=\"{color}\"")));
    let digits = of_color.filter_map(|path| path.split_once("d=\"M ")?.1.split('"').next());
    digits.map(|digits| digits.split('L').map(point).collect()).collect()
}

fn radii(points: &[[f64; 2]]) -> impl Iterator<Item = f64> {
    points.iter().map(|[x, y]| x.hypot(*y))
}

/// Each case is a scenario, parts of the caption, radii of the circles over s, and whether the curve returns to the first circle.
#[test]
fn the_curve_lies_between_its_circles() {
    let rho = |e: f64| (1.0 - e * e).sqrt();
    let level = scenario("plot_level", &branch_points([-0.3, 0.6, 1.4], 1));
    let circle = scenario("plot_circle", &branch_points([0.5, 0.5, 1.7], -1));
    let centre = scenario("plot_centre", &branch_points([0.1, 1.0, 1.4], 1));
    let spiral = scenario("plot_spiral", &branch_points([0.2, 1.0, 1.0], 1));
    let cases: [(&str, &str, &[f64], f64); 5] = [
        ("@figure_3_loops", "loops, 5 periods: e₁ = 0.7, e₂ = 0.9, e₃ = 3", &[rho(0.7), rho(0.9)], rho(0.9)),
        (&level, "smooth, 3 periods: e₁ = -0.3, e₂ = 0.6, e₃ = 1.4", &[rho(0.3), rho(0.6), 1.0], rho(0.6)),
        (&circle, "circle: e₁ = 0.5, e₂ = 0.5, e₃ = 1.7", &[rho(0.5)], rho(0.5)),
        (&centre, "through origin, 3 periods: e₁ = 0.1, e₂ = 1, e₃ = 1.4", &[rho(0.1)], 0.0),
        (&spiral, "spiral: e₁ = 0.2, e₂ = 1, e₃ = 1", &[rho(0.2)], 0.0),
    ];
    folder("plot_between");
    for (index, (file, caption, circles, least)) in cases.into_iter().enumerate() {
        let picture = svg(file, &format!("plot_between/{index}.svg"));
        assert!(picture.contains(&format!(">{caption}<")), "{caption} is not in {picture}");
        let most = circles.iter().fold(0.0_f64, |most, radius| most.max(*radius));
        // the frame is 560 pixels wide, and 1.18 times as far from the middle as the largest radius
        let scale = 280.0 / (1.18 * most);
        let bounds = lines(&picture, "#8a8a8a").concat();
        let of = |r: f64| circles.iter().position(|circle| (r - scale * circle).abs() < 0.02);
        let mut found: Vec<_> =
            radii(&bounds).map(|r| of(r).unwrap_or_else(|| panic!("{caption}: {r}"))).collect();
        found.sort_unstable();
        found.dedup();
        assert_eq!(found.len(), circles.len(), "{caption}");
        let [curve] = &lines(&picture, "#1f4e8c")[..] else { panic!("{caption}: one curve") };
        let [low, high] = radii(curve).fold([f64::INFINITY, 0.0], |[low, high], r| [low.min(r), high.max(r)]);
        assert!(
            (low - scale * least).abs() < 1.2 && (high - scale * most).abs() < 0.1,
            "{caption}: {low} {high}"
        );
        let longest = curve.windows(2).map(|pair| (pair[0][0] - pair[1][0]).hypot(pair[0][1] - pair[1][1]));
        assert!(longest.fold(0.0, f64::max) < 30.0 && curve.len() > 60, "{caption}");
    }
    assert_eq!(count("plot_between"), 5, "nothing is left beside the pictures");
}

#[test]
fn png_has_its_size() {
    folder("plot_png");
    for (line, size) in [("@sleeping", [1304, 1420]), ("@toy_top --size 163", [163, 178])] {
        toytop(format!("plot {line} -o plot_png/a.PNG")).ok();
        let bytes = std::fs::read(path("plot_png/a.PNG")).expect("the picture");
        assert!(bytes.starts_with(b"\x89PNG\r\n\x1a\n") && bytes.ends_with(b"IEND\xaeB`\x82"));
        let number = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().expect("four bytes"));
        assert_eq!([number(16), number(20)], size, "{line}");
    }
}

/// Every kind of picture has names and units at its axes, in SI and without units. A part after "not" is missing.
#[test]
fn every_kind_says_what_it_shows() {
    folder("plot_kinds");
    for (line, parts) in [
        ("@toy_top", "x, mm ... y, mm ... t = 0 to 1.215 s"),
        ("@figure_3_loops", "x in units of s ... >lowest: tilt 45.57°< ... >highest: tilt 25.84°<"),
        ("@toy_top --span 1e6..1000000.2", "t = 1e6 to 1.0000002e6 s"),
        ("@lagrange", ">axis< ... tip held ... not >tip<"),
        ("@lagrange --kind axis", "the axis on the unit sphere ... lowest: tilt 27.55°"),
        (
            "@toy_top --kind tilt",
            "t, s ... tilt, degrees ... >highest: tilt 20.00°< ... >lowest: tilt 22.23°<",
        ),
        ("@toy_top --kind precession", "azimuth of the axis, degrees ... its mean: 296.3 degrees/s"),
        ("@toy_top --kind potential", "effective potential minus the energy h, mJ"),
        ("@sleeping", "the tip rests ... l - n = 0, ... not #8a8a8a"),
        // an azimuth that is constant but for roundings stands in the middle of a degree on each side
        ("@pendulum --kind precession", "its mean: 0 degrees/s ... >-0.5< ... >0.5<"),
    ] {
        let picture = svg(line, "plot_kinds/a.svg");
        for part in parts.split(" ... ") {
            let (part, is_there) = part.strip_prefix("not ").map_or((part, true), |part| (part, false));
            assert_eq!(picture.contains(part), is_there, "{line}: {part}");
        }
    }
    let resting = lines(&svg("@sleeping", "plot_kinds/a.svg"), "#1f4e8c");
    assert!(resting.iter().all(|line| radii(line).all(|r| r < 0.1)), "a point is no circle");
    let motion_without_table = motion_without_table("plot_needle");
    toytop(format!("plot {motion_without_table} -o a.svg")).refused(3, "plot_needle: no table");
    toytop("plot @sleeping --kind precession -o a.svg")
        .refused(3, "sleeping: the axis is vertical at all times");
    all_refused("plot @toy_top", &[("-o tip.jpg", ".svg or .png"), ("-o tip", ".svg or .png")]);
    all_refused(
        "plot @sleeping -o a.svg",
        &[
            ("--span 2..1", "must be LOW..HIGH"),
            ("--kind tilt --span 0..1e300", "--span: 1e300 must be within"),
            ("--size 5", "--size"),
            ("--kind top", "tip, axis, tilt, precession, potential"),
        ],
    );
}

/// More periods than a frame can show are refused before anything is computed; the longest time that the message allows is drawn.
#[test]
fn more_periods_than_a_picture_can_show_are_refused() {
    folder("plot_periods");
    let spiral = scenario("plot_rises", &branch_points([0.2, 1.0, 1.0], 1));
    let circle = scenario("plot_turns", &branch_points([0.5, 0.5, 1.7], -1));
    for (file, kind, times, longest) in [
        ("@toy_top", "precession", "1e6..2e6", "75.96"),
        ("@toy_top", "tip", "-38..38", "75.96"),
        (&spiral, "tilt", "0..1e5", "8482"),
        (&circle, "axis", "0..1e5", "12180"),
    ] {
        let line = format!("plot {file} --kind {kind} --span={times} -o plot_periods/a.svg");
        let most = format!("must span at most {longest} (1000 nutation periods or turns)");
        toytop(line).refused(2, &format!("error: --span: {times}: {most}\n"));
    }
    toytop("plot @toy_top --kind potential --span=0..1 -o plot_periods/a.svg")
        .refused(2, "error: --span: not for --kind potential\n");
    assert_eq!(count("plot_periods"), 0);
    // a curve with fewer than 32 points in a nutation period (75.96 ms) would show an alias of the motion
    let longest = svg("@toy_top --span=0..75.95", "plot_periods/a.svg");
    assert!(lines(&longest, "#1f4e8c").iter().map(Vec::len).max() >= Some(63_000));
}

/// The labels of the axes have few digits, because they count from the first time and whole turns.
#[test]
fn an_axis_counts_from_its_beginning() {
    folder("plot_far");
    for (kind, times, titles) in [
        ("tilt", "1000000..1000000.2", "t - 1000000 s"),
        (
            "precession",
            "-1000000.5..-1000000",
            "t + 1000000.5 s ... azimuth of the axis + 822946 turns, degrees",
        ),
        ("tilt", "0..0.2", "t, s"),
    ] {
        let svg = svg(&format!("@toy_top --kind {kind} --span={times}"), "plot_far/a.svg");
        let texts: Vec<_> =
            svg.split("</text>").filter_map(|part| part.rsplit_once('>')).map(|(_, text)| text).collect();
        assert!(titles.split(" ... ").all(|title| texts.contains(&title)), "{titles}: {texts:?}");
        let ticks: Vec<_> = texts.iter().filter(|text| text.parse::<f64>().is_ok()).collect();
        assert!(ticks.len() > 5 && ticks.iter().all(|tick| tick.len() < 7), "{ticks:?}");
    }
}

/// The arrow is on the curve and points in the direction of the tip's motion.
#[test]
fn the_arrow_points_along_the_curve() {
    folder("plot_arrow");
    for name in ["@toy_top", "@figure_3_loops", "@lagrange"] {
        let picture = svg(name, "plot_arrow/a.svg");
        let curve = lines(&picture, "#1f4e8c").remove(0);
        let [arrow] = &lines(&picture, "#c0392b")[..] else { panic!("{name}: one arrow") };
        let [left, tip, right] = arrow[..] else { panic!("{name}: two arms") };
        let from_tip = |[x, y]: [f64; 2]| [x - tip[0], y - tip[1]];
        let length = |[x, y]: [f64; 2]| x.hypot(y);
        let at = curve.iter().position(|point| length(from_tip(*point)) < 0.05).expect("on the curve");
        let behind = from_tip([0.5 * (left[0] + right[0]), 0.5 * (left[1] + right[1])]);
        let came = from_tip(curve[at - 1]);
        let cosine = (behind[0] * came[0] + behind[1] * came[1]) / (length(behind) * length(came));
        assert!(cosine > 0.99, "{name}: {cosine}");
    }
}

#[test]
fn the_readmes_picture_is_todays() {
    folder("plot_readme");
    let kept = read(&repository("host/docs/tip.svg"));
    let drawn = svg("@figure_3_loops", "plot_readme/tip.svg");
    assert_eq!(drawn, kept, "toytop plot host/scenarios/figure_3_loops.toml -o host/docs/tip.svg");
}
