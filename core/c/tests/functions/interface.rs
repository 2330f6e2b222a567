//! Tests of the functions as a program in C calls them: they give the bits of the crate, and a status for each error.

use crate::top::{RELEASE, TOP, launched, parameters, state, text};
use core::ffi::CStr;
use core::mem::{MaybeUninit, size_of};
use core::ptr::{null, null_mut};
use toytop::{Ephemeris, Motion, Release, State, Tick, Top};
use toytop_c::toytop_status::*;
use toytop_c::*;

fn motion() -> Motion {
    Motion::launch(&Top::sliding(&parameters()).expect("a top"), &state()).expect("a motion")
}

/// Value that a function writes, and its status.
fn told<T: Copy + Default>(call: impl FnOnce(*mut T) -> toytop_status) -> T {
    let mut value = T::default();
    assert_eq!(call(&raw mut value), TOYTOP_OK);
    value
}

#[test]
fn every_quantity_has_the_bits_of_the_crate() {
    let expected = Ephemeris::<f64, 48>::new(&motion(), Tick::hertz(1000).expect("a tick")).expect("it fits");
    let mut memory = MaybeUninit::<toytop_ephemeris_f64>::uninit();
    let (table, size) = (memory.as_mut_ptr(), size_of::<toytop_ephemeris_f64>());
    let (motion, tick) = (launched(&TOP), toytop_hertz(1000));
    let mut place = MaybeUninit::<toytop_ephemeris_sample>::uninit();
    unsafe {
        assert_eq!(toytop_f64_set_up(table, size, &motion, tick, 0.0, null_mut()), TOYTOP_OK);
        for n in [0, 1, -5000, 1 << 40, i64::MAX] {
            let sample = expected.at_tick(n);
            assert_eq!(toytop_f64_at_tick(table, n, place.as_mut_ptr()), TOYTOP_OK);
            let now = place.as_ptr();
            assert_eq!(told(|to: *mut [f64; 4]| toytop_f64_quaternion(now, to.cast())), sample.quaternion());
            assert_eq!(told(|to: *mut [f64; 3]| toytop_f64_axis(now, to.cast())), sample.axis());
            assert_eq!(told(|to: *mut [f64; 3]| toytop_f64_omega(now, to.cast())), sample.omega());
            assert_eq!(told(|to: *mut [f64; 3]| toytop_f64_omega_body(now, to.cast())), sample.omega_body());
            let (tip, velocity) = (sample.tip(), sample.tip_velocity());
            assert_eq!(told(|to: *mut [f64; 2]| toytop_f64_tip(now, to.cast())), [tip.re, tip.im]);
            let told_velocity = told(|to: *mut [f64; 2]| toytop_f64_tip_velocity(now, to.cast()));
            assert_eq!(told_velocity, [velocity.re, velocity.im]);
            let angle = sample.tip_angle().expect("an angle").to_radians();
            assert_eq!(told(|to| toytop_f64_tip_angle(now, to)), angle);
            let mut point = MaybeUninit::uninit();
            let found = expected.next_turning_point(n).expect("a turning point");
            assert_eq!(toytop_f64_turning_point(table, n, point.as_mut_ptr()), TOYTOP_OK);
            let point: toytop_turning_point = point.assume_init();
            assert_eq!((point.tick, point.upper), (found.tick, u32::from(found.upper)));
        }
        let mut bounds = MaybeUninit::uninit();
        assert_eq!(toytop_f64_error_bounds(table, bounds.as_mut_ptr()), TOYTOP_OK);
        let bounds: toytop_error_bounds = bounds.assume_init();
        let (own, rate) = (expected.error_bound(), expected.rate_error_bound());
        assert_eq!([bounds.orientation, bounds.orientation_per_tick], [own.constant, own.per_tick]);
        assert_eq!([bounds.rate, bounds.rate_per_tick], [rate.constant, rate.per_tick]);
    }
}

#[test]
fn a_cursor_a_delay_and_a_time_agree() {
    let mut memory = MaybeUninit::<toytop_ephemeris_q31>::uninit();
    let (table, size) = (memory.as_mut_ptr(), size_of::<toytop_ephemeris_q31>());
    let motion = launched(&TOP);
    let (mut cursor, mut place) = (MaybeUninit::uninit(), MaybeUninit::uninit());
    unsafe {
        assert_eq!(toytop_q31_set_up(table, size, &motion, toytop_hertz(1000), 0.0, null_mut()), TOYTOP_OK);
        let at = |n, place: &mut MaybeUninit<toytop_ephemeris_sample>| {
            assert_eq!(toytop_q31_at_tick(table, n, place.as_mut_ptr()), TOYTOP_OK);
            told(|to: *mut [i32; 4]| toytop_q31_quaternion(place.as_ptr(), to.cast()))
        };
        let before = at(7, &mut place);
        assert_eq!(toytop_q31_delay(table, 100.0), TOYTOP_OK);
        let delayed = at(107, &mut place);
        assert!(before.iter().zip(delayed).all(|(x, y)| x.abs_diff(y) < 8), "{before:?} {delayed:?}");
        assert_eq!(toytop_q31_cursor(table, 107, cursor.as_mut_ptr()), TOYTOP_OK);
        let next = |to: *mut [i32; 4]| toytop_q31_next_quaternion(table, cursor.as_mut_ptr(), to.cast());
        assert_eq!(told(next), delayed);
        assert_eq!(told(|to| toytop_ephemeris_cursor_tick(cursor.as_ptr(), to)), 107);
        assert_eq!(toytop_q31_at(table, 0.107, place.as_mut_ptr()), TOYTOP_OK);
        assert_eq!(told(|to: *mut [i32; 4]| toytop_q31_quaternion(place.as_ptr(), to.cast())), delayed);
        assert_eq!(toytop_q31_at(table, f64::NAN, place.as_mut_ptr()), TOYTOP_NOT_FINITE);
    }
}

