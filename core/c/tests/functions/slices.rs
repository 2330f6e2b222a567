//! Tests of set-ups with other work in between, and of free bodies and rotors.

use crate::top::{TOP, launched, numbers, output_of, parameters, state};
use core::ffi::c_void;
use core::mem::size_of;
use core::ptr::null_mut;
use toytop::{Ephemeris, Motion, Tick, Top, TopParameters};
use toytop_c::toytop_status::*;
use toytop_c::*;

const TICK: toytop_tick = toytop_tick { ticks: 1000, seconds: 1 };

unsafe extern "C" fn count(calls: *mut c_void) {
    unsafe { *calls.cast::<u32>() += 1 };
}

/// Memory of a table, all of whose words are initialised.
fn memory<T>() -> Vec<u64> {
    vec![0x5555_5555_5555_5555; size_of::<T>() / 8]
}

#[test]
fn other_work_in_between_gives_the_same_table() {
    let motion = launched(&TOP);
    for truncation in [0.0, 1e-4] {
        let [mut whole, mut interrupted] = [(); 2].map(|()| memory::<toytop_ephemeris_f64>());
        let (size, mut calls) = (size_of::<toytop_ephemeris_f64>(), 0_u32);
        let mut workspace = Box::<toytop_workspace>::new_uninit();
        let (table, workspace) = (interrupted.as_mut_ptr().cast(), workspace.as_mut_ptr());
        let [on_stack, with_pauses] = unsafe {
            let context = (&raw mut calls).cast();
            [
                toytop_f64_set_up(whole.as_mut_ptr().cast(), size, &motion, TICK, 7, truncation, null_mut()),
                toytop_f64_set_up_with_pauses(
                    table,
                    size,
                    workspace,
                    &motion,
                    TICK,
                    7,
                    truncation,
                    Some(count),
                    context,
                    null_mut(),
                ),
            ]
        };
        assert_eq!([on_stack, with_pauses], [TOYTOP_OK; 2]);
        assert!(calls > 30, "{calls} calls");
        // behind the head and the flag of the memory, without padding, whose bytes may differ
        let table = |words: &[u64]| unsafe { words[2..].as_ptr().cast::<Ephemeris<f64, 48>>().read() };
        assert_eq!(table(&whole), table(&interrupted), "truncation {truncation}");
        assert_eq!(whole[0], interrupted[0]);
    }
}

#[test]
fn free_bodies_and_rotors_are_those_of_the_crate() {
    let parameters = TopParameters { rotor_momentum: -1.5e-3, ..parameters() };
    for (support, top) in [(TOYTOP_FREE, Top::free(&parameters)), (TOYTOP_SLIDING, Top::sliding(&parameters))]
    {
        let motion = Motion::launch(&top.expect("a top"), &state()).expect("a motion");
        let expected =
            Ephemeris::<f32, 25>::new(&motion, Tick::hertz(1000).expect("a tick")).expect("it fits");
        let motion = launched(&toytop_top { support, rotor_momentum: -1.5e-3, ..TOP });
        let mut bytes = memory::<toytop_ephemeris_f32>();
        let table: *mut toytop_ephemeris_f32 = bytes.as_mut_ptr().cast();
        let q = unsafe {
            let size = size_of::<toytop_ephemeris_f32>();
            assert_eq!(toytop_f32_set_up(table, size, &motion, TICK, 0, 0.0, null_mut()), TOYTOP_OK);
            let constants = output_of(|to| toytop_motion_constants(&motion, to));
            assert_eq!(constants.min_normal_force.is_nan(), support == TOYTOP_FREE);
            assert_eq!(constants.e3.is_infinite(), support == TOYTOP_FREE);
            let now = output_of(|to| toytop_f32_at_tick(table, 777, to));
            numbers(|to| toytop_f32_quaternion(&now, to))
        };
        assert_eq!(q, expected.at_tick(777).quaternion());
    }
}
