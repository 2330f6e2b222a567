//! Pictures of `toytop figures`: figures 2 and 3 of the paper, u against time, and errors against time.

mod chart;
mod curves;
mod ends;
mod errors;
mod heights;

use crate::Failure;
use crate::output::progress::Progress;
use crate::pictures::plot::{Form, encode};
use kuva::render::render::Scene;

pub(crate) use chart::COLORS;
pub use chart::{Chart, Curve, power_of_ten};
pub use errors::measured as measured_errors;

/// Picture with its file name and title.
#[derive(Debug)]
pub struct Picture {
    /// Name of the file without its extension.
    pub name: &'static str,
    /// Title on a page.
    pub title: &'static str,
    scene: Scene,
}

impl Picture {
    /// Picture of a scene.
    #[must_use]
    pub fn new(name: &'static str, title: &'static str, scene: Scene) -> Self {
        Self { name, title, scene }
    }

    /// Picture as SVG or PNG.
    ///
    /// # Errors
    /// [`Failure::Output`]: the picture cannot be encoded.
    pub fn encoded(&self, form: Form) -> Result<Vec<u8>, Failure> {
        encode(&self.scene, form)
    }
}

/// All pictures.
///
/// # Errors
/// None: the motions are valid.
pub fn all() -> Result<Vec<Picture>, Failure> {
    let mut progress = Progress::new(4 + errors::METHODS.len() as u64, "steps");
    let [figure_2, figure_3] = curves::both()?;
    progress.add(2);
    let heights = heights::picture()?;
    progress.add(1);
    let errors = errors::picture(&mut progress)?;
    Ok(vec![
        Picture::new("figure_2", "The paper's figure 2", figure_2),
        Picture::new("figure_3", "The paper's figure 3", figure_3),
        Picture::new("height_against_time", "Nutation", heights),
        Picture::new("error_against_time", "Error against time", errors),
    ])
}
