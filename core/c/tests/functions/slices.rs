//! Tests of set-ups in slices, which give the table of a set-up at once, with a status for every misuse; and of free bodies and rotors.

use crate::top::{TOP, launched, parameters, state};
use core::ffi::CStr;
use core::mem::{MaybeUninit, size_of};
use core::ptr::{null, null_mut};
use toytop::fixed::types::I2F30;
use toytop::{Ephemeris, Motion, Tick, Top, TopParameters};
use toytop_c::toytop_status::*;
use toytop_c::*;

const TICK: toytop_tick = toytop_tick { ticks: 1000, seconds: 1 };

fn begun(motion: &toytop_motion, truncation: f64) -> Box<toytop_set_up> {
    let mut set_up = Box::<toytop_set_up>::new_uninit();
    unsafe {
        let begun = toytop_set_up_begin(set_up.as_mut_ptr(), motion, TICK, truncation, null_mut());
        assert_eq!(begun, TOYTOP_OK);
        set_up.assume_init()
    }
}

/// Memory of a table, all of whose words are initialised.
fn memory<T>() -> Vec<u64> {
    vec![0x5555_5555_5555_5555; size_of::<T>() / 8]
}

macro_rules! slices_give_the_table {
    ($table:ty, $of:ty, $at_once:ident, $poll:ident) => {
        let motion = launched(&TOP);
        for truncation in [0.0, 1e-4] {
            let (mut whole, mut sliced) = (memory::<$table>(), memory::<$table>());
            let (size, mut slices) = (size_of::<$table>(), 1);
            let mut set_up = begun(&motion, truncation);
            unsafe {
                let table = whole.as_mut_ptr().cast();
                assert_eq!($at_once(table, size, &motion, TICK, truncation, null_mut()), TOYTOP_OK);
                let table = sliced.as_mut_ptr().cast();
                while $poll(&mut *set_up, table, size, null_mut()) == TOYTOP_PENDING {
                    slices += 1;
                }
                assert!(slices > 8, "{slices} slices");
                assert_eq!($poll(&mut *set_up, table, size, null_mut()), TOYTOP_OK);
            }
            // behind the head, without padding, whose bytes may differ
            let table = |bytes: &[u64]| unsafe { bytes[1..].as_ptr().cast::<$of>().read() };
            assert_eq!(table(&whole), table(&sliced), "truncation {truncation}");
            assert_eq!(whole[0], sliced[0]);
        }
    };
}

#[test]
fn slices_give_the_same_table() {
    slices_give_the_table!(toytop_ephemeris_f32, Ephemeris<f32, 25>, toytop_f32_set_up, toytop_f32_set_up_poll);
    slices_give_the_table!(toytop_ephemeris_f64, Ephemeris<f64, 48>, toytop_f64_set_up, toytop_f64_set_up_poll);
    slices_give_the_table!(toytop_ephemeris_q31, Ephemeris<I2F30, 32>, toytop_q31_set_up, toytop_q31_set_up_poll);
}

