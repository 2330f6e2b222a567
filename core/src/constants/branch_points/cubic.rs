//! Roots of a cubic with three real roots.

use crate::scalar::Float;

/// Largest root of y³ + g₂ y² + g₁ y + g₀ (all roots real), by Newton's method from above, where it decreases
/// monotonically.
///
/// Convergence to a double root is linear with factor 1/2, to a triple root with factor 2/3, so the starting value is
/// chosen close to the root.
pub(crate) fn largest_root<F: Float>(g0: F, g1: F, g2: F) -> F {
    const MOST_STEPS: usize = 200;
    let larger = |x: F, y: F| if x > y { x } else { y };
    let cube_root = F::from_f64(libm::cbrt(g0.abs().to_f64()));
    let mut y = larger(g2.abs(), larger(g1.abs().sqrt(), cube_root)).doubled();
    if g2 > F::ZERO {
        // y³ >= 0 at every iterate, so the root of the quadratic is another upper bound; it is close where all three
        // coefficients are small
        let root = (g1.squared() - (g2 * g0).doubled().doubled()).sqrt();
        let above = if g1 > F::ZERO { -g0.doubled() / (g1 + root) } else { (root - g1) / g2.doubled() };
        let above = above * F::from_f64(1.0 + 1e-15);
        y = if above < y { larger(above, F::ZERO) } else { y };
    }
    for _ in 0..MOST_STEPS {
        let value = ((y + g2) * y + g1) * y + g0;
        let slope = ((y + y + y) + g2.doubled()) * y + g1;
        if value <= F::ZERO || slope <= F::ZERO {
            break;
        }
        let next = y - value / slope;
        if next >= y {
            break;
        }
        y = next;
    }
    y
}

/// Simple root, improved from an approximate value by three steps of Newton's method.
pub(crate) fn polished<F: Float>(start: F, g0: F, g1: F, g2: F) -> F {
    (0..3).fold(start, |y, _| {
        let slope = ((y + y + y) + g2.doubled()) * y + g1;
        if slope == F::ZERO { y } else { y - (((y + g2) * y + g1) * y + g0) / slope }
    })
}
