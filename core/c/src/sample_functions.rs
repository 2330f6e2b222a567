//! Quantities of a sample.

use crate::input::toytop_state;
use crate::sample::{re_im, toytop_ephemeris_sample, write_quantity};
use crate::status::toytop_status;
use toytop::fixed::types::I2F30;
use toytop::{Orientation, State};

/// Function that writes one quantity of a sample.
macro_rules! quantity {
    ($(#[$doc:meta])* $function:ident<$scalar:ty>($quantity:ident: $number:ty) = |$sample:ident| $value:expr) => {
$(#[$doc])*
#[unsafe(no_mangle)]
pub unsafe extern "C" fn $function(
    sample: *const toytop_ephemeris_sample,
    $quantity: *mut $number,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { write_quantity::<$scalar, _>(sample, $quantity.cast(), |$sample| Ok($value)).into() }
}
    };
}

macro_rules! functions {
    ($name:ident, $scalar:ty, $output:ty, $wide:ty) => {
        pastey::paste! {

        quantity! {
        /// Cayley-Klein parameters: four numbers Re alpha, Im alpha, Re beta, Im beta.
        [<toytop_ $name _cayley_klein>]<$scalar>(parameters: $output) = |sample| {
            let Orientation { alpha, beta } = sample.orientation();
            [re_im(alpha), re_im(beta)]
        }
        }

        quantity! {
        /// Unit quaternion, four numbers w, x, y, z, from body to fixed coordinates.
        [<toytop_ $name _quaternion>]<$scalar>(quaternion: $output) = |sample| sample.quaternion()
        }

        quantity! {
        /// Unit vector of three components from the tip to the centre of mass, in the fixed frame. The third is u, the cosine of the
        /// tilt, which a rounding can take past 1.
        [<toytop_ $name _axis>]<$scalar>(axis: $output) = |sample| sample.axis()
        }

        quantity! {
        /// Angular velocity of three components in the fixed frame, rad/s.
        [<toytop_ $name _omega>]<$scalar>(omega: $wide) = |sample| sample.omega()
        }

        quantity! {
        /// Angular velocity of three components in the body frame, rad/s, as a gyroscope measures it.
        [<toytop_ $name _omega_body>]<$scalar>(omega: $wide) = |sample| sample.omega_body()
        }

        quantity! {
        /// Position x, y of the tip, m from the point of the plane below the centre of mass; for a fixed tip the horizontal part of the
        /// axis with the opposite sign.
        [<toytop_ $name _tip>]<$scalar>(tip: $wide) = |sample| re_im(sample.tip())
        }

        quantity! {
        /// Velocity x, y of the tip, m/s; 1/s for a fixed tip.
        [<toytop_ $name _tip_velocity>]<$scalar>(velocity: $wide) = |sample| re_im(sample.tip_velocity())
        }

        quantity! {
        /// Angle of the tip, rad, continued in time from (-pi, pi] at the launch. `TOYTOP_NONE` if the axis is always vertical.
        [<toytop_ $name _tip_angle>]<$scalar>(angle: f64) =
            |sample| sample.tip_angle().ok_or(toytop_status::TOYTOP_NONE)?.to_radians()
        }

        quantity! {
        /// State of a sample, from which another motion can be launched.
        [<toytop_ $name _state>]<$scalar>(state: toytop_state) =
            |sample| toytop_state::from_state(&State::from_attitude(&sample.attitude_state())?)
        }

            }
    };
}

functions!(f32, f32, f32, f32);
functions!(f64, f64, f64, f64);
functions!(q31, I2F30, i32, f32);
