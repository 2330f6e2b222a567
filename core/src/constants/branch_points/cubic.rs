//! Roots of a cubic with three real roots.

use crate::scalar::{Float, exponent, power_of_two};

/// Cubic y³ + g₂ y² + g₁ y + g₀, whose roots are real.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cubic<F> {
    pub(crate) g0: F,
    pub(crate) g1: F,
    pub(crate) g2: F,
}

impl<F: Float> Cubic<F> {
    #[inline(never)] // a call, because three functions evaluate the cubic in extended precision
    fn value(&self, y: F) -> F {
        ((y + self.g2) * y + self.g1) * y + self.g0
    }

    #[inline(never)]
    fn slope(&self, y: F) -> F {
        ((y + y + y) + self.g2.doubled()) * y + self.g1
    }

    /// Simple root, improved from an approximate value by three steps of Newton's method.
    pub(crate) fn polished(&self, start: F) -> F {
        (0..3).fold(start, |y, _| {
            let slope = self.slope(y);
            if slope == F::ZERO { y } else { y - self.value(y) / slope }
        })
    }

    /// Upper bound on the largest root, close to it.
    #[inline(never)] // the stack frames of a launch must not add up
    fn above(&self) -> F {
        let Self { g0, g1, g2 } = *self;
        let larger = |x: F, y: F| if x > y { x } else { y };
        // a power of two, because the cube root of libm would take much of a chip's flash
        let cube_root = F::from_f64(power_of_two((exponent(g0.to_f64()) + 2).div_euclid(3)));
        let above = larger(g2.abs(), larger(g1.abs().sqrt(), cube_root)).doubled();
        if g2 <= F::ZERO {
            return above;
        }
        // y³ >= 0 at every iterate, so the root of the quadratic is another upper bound; it is close where all three
        // coefficients are small
        let root = (g1.squared() - (g2 * g0).doubled().doubled()).sqrt();
        let of_quadratic =
            if g1 > F::ZERO { -g0.doubled() / (g1 + root) } else { (root - g1) / g2.doubled() };
        let of_quadratic = of_quadratic * F::from_f64(1.0 + 1e-15);
        if of_quadratic < above { larger(of_quadratic, F::ZERO) } else { above }
    }

    /// Upper bound on the largest root that is closer than `above`, by Newton's method in `f32`; `above` itself where rounding or the
    /// range of `f32` prevents it.
    fn closer(&self, above: F) -> F {
        const STEPS: usize = 10;
        /// Relative distance from the root that the roundings may leave.
        const MARGIN: f32 = 1e-6;
        let [g0, g1, g2] = [self.g0, self.g1, self.g2].map(|g| g.to_f64() as f32);
        let rounded = Cubic { g0, g1, g2 };
        let mut y = above.to_f64() as f32;
        for _ in 0..STEPS {
            let next = y - rounded.value(y) / rounded.slope(y);
            // NaN ends the steps, too
            if next < y * (1.0 - MARGIN) {
                y = next;
            } else {
                break;
            }
        }
        let closer = F::from_f64((y * (1.0 + MARGIN)).into());
        // above the point of inflection the cubic is convex: where it is positive and increases, no root is larger
        let is_above = closer < above
            && closer.doubled() + closer + self.g2 > F::ZERO
            && self.slope(closer) > F::ZERO
            && self.value(closer) > F::ZERO;
        if is_above { closer } else { above }
    }
}

/// Search for the largest root by Newton's method from above, where the iterates decrease monotonically.
///
/// Convergence to a double root is linear with factor 1/2, to a triple root with factor 2/3, so the starting value is
/// chosen close to the root.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LargestRoot<F> {
    cubic: Cubic<F>,
    y: F,
    steps: u32,
}

impl<F: Float> LargestRoot<F> {
    const MOST_STEPS: u32 = 200;
    /// Number of steps in a slice of a launch.
    const STEPS: u32 = 8;

    pub(crate) fn new(cubic: Cubic<F>) -> Self {
        Self { cubic, y: cubic.closer(cubic.above()), steps: 0 }
    }

    pub(crate) fn cubic(&self) -> &Cubic<F> {
        &self.cubic
    }

    /// Takes at most `STEPS` steps. Returns the root once it has converged.
    #[inline(never)] // the stack frames of a launch must not add up
    pub(crate) fn proceed(&mut self) -> Option<F> {
        for _ in 0..Self::STEPS {
            let (value, slope) = (self.cubic.value(self.y), self.cubic.slope(self.y));
            if value <= F::ZERO || slope <= F::ZERO || self.steps == Self::MOST_STEPS {
                return Some(self.y);
            }
            let next = self.y - value / slope;
            if next >= self.y {
                return Some(self.y);
            }
            (self.y, self.steps) = (next, self.steps + 1);
        }
        None
    }
}
