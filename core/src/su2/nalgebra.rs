//! Conversions to and from the rotations of nalgebra (feature `nalgebra`).
//!
//! A `UnitQuaternion` keeps the sign of an [`Orientation`]. A `Rotation3` has none; nalgebra chooses it.

use super::Orientation;
use crate::scalar::Ring;
use nalgebra::{Quaternion, RealField, Rotation3, UnitQuaternion};

/// Conversion without normalisation.
impl<R: Ring + RealField> From<Orientation<R>> for UnitQuaternion<R> {
    fn from(orientation: Orientation<R>) -> Self {
        let [w, x, y, z] = orientation.quaternion();
        Self::new_unchecked(Quaternion::new(w, x, y, z))
    }
}

/// Exact conversion.
impl<R: Ring + RealField> From<UnitQuaternion<R>> for Orientation<R> {
    fn from(q: UnitQuaternion<R>) -> Self {
        Self::from_quaternion([q.w, q.i, q.j, q.k])
    }
}

/// Adjoint action Ad_Φ as a matrix; its third column is the axis r.
impl<R: Ring + RealField> From<Orientation<R>> for Rotation3<R> {
    fn from(orientation: Orientation<R>) -> Self {
        UnitQuaternion::from(orientation).to_rotation_matrix()
    }
}

/// One of the two orientations Φ of a rotation.
impl<R: Ring + RealField> From<Rotation3<R>> for Orientation<R> {
    fn from(rotation: Rotation3<R>) -> Self {
        UnitQuaternion::from_rotation_matrix(&rotation).into()
    }
}
