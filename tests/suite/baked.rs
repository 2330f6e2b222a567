//! An ephemeris as literal data: nothing is lost, and nothing that was changed is read.

use fixed::types::{I2F14, I2F30};
use toytop::{Baked, BakedError, Ephemeris, Tick};
use toytop_tests::vectors;

#[test]
fn there_and_back_to_the_bit() {
    let (mut fitting, mut fitting_fixed, mut aperiodic) = (0, 0, 0);
    for vector in vectors::all() {
        let (name, motion) = (&vector.name, vector.motion().unwrap());
        let single = Ephemeris::<f32, 256, 7>::new(&motion, Tick::hertz(1000).unwrap()).unwrap();
        let baked = single.to_baked();
        let back = baked.ephemeris().unwrap();
        assert!(back == single, "{name}");
        // the checksum sees the sign of a zero, which `==` does not
        assert_eq!(back.to_baked().checksum, baked.checksum, "{name}");
        aperiodic += u32::from(baked.horizon.is_some());
        if let Ok(long) = Ephemeris::<I2F30, 256, 7>::new(&motion, Tick::hertz(8000).unwrap()) {
            let baked = long.to_baked();
            let back = baked.ephemeris().unwrap();
            assert!(back == long && back.to_baked().checksum == baked.checksum, "{name}");
            // the same numbers are no table of another scalar
            assert_ne!(baked.checksum, single.to_baked().checksum, "{name}");
            fitting_fixed += 1;
        }
        if let Ok(short) = Ephemeris::<I2F14, 128, 4>::new(&motion, Tick::hertz(8000).unwrap()) {
            let mut baked = short.to_baked();
            let back = baked.ephemeris().unwrap();
            assert!(back == short && back.to_baked().checksum == baked.checksum, "{name}");
            baked.coefficients[127][3][3] ^= 1;
            assert!(baked.ephemeris().is_err(), "{name}");
            fitting_fixed += 1;
        }
        if let Ok(double) = Ephemeris::<f64, 256, 12>::new(&motion, Tick::ratio(44_100, 2).unwrap()) {
            let baked = double.to_baked();
            let back = baked.ephemeris().unwrap();
            assert!(back == double && back.to_baked().checksum == baked.checksum, "{name}");
            for n in [0, 77, -1 << 40, i64::MAX] {
                assert_eq!(back.at_tick(n).phi_and_tip(), double.at_tick(n).phi_and_tip(), "{name}");
            }
            let both = [&back, &double].map(|table| (table.at(0.1).pose(), table.error_bound()));
            assert_eq!(both[0], both[1], "{name}");
            fitting += 1;
        }
    }
    assert!(fitting_fixed > 110, "{fitting_fixed} tables in fixed point");
    assert!(fitting > 40 && aperiodic >= 3, "{fitting} motions in f64, {aperiodic} aperiodic ones");
}

/// What is done to one number.
type Change = fn(&mut Baked<f32, 25, 5>);

fn refused(baked: Baked<f32, 25, 5>, change: Change) -> Option<BakedError> {
    let mut changed = baked;
    change(&mut changed);
    changed.ephemeris().err()
}

#[test]
fn a_bit_flipped_anywhere_is_refused() {
    let motion = vectors::named("exact_generic_pp").motion().unwrap();
    let baked = Ephemeris::<f32, 25, 5>::new(&motion, Tick::hertz(1000).unwrap()).unwrap().to_baked();
    let changes: [Change; 13] = [
        |baked| baked.checksum ^= 1 << 31,
        |baked| baked.first[1] ^= 1 << 63,
        |baked| baked.step[2][0] ^= 1,
        |baked| baked.exact_step[0][1] = f64::from_bits(baked.exact_step[0][1].to_bits() ^ 1),
        |baked| baked.ticks_per_time[1] = -baked.ticks_per_time[1],
        |baked| baked.horizon = Some([0; 2]),
        |baked| baked.bound[0] = f64::from_bits(baked.bound[0].to_bits() ^ 1),
        |baked| baked.tip_scale = -baked.tip_scale,
        |baked| baked.rates[0] = f32::from_bits(baked.rates[0].to_bits() ^ 1),
        |baked| baked.cells[15] ^= 1,
        |baked| baked.coefficients[0][0][0] ^= 1,
        |baked| baked.coefficients[24][4][3] ^= 1 << 31,
        |baked| baked.coefficients.swap(3, 4),
    ];
    for (index, change) in changes.into_iter().enumerate() {
        assert!(matches!(refused(baked, change), Some(BakedError::Checksum { .. })), "{index}");
    }
    assert_eq!(refused(baked, |baked| baked.format += 1), Some(BakedError::Format { found: 3 }));
    // every bit of every coefficient
    for segment in 0..25 {
        for bit in 0..5 * 4 * 32 {
            let mut changed = baked;
            changed.coefficients[segment][bit / 128][bit / 32 % 4] ^= 1 << (bit % 32);
            assert!(changed.ephemeris().is_err(), "{segment} {bit}");
        }
    }
}

#[test]
fn what_is_wrong_is_said() {
    let checksum = BakedError::Checksum { stated: 0xab, computed: 0x1234_5678 };
    assert_eq!(checksum.to_string(), "checksum: must be 0x12345678, not 0x000000ab: the data were changed");
    assert_eq!(BakedError::Format { found: 7 }.to_string(), "format: must be 2, not 7");
}
