//! What a tick does, in f64: the increments of the three phases over one tick, as functions of χ at its start, and their
//! polynomials on a part of the circle.

use crate::launch::Motion;
use crate::nutation::series::{Expansion, Point, Slopes};
use crate::nutation::{Nutation, PhaseRates};
use crate::real::{Float, Scalar};
use crate::turns::Turns;

/// Coefficients a polynomial has at most.
pub(super) const MOST_TERMS: usize = 16;

/// Chebyshev terms that are computed and dropped: they tell what the polynomial misses.
const DROPPED: usize = 2;

/// The increments of χ, ψ_A and ψ_B in turns.
pub(super) type Increments = [f64; 3];

/// The flow of a motion's law over one tick.
pub(super) struct Flow {
    law: Nutation<f64>,
    /// Of a tick, in units of time.
    length: f64,
}

/// Three polynomials on [-1, 1], lowest power first, and the sum of what each leaves out.
pub(super) struct Fit {
    pub(super) polynomials: [[f64; MOST_TERMS]; 3],
    pub(super) missed: Increments,
}

impl Flow {
    pub(super) fn new(motion: &Motion, length: f64) -> Self {
        Self { law: motion.law().cast(), length }
    }

    /// Over a tick that starts at χ; NaN if the tick is so long that 256 series of 16 terms do not cover it.
    fn over_a_tick(&self, chi: Turns) -> Increments {
        const MOST_PIECES: u32 = 256;
        let start = point(chi);
        let mut expansion = Expansion::EMPTY;
        let mut pieces = 1;
        while pieces <= MOST_PIECES {
            let unit = self.length / f64::from(pieces);
            self.expand(&start, unit, &mut expansion);
            if expansion.left_out(1.0) <= LEFT_OUT {
                return self.march(start, &mut expansion, unit, pieces);
            }
            pieces *= 2;
        }
        [f64::NAN; 3]
    }

    /// `expansion` is that of the first piece.
    #[inline(never)] // set-up's frames should not add up on a small stack
    fn march(&self, start: Point, expansion: &mut Expansion, unit: f64, pieces: u32) -> Increments {
        let mut point = expansion.point(1.0);
        for _ in 1..pieces {
            self.expand(&point, unit, expansion);
            point = expansion.point(1.0);
        }
        increments(&start, &point)
    }

    /// Around a point, the slow phases with their whole rates.
    fn expand(&self, point: &Point, unit: f64, to: &mut Expansion) {
        let (sine, cosine) = point.sine_cosine();
        let rates = self.law.rates(sine, cosine);
        let [nutation, alpha, beta] = [rates.nutation, rates.alpha, rates.beta].map(|rate| rate * unit);
        let slopes = Slopes { psi: PhaseRates { nutation, alpha, beta }, theta: [alpha, beta], weight: 1.0 };
        self.law.expand(point, &slopes, unit, LEFT_OUT, to);
    }

