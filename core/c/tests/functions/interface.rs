//! Tests of the functions as a program in C calls them: they give the bits of the crate, and a status for each error.

use crate::top::{RELEASE, TOP, f32_size, f64_table, launched, numbers, output_of, parameters, state, text};
use core::ffi::CStr;
use core::mem::{MaybeUninit, size_of};
use core::ptr::{null, null_mut};
use toytop::{Complex, Ephemeris, Events, Level, Motion, Phase, Release, State, Tick, Top};
use toytop_c::toytop_status::*;
use toytop_c::*;
use toytop_fit::Sensitivity;

fn motion() -> Motion {
    Motion::launch(&Top::sliding(&parameters()).expect("a top"), &state()).expect("a motion")
}

#[test]
fn every_quantity_has_the_bits_of_the_crate() {
    let expected = Ephemeris::<f64, 48>::new(&motion(), Tick::hertz(1000).expect("a tick")).expect("it fits");
    let table = &*f64_table(&launched(&TOP));
    unsafe {
        for n in [0, 1, -5000, 1 << 40, i64::MAX] {
            let sample = expected.at_tick(n);
            let now = &output_of(|to| toytop_f64_at_tick(table, n, to));
            assert_eq!(numbers(|to| toytop_f64_quaternion(now, to)), sample.quaternion());
            assert_eq!(numbers(|to| toytop_f64_axis(now, to)), sample.axis());
            assert_eq!(numbers(|to| toytop_f64_omega(now, to)), sample.omega());
            assert_eq!(numbers(|to| toytop_f64_omega_body(now, to)), sample.omega_body());
            let parts = |z: Complex<f64>| [z.re, z.im];
            assert_eq!(numbers(|to| toytop_f64_tip(now, to)), parts(sample.tip()));
            let velocity = numbers(|to| toytop_f64_tip_velocity(now, to));
            assert_eq!(velocity, parts(sample.tip_velocity()));
            let angle = sample.tip_angle().expect("an angle").to_radians();
            assert_eq!(output_of(|to| toytop_f64_tip_angle(now, to)), angle);
            let bounds: toytop_error_bounds = output_of(|to| toytop_f64_error_bounds(table, n, to));
            let [orientation, rate] = [expected.error_bound_at(n), expected.rate_error_bound_at(n)];
            assert_eq!([bounds.orientation, bounds.rate], [orientation, rate]);
        }
    }
}

#[test]
fn events_and_partial_derivatives_are_those_of_the_crate() {
    let expected = Ephemeris::<f64, 48>::new(&motion(), Tick::hertz(1000).expect("a tick")).expect("it fits");
    let launched = &launched(&TOP);
    let table = &*f64_table(launched);
    let same = |found: toytop_event, mut events: Events<'_, f64>| {
        let event = events.next().expect("an event");
        assert_eq!(
            (found.tick, found.fraction, found.upward),
            (event.tick, event.fraction, event.upward.into())
        );
    };
    unsafe {
        for from in [0, -5000, 1 << 40] {
            same(output_of(|to| toytop_f64_turning_point(table, from, to)), expected.turning_points(from));
            let level = Level::of_tilt(0.36).expect("a level");
            same(
                output_of(|to| toytop_f64_tilt_reached(table, 0.36, from, to)),
                expected.crossings(level, from),
            );
            let direction = Phase::from_radians(-2.0);
            let found = output_of(|to| toytop_f64_direction_reached(table, -2.0, from, to));
            same(found, expected.tip_angles(direction, from));
        }
        let mut event = MaybeUninit::uninit();
        let event = event.as_mut_ptr();
        assert_eq!(toytop_f64_tilt_reached(table, 3.0, 0, event), TOYTOP_NONE);
        assert_eq!(toytop_f64_tilt_reached(table, 4.0, 0, event), TOYTOP_OUT_OF_RANGE);
        assert_eq!(toytop_f64_direction_reached(table, f64::NAN, 0, event), TOYTOP_NOT_FINITE);
        let partials: toytop_partials = output_of(|to| toytop_motion_partials(launched, 0.3, to));
        let now = Sensitivity::new(&motion()).at(0.3).expect("derivatives");
        assert_eq!((partials.orientation, partials.omega), (now.d_orientation(), now.d_omega()));
        assert_eq!(partials.omega_body, now.d_omega_body());
        assert_eq!(partials.tip, now.d_tip().map(|tip| [tip.re, tip.im]));
        let mut partials = MaybeUninit::uninit();
        assert_eq!(toytop_motion_partials(launched, f64::NAN, partials.as_mut_ptr()), TOYTOP_NONE);
    }
}

