//! Choice of a propagator: table, cursor, stepper or closed form.
//!
//! | you need | use | why |
//! |---|---|---|
//! | the next tick, thousands of times a second | `Cursor` | cheapest; error bound for ever; needs set-up and a table |
//! | any tick or any time | `Table` | as exact, some more cycles |
//! | no table in RAM, or a new motion every few ticks | `Stepper` | set up without a table; the error grows with the periods |
//! | an independent check on a PC | `toytop-closed-forms` | the paper's closed forms, where they exist |
//! | firmware that never sets up | `Baked` | the table is computed on a PC: see the example `baked` |

use toytop::{Motion, Regime, Release, State, Stepper, TableF64, Tick, Top, TopParameters};

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let top = Top::sliding(&TopParameters::TOY)?;
    let state = State::from_release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() })?;
    let motion = Motion::launch(&top, &state)?;
    assert_eq!(motion.regime(), Regime::Nutating);

    // A table, then any tick.
    let table = TableF64::new(&motion, Tick::hertz(1000)?)?;
    // Consecutive ticks.
    let mut cursor = table.cursor(0);
    // No table; steps of any length.
    let mut stepper = Stepper::<f64>::new(&motion);
    let mut worst: f64 = 0.0;
    for tick in 0..2000 {
        let next = cursor.next(&table).orientation();
        assert_eq!(next, table.at_tick(tick).orientation(), "cursor and at_tick give the same bits");
        worst = worst.max(next.distance(&stepper.orientation()));
        stepper.step(0.001);
    }
    println!("table against stepper, two seconds in steps of 1 ms: {worst:.1e} rad");
    println!("error bound of the table there: {:.1e} rad", table.error_bound_at(2000));
    println!("size of the table: {} bytes", size_of_val(&table));
    println!("size of the stepper: {} bytes", size_of_val(&stepper));
    assert!(worst < 1e-3);
    Ok(())
}
