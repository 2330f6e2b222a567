//! Functions that JavaScript calls. Numbers are passed in both directions in one array, and words are returned in another.
//!
//! A result stays there until the next call, and JavaScript copies the data that it keeps. The functions are exported by their
//! unmangled names only on WebAssembly, because elsewhere another function could have the same name.

use crate::page_motion::{PageMotion, pose_numbers};
use crate::runge_kutta::RungeKutta;
use core::array::from_fn;
use core::sync::atomic::{AtomicU8, AtomicU64, Ordering::Relaxed};
use spin::Mutex;
use toytop::{Motion, ParameterError};
use toytop_model::constants::{number_constants, regime, tip_class};
use toytop_model::display_duration::display_duration;
use toytop_model::launch::{KINDS, Launch};
use toytop_model::motion_with_period::MotionWithPeriod;
use toytop_model::parameters::{self, SUPPORTS, top_parameters};

/// Points of a curve that one call computes at most.
const POINTS: usize = 4096;
/// Numbers of a point of a curve: r₁, r₂, r₃, c₁, c₂.
const COORDINATES: usize = 5;

static NUMBERS: [AtomicU64; POINTS * COORDINATES] = [const { AtomicU64::new(0) }; POINTS * COORDINATES];
static WORDS: [AtomicU8; 256] = [const { AtomicU8::new(0) }; 256];
static MOTION: Mutex<Option<Motion>> = Mutex::new(None);
static PAGE_MOTION: Mutex<PageMotion> = Mutex::new(PageMotion::EMPTY);
static RUNGE_KUTTA: Mutex<Option<RungeKutta>> = Mutex::new(None);

/// Address of the numbers, each an `f64` by its bits.
#[cfg_attr(target_family = "wasm", unsafe(no_mangle))]
pub extern "C" fn numbers() -> *const AtomicU64 {
    NUMBERS.as_ptr()
}

/// Address of the words, in UTF-8.
#[cfg_attr(target_family = "wasm", unsafe(no_mangle))]
pub extern "C" fn words() -> *const AtomicU8 {
    WORDS.as_ptr()
}

/// Names of the numbers that [`launch`] returns: the constants, the bound on the orientation error at t = 0, rad, its
/// growth, rad/s, and the time that the pictures cover, s.
pub fn launch_names() -> impl Iterator<Item = &'static str> {
    number_constants().map(|(name, _)| name).chain(["error", "error_growth", "span"])
}

/// Sets the motion. After a refusal there is none.
///
/// * `support`: index in [`SUPPORTS`]
/// * `kind`: index in [`KINDS`]
/// * the array: the numbers of [`top_parameters`], then of the motion
///
/// The result is the length of the words. It is positive if all is well: the words are regime and class of the tip curve,
/// and the numbers are listed by [`launch_names`]. It is negative after a refusal: the words are the parameter and what is
/// allowed.
#[cfg_attr(target_family = "wasm", unsafe(no_mangle))]
pub extern "C" fn launch(support: u32, kind: u32) -> i32 {
    (*MOTION.lock(), *RUNGE_KUTTA.lock()) = (None, None);
    match launched(support, kind) {
        Ok(motion) => {
            let page_motion = PAGE_MOTION.lock();
            write_numbers(
                number_constants()
                    .map(|(_, value)| value(&motion))
                    .chain(page_motion.error_bound())
                    .chain([display_duration(&motion, |t| page_motion.at(t).1.modulus())]),
            );
            *MOTION.lock() = Some(*motion);
            write_words([regime(motion.regime()), tip_class(motion.tip_class())])
        }
        Err(error) => -write_words([error.parameter(), error.allowed()]),
    }
}

fn launched(support: u32, kind: u32) -> Result<MotionWithPeriod, ParameterError> {
    let refused = |parameter| ParameterError::new(parameter, "one of its words");
    let (_, support) = *SUPPORTS.get(support as usize).ok_or(refused("support"))?;
    let (_, kind) = *KINDS.get(kind as usize).ok_or(refused("kind"))?;
    let numbers_of_top = from_fn(number);
    let top = parameters::top(support, &top_parameters(numbers_of_top))?;
    let launch = Launch::new(kind, from_fn(|i| number(numbers_of_top.len() + i)))?;
    let motion = MotionWithPeriod::new(launch.motion(&top)?);
    PAGE_MOTION.lock().set_up(&motion)?;
    Ok(motion)
}

/// Puts the pose at time t into the numbers.
#[cfg_attr(target_family = "wasm", unsafe(no_mangle))]
pub extern "C" fn pose(t: f64) {
    write_numbers(pose_numbers(PAGE_MOTION.lock().at(t)));
}

/// Puts axis and tip at `count` times into the numbers, the first at `from`, `step` apart.
#[cfg_attr(target_family = "wasm", unsafe(no_mangle))]
pub extern "C" fn curve(from: f64, step: f64, count: u32) {
    let page_motion = PAGE_MOTION.lock();
    write_numbers((0..count).flat_map(|i| {
        let [.., r1, r2, r3, c1, c2] = pose_numbers(page_motion.at(from + step * f64::from(i)));
        [r1, r2, r3, c1, c2]
    }));
}

/// Starts an integration of the motion with this step, s. A step that is not positive ends it.
#[cfg_attr(target_family = "wasm", unsafe(no_mangle))]
pub extern "C" fn runge_kutta(step: f64) {
    let motion = *MOTION.lock();
    *RUNGE_KUTTA.lock() = motion.filter(|_| step > 0.0).map(|motion| RungeKutta::new(&motion, step));
}

/// Puts the pose of the integration into the numbers, then the time that it has reached on its way to t, and its distance from
/// the exact orientation, rad. The result is 1, or 0 without an integration.
#[cfg_attr(target_family = "wasm", unsafe(no_mangle))]
pub extern "C" fn runge_kutta_pose(t: f64) -> u32 {
    let Some(integration) = &mut *RUNGE_KUTTA.lock() else { return 0 };
    let (reached, orientation, tip) = integration.advance_to(t);
    let distance = PAGE_MOTION.lock().at(reached).0.distance(&orientation);
    write_numbers(pose_numbers((orientation, tip)).into_iter().chain([reached, distance]));
    1
}

fn number(index: usize) -> f64 {
    NUMBERS.get(index).map_or(0.0, |bits| f64::from_bits(bits.load(Relaxed)))
}

fn write_numbers(values: impl IntoIterator<Item = f64>) {
    for (slot, value) in NUMBERS.iter().zip(values) {
        slot.store(value.to_bits(), Relaxed);
    }
}

/// Writes two words with a line feed between them; the result is their length.
fn write_words([first, second]: [&str; 2]) -> i32 {
    let mut length = 0;
    for (slot, byte) in WORDS.iter().zip(first.bytes().chain([b'\n']).chain(second.bytes())) {
        slot.store(byte, Relaxed);
        length += 1;
    }
    length
}
