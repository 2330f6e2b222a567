//! nalgebra's rotations, in both directions (feature `nalgebra`).
//!
//! By the components of [`Phi::quaternion`], so `UnitQuaternion` and [`Phi`] are the same element of SU(2), *sign included*: Φ
//! and -Φ give q and -q. Both turn body coordinates into fixed ones. A `Rotation3` has no sign; coming back from it, Φ is
//! one of the two, that with the quaternion nalgebra chooses.

use crate::real::Ring;
use crate::su2::Phi;
use nalgebra::{Quaternion, RealField, Rotation3, UnitQuaternion};

/// Not renormalised: Φ must be of unit norm, as every one of this crate is.
impl<R: Ring + RealField> From<Phi<R>> for UnitQuaternion<R> {
    fn from(phi: Phi<R>) -> Self {
        let [w, x, y, z] = phi.quaternion();
        Self::new_unchecked(Quaternion::new(w, x, y, z))
    }
}

/// Exact: the components are moved, not computed.
impl<R: Ring + RealField> From<UnitQuaternion<R>> for Phi<R> {
    fn from(q: UnitQuaternion<R>) -> Self {
        Self::from_quaternion([q.w, q.i, q.j, q.k])
    }
}

/// The adjoint action Ad_Φ as a matrix; its third column is the axis r.
impl<R: Ring + RealField> From<Phi<R>> for Rotation3<R> {
    fn from(phi: Phi<R>) -> Self {
        UnitQuaternion::from(phi).to_rotation_matrix()
    }
}

/// One of the two Φ of a rotation.
impl<R: Ring + RealField> From<Rotation3<R>> for Phi<R> {
    fn from(rotation: Rotation3<R>) -> Self {
        UnitQuaternion::from_rotation_matrix(&rotation).into()
    }
}