#[test]
fn a_cursor_an_epoch_and_a_time_agree() {
    let mut memory = MaybeUninit::<toytop_ephemeris_q31>::uninit();
    let (table, size) = (memory.as_mut_ptr(), size_of::<toytop_ephemeris_q31>());
    let motion = launched(&TOP);
    let set_up = |epoch| unsafe {
        toytop_q31_set_up(table, size, &motion, toytop_hertz(1000), epoch, 0.0, null_mut())
    };
    let quaternion = |now: toytop_ephemeris_sample| -> [i32; 4] {
        unsafe { numbers(|to| toytop_q31_quaternion(&now, to)) }
    };
    unsafe {
        assert_eq!(set_up(0), TOYTOP_OK);
        let before = quaternion(output_of(|to| toytop_q31_at_tick(table, 7, to)));
        assert_eq!(set_up(100), TOYTOP_OK);
        let delayed = quaternion(output_of(|to| toytop_q31_at_tick(table, 107, to)));
        assert!(before.iter().zip(delayed).all(|(x, y)| x.abs_diff(y) < 8), "{before:?} {delayed:?}");
        let mut cursor = output_of(|to| toytop_q31_cursor(table, 107, to));
        assert_eq!(numbers(|to| toytop_q31_next_quaternion(table, &mut cursor, to)), delayed);
        assert_eq!(output_of(|to| toytop_ephemeris_cursor_tick(&cursor, to)), 107);
        let mut now = output_of(|to| toytop_q31_at(table, 0.107, to));
        assert_eq!(quaternion(now), delayed);
        assert_eq!(toytop_q31_at(table, f64::NAN, &mut now), TOYTOP_NOT_FINITE);
        for beyond in [9.3e15, -9.3e15] {
            assert_eq!(toytop_q31_at(table, beyond, &mut now), TOYTOP_OUT_OF_RANGE);
            assert_eq!(toytop_q31_at(table, 0.99 * beyond, &mut now), TOYTOP_OK);
        }

        // a call that is refused leaves the cursor where it is
        assert_eq!(toytop_q31_next(table, &mut cursor, null_mut()), TOYTOP_NULL_POINTER);
        assert_eq!(output_of(|to| toytop_ephemeris_cursor_tick(&cursor, to)), 107);
        assert_eq!(toytop_q31_next(table, &mut cursor, &mut now), TOYTOP_OK);
        assert_eq!(output_of(|to| toytop_ephemeris_cursor_tick(&cursor, to)), 108);

        // cursors and samples of an earlier table, of another one or of another scalar are refused
        // zeroed memory: both tables are the first in theirs
        let mut tables = [MaybeUninit::<toytop_ephemeris_f32>::zeroed(); 2];
        let [single, another] = tables.each_mut().map(MaybeUninit::as_mut_ptr);
        for place in [single, another] {
            let (size, tick) = (size_of::<toytop_ephemeris_f32>(), toytop_hertz(1000));
            assert_eq!(toytop_f32_set_up(place, size, &motion, tick, 100, 0.0, null_mut()), TOYTOP_OK);
        }
        let mut of_single = output_of(|to| toytop_f32_cursor(single, 100, to));
        let next = |table, cursor| toytop_f32_next_quaternion(table, cursor, [0.0; 4].as_mut_ptr());
        assert_eq!(next(single, &mut cursor), TOYTOP_NOT_SET_UP);
        assert_eq!(next(another, &mut of_single), TOYTOP_NOT_SET_UP);
        assert_eq!(next(single, &mut of_single), TOYTOP_OK);
        let stale = output_of(|to| toytop_q31_at_tick(table, 107, to));
        assert_eq!(set_up(100), TOYTOP_OK);
        let mut numbers = [0; 4];
        assert_eq!(toytop_q31_next(table, &mut cursor, &mut now), TOYTOP_NOT_SET_UP);
        assert_eq!(toytop_q31_next_quaternion(table, &mut cursor, numbers.as_mut_ptr()), TOYTOP_NOT_SET_UP);
        assert_eq!(toytop_q31_quaternion(&stale, numbers.as_mut_ptr()), TOYTOP_NOT_SET_UP);
        assert_eq!(numbers, [0; 4]);
        let never = MaybeUninit::zeroed();
        assert_eq!(toytop_q31_quaternion(never.as_ptr(), numbers.as_mut_ptr()), TOYTOP_NOT_SET_UP);
        assert_eq!(
            toytop_q31_quaternion(&output_of(|to| toytop_q31_at_tick(table, 0, to)), null_mut()),
            TOYTOP_NULL_POINTER
        );
        assert_eq!(
            toytop_f64_quaternion(&output_of(|to| toytop_q31_at_tick(table, 0, to)), [0.0; 4].as_mut_ptr()),
            TOYTOP_NOT_SET_UP
        );
        assert_eq!(toytop_f32_at_tick(table.cast(), 0, &mut now), TOYTOP_NOT_SET_UP);
    }
}

