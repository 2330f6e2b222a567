//! Numbers with 17 significant digits, as `{:.16e}` writes them, but several times as fast.

/// Powers 5⁰ to 5³² of five, whose products with a number of 53 bits have at most 128 bits.
const POWERS_OF_5: [u128; 33] = {
    let mut powers = [1; 33];
    let mut k = 1;
    while k < powers.len() {
        powers[k] = 5 * powers[k - 1];
        k += 1;
    }
    powers
};

/// Appends a number with 17 significant digits; -0 is written as 0.
pub(crate) fn push(text: &mut Vec<u8>, x: f64) {
    match digits(x.abs()) {
        Some((digits, exponent)) => {
            if x < 0.0 {
                text.push(b'-');
            }
            push_digits(text, digits, exponent);
        }
        None => text.extend_from_slice(format!("{:.16e}", x + 0.0).as_bytes()),
    }
}

fn push_digits(text: &mut Vec<u8>, mut digits: u64, exponent: i32) {
    let mut places = [b'0'; 18];
    for place in places[2..].iter_mut().rev() {
        *place += (digits % 10) as u8;
        digits /= 10;
    }
    places[0] += digits as u8;
    places[1] = b'.';
    text.extend_from_slice(&places);
    text.push(b'e');
    if exponent < 0 {
        text.push(b'-');
    }
    let size = exponent.unsigned_abs() as u8;
    if size >= 10 {
        text.push(b'0' + size / 10);
    }
    text.push(b'0' + size % 10);
}

/// Digits of a number from 1e-16 to 2^53, correctly rounded, as a whole number of 17 digits, and the decimal exponent of the first digit.
fn digits(x: f64) -> Option<(u64, i32)> {
    const LEAST: u64 = 10_u64.pow(16);
    if !(1e-16..9e15).contains(&x) {
        return (x == 0.0).then_some((0, 0));
    }
    let bits = x.to_bits();
    // x = mantissa · 2^power, normal
    let mantissa = u128::from((bits & ((1 << 52) - 1)) | (1 << 52));
    let power = (bits >> 52) as i32 - 1075;
    // the decimal exponent, or one less
    let mut exponent = ((f64::from(power + 52)) * std::f64::consts::LOG10_2).floor() as i32;
    loop {
        // x · 10^k = mantissa · 5^k / 2^-(k + power)
        let k = 16 - exponent;
        let product = mantissa * POWERS_OF_5.get(k as usize)?;
        let shift = -(k + power);
        if !(1..128).contains(&shift) {
            return None;
        }
        let (whole, half) = ((product >> shift) as u64, 1_u128 << (shift - 1));
        let rest = product & ((1_u128 << shift) - 1);
        let up = rest > half || (rest == half && whole % 2 == 1);
        let rounded = whole + u64::from(up);
        if rounded < 10 * LEAST {
            return Some((rounded, exponent));
        }
        exponent += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::random::Random;

    #[test]
    fn the_same_as_the_standard_library() {
        let mut random = Random::new(7, 0);
        let mut numbers = vec![
            0.0,
            -0.0,
            1.0,
            -1.0,
            0.5,
            0.1,
            1e-16,
            9.999_999_999_999_999e-17,
            1e15,
            9e15,
            1e16,
            1e300,
            5e-324,
            0.3,
            0.999_999_999_999_999_9,
            9.999_999_999_999_998,
            f64::MAX,
            2.0_f64.powi(53),
            123_456_789.0,
        ];
        numbers.extend(
            (-16..16).flat_map(|k| [10_f64.powi(k), 10_f64.powi(k).next_down(), 10_f64.powi(k).next_up()]),
        );
        numbers.extend(
            (0..200_000).map(|_| random.scale(1e-18, 1e18) * if random.one_in(2) { -1.0 } else { 1.0 }),
        );
        numbers.extend((0..50_000).map(|_| (random.between(-1e6, 1e6)).round() / 1024.0));
        let mut text = Vec::new();
        for x in numbers {
            text.clear();
            push(&mut text, x);
            assert_eq!(String::from_utf8_lossy(&text), format!("{:.16e}", x + 0.0), "{x:e}");
        }
    }
}
