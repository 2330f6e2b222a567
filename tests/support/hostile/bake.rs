//! Tables as literal data: nothing is lost on the way, and a changed one is refused.

use super::input::Input;
use toytop::{Baked, Ephemeris, Motion, Tick};

pub(super) fn run(bytes: &[u8]) {
    let mut input = Input::new(bytes);
    let double = input.byte() % 2 == 1;
    let Ok(motion) = input.motion() else { return };
    let Ok(tick) = input.tick(&motion) else { return };
    if double { in_f64(&motion, tick, &mut input) } else { in_f32(&motion, tick, &mut input) }
}

/// What is the same for both scalars, whose functions for constants have no trait.
macro_rules! there_and_back {
    ($name:ident, $scalar:ty, $changed:ident) => {
        fn $name(motion: &Motion, tick: Tick, input: &mut Input<'_>) {
            let Ok(ephemeris) = Ephemeris::<$scalar, 4, 6>::within(motion, tick, input.truncation()) else {
                return;
            };
            let baked = ephemeris.to_baked();
            let back = baked.ephemeris().unwrap_or_else(|error| panic!("{error}"));
            assert!(back == ephemeris && back.to_baked() == baked);
            let mut changed = baked;
            flip_head(&mut changed, input);
            assert!(changed.ephemeris().is_err());
            let mut changed = baked;
            let [segment, power, part, bit] = [input.byte(), input.byte(), input.byte(), input.byte()];
            let place = &mut changed.coefficients[usize::from(segment % 4)][usize::from(power % 6)];
            $changed(&mut place[usize::from(part % 4)], bit);
            assert!(changed.ephemeris().is_err());
        }
    };
}

there_and_back!(in_f32, f32, flip_i32);
there_and_back!(in_f64, f64, flip_f64);

fn flip_i32(number: &mut i32, bit: u8) {
    *number ^= 1 << (bit % 32);
}

fn flip_f64(number: &mut f64, bit: u8) {
    *number = f64::from_bits(number.to_bits() ^ (1 << (bit % 64)));
}

/// One bit of what is not the table.
fn flip_head<R: toytop::Tabular>(baked: &mut Baked<R, 4, 6>, input: &mut Input<'_>) {
    let [place, bit] = [input.byte(), input.byte()];
    let entry = usize::from(place / 16) % 3;
    match place % 8 {
        0 => baked.format ^= 1 << (bit % 32),
        1 => baked.checksum ^= 1 << (bit % 32),
        2 => baked.first[entry] ^= 1 << (bit % 64),
        3 => baked.step[entry][usize::from(bit) % 3] ^= 1 << (bit % 32),
        4 => flip_f64(&mut baked.exact_step[entry][usize::from(bit) % 2], bit),
        5 => flip_f64(&mut baked.ticks_per_time[entry % 2], bit),
        6 => flip_f64(&mut baked.bound[entry % 2], bit),
        _ => match &mut baked.horizon {
            Some(horizon) => horizon[entry % 2] ^= 1 << (bit % 64),
            None => baked.horizon = Some([0; 2]),
        },
    }
}
