//! Pictures of space: the camera, the axis on its sphere, and the top in motion.

pub mod animation;
mod camera;
pub mod sphere;
