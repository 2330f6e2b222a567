//! Curves of the tip in the paper's figures: three in figure 2, six in figure 3.

use crate::Failure;
use crate::input::builtin;
use crate::input::scenario::Scenario;
use crate::output::names;
use crate::pictures::plot::{Curve, extent, lines, square};
use kuva::render::figure::Figure;
use kuva::render::render::Scene;

/// Size of a panel with its title, pixels.
const PANEL: [f64; 2] = [340.0, 372.0];
const COLUMNS: usize = 3;
const TITLES: [&str; 2] = [
    "Springborn, figure 2: l + n > 0, l - n > 0, s = 1, e₁ = 0.7, e₂ = 0.9, e₄² = 2",
    "Springborn, figure 3: l + n > 0 > l - n, s = 1, e₁ = 0.7, e₂ = 0.9, e₄² = 2",
];

pub(super) fn both() -> Result<[Scene; 2], Failure> {
    let figures = builtin::figures().map_err(|error| Failure::Input(format!("built-in motions: {error}")))?;
    let [second, third] = [0, 1].map(|i| figure(TITLES[i], &figures[i]));
    Ok([second?, third?])
}

fn figure(title: &str, scenarios: &[Scenario]) -> Result<Scene, Failure> {
    let (mut plots, mut layouts) = (Vec::new(), Vec::new());
    for Scenario { motion, .. } in scenarios {
        let (curve, scale) = (Curve::of(motion)?, motion.top().tip_scale());
        let panel = lines(&curve, scale);
        let class = names::tip_class(motion.tip_class());
        let title = format!("e₃ = {}: {class}", motion.branch_points().e3);
        layouts.push(
            square(&panel, extent(&curve, scale))
                .with_title(title)
                .with_title_size(15)
                .with_tick_size(11)
                .with_x_tick_step(0.5)
                .with_y_tick_step(0.5),
        );
        plots.push(panel);
    }
    let rows = scenarios.len().div_ceil(COLUMNS);
    let figure = Figure::new(rows, COLUMNS).with_title(title).with_title_size(18);
    Ok(figure.with_cell_size(PANEL[0], PANEL[1]).with_plots(plots).with_layouts(layouts).render())
}
