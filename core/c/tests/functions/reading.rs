//! Tests of the reading of a table: every quantity has the bits of the crate, and a cursor or sample of another table is refused.

use crate::fixture::{SETTINGS, TOP, f64_table, launched, motion, numbers, output_of, table_of};
use core::mem::MaybeUninit;
use core::ptr::null_mut;
use toytop::{Complex, Events, Level, Phase};
use toytop_c::toytop_status::*;
use toytop_c::*;
use toytop_fit::Sensitivity;

#[test]
fn every_quantity_has_the_bits_of_the_crate() {
    let expected = table_of(&motion());
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
    let expected = table_of(&motion());
    let launched = &launched(&TOP);
    let table = &*f64_table(launched);
    let same = |mut found: toytop_events, events: Events<'_, f64>| {
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

/// Table of the top of the tests in 32-bit fixed point, launched at tick `epoch`.
fn set_up_q31(memory: &mut MaybeUninit<toytop_table_q31>, epoch: i64) -> *mut toytop_table_q31 {
    let (table, settings) = (memory.as_mut_ptr(), toytop_settings { epoch, ..SETTINGS });
    let status =
        unsafe { toytop_q31_set_up(table, TOYTOP_TABLE_Q31_SIZE, &launched(&TOP), &settings, null_mut()) };
    assert_eq!(status, TOYTOP_OK);
    table
}

fn quaternion_q31(now: &toytop_sample) -> [i32; 4] {
    unsafe { numbers(|to| toytop_q31_quaternion(now, to)) }
}

#[test]
fn a_cursor_an_epoch_and_a_time_agree() {
    let mut memory = MaybeUninit::uninit();
    unsafe {
        let table = set_up_q31(&mut memory, 0);
        let before = quaternion_q31(&output_of(|to| toytop_q31_at_tick(table, 7, to)));
        let table = set_up_q31(&mut memory, 100);
        let delayed = quaternion_q31(&output_of(|to| toytop_q31_at_tick(table, 107, to)));
        assert!(before.iter().zip(delayed).all(|(x, y)| x.abs_diff(y) < 8), "{before:?} {delayed:?}");
        let mut cursor = output_of(|to| toytop_q31_cursor(table, 107, to));
        assert_eq!(numbers(|to| toytop_q31_next_quaternion(table, &mut cursor, to)), delayed);
        assert_eq!(output_of(|to| toytop_cursor_tick(&cursor, to)), 107);
        let mut now = output_of(|to| toytop_q31_at(table, 10.7, to));
        assert_eq!(quaternion_q31(&now), delayed);
        assert_eq!(toytop_q31_at(table, f64::NAN, &mut now), TOYTOP_NOT_FINITE);
        for beyond in [9.3e17, -9.3e17] {
            assert_eq!(toytop_q31_at(table, beyond, &mut now), TOYTOP_OUT_OF_RANGE);
            assert_eq!(toytop_q31_at(table, 0.99 * beyond, &mut now), TOYTOP_OK);
        }
    }
}

#[test]
fn a_refused_call_leaves_the_cursor_where_it_is() {
    let mut memory = MaybeUninit::uninit();
    let table = set_up_q31(&mut memory, 0);
    unsafe {
        let mut cursor = output_of(|to| toytop_q31_cursor(table, 107, to));
        assert_eq!(toytop_q31_next(table, &mut cursor, null_mut()), TOYTOP_NULL_POINTER);
        assert_eq!(output_of(|to| toytop_cursor_tick(&cursor, to)), 106);
        output_of(|to| toytop_q31_next(table, &mut cursor, to));
        assert_eq!(output_of(|to| toytop_cursor_tick(&cursor, to)), 107);
    }
}

#[test]
fn a_cursor_of_another_table_is_refused() {
    let mut memories = [MaybeUninit::uninit(); 2];
    let [table, another] = memories.each_mut().map(|memory| set_up_q31(memory, 0));
    let in_f64 = f64_table(&launched(&TOP));
    unsafe {
        let own = output_of(|to| toytop_q31_cursor(table, 7, to));
        let of_another = output_of(|to| toytop_q31_cursor(another, 7, to));
        let of_f64 = output_of(|to| toytop_f64_cursor(&*in_f64, 7, to));
        for (mut cursor, status) in
            [(of_another, TOYTOP_NOT_SET_UP), (of_f64, TOYTOP_NOT_SET_UP), (own, TOYTOP_OK)]
        {
            assert_eq!(toytop_q31_next_quaternion(table, &mut cursor, [0; 4].as_mut_ptr()), status);
        }
    }
}

#[test]
fn cursors_samples_and_events_of_an_earlier_table_are_refused() {
    let mut memory = MaybeUninit::uninit();
    let mut numbers = [0; 4];
    unsafe {
        let table = set_up_q31(&mut memory, 0);
        let mut cursor = output_of(|to| toytop_q31_cursor(table, 7, to));
        let mut sample = output_of(|to| toytop_q31_at_tick(table, 7, to));
        let mut events = output_of(|to| toytop_q31_turning_points(table, 7, to));
        let (stale, table) = (sample, set_up_q31(&mut memory, 0));
        assert_eq!(toytop_q31_next(table, &mut cursor, &mut sample), TOYTOP_NOT_SET_UP);
        assert_eq!(toytop_q31_quaternion(&stale, numbers.as_mut_ptr()), TOYTOP_NOT_SET_UP);
        let mut event = MaybeUninit::uninit();
        assert_eq!(toytop_q31_next_event(&mut events, event.as_mut_ptr()), TOYTOP_NOT_SET_UP);
        let never = MaybeUninit::zeroed();
        assert_eq!(toytop_q31_quaternion(never.as_ptr(), numbers.as_mut_ptr()), TOYTOP_NOT_SET_UP);
        assert_eq!(numbers, [0; 4]);
    }
}

#[test]
fn a_sample_is_read_in_its_own_scalar_alone() {
    let mut memory = MaybeUninit::uninit();
    unsafe {
        let table = set_up_q31(&mut memory, 0);
        let mut sample = output_of(|to| toytop_q31_at_tick(table, 0, to));
        assert_eq!(toytop_q31_quaternion(&sample, null_mut()), TOYTOP_NULL_POINTER);
        assert_eq!(toytop_f64_quaternion(&sample, [0.0; 4].as_mut_ptr()), TOYTOP_NOT_SET_UP);
        assert_eq!(toytop_f32_at_tick(table.cast(), 0, &mut sample), TOYTOP_NOT_SET_UP);
    }
}
