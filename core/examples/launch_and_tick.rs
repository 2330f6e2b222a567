//! Launch of a top, and its orientation at the ticks of an interrupt.
//!
//! Set-up runs once per launch and may refuse its input; what an interrupt calls cannot fail.

use toytop::{Motion, Release, State, TableF32, Tick, Top, TopParameters};

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let top = Top::sliding(&TopParameters::TOY)?;
    // The axis leans by 0.35 rad and rests; the body turns about its axis at 150 rad/s.
    let state = State::from_release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() })?;
    let motion = Motion::launch(&top, &state)?;
    let table = TableF32::new(&motion, Tick::hertz(1000)?)?;

    // The next tick, three additions after the last one.
    let mut cursor = table.cursor(0);
    for _ in 0..3 {
        let sample = cursor.next(&table);
        println!("tick {}: quaternion {:?}, u = {}", cursor.tick(), sample.quaternion(), sample.u());
    }

    // Any other tick costs little more, and the error bound is known before.
    let far = table.at_tick(1 << 40);
    println!("tick 2^40, after 35 years: tip {:?} m", far.tip());
    println!("error bound there: {:.1e} rad", table.error_bound_at(1 << 40));

    // Between two ticks, and what follows from the orientation's rate.
    let between = table.at(0.01234);
    println!("t = 12.34 ms: omega {:?} rad/s in the fixed frame", between.omega());

    let expected = table.at_tick(cursor.tick()).quaternion();
    let mut again = table.cursor(cursor.tick());
    assert_eq!(again.next(&table).quaternion(), expected, "cursor and at_tick give the same bits");
    assert!(table.error_bound_at(1 << 40) < 3e-6);
    Ok(())
}
