//! Tests of `toytop figures`: all pictures, and the numbers of the paper's captions in them.

use super::{run, stderr, stdout};
use std::path::PathBuf;

#[test]
fn the_papers_figures_and_two_more() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("figures/new");
    // the folder may exist from an earlier run
    let _ = std::fs::remove_dir_all(&folder);
    let output = run(&["figures", "-o", folder.to_str().expect("UTF-8")]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let names: Vec<_> = stdout(&output).lines().map(PathBuf::from).collect();
    assert_eq!(names.len(), 8);
    assert_eq!(std::fs::read_dir(&folder).expect("the folder").count(), 8, "nothing else is left there");
    for name in names.iter().filter(|name| name.extension().is_some_and(|ending| ending == "png")) {
        assert_eq!(&std::fs::read(name).expect("a picture")[..8], b"\x89PNG\r\n\x1a\n");
    }
    let svg = |name: &str| std::fs::read_to_string(folder.join(name)).expect("a picture");
    let panels = ["e₃ = 1: smooth", "e₃ = 2: smooth", "e₃ = 100: smooth"];
    let more =
        ["e₃ = 1.1: smooth", "e₃ = 1.3: smooth", "e₃ = 1.85: cusp", "e₃ = 2.5: loops", "e₃ = 3: loops"];
    for (figure, panels) in
        [("figure_2.svg", panels.to_vec()), ("figure_3.svg", [&panels[..1], &more].concat())]
    {
        let picture = svg(figure);
        let places: Vec<_> = panels.iter().map(|panel| picture.find(&format!(">{panel}<"))).collect();
        assert!(places.iter().all(Option::is_some) && places.is_sorted(), "{figure}: {places:?}");
        assert_eq!(
            picture.matches("stroke=\"#1f4e8c\"").count(),
            panels.len(),
            "{figure}: one curve a panel"
        );
        assert!(picture.contains("e₄² = 2") && picture.contains("e₁ = 0.7, e₂ = 0.9"));
    }
    let errors = svg("error_against_time.svg");
    for name in ["ephemeris f64, 48x11", "RK4, 1024 steps", "nalgebra, exponential", "full solver", "10⁻¹⁴"]
    {
        assert!(errors.contains(name), "{name}");
    }
    assert!(svg("height_against_time.svg").contains(">u = cos(tilt)<"));
    let file = names[0].join("below_a_file");
    let output = run(&["figures", "-o", file.to_str().expect("UTF-8")]);
    assert_eq!((output.status.code(), stderr(&output).matches('\n').count()), (Some(2), 1));
}
