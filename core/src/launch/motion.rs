//! A motion: everything about one throw that does not depend on time.

use super::averages::Averages;
use super::start::{Start, chi, half_phase, half_turns, slow_phase};
use super::{BranchPoints, FirstIntegrals, Regime, Signs, State, TipClass, normal_force};
use crate::cayley_klein::{Brackets, Place};
use crate::complex::Complex;
use crate::error::{LaunchError, finite, require};
use crate::nutation::{Nutation, gudermannian};
use crate::real::{DoubleDouble, Float, Ring, Scalar};
use crate::su2::PhiRate;
use crate::top::{Quantities, Support, Top};
use crate::turns::{Rate, Turns, in_turns};

/// One throw: regime, constants, and where it is at t = 0. Immutable; build any number of steppers from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    top: Top,
    signs: Signs,
    e: BranchPoints<DoubleDouble>,
    integrals: FirstIntegrals<DoubleDouble>,
    regime: Regime,
    course: Course,
    /// A and B, the slow phases of α and β, at t = 0.
    phases: [Turns; 2],
}

/// What changes with time besides the two slow phases, and its value at t = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Course {
    /// u is constant, the slow phases turn at these rates.
    Steady([Rate; 2]),
    /// χ.
    Nutating(Turns),
    /// v, with χ = gd v.
    Aperiodic(f64),
}

impl Motion {
    /// From a state. The state's numbers count as exact; all of set-up is in double-double, so what is stored is good to
    /// an `f64` rounding.
    ///
    /// # Errors
    /// `omega`: so fast that e₃ would exceed 1e14.
    pub fn launch(top: &Top, state: &State) -> Result<Self, LaunchError> {
        let (integrals, point) = FirstIntegrals::with_point(top, state);
        let signs = integrals.signs();
        let e = BranchPoints::about(top, &integrals, &point)?;
        let upright = point.one_minus_u == DoubleDouble::ZERO && point.excess == DoubleDouble::ZERO;
        let regime = Regime::of(&e, signs, upright);

        let (phi, omega) = state.exact::<DoubleDouble>();
        let rate = PhiRate::from_fixed(&phi, omega);
        let [alpha, beta] =
            [(phi.alpha, rate.alpha), (phi.beta, rate.beta)].map(|(z, z_dot)| [z, z_dot].map(to_f64));
        let mut motion = Self {
            top: *top,
            signs,
            e,
            integrals,
            regime,
            course: Course::Nutating(Turns::ZERO),
            phases: [Turns::ZERO; 2],
        };
        if motion.stands_still() {
            motion.course = motion.steady_course();
            motion.phases = [alpha, beta].map(|[z, _]| Turns::from_radians(z.arg()));
            return Ok(motion);
        }
        let d = motion.a_over_p() + motion.quantities().s * point.one_minus_u * point.one_plus_u;
        let g0 = d * point.udot.squared() / DoubleDouble::from(top.g()).doubled();
        let (sine, cosine) = half_phase(&e, &point, g0, regime == Regime::Aperiodic);
        motion.course = if regime == Regime::Aperiodic {
            Course::Aperiodic(libm::asinh(sine / cosine))
        } else {
            Course::Nutating(chi(sine, cosine))
        };
        let place = motion.place_at_start();
        let mut rates = motion.law().cast().rates(place.sine, place.cosine);
        let drift = motion.half_tau().to_f64();
        (rates.alpha, rates.beta) = (rates.alpha + drift, rates.beta - drift);
        let brackets = motion.brackets();
        motion.phases = [
            slow_phase(&brackets.alpha, &place, [rates.nutation, rates.alpha], alpha),
            slow_phase(&brackets.beta, &place, [rates.nutation, rates.beta], beta),
        ];
        Ok(motion)
    }