#[test]
fn each_error_has_a_status() {
    let motion = launched(&TOP);
    let mut table = [0_u64; TOYTOP_EPHEMERIS_F32_SIZE / 8];
    let table: *mut toytop_ephemeris_f32 = table.as_mut_ptr().cast();
    let (size, tick) = (size_of::<toytop_ephemeris_f32>(), toytop_hertz(1000));
    let mut place = MaybeUninit::<toytop_ephemeris_sample>::zeroed();
    let mut why = MaybeUninit::uninit();
    let mut q = [0_f32; 4];
    unsafe {
        assert_eq!(toytop_f32_at_tick(table, 0, place.as_mut_ptr()), TOYTOP_NOT_SET_UP);
        assert_eq!(toytop_f32_quaternion(place.as_ptr(), q.as_mut_ptr()), TOYTOP_NOT_SET_UP);
        let empty: toytop_motion = MaybeUninit::zeroed().assume_init();
        assert_eq!(toytop_f32_set_up(table, size, &empty, tick, 0.0, null_mut()), TOYTOP_NOT_SET_UP);
        assert_eq!(toytop_f32_set_up(null_mut(), size, &motion, tick, 0.0, null_mut()), TOYTOP_NULL_POINTER);
        assert_eq!(toytop_f32_set_up(table, size, null(), tick, 0.0, null_mut()), TOYTOP_NULL_POINTER);
        assert_eq!(toytop_f32_set_up(table, 1559, &motion, tick, 0.0, null_mut()), TOYTOP_BAD_MEMORY);
        let odd = table.byte_add(4);
        assert_eq!(toytop_f32_set_up(odd, size - 8, &motion, tick, 0.0, null_mut()), TOYTOP_BAD_MEMORY);
        let never = toytop_tick { ticks: 0, seconds: 1 };
        assert_eq!(
            toytop_f32_set_up(table, size, &motion, never, 0.0, why.as_mut_ptr()),
            TOYTOP_OUT_OF_RANGE
        );
        assert!(text(why.assume_init_ref()).starts_with("tick: must be a positive number"));
        assert_eq!(
            toytop_f32_set_up(table, 1560, &motion, tick, 1e-12, why.as_mut_ptr()),
            TOYTOP_TABLE_TOO_SMALL
        );
        let small: toytop_error = why.assume_init();
        assert!(
            small.segments == 16 && text(&small).contains("16 segments are not enough"),
            "{}",
            text(&small)
        );
        assert_eq!(toytop_f32_at_tick(table, 0, place.as_mut_ptr()), TOYTOP_NOT_SET_UP);

        // the number of segments that is stated to be enough, and one fewer
        let needed = toytop_f32_segments_needed(&motion, 1e-12) as usize;
        assert!((17..=4096).contains(&needed), "{needed}");
        assert_eq!(toytop_f32_segments_needed(null(), 1e-12), 0);
        assert_eq!(toytop_f32_segments_needed(&motion, -1.0), 0);
        assert_eq!(toytop_f32_segments_needed(&motion, 1e-300), 0);
        let bytes = 280 + 80 * needed;
        let mut large = vec![0_u64; bytes / 8];
        let large: *mut toytop_ephemeris_f32 = large.as_mut_ptr().cast();
        let fewer = toytop_f32_set_up(large, bytes - 80, &motion, tick, 1e-12, null_mut());
        assert_eq!(fewer, TOYTOP_TABLE_TOO_SMALL);
        assert_eq!(toytop_f32_set_up(large, bytes, &motion, tick, 1e-12, null_mut()), TOYTOP_OK);
        assert_eq!(toytop_f32_at_tick(large, 0, place.as_mut_ptr()), TOYTOP_OK);
        assert_eq!(toytop_f32_quaternion(place.as_ptr(), null_mut()), TOYTOP_NULL_POINTER);
        // a table or sample of another scalar
        assert_eq!(toytop_q31_at_tick(large.cast(), 0, place.as_mut_ptr()), TOYTOP_NOT_SET_UP);
        assert_eq!(toytop_f64_quaternion(place.as_ptr(), q.as_mut_ptr().cast()), TOYTOP_NOT_SET_UP);
        assert_eq!(
            text(&refusal(toytop_top { support: 9, ..TOP })),
            "support: must be TOYTOP_SLIDING, TOYTOP_FIXED or TOYTOP_FREE"
        );
        assert!(text(&refusal(toytop_top { gravity: 0.0, ..TOP })).starts_with("gravity: must be positive"));
        let fast = toytop_top { rotor_momentum: -1e9, ..TOP };
        assert!(text(&refusal(fast)).starts_with("rotor_momentum: must be at most 1e12"));
        let free = toytop_top { support: TOYTOP_FREE, gravity: f64::NAN, ..TOP };
        assert_eq!(text(&refusal(free)), "gravity: must be a finite number");
    }
    assert_eq!(unsafe { CStr::from_ptr(toytop_status_text(77)) }, c"not a status of toytop");
}

