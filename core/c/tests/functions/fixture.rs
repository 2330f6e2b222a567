//! Top, release, motion and settings of the tests, and the values that functions write.

use core::ffi::{CStr, c_void};
use core::mem::MaybeUninit;
use core::ptr::null_mut;
use toytop::{Motion, Release, SizedTable, State, Tick, Top, TopParameters};
use toytop_c::toytop_status::*;
use toytop_c::*;

pub(crate) const TOP: toytop_top = toytop_top {
    support: TOYTOP_SLIDING,
    transverse_inertia: 3.0e-5,
    axial_inertia: 2.0e-5,
    com_height: 0.03,
    mass: 0.05,
    mass_moment: 0.0,
    gravity: 9.81,
    rotor_momentum: 0.0,
};
pub(crate) const RELEASE: toytop_release =
    toytop_release { tilt: 0.35, azimuth: 0.1, roll: 0.0, spin: 150.0, precession: 2.0, nutation: 0.0 };

pub(crate) const SETTINGS: toytop_settings = toytop_settings {
    tick: toytop_tick { ticks: 10, seconds: 1 },
    epoch: 0,
    truncation: 0.0,
    workspace: null_mut(),
    pause: None,
    context: null_mut(),
};

/// Bytes of a table in `f32` with this many segments.
pub(crate) fn f32_size(segments: usize) -> usize {
    TOYTOP_TABLE_F32_SIZE - 80 * 25 + 80 * segments
}

/// Same release in the crate.
pub(crate) fn release() -> Release {
    Release { tilt: 0.35, azimuth: 0.1, spin: 150.0, precession: 2.0, ..Release::default() }
}

/// State of this release.
pub(crate) fn state() -> State {
    State::from_release(&release()).expect("a release")
}

/// Value that a function writes.
pub(crate) fn output_of<T>(call: impl FnOnce(*mut T) -> toytop_status) -> T {
    let mut value = MaybeUninit::uninit();
    assert_eq!(call(value.as_mut_ptr()), TOYTOP_OK);
    unsafe { value.assume_init() }
}

/// Numbers that a function writes.
pub(crate) fn numbers<T, const N: usize>(call: impl FnOnce(*mut T) -> toytop_status) -> [T; N] {
    output_of(|to: *mut [T; N]| call(to.cast()))
}

/// Motion of the same top and state by the crate.
pub(crate) fn motion() -> Motion {
    Motion::launch(&Top::sliding(&TopParameters::TOY).expect("a top"), &state()).expect("a motion")
}

/// Table of a motion by the crate.
pub(crate) fn table_of(motion: &Motion) -> SizedTable<f64, 48> {
    SizedTable::new(motion, Tick::hertz(10).expect("a tick")).expect("it fits")
}

/// Pause that counts its calls.
pub(crate) unsafe extern "C" fn count(calls: *mut c_void) {
    unsafe { *calls.cast::<u32>() += 1 };
}

/// State of a release.
pub(crate) fn released(release: &toytop_release) -> toytop_state {
    output_of(|to| unsafe { toytop_state_from_release(release, to, null_mut()) })
}

/// Motion of a top with the release of the tests.
pub(crate) fn launched(top: &toytop_top) -> toytop_motion {
    output_of(|to| unsafe { toytop_launch(top, &released(&RELEASE), to, null_mut()) })
}

/// Constants of a motion.
pub(crate) fn constants_of(motion: &toytop_motion) -> toytop_constants {
    output_of(|to| unsafe { toytop_motion_constants(motion, to) })
}

/// Table in `f64` of a motion that is launched at tick 0, at 10 ticks a second: more than one turning point a tick.
pub(crate) fn f64_table(motion: &toytop_motion) -> Box<toytop_table_f64> {
    let mut table = Box::<toytop_table_f64>::new_uninit();
    unsafe {
        let place = table.as_mut_ptr();
        assert_eq!(toytop_f64_set_up(place, TOYTOP_TABLE_F64_SIZE, motion, &SETTINGS, null_mut()), TOYTOP_OK);
        table.assume_init()
    }
}

/// Text of an error.
pub(crate) fn text(error: &toytop_error) -> &str {
    unsafe { CStr::from_ptr(error.text.as_ptr()) }.to_str().expect("ASCII")
}
