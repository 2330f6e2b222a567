//! The pictures of `toytop figures`: the paper's two, and two that it has no room for.

mod chart;
mod curves;
mod errors;
mod heights;

use crate::Failure;
use crate::plot::{Form, encode};
use crate::progress::Progress;
use kuva::render::render::Scene;

/// A picture: its name, without an ending, and itself.
#[derive(Debug)]
pub struct Picture {
    /// Of the file.
    pub name: &'static str,
    scene: Scene,
}

impl Picture {
    /// As SVG or PNG.
    ///
    /// # Errors
    /// [`Failure::Output`]: it cannot be encoded.
    pub fn encoded(&self, form: Form) -> Result<Vec<u8>, Failure> {
        encode(&self.scene, form)
    }
}

/// All of them.
///
/// # Errors
/// None: the motions are valid.
pub fn all() -> Result<Vec<Picture>, Failure> {
    let mut progress = Progress::new(4 + errors::ENTRANTS.len() as u64, "steps");
    let [figure_2, figure_3] = curves::both()?;
    progress.add(2);
    let heights = heights::picture()?;
    progress.add(1);
    let errors = errors::picture(&mut progress)?;
    Ok(vec![
        Picture { name: "figure_2", scene: figure_2 },
        Picture { name: "figure_3", scene: figure_3 },
        Picture { name: "height_against_time", scene: heights },
        Picture { name: "error_against_time", scene: errors },
    ])
}
