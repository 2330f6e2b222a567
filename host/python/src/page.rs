//! Pictures for a notebook: the tip's curve, and the page with the top in motion.

use crate::error::failed;
use crate::motion::PyMotion;
use pyo3::prelude::*;
use std::fs;
use std::path::PathBuf;
use toytop_host::input::scenario::ScenarioFile;
use toytop_host::pictures::curve::{Circle, Curve};
use toytop_host::pictures::view;

/// Page that shows a top in motion. A notebook draws it where it ends a cell.
#[pyclass(module = "toytop", frozen)]
pub(crate) struct Page {
    html: String,
}

#[pymethods]
impl Page {
    /// Text of the page, HTML that needs no other file and no network.
    #[getter]
    fn html(&self) -> &str {
        &self.html
    }

    /// Writes the page to a file for a browser.
    ///
    /// Raises:
    ///     OSError: the file cannot be written.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        Ok(fs::write(path, &self.html)?)
    }

    fn _repr_html_(&self) -> String {
        let page = self.html.replace('&', "&amp;").replace('"', "&quot;");
        format!("<iframe srcdoc=\"{page}\" width=\"100%\" height=\"720\" style=\"border:0\"></iframe>")
    }

    fn __repr__(&self) -> String {
        format!("<Page of {} KB>", self.html.len() / 1000)
    }
}

#[pymethods]
impl PyMotion {
    /// Page with the top in motion, for a notebook or a browser: it computes in the page itself and needs no network.
    fn view(&self) -> PyResult<Page> {
        let file = ScenarioFile::parse("A spinning top", &self.0.text()).map_err(failed)?;
        Ok(Page { html: view::page(&file).map_err(failed)? })
    }

    /// Picture of the curve that the tip draws, for a notebook.
    fn _repr_html_(&self, py: Python<'_>) -> PyResult<String> {
        Ok(tip_curve(&py.detach(|| Curve::of(&self.0.motion)).map_err(failed)?))
    }
}

/// Width and height of the picture of the tip's curve, pixels.
const SIDE: f64 = 320.0;

/// Tip's curve as SVG, between its circles and from its start, with the second fixed axis upwards.
fn tip_curve(Curve { points, circles, .. }: &Curve) -> String {
    let radii = circles.iter().map(|Circle { radius, .. }| *radius);
    let largest = radii.clone().chain(points.iter().map(|[x, y]| x.hypot(*y))).fold(0.0, f64::max);
    let scale = if largest > 0.0 { 0.45 * SIDE / largest } else { 1.0 };
    let place = |[x, y]: [f64; 2]| [0.5 * SIDE + scale * x, 0.5 * SIDE - scale * y];
    let shapes: String = radii
        .map(|radius| {
            let (centre, radius) = (0.5 * SIDE, scale * radius);
            format!(
                "<circle cx=\"{centre}\" cy=\"{centre}\" r=\"{radius:.2}\" fill=\"none\" stroke=\"#8a8a8a\"/>"
            )
        })
        .collect();
    let path: Vec<_> = points
        .iter()
        .map(|point| {
            let [x, y] = place(*point);
            format!("{x:.2},{y:.2}")
        })
        .collect();
    let [x, y] = place(points.first().copied().unwrap_or_default());
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{SIDE}\" height=\"{SIDE}\" viewBox=\"0 0 {SIDE} {SIDE}\">\
         <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>{shapes}<polyline points=\"{}\" fill=\"none\" stroke=\"#1f4e8c\" \
         stroke-width=\"1.5\"/><circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"3.5\" fill=\"#c0392b\"/></svg>",
        path.join(" ")
    )
}
