//! Tests of tops, impulses and launches.

use crate::fixture::{
    self, RELEASE, TOP, constants_of, count, f64_table, launched, motion, numbers, output_of, released,
    state, table_of, text,
};
use core::ffi::CStr;
use core::mem::MaybeUninit;
use core::ptr::null_mut;
use toytop::{Level, Motion, PointImpulse, Release, State, Top, TopParameters};
use toytop_c::toytop_status::*;
use toytop_c::*;

#[test]
fn each_refused_top_has_a_text() {
    for (top, line) in [
        (toytop_top { support: 9, ..TOP }, "support: must be TOYTOP_SLIDING, TOYTOP_FIXED or TOYTOP_FREE"),
        (toytop_top { rotor_momentum: -1e9, ..TOP }, "rotor_momentum: must be at most 1e12"),
        (toytop_top { support: TOYTOP_FREE, gravity: f64::NAN, ..TOP }, "gravity: must be a finite number"),
    ] {
        let (state, mut why) = (released(&RELEASE), MaybeUninit::uninit());
        let why = unsafe {
            assert_ne!(
                toytop_launch(&top, &state, MaybeUninit::uninit().as_mut_ptr(), why.as_mut_ptr()),
                TOYTOP_OK
            );
            why.assume_init()
        };
        assert!(text(&why).starts_with(line), "{}", text(&why));
    }
    let text = |status| unsafe { CStr::from_ptr(toytop_status_text(status)) };
    assert_eq!([8, 9].map(text), [c"an aperiodic motion has no table", c"not a status of toytop"]);
}

#[test]
fn an_impulse_starts_another_motion() {
    let (state, impulse, point) = (state(), [0.0, 2e-3, 0.0], [0.025, 0.0, 0.03]);
    let stroke = PointImpulse { impulse, point };
    let struck = state.with_impulse(motion().top(), &stroke).expect("a stroke");
    unsafe {
        let from = &released(&RELEASE);
        let after =
            output_of(|to| toytop_impulse(&TOP, from, impulse.as_ptr(), point.as_ptr(), to, null_mut()));
        assert_eq!(after.omega, struck.omega());
        let reaction = output_of(|to: *mut [f64; 3]| {
            toytop_reaction_impulse(&TOP, from, impulse.as_ptr(), point.as_ptr(), to.cast(), null_mut())
        });
        assert_eq!(reaction, state.reaction_impulse(motion().top(), &stroke).expect("an answer"));
    }
}

#[test]
fn free_bodies_and_rotors_are_those_of_the_crate() {
    let parameters = TopParameters { rotor_momentum: -1.5e-3, ..TopParameters::TOY };
    for (support, top) in [(TOYTOP_FREE, Top::free(&parameters)), (TOYTOP_SLIDING, Top::sliding(&parameters))]
    {
        let expected = table_of(&Motion::launch(&top.expect("a top"), &state()).expect("a motion"));
        let motion = launched(&toytop_top { support, rotor_momentum: -1.5e-3, ..TOP });
        let constants = constants_of(&motion);
        assert_eq!(constants.min_normal_force.is_nan(), support == TOYTOP_FREE);
        assert_eq!(constants.e3.is_infinite(), support == TOYTOP_FREE);
        let table = f64_table(&motion);
        let now = output_of(|to| unsafe { toytop_f64_at_tick(&*table, 777, to) });
        let q: [f64; 4] = numbers(|to| unsafe { toytop_f64_quaternion(&now, to) });
        assert_eq!(q, expected.at_tick(777).quaternion());
    }
}

/// A top that is thrown upwards leaves the plane at the tilt that the constants have.
#[test]
fn a_lift_off_is_that_of_the_crate() {
    let release = toytop_release { nutation: 60.0, ..RELEASE };
    let expected = Release { nutation: 60.0, ..fixture::release() };
    let motion = Motion::launch(motion().top(), &State::from_release(&expected).expect("a release"))
        .expect("a motion");
    let level = Level::lift_off(&motion).expect("a lift-off");
    unsafe {
        let motion = output_of(|to| toytop_launch(&TOP, &released(&release), to, null_mut()));
        let constants = constants_of(&motion);
        assert_eq!(constants.lift_off_tilt, level.tilt());
        let table = &*f64_table(&motion);
        let mut events = output_of(|to| toytop_f64_crossings(table, constants.lift_off_tilt, 0, to));
        let event = output_of(|to| toytop_f64_next_event(&mut events, to));
        let now = output_of(|to| toytop_f64_at(table, (event.tick as f64 + event.fraction) / 10.0, to));
        let axis: [f64; 3] = numbers(|to| toytop_f64_axis(&now, to));
        assert!((axis[2] - level.u()).abs() < 1e-14, "{axis:?}");
        let free = launched(&toytop_top { support: TOYTOP_FREE, ..TOP });
        assert!(constants_of(&free).lift_off_tilt.is_nan());
    }
}

#[test]
fn pauses_do_not_change_a_motion() {
    let mut calls = 0_u32;
    let context = (&raw mut calls).cast();
    let state = released(&RELEASE);
    let with_pauses = output_of(|to| unsafe {
        toytop_launch_with_pauses(&TOP, &state, Some(count), context, to, null_mut())
    });
    assert!(calls > 5, "{calls} calls");
    let [paused, other] = [with_pauses, launched(&TOP)].map(|motion| format!("{:?}", constants_of(&motion)));
    assert_eq!(paused, other);
}
