//! Addresses of the page: an error is named, and the motion stays as it was.

use super::probe;
use crate::command::{list, sample};
use crate::pictures::view::{folder, view};

/// Top and launch of the addresses; each address has one error.
const TOP: &str = "mass=0.05&com_height=0.03&transverse_inertia=3e-5&axial_inertia=2e-5";

/// Addresses, each with the message of the page.
fn addresses() -> Vec<(String, &'static str)> {
    let of_top = |rest: &str| format!("{TOP}&{rest}");
    vec![
        (
            "mass=0.05&kind=release&tilt_deg=20&spin=100".to_owned(),
            "transverse_inertia, axial_inertia, com_height: must be given",
        ),
        (
            of_top("kind=release&spin=100").replace("com_height=0.03&", ""),
            "com_height, tilt_deg: must be given",
        ),
        (
            of_top("support=fixed&kind=release&spin=1")
                .replace("mass=0.05&com_height=0.03&", "mass_moment=1e-3&"),
            "tilt_deg: must be given",
        ),
        (of_top("kind=state&alpha=1&beta=0,0&omega=0,0,1"), "alpha: must be given"),
        (of_top("kind=release&tilt_deg=400&spin=100"), "tilt: must be between 0 and 180 degrees"),
        (of_top("kind=release&tilt_deg=20&spin=x"), "spin: must be a number"),
        (of_top("kind=release&tilt_deg=20&spin=100&foo=1"), "foo: unknown key"),
        ("t=3&constructor=1".to_owned(), "constructor: unknown key"),
        (of_top("kind=release&tilt_deg=20&spin=100&e1=0.5"), "e1: not for kind=release"),
        (of_top("kind=roll&e1=0.5"), "kind: must be one of release, state, branch_points"),
        (of_top("spin=100"), "kind: must be given"),
        (of_top("support=held&kind=release"), "support: must be one of sliding, fixed, free"),
        ("t=3".to_owned(), ""),
        ("&&".to_owned(), ""),
        (of_top("kind=release&tilt_deg=20&spin=100"), ""),
    ]
}

#[test]
#[ignore = "a browser: cargo xtask test --only browser"]
fn an_address_with_an_error_is_answered() {
    let page = folder("view_addresses").join("top.html");
    view(&[&sample("toy_top")], &page);
    let addresses = addresses();
    let fragments: Vec<_> = addresses.iter().map(|(fragment, _)| format!("#{fragment}")).collect();
    let found = probe(&page, &format!("visit({fragments:?})"), 1200, "");
    let found = list(&found);
    assert_eq!(found.len(), addresses.len());
    for (i, ((fragment, message), found)) in addresses.iter().zip(found).enumerate() {
        // the last address is a motion
        let spin = if i + 1 == addresses.len() { 100.0 } else { 150.0 };
        assert_eq!((found[0].as_str(), found[1].as_f64()), (Some(*message), Some(spin)), "{fragment}");
    }
}
