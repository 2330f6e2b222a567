//! Conventions of a source: the body axis that is the axis of symmetry, and the quantity that is called position.

use crate::motion::propagate::Sample;
use serde::Deserialize;
use toytop::Orientation;

/// Body axes and length of a source. The third fixed axis points up in all of them.
#[derive(Clone, Copy, Deserialize)]
pub struct Conventions {
    /// Number of the body axis that points from the tip to the centre of mass: 2 or 3.
    pub symmetry_axis: usize,
    /// Distance from the tip to the centre of mass, in which positions are computed.
    pub length: f64,
}

/// Motion at one time, in a source's conventions.
pub struct Values {
    /// Position of the centre of mass relative to the tip.
    pub position: [f64; 3],
    /// Quaternion w, x, y, z from body to fixed axes.
    pub quaternion: [f64; 4],
    /// Angular velocity along the body axes.
    pub omega_body: [f64; 3],
}

impl Conventions {
    /// Rotation P that takes the source's body coordinates to those of the core, whose third axis is the axis of symmetry.
    pub fn to_core(self) -> Orientation<f64> {
        match self.symmetry_axis {
            // a quarter turn about the first axis takes the second axis to the third
            2 => Orientation::from_quaternion([1.0, 1.0, 0.0, 0.0]).normalised(),
            _ => Orientation::IDENTITY,
        }
    }

    /// Values of a sample of the core in the source's conventions.
    pub fn values(&self, sample: &Sample) -> Values {
        let core = sample.orientation();
        let orientation = core.compose(&self.to_core());
        Values {
            position: core.axis().map(|x| self.length * x),
            quaternion: orientation.quaternion(),
            omega_body: orientation.inverse().adjoint(sample.omega),
        }
    }
}
