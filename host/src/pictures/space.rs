//! Pictures of space: the camera, the axis on its sphere, and the top in motion.

pub(crate) mod animation;
mod camera;
pub(crate) mod sphere;
