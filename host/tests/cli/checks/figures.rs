//! `toytop figures`: the numbers of the paper's captions are in the pictures.

use crate::command::{count, folder, read, toytop};

#[test]
fn captions_have_the_numbers_of_the_paper() {
    folder("figures");
    assert_eq!(toytop("figures -o figures/new").ok().lines().count(), 9);
    assert_eq!(count("figures/new"), 9);
    for (name, class, sign) in [
        ("figure_2_e3_1", "smooth", "="),
        ("figure_2_e3_2", "smooth", "&gt;"),
        ("figure_2_e3_100", "smooth", "&gt;"),
        ("figure_3_e3_1", "smooth", "="),
        ("figure_3_e3_1.1", "smooth", "&lt;"),
        ("figure_3_e3_1.3", "smooth", "&lt;"),
        ("figure_3_e3_1.85", "cusp", "&lt;"),
        ("figure_3_e3_2.5", "loops", "&lt;"),
        ("figure_3_e3_3", "loops", "&lt;"),
    ] {
        let picture = read(&format!("figures/new/{name}.svg"));
        let (_, e3) = name.rsplit_once('_').expect("e3");
        for part in
            [format!("{class}, "), format!("e₁ = 0.7, e₂ = 0.9, e₃ = {e3}<"), format!("l - n {sign} 0")]
        {
            assert!(picture.contains(&part), "{name}: {part}");
        }
        // the curve and its legend
        assert_eq!(picture.matches("stroke=\"#1f4e8c\"").count(), 2, "{name}");
    }
    toytop("figures -o figures/new/figure_3_e3_3.svg/below").refused(2, "figure_3_e3_3.svg");
    toytop("figures -o -").refused(2, "must not be -, because stdout has the report");
}
