//! Tests of the reading of a table: every quantity has the bits of the crate, and a cursor or sample of another table is refused.

use crate::fixture::{SETTINGS, TOP, f64_table, launched, motion, numbers, output_of};
use core::mem::{MaybeUninit, size_of};
use core::ptr::null_mut;
use toytop::{Complex, Ephemeris, Events, Level, Phase, Tick};
use toytop_c::toytop_status::*;
use toytop_c::*;
use toytop_fit::Sensitivity;

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
    let same = |mut found: toytop_ephemeris_events, events: Events<'_, f64>| {
        for event in events.take(3) {
            let found = unsafe { output_of(|to| toytop_f64_next_event(&mut found, to)) };
            assert_eq!(
                (found.tick, found.fraction, found.upward),
                (event.tick, event.fraction, event.upward.into())
            );
        }
    };
    unsafe {
        for from in [0, -5000, 1 << 40] {
            same(output_of(|to| toytop_f64_turning_points(table, from, to)), expected.turning_points(from));
            let level = Level::from_tilt(0.36).expect("a level");
            same(
                output_of(|to| toytop_f64_crossings(table, 0.36, from, to)),
                expected.crossings(level, from),
            );
            let angle = Phase::from_radians(-2.0);
            let found = output_of(|to| toytop_f64_tip_angles(table, -2.0, from, to));
            same(found, expected.tip_angles(angle, from));
        }
        let mut none = output_of(|to| toytop_f64_crossings(table, 3.0, 0, to));
        assert_eq!(toytop_f64_next_event(&mut none, MaybeUninit::uninit().as_mut_ptr()), TOYTOP_NONE);
        let events = &mut none;
        assert_eq!(toytop_f64_crossings(table, 4.0, 0, events), TOYTOP_OUT_OF_RANGE);
        assert_eq!(toytop_f64_tip_angles(table, f64::NAN, 0, events), TOYTOP_NOT_FINITE);
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
        toytop_q31_set_up(table, size, &motion, &toytop_settings { epoch, ..SETTINGS }, null_mut())
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

        // cursors, samples and events of an earlier table, of another one or of another scalar are refused
        // zeroed memory: both tables are the first in theirs
        let mut tables = [MaybeUninit::<toytop_ephemeris_f32>::zeroed(); 2];
        let [single, another] = tables.each_mut().map(MaybeUninit::as_mut_ptr);
        for place in [single, another] {
            let (size, settings) =
                (size_of::<toytop_ephemeris_f32>(), toytop_settings { epoch: 100, ..SETTINGS });
            assert_eq!(toytop_f32_set_up(place, size, &motion, &settings, null_mut()), TOYTOP_OK);
        }
        let mut of_single = output_of(|to| toytop_f32_cursor(single, 100, to));
        let next = |table, cursor| toytop_f32_next_quaternion(table, cursor, [0.0; 4].as_mut_ptr());
        assert_eq!(next(single, &mut cursor), TOYTOP_NOT_SET_UP);
        assert_eq!(next(another, &mut of_single), TOYTOP_NOT_SET_UP);
        assert_eq!(next(single, &mut of_single), TOYTOP_OK);
        let stale = output_of(|to| toytop_q31_at_tick(table, 107, to));
        let mut stale_events = output_of(|to| toytop_q31_turning_points(table, 107, to));
        assert_eq!(set_up(100), TOYTOP_OK);
        let mut numbers = [0; 4];
        assert_eq!(toytop_q31_next(table, &mut cursor, &mut now), TOYTOP_NOT_SET_UP);
        assert_eq!(toytop_q31_next_quaternion(table, &mut cursor, numbers.as_mut_ptr()), TOYTOP_NOT_SET_UP);
        assert_eq!(toytop_q31_quaternion(&stale, numbers.as_mut_ptr()), TOYTOP_NOT_SET_UP);
        let mut event = MaybeUninit::uninit();
        assert_eq!(toytop_q31_next_event(&mut stale_events, event.as_mut_ptr()), TOYTOP_NOT_SET_UP);
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
