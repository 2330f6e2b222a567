//! Division of the half period into nodes: their number, and sines and cosines of their angles.

use crate::scalar::{Float, Ring};

/// Largest number of nodes on half a period. A motion with m₁ = 1e-300 needs 2560.
pub(super) const MOST_NODES: u32 = 1 << 13;

/// First division of the half period, into 1, 3 or 5 parts, and the number of nodes, at least `nodes`, after two or more
/// doublings. The estimate of the error needs two.
pub(super) fn division(nodes: f64) -> (u32, u32) {
    let doubled = |division: u32| {
        let mut count = 4 * division;
        while f64::from(count) < nodes && count < MOST_NODES {
            count *= 2;
        }
        (division, count)
    };
    let fewer = |a: (u32, u32), b: (u32, u32)| if b.1 < a.1 { b } else { a };
    fewer(fewer(doubled(1), doubled(3)), doubled(5))
}

/// Sine and cosine of a right angle divided by 1, 3 or 5.
pub(super) fn part_of_right_angle<N: Float>(division: u32) -> [N; 2] {
    let sine = match division {
        3 => N::ONE.halved(),
        5 => (N::from_f64(5.0).sqrt() - N::ONE).halved().halved(),
        _ => return [N::ONE, N::ZERO],
    };
    [sine, (N::ONE - sine * sine).sqrt()]
}

pub(super) fn sum_of_angles<N: Ring>([sine, cosine]: [N; 2], [other_sine, other_cosine]: [N; 2]) -> [N; 2] {
    [sine * other_cosine + cosine * other_sine, cosine * other_cosine - sine * other_sine]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::landen::Landen;
    use crate::scalar::Extended;

    /// K'/K is 1 for m = 1/2, so that the error decreases by 2π/ln 2 bits a node; K grows with the logarithm of m₁.
    #[test]
    fn the_number_of_nodes_is_known_beforehand() {
        let nodes = |m1: f64| {
            let m1 = Extended::from(m1);
            let mut landen = Landen::NONE;
            landen.fill([Extended::ONE - m1, m1], &mut || {});
            (landen.bits_per_node(), division(105.0 / landen.bits_per_node()).1)
        };
        let (bits, _) = nodes(0.5);
        assert!(
            (bits / (2.0 * core::f64::consts::PI / core::f64::consts::LN_2) - 1.0).abs() < 0.02,
            "{bits}"
        );
        assert_eq!([0.5, 1e-15, 1e-300].map(|m1| nodes(m1).1), [12, 160, 2560]);
    }
}