/// Set-ups with every error, in the order of the checks; the table is void after each that is not about its own memory.
#[test]
fn each_refused_set_up_has_a_status() {
    let motion = &launched(&TOP);
    let mut words = [0_u64; TOYTOP_EPHEMERIS_F32_SIZE / 8];
    let table: *mut toytop_ephemeris_f32 = words.as_mut_ptr().cast();
    let size = size_of::<toytop_ephemeris_f32>();
    let mut boxed = Box::<toytop_workspace>::new_uninit();
    let memory = boxed.as_mut_ptr();
    let empty: toytop_motion = unsafe { MaybeUninit::zeroed().assume_init() };
    let [tick, never] = [1000, 0].map(|rate| toytop_hertz(rate));
    let run = |table, size, memory, motion: *const _, tick, truncation| unsafe {
        let mut why = MaybeUninit::<toytop_error>::zeroed();
        let (none, error) = (null_mut(), why.as_mut_ptr());
        let status = toytop_f32_set_up_with_pauses(
            table, size, memory, motion, tick, 0, truncation, None, none, error,
        );
        (status, why.assume_init())
    };
    let good = || run(table, f32_size(16), memory, motion, tick, 1e-2).0;
    let read = || unsafe { toytop_f32_at_tick(table, 0, MaybeUninit::uninit().as_mut_ptr()) };
    assert_eq!(read(), TOYTOP_NOT_SET_UP);
    let odd = table.wrapping_byte_add(4);
    for (table, size, expected) in [
        (null_mut(), size, TOYTOP_NULL_POINTER),
        (odd, size - 8, TOYTOP_BAD_MEMORY),
        (table, f32_size(8) - 1, TOYTOP_BAD_MEMORY),
    ] {
        assert_eq!(run(table, size, memory, motion, tick, 0.0).0, expected);
    }
    for (size, memory, motion, tick, truncation, expected, line) in [
        (size, null_mut(), motion as *const _, tick, 0.0, TOYTOP_NULL_POINTER, ""),
        (size, memory.wrapping_byte_add(4), motion, tick, 0.0, TOYTOP_BAD_MEMORY, ""),
        (size, memory, null(), tick, 0.0, TOYTOP_NULL_POINTER, ""),
        (size, memory, &empty, tick, 0.0, TOYTOP_NOT_SET_UP, ""),
        (size, memory, motion, never, 0.0, TOYTOP_OUT_OF_RANGE, "tick: must be a positive number"),
        (size, memory, motion, tick, f64::NAN, TOYTOP_OUT_OF_RANGE, "truncation: must be positive"),
        (f32_size(16), memory, motion, tick, 1e-12, TOYTOP_TABLE_TOO_SMALL, "table: must have more segments"),
    ] {
        assert_eq!(good(), TOYTOP_OK);
        assert_eq!(read(), TOYTOP_OK);
        let (status, why) = run(table, size, memory, motion, tick, truncation);
        assert_eq!(status, expected);
        assert!(text(&why).contains(line), "{}", text(&why));
        assert_eq!(why.segments, if status == TOYTOP_TABLE_TOO_SMALL { 16 } else { 0 });
        assert_eq!(read(), TOYTOP_NOT_SET_UP, "{line}");
    }
}