#[test]
fn misuse_is_answered() {
    let motion = launched(&TOP);
    let (mut first, mut second) = (memory::<toytop_ephemeris_f32>(), memory::<toytop_ephemeris_f32>());
    let (table, other): (*mut toytop_ephemeris_f32, *mut toytop_ephemeris_f32) =
        (first.as_mut_ptr().cast(), second.as_mut_ptr().cast());
    let (size, mut why) = (size_of::<toytop_ephemeris_f32>(), MaybeUninit::<toytop_error>::uninit());
    let why = why.as_mut_ptr();
    let text = || unsafe { CStr::from_ptr((*why).text.as_ptr()) }.to_str().expect("ASCII");
    unsafe {
        // nothing, or something else, was begun
        let mut set_up = Box::<toytop_set_up>::new_zeroed().assume_init();
        assert_eq!(toytop_f32_set_up_poll(null_mut(), table, size, why), TOYTOP_NULL_POINTER);
        assert_eq!(toytop_f32_set_up_poll(&mut *set_up, table, size, why), TOYTOP_NOT_SET_UP);
        let never = toytop_tick { ticks: 1000, seconds: 0 };
        let empty: toytop_motion = MaybeUninit::zeroed().assume_init();
        assert_eq!(toytop_set_up_begin(null_mut(), &motion, TICK, 0.0, why), TOYTOP_NULL_POINTER);
        assert_eq!(toytop_set_up_begin(&mut *set_up, null(), TICK, 0.0, why), TOYTOP_NULL_POINTER);
        assert_eq!(toytop_set_up_begin(&mut *set_up, &empty, TICK, 0.0, why), TOYTOP_NOT_SET_UP);
        assert_eq!(toytop_set_up_begin(&mut *set_up, &motion, never, 0.0, why), TOYTOP_OUT_OF_RANGE);
        assert_eq!(toytop_set_up_begin(&mut *set_up, &motion, TICK, f64::NAN, why), TOYTOP_OUT_OF_RANGE);
        assert!(text().starts_with("truncation: must be positive"), "{}", text());
        let odd = (&raw mut *set_up).byte_add(4);
        assert_eq!(toytop_set_up_begin(odd, &motion, TICK, 0.0, why), TOYTOP_BAD_MEMORY);
        assert_eq!(toytop_f32_set_up_poll(&mut *set_up, table, size, why), TOYTOP_NOT_SET_UP);

        // a refused memory does not count as the first
        let mut set_up = begun(&motion, 0.0);
        assert_eq!(toytop_f32_set_up_poll(&mut *set_up, null_mut(), size, why), TOYTOP_NULL_POINTER);
        assert_eq!(toytop_f32_set_up_poll(&mut *set_up, table, 1559, why), TOYTOP_BAD_MEMORY);
        assert_eq!(toytop_f32_set_up_poll(&mut *set_up, table, size, why), TOYTOP_PENDING);
        assert_eq!(text(), "the set-up needs more slices");
        // another table, another size, another scalar
        assert_eq!(toytop_f32_set_up_poll(&mut *set_up, other, size, why), TOYTOP_OUT_OF_RANGE);
        assert_eq!(text(), "table: must be that of the first slice, and of the same size");
        assert_eq!(toytop_f32_set_up_poll(&mut *set_up, table, size - 80, why), TOYTOP_OUT_OF_RANGE);
        assert_eq!(toytop_q31_set_up_poll(&mut *set_up, table.cast(), size, why), TOYTOP_OUT_OF_RANGE);
        assert!(second.iter().all(|word| *word == 0x5555_5555_5555_5555));
        // a table that is not yet ready
        let mut sample = MaybeUninit::uninit();
        assert_eq!(toytop_f32_at_tick(table, 0, sample.as_mut_ptr()), TOYTOP_NOT_SET_UP);
        // a table that was set up at once meanwhile
        assert_eq!(toytop_f32_set_up(table, size, &motion, TICK, 0.0, why), TOYTOP_OK);
        assert_eq!(toytop_f32_set_up_poll(&mut *set_up, table, size, why), TOYTOP_OUT_OF_RANGE);
        assert_eq!(text(), "table: must be left alone until its set-up ends");
        assert_eq!(toytop_f32_at_tick(table, 0, sample.as_mut_ptr()), TOYTOP_OK);
    }
}

#[test]
fn the_result_of_a_set_up_stays() {
    let motion = launched(&TOP);
    let mut bytes = memory::<toytop_ephemeris_f32>();
    let table: *mut toytop_ephemeris_f32 = bytes.as_mut_ptr().cast();
    let (mut set_up, mut why) = (begun(&motion, 1e-12), MaybeUninit::<toytop_error>::uninit());
    let mut sample = MaybeUninit::uninit();
    unsafe {
        let mut poll = || toytop_f32_set_up_poll(&mut *set_up, table, 1560, why.as_mut_ptr());
        while poll() == TOYTOP_PENDING {}
        assert_eq!([poll(), poll()], [TOYTOP_TABLE_TOO_SMALL; 2]);
        assert_eq!((*why.as_ptr()).segments, 16);
        assert_eq!(toytop_f32_at_tick(table, 0, sample.as_mut_ptr()), TOYTOP_NOT_SET_UP);
        // the end of one set-up, and the memory of another one after it
        assert_eq!(toytop_f32_set_up(table, 1560, &motion, TICK, 1e-2, null_mut()), TOYTOP_OK);
        assert_eq!(toytop_f32_set_up_poll(&mut *set_up, table, 1560, null_mut()), TOYTOP_TABLE_TOO_SMALL);
        assert_eq!(toytop_f32_at_tick(table, 0, sample.as_mut_ptr()), TOYTOP_OK);
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
        let (mut sample, mut q) = (MaybeUninit::uninit(), [0_f32; 4]);
        let mut constants = MaybeUninit::<toytop_constants>::uninit();
        unsafe {
            let size = size_of::<toytop_ephemeris_f32>();
            assert_eq!(toytop_f32_set_up(table, size, &motion, TICK, 0.0, null_mut()), TOYTOP_OK);
            assert_eq!(toytop_f32_at_tick(table, 777, sample.as_mut_ptr()), TOYTOP_OK);
            assert_eq!(toytop_f32_quaternion(sample.as_ptr(), q.as_mut_ptr()), TOYTOP_OK);
            assert_eq!(toytop_motion_constants(&motion, constants.as_mut_ptr()), TOYTOP_OK);
            let constants = constants.assume_init();
            assert_eq!(constants.min_normal_force.is_nan(), support == TOYTOP_FREE);
            assert_eq!(constants.e3.is_infinite(), support == TOYTOP_FREE);
        }
        assert_eq!(q, expected.at_tick(777).quaternion());
    }
}