/// Reason for which a top is refused.
fn refusal(top: toytop_top) -> toytop_error {
    let (mut state, mut motion, mut why) =
        (MaybeUninit::uninit(), MaybeUninit::uninit(), MaybeUninit::uninit());
    unsafe {
        assert_eq!(toytop_state_from_release(&RELEASE, state.as_mut_ptr(), why.as_mut_ptr()), TOYTOP_OK);
        assert_ne!(toytop_launch(&top, state.as_ptr(), motion.as_mut_ptr(), why.as_mut_ptr()), TOYTOP_OK);
        why.assume_init()
    }
}

/// A motion for `f32` has the table of one for all scalars, and the errors of its rates in the bound.
#[test]
fn a_motion_for_f32_has_shorter_rates() {
    let bounds = [toytop_launch, toytop_launch_f32].map(|launch| {
        let (mut state, mut motion) = (MaybeUninit::uninit(), MaybeUninit::uninit());
        let mut table = MaybeUninit::<toytop_ephemeris_f32>::uninit();
        let (mut now, mut numbers) = (MaybeUninit::uninit(), [0.0_f32; 6]);
        unsafe {
            assert_eq!(toytop_state_from_release(&RELEASE, state.as_mut_ptr(), null_mut()), TOYTOP_OK);
            assert_eq!(launch(&TOP, state.as_ptr(), motion.as_mut_ptr(), null_mut()), TOYTOP_OK);
            let tick = toytop_hertz(1000);
            let size = size_of::<toytop_ephemeris_f32>();
            let why = null_mut();
            assert_eq!(
                toytop_f32_set_up(table.as_mut_ptr(), size, motion.as_ptr(), tick, 0.0, why),
                TOYTOP_OK
            );
            assert_eq!(toytop_f32_at_tick(table.as_ptr(), 1000, now.as_mut_ptr()), TOYTOP_OK);
            assert_eq!(toytop_f32_cayley_klein(now.as_ptr(), numbers.as_mut_ptr()), TOYTOP_OK);
            let mut bounds = MaybeUninit::uninit();
            assert_eq!(toytop_f32_error_bounds(table.as_ptr(), bounds.as_mut_ptr()), TOYTOP_OK);
            (numbers, bounds.assume_init())
        }
    });
    let [(numbers, bounds), (short_numbers, short_bounds)] = bounds;
    assert_eq!(numbers, short_numbers);
    assert_eq!(bounds.orientation, short_bounds.orientation);
    let growth = short_bounds.orientation_per_tick;
    assert!((1e-19..1e-17).contains(&growth) && bounds.orientation_per_tick < 1e-9 * growth, "{growth:e}");
    assert_ne!(unsafe { toytop_launch_f32(null(), null(), null_mut(), null_mut()) }, TOYTOP_OK);
}

#[test]
fn an_impulse_starts_another_motion() {
    let state =
        State::release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() }).expect("a release");
    let struck = state.with_impulse(motion().top(), [0.0, 2e-3, 0.0], [0.025, 0.0, 0.03]).expect("a stroke");
    let (mut before, mut after) = (MaybeUninit::uninit(), MaybeUninit::uninit());
    let release = toytop_release { azimuth: 0.0, precession: 0.0, ..RELEASE };
    let (impulse, point) = ([0.0, 2e-3, 0.0], [0.025, 0.0, 0.03]);
    unsafe {
        assert_eq!(toytop_state_from_release(&release, before.as_mut_ptr(), null_mut()), TOYTOP_OK);
        let (from, to) = (before.as_ptr(), after.as_mut_ptr());
        assert_eq!(toytop_impulse(&TOP, from, impulse.as_ptr(), point.as_ptr(), to, null_mut()), TOYTOP_OK);
        let after: toytop_state = after.assume_init();
        assert_eq!(after.omega, struck.omega());
        let reaction = told(|to: *mut [f64; 3]| {
            toytop_reaction_impulse(&TOP, from, impulse.as_ptr(), point.as_ptr(), to.cast(), null_mut())
        });
        assert_eq!(reaction, state.reaction_impulse(motion().top(), impulse, point).expect("an answer"));
    }
}