    /// From branch points -1 <= e₁ <= e₂ <= 1 <= e₃ (which count as exact), the signs of l + n and l - n, and where on
    /// the curve it starts.
    ///
    /// # Errors
    /// `e1`, `e2`, `e3`, `nutation_phase`, `arg_alpha`, `arg_beta`: not finite or out of order; the three angles must be
    /// within ±1e6 rad.
    pub fn from_branch_points(
        top: &Top,
        e: [f64; 3],
        signs: Signs,
        start: &Start,
    ) -> Result<Self, LaunchError> {
        let [e1, e2, e3] = e;
        let e = BranchPoints::exact(e1, e2, e3)?;
        let Start { theta, arg_alpha, arg_beta } = *start;
        for (name, angle) in [("theta", theta), ("arg_alpha", arg_alpha), ("arg_beta", arg_beta)] {
            finite(name, angle)?;
            require(Float::abs(angle) <= 1e6, name, "between -1e6 and 1e6 rad")?;
        }
        let integrals = e.integrals_in(top, signs);
        let chi = half_turns(theta);
        let upright = chi.halves().1 == Turns::QUARTER;
        let regime = Regime::of(&e, signs, upright);
        let given = [arg_alpha, arg_beta].map(|angle| Turns::of(in_turns(angle.into())));
        let mut motion =
            Self { top: *top, signs, e, integrals, regime, course: Course::Nutating(chi), phases: given };
        if motion.stands_still() {
            motion.course = motion.steady_course();
            return Ok(motion);
        }
        if regime == Regime::Aperiodic {
            let (sine, cosine) = f64::sine_cosine(chi);
            motion.course = Course::Aperiodic(libm::asinh(sine / cosine));
        }
        let place = motion.place_at_start();
        let brackets = motion.brackets();
        let [alpha, beta] = given;
        motion.phases = [alpha - brackets.alpha.argument(&place), beta - brackets.beta.argument(&place)];
        Ok(motion)
    }

    /// The top.
    #[must_use]
    pub fn top(&self) -> &Top {
        &self.top
    }

    /// The kind of motion.
    #[must_use]
    pub fn regime(&self) -> Regime {
        self.regime
    }

    /// The kind of curve the tip draws.
    #[must_use]
    pub fn tip_class(&self) -> TipClass {
        TipClass::of(self.regime, &self.e, self.signs)
    }

    /// l, n, h.
    #[must_use]
    pub fn first_integrals(&self) -> FirstIntegrals {
        self.integrals.to_f64()
    }

    /// e₁, e₂, e₃ and their differences.
    #[must_use]
    pub fn branch_points(&self) -> BranchPoints {
        self.e.to_f64()
    }

    /// The signs of l + n and l - n.
    #[must_use]
    pub fn signs(&self) -> Signs {
        self.signs
    }

    /// The nutation period and the turns of α and β in it; where u is constant, of the small nutation that a push would
    /// start. `None` where nothing comes back: aperiodic, sleeping unstable, and the border of sleep (e₁ = e₂ = e₃ = 1).
    ///
    /// Cost: a quadrature of some 16 to 128 nodes in double-double, up to 65536 where A/(ps) is tiny, every time it is called.
    #[must_use]
    pub fn averages(&self) -> Option<Averages> {
        (self.e.e3_minus_e2 > DoubleDouble::ZERO).then(|| self.exact_averages().0.to_f64())
    }

    /// The least normal force over the motion, in units of the weight: N = 1 + s u''/g. Below 0 a real top would leave
    /// the plane, and what is computed is not what it does. `None` for a fixed tip, whose joint pulls as well as pushes.
    #[must_use]
    pub fn min_normal_force(&self) -> Option<f64> {
        (self.top.support() == Support::Sliding).then(|| {
            if self.is_steady() {
                return 1.0;
            }
            normal_force::minimum(&self.e.to_f64(), self.a_over_p().to_f64(), self.top.s())
        })
    }

    fn quantities(&self) -> Quantities<DoubleDouble> {
        Quantities::of(&self.top)
    }

    /// A/p, m.
    fn a_over_p(&self) -> DoubleDouble {
        let Quantities { a, p, .. } = self.quantities();
        a / p
    }

