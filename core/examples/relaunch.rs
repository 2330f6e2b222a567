//! Relaunch after an impulse: a stroke changes ω at once and leaves the orientation as it is.
//!
//! The motion after the stroke is another exact motion, with a table of its own. Its ticks are counted as before: the tick of the
//! stroke is the epoch of the new table. The cursor is replaced together with the table; the firmware example
//! `relaunch` does so between two ticks of a running interrupt.

use toytop::{
    Motion, PointImpulse, Release, State, TableF64, TableMemory, TableSettings, Tick, Top, TopParameters,
    Workspace,
};

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let top = Top::sliding(&TopParameters::TOY)?;
    let state = State::from_release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() })?;
    let settings = TableSettings::new(Tick::hertz(1000)?);
    let mut workspace = Workspace::new();
    let [mut first, mut second] = [(); 2].map(|()| TableMemory::<TableF64>::new());
    let before = first.set_up(&mut workspace, &Motion::launch(&top, &state)?, settings, &mut || {})?;

    // At tick 250 a stick strikes the rim with 2 mN s: 25 mm from the axis, at the height of the centre of mass, along the
    // second fixed axis.
    let struck_at: u16 = 250;
    let state = before.at_tick(struck_at.into()).state()?;
    let stroke = PointImpulse { impulse: [0.0, 2.0e-3, 0.0], point: [0.025, 0.0, 0.03] };
    let [.., pressure] = state.reaction_impulse(&top, &stroke)?;
    println!("the plane answers with {pressure:.1e} N s; if that were negative, the top would leave it");
    let motion = Motion::launch(&top, &state.with_impulse(&top, &stroke)?)?;
    let settings = TableSettings { epoch: struck_at.into(), ..settings };
    let after = second.set_up(&mut workspace, &motion, settings, &mut || {})?;

    let [old, new] = [before, after].map(|table| table.at_tick(struck_at.into()));
    let jump = old.orientation().distance(&new.orientation());
    println!("the orientation jumps by {jump:.1e} rad");
    println!("omega before: {:?} rad/s", old.omega());
    println!("omega after:  {:?} rad/s", new.omega());
    assert!(jump < 1e-12 && pressure > 0.0);
    for (stated, found) in state.with_impulse(&top, &stroke)?.omega().into_iter().zip(new.omega()) {
        assert!((stated - found).abs() < 1e-9, "{stated} {found}");
    }

    // Ticks go on from table to table.
    let mut cursor = before.cursor(struck_at.into());
    println!("u at tick {struck_at}: {}", cursor.next(before).u());
    cursor = after.cursor(cursor.tick() + 1);
    println!("u at tick {}: {}", struck_at + 1, cursor.next(after).u());
    assert_eq!(cursor.tick(), i64::from(struck_at) + 1);
    Ok(())
}
