//! Largest root of a cubic.

use crate::integer::{exponent, power_of_two};
use crate::scalar::{Extended, Float, Ring};

/// Cubic y³ + g₂ y² + g₁ y + g₀ that is convex from its largest root on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cubic {
    pub(crate) g0: Extended,
    pub(crate) g1: Extended,
    pub(crate) g2: Extended,
}

impl Cubic {
    fn value(&self, y: Extended) -> Extended {
        ((y + self.g2) * y + self.g1) * y + self.g0
    }

    fn slope(&self, y: Extended) -> Extended {
        ((y + y + y) + self.g2.doubled()) * y + self.g1
    }

    /// Simple root, improved from an approximate value by three steps of Newton's method.
    pub(crate) fn refined(&self, start: Extended) -> Extended {
        (0..3).fold(start, |y, _| {
            let slope = self.slope(y);
            if slope == Extended::ZERO { y } else { y - self.value(y) / slope }
        })
    }

    /// Upper bound on the largest root, from which linear convergence takes few steps.
    fn upper_bound(&self) -> Extended {
        let Self { g0, g1, g2 } = *self;
        let zero = Extended::ZERO;
        // a power of two, because libm's cube root takes much flash
        let cube_root = Extended::from(power_of_two((exponent(g0.to_f64()) + 2).div_euclid(3)));
        let bound = g2.abs().larger_or_nan(g1.abs().sqrt()).larger_or_nan(cube_root).doubled();
        if g2 <= zero {
            return bound;
        }
        // y³ >= 0 at every iterate, so the root of the quadratic is another upper bound, close for small coefficients
        let root = (g1.squared() - (g2 * g0).doubled().doubled()).sqrt();
        let of_quadratic = if g1 > zero { -g0.doubled() / (g1 + root) } else { (root - g1) / g2.doubled() };
        let of_quadratic = of_quadratic * Extended::from(1.0 + 1e-15);
        if of_quadratic < bound { of_quadratic.larger_or_nan(zero) } else { bound }
    }

    /// Largest root, by Newton's method from above.
    pub(crate) fn largest_root(&self, pause: &mut dyn FnMut()) -> Extended {
        const MAX_STEPS: u32 = 200;
        let mut y = self.upper_bound();
        for _ in 0..MAX_STEPS {
            let value = self.value(y);
            let slope = self.slope(y);
            if value <= Extended::ZERO || slope <= Extended::ZERO {
                break;
            }
            let next = y - value / slope;
            if next >= y {
                break;
            }
            y = next;
            pause();
        }
        y
    }
}