    /// τ/2 = (1/C - 1/A) n/2, the rate at which a top with C ≠ A turns ahead of one with C = A, rad per unit time.
    pub(super) fn half_tau(&self) -> DoubleDouble {
        self.quantities().tau(self.integrals.n).halved()
    }

    /// The constant part of the rates of the slow phases, ±τ/2.
    pub(crate) fn drift(&self) -> (Rate, f64) {
        (rate_in_turns(self.half_tau()), self.half_tau().to_f64())
    }

    pub(crate) fn law(&self) -> Nutation<DoubleDouble> {
        Nutation::new(&self.top, &self.e, &self.integrals, self.signs)
    }

    pub(crate) fn brackets<R: Float>(&self) -> Brackets<R> {
        if self.is_steady() {
            let (one_plus_u, one_minus_u) = self.steady_tilt();
            Brackets::steady(one_plus_u, one_minus_u)
        } else {
            Brackets::swinging(&self.e, self.signs)
        }
    }

    pub(super) fn exact_branch_points(&self) -> &BranchPoints<DoubleDouble> {
        &self.e
    }

    pub(crate) fn course(&self) -> Course {
        self.course
    }

    /// χ at t = 0 of a motion that nutates.
    pub(crate) fn nutation_start(&self) -> Option<Turns> {
        match self.course {
            Course::Nutating(chi) => Some(chi),
            Course::Steady(_) | Course::Aperiodic(_) => None,
        }
    }

    pub(crate) fn phases(&self) -> [Turns; 2] {
        self.phases
    }

    /// 1 + u and 1 - u of a steady motion.
    fn steady_tilt(&self) -> (DoubleDouble, DoubleDouble) {
        if self.regime == Regime::SleepingUnstable {
            (DoubleDouble::from(2.0), DoubleDouble::ZERO)
        } else {
            (self.e.one_plus_e1, self.e.one_minus_e2)
        }
    }

    /// The rates of A and B where u is constant, rad per unit time: ((l ± n)/(A (1 ± u)) ± τ)/2, with the upper signs for A;
    /// 0 for a parameter that vanishes.
    pub(crate) fn steady_rates(&self) -> [DoubleDouble; 2] {
        let twice_a = DoubleDouble::from(self.top.a()).doubled();
        let (one_plus_u, one_minus_u) = self.steady_tilt();
        let rate = |momentum: DoubleDouble, complement: DoubleDouble, drift: DoubleDouble| {
            if complement > DoubleDouble::ZERO {
                momentum / (twice_a * complement) + drift
            } else {
                DoubleDouble::ZERO
            }
        };
        [
            rate(self.integrals.l_plus_n, one_plus_u, self.half_tau()),
            rate(self.integrals.l_minus_n, one_minus_u, -self.half_tau()),
        ]
    }

    /// Whether u is constant, exactly. A swing too small to see is still a swing: its mean rates are not those at one u.
    fn stands_still(&self) -> bool {
        self.e.e2_minus_e1 == DoubleDouble::ZERO || self.regime == Regime::SleepingUnstable
    }

    /// As [`Motion::stands_still`], once the course is known.
    pub(crate) fn is_steady(&self) -> bool {
        matches!(self.course, Course::Steady(_))
    }

    fn steady_course(&self) -> Course {
        Course::Steady(self.steady_rates().map(rate_in_turns))
    }

    /// The place at t = 0 with the slow phases taken off.
    fn place_at_start(&self) -> Place<f64> {
        let (sine, cosine) = match self.course {
            Course::Steady(_) => (0.0, 1.0),
            Course::Nutating(chi) => f64::sine_cosine(chi),
            Course::Aperiodic(v) => gudermannian(v),
        };
        Place { sine, cosine, alpha: Complex::ONE, beta: Complex::ONE }
    }
}

fn rate_in_turns(radians: DoubleDouble) -> Rate {
    let turns = in_turns(radians);
    Rate::new(turns.hi(), turns.lo())
}

fn to_f64(z: Complex<DoubleDouble>) -> Complex<f64> {
    Complex::new(z.re.to_f64(), z.im.to_f64())
}
