//! Quantities of a sample.

use crate::input::toytop_state;
use crate::sample::{self, parts, toytop_ephemeris_sample};
use crate::status::toytop_status;
use crate::table::CScalar;
use toytop::fixed::types::I2F30;

/// Sample of a table in memory of the caller.
type Sampled<R> = toytop::Sample<'static, R>;

/// Function that writes one quantity of a sample.
macro_rules! quantity {
    ($(#[$doc:meta])* $function:ident($quantity:ident: $number:ty) $compute:expr) => {
$(#[$doc])*
#[unsafe(no_mangle)]
pub unsafe extern "C" fn $function(
    sample: *const toytop_ephemeris_sample,
    $quantity: *mut $number,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { sample::write_quantity(sample, $quantity.cast(), $compute).into() }
}
    };
}

macro_rules! functions {
    ($name:ident, $scalar:ty, $output:ty, $wide:ty) => { pastey::paste! {

quantity! {
/// Cayley-Klein parameters: four numbers Re alpha, Im alpha, Re beta, Im beta.
[<toytop_ $name _cayley_klein>](parameters: $output) sample::cayley_klein::<$scalar>
}

quantity! {
/// Unit quaternion, four numbers w, x, y, z, from body to fixed coordinates.
[<toytop_ $name _quaternion>](quaternion: $output)
    |sample: Sampled<$scalar>| Ok(sample.quaternion().map(CScalar::to_c))
}

quantity! {
/// Unit vector of three components from the tip to the centre of mass, in the fixed frame. The third is u, the cosine of the
/// tilt, which a rounding can take past 1.
[<toytop_ $name _axis>](axis: $output) |sample: Sampled<$scalar>| Ok(sample.axis().map(CScalar::to_c))
}

quantity! {
/// Angular velocity of three components in the fixed frame, rad/s.
[<toytop_ $name _omega>](omega: $wide) |sample: Sampled<$scalar>| Ok(sample.omega())
}

quantity! {
/// Angular velocity of three components in the body frame, rad/s, as a gyroscope measures it.
[<toytop_ $name _omega_body>](omega: $wide)
    |sample: Sampled<$scalar>| Ok(sample.omega_body())
}

quantity! {
/// Position x, y of the tip, m from the point of the plane below the centre of mass; for a fixed tip the horizontal part of the
/// axis with the opposite sign.
[<toytop_ $name _tip>](tip: $wide) |sample: Sampled<$scalar>| Ok(parts(sample.tip()))
}

quantity! {
/// Velocity x, y of the tip, m/s; 1/s for a fixed tip.
[<toytop_ $name _tip_velocity>](velocity: $wide) |sample: Sampled<$scalar>| Ok(parts(sample.tip_velocity()))
}

quantity! {
/// Angle of the tip, rad, continued in time from (-pi, pi] at the launch. `TOYTOP_NONE` if the axis is always vertical.
[<toytop_ $name _tip_angle>](angle: f64) sample::tip_angle::<$scalar>
}

quantity! {
/// State of a sample, from which another motion can be launched.
[<toytop_ $name _state>](state: toytop_state) sample::state::<$scalar>
}

    } };
}

functions!(f32, f32, f32, f32);
functions!(f64, f64, f64, f64);
functions!(q31, I2F30, i32, f32);