    /// The law's series around χ, over a tick and what it takes to turn by `reach` rad.
    fn around(&self, chi: Turns, reach: f64) -> Neighbourhood<'_> {
        let centre = point(chi);
        let (sine, cosine) = centre.sine_cosine();
        let unit = self.length + reach / self.law.rates(sine, cosine).nutation;
        let mut expansion = Expansion::EMPTY;
        self.expand(&centre, unit, &mut expansion);
        Neighbourhood { flow: self, expansion, centre, unit }
    }

    /// The increments on segment `segment` of `segments` that cover half a turn of χ, by interpolation in Chebyshev's points.
    pub(super) fn fit(&self, segment: usize, segments: usize, terms: usize) -> Fit {
        let half_width = 0.25 / segments as f64; // in turns
        let centre = Turns::new((2 * segment + 1) as f64 * half_width);
        let neighbourhood = self.around(centre, half_width / PER_RADIAN);
        let terms = terms.min(MOST_TERMS);
        let nodes = terms + DROPPED;
        let mut chebyshev = [[0.0; MOST_TERMS + DROPPED]; 3];
        for node in 0..nodes {
            let (_, x) = f64::sine_cosine(Turns::new((node as f64 + 0.5) / (2 * nodes) as f64));
            let offset = x * half_width;
            let values = neighbourhood
                .tick_from(offset / PER_RADIAN)
                .unwrap_or_else(|| self.over_a_tick(centre + Turns::new(offset)));
            for (sums, value) in chebyshev.iter_mut().zip(values) {
                let (mut t, mut next) = (1.0, x);
                for (k, sum) in sums.iter_mut().enumerate().take(nodes) {
                    let weight = if k == 0 { 1.0 } else { 2.0 } / nodes as f64;
                    *sum += weight * value * t;
                    (t, next) = (next, 2.0 * x * next - t);
                }
            }
        }
        Fit {
            polynomials: chebyshev.map(|series| powers(&series, terms)),
            missed: chebyshev
                .map(|series| series.iter().skip(terms).fold(0.0, |sum, c| sum + Float::abs(*c))),
        }
    }
}

/// The motion near a point of it, by one series: good for most ticks that start there.
struct Neighbourhood<'a> {
    flow: &'a Flow,
    expansion: Expansion,
    centre: Point,
    /// Of the series, in units of time.
    unit: f64,
}

impl Neighbourhood<'_> {
    /// The tick that starts where χ is `offset` rad from the centre; `None` if the series does not reach so far.
    fn tick_from(&self, offset: f64) -> Option<Increments> {
        /// Each squares the error, and the first guess is good to a digit.
        const NEWTON_STEPS: usize = 5;
        let length = self.flow.length / self.unit;
        let (mut time, mut from) = (0.0, self.centre);
        for _ in 0..NEWTON_STEPS {
            let (sine, cosine) = from.sine_cosine();
            let rate = self.flow.law.rates(sine, cosine).nutation * self.unit;
            time -= ((from.chi - self.centre.chi).to_radians() - offset) / rate;
            from = self.expansion.point(time);
        }
        let reached = self.expansion.left_out(time).max(self.expansion.left_out(time + length));
        let to = self.expansion.point(time + length);
        let increments = increments(&from, &to);
        (reached <= LEFT_OUT).then_some(increments)
    }
}

/// What a series may leave out, rad.
const LEFT_OUT: f64 = 1e-16;

const PER_RADIAN: f64 = 0.5 * core::f64::consts::FRAC_1_PI;

/// At χ, with the slow phases counted from there.
fn point(chi: Turns) -> Point {
    Point { chi, ..Point::default() }
}

/// From one point to another.
fn increments(from: &Point, to: &Point) -> Increments {
    let ([alpha, beta], [alpha_next, beta_next]) = (from.theta, to.theta);
    [to.chi - from.chi, alpha_next - alpha, beta_next - beta].map(Turns::to_f64)
}

/// The coefficients of 1, x, x², ... of the first `terms` Chebyshev polynomials, by Clenshaw's recurrence.
fn powers(chebyshev: &[f64], terms: usize) -> [f64; MOST_TERMS] {
    let times_x = |p: &[f64; MOST_TERMS]| {
        let mut product = [0.0; MOST_TERMS];
        product.iter_mut().skip(1).zip(p).for_each(|(to, from)| *to = *from);
        product
    };
    let (mut b, mut later) = ([0.0; MOST_TERMS], [0.0; MOST_TERMS]);
    for (k, c) in chebyshev.iter().enumerate().take(terms).rev() {
        let factor = if k == 0 { 1.0 } else { 2.0 };
        let mut next = times_x(&b);
        next.iter_mut().zip(later).for_each(|(value, later)| *value = factor * *value - later);
        if let Some(constant) = next.first_mut() {
            *constant += c;
        }
        (b, later) = (next, b);
    }
    b
}
