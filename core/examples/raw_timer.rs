//! Ticks that are the counts of a hardware timer: 25 MHz, 32 bits, which wraps every 172 s.
//!
//! An interrupt that comes late reads the count at which it runs, so that its lateness is no error. Set-up and tick cost the same
//! at every tick rate.

use toytop::{Motion, Release, State, TableF32, Tick, Top, TopParameters};

const TIMER: u32 = 25_000_000;
const HOUR: i64 = 3600 * TIMER as i64;

/// Count of 64 bits of a timer of 32 bits, which is read at least once between two wraps.
#[derive(Default)]
struct Count(i64);

impl Count {
    fn widened(&mut self, timer: u32) -> i64 {
        // the difference of two counts is right across a wrap
        self.0 += i64::from(timer.wrapping_sub(self.0 as u32));
        self.0
    }
}

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let top = Top::sliding(&TopParameters::TOY)?;
    let state = State::from_release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() })?;
    let motion = Motion::launch(&top, &state)?;
    let by_timer = TableF32::new(&motion, Tick::hertz(TIMER)?)?;
    let by_millisecond = TableF32::new(&motion, Tick::hertz(1000)?)?;

    // an interrupt every 100 s or so, never on time
    let mut count = Count::default();
    let mut tick = 0;
    for late in [7, 301, 0, 12_345].into_iter().cycle() {
        tick += 100 * i64::from(TIMER) + late;
        assert_eq!(count.widened(tick as u32), tick, "the low 32 bits tell the count");
        if tick > HOUR {
            break;
        }
    }
    let now = by_timer.at_tick(count.0);
    println!("count {}, {} wraps: quaternion {:?}", count.0, count.0 >> 32, now.quaternion());

    // the same motion at the same time
    let expected = by_millisecond.at_tick(3_600_000).orientation();
    let error = by_timer.at_tick(HOUR).orientation().distance(&expected);
    let bound = by_timer.error_bound_at(HOUR);
    println!("after an hour: bound {bound:.1e} rad, {error:.1e} rad from ticks of 1 ms");
    assert!(bound < 1.8e-7 && f64::from(error) < bound + by_millisecond.error_bound_at(3_600_000));
    Ok(())
}