/// The number of segments that is stated to be enough is, and one fewer is not.
#[test]
fn the_segments_needed_are_enough() {
    let motion = &launched(&TOP);
    let needed = |motion, truncation| unsafe { toytop_f32_segments_needed(motion, truncation) as usize };
    let segments = needed(motion, 1e-12);
    assert!((17..=4096).contains(&segments), "{segments}");
    assert_eq!([needed(null(), 1e-12), needed(motion, -1.0)], [0; 2]);
    let bytes = f32_size(segments);
    let mut words = vec![0_u64; bytes / 8];
    let table = words.as_mut_ptr().cast();
    for (bytes, expected) in [(bytes - 80, TOYTOP_TABLE_TOO_SMALL), (bytes, TOYTOP_OK)] {
        let ended =
            unsafe { toytop_f32_set_up(table, bytes, motion, toytop_hertz(1000), 0, 1e-12, null_mut()) };
        assert_eq!(ended, expected);
    }
}

#[test]
fn each_refused_top_has_a_text() {
    for (top, line) in [
        (toytop_top { support: 9, ..TOP }, "support: must be TOYTOP_SLIDING, TOYTOP_FIXED or TOYTOP_FREE"),
        (toytop_top { rotor_momentum: -1e9, ..TOP }, "rotor_momentum: must be at most 1e12"),
        (toytop_top { support: TOYTOP_FREE, gravity: f64::NAN, ..TOP }, "gravity: must be a finite number"),
    ] {
        let why = refusal(top);
        assert!(text(&why).starts_with(line), "{}", text(&why));
    }
    let text = |status| unsafe { CStr::from_ptr(toytop_status_text(status)) };
    assert_eq!([8, 9].map(text), [c"an aperiodic motion has no table", c"not a status of toytop"]);
}

/// Reason for which a top is refused.
fn refusal(top: toytop_top) -> toytop_error {
    let mut motion = MaybeUninit::uninit();
    unsafe {
        let state = output_of(|to| toytop_state_from_release(&RELEASE, to, null_mut()));
        let mut why = MaybeUninit::uninit();
        assert_ne!(toytop_launch(&top, &state, motion.as_mut_ptr(), why.as_mut_ptr()), TOYTOP_OK);
        why.assume_init()
    }
}

#[test]
fn an_impulse_starts_another_motion() {
    let state =
        State::from_release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() }).expect("a release");
    let struck = state.with_impulse(motion().top(), [0.0, 2e-3, 0.0], [0.025, 0.0, 0.03]).expect("a stroke");
    let release = toytop_release { azimuth: 0.0, precession: 0.0, ..RELEASE };
    let (impulse, point) = ([0.0, 2e-3, 0.0], [0.025, 0.0, 0.03]);
    unsafe {
        let from = &output_of(|to| toytop_state_from_release(&release, to, null_mut()));
        let after =
            output_of(|to| toytop_impulse(&TOP, from, impulse.as_ptr(), point.as_ptr(), to, null_mut()));
        assert_eq!(after.omega, struck.omega());
        let reaction = output_of(|to: *mut [f64; 3]| {
            toytop_reaction_impulse(&TOP, from, impulse.as_ptr(), point.as_ptr(), to.cast(), null_mut())
        });
        assert_eq!(reaction, state.reaction_impulse(motion().top(), impulse, point).expect("an answer"));
    }
}
