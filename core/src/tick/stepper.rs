//! The incremental propagator: one Runge-Kutta step of three phases a tick.
//!
//! Only the half phase χ and the slow phases ψ_A and ψ_B are integrated, and their rates depend on χ alone. Orientation,
//! unit norm and first integrals are functions of the phases, so no step size can make |Φ|, l, n or h drift; a step's
//! error is an error *along* the motion. The phases are integers in turns: they lose nothing as they grow, in `f32` too.

use super::Pose;
use super::tip::{Tip, TipLaw};
use crate::cayley_klein::{Brackets, Place};
use crate::complex::Complex;
use crate::launch::{Course, Motion};
use crate::nutation::{Nutation, PhaseRates, gudermannian};
use crate::real::{Float, Real};
use crate::su2::Phi;
use crate::turns::{Rate, Turns};

/// Steps a motion through time; dt may change from call to call and have either sign.
///
/// Fourth order in dt. With 4096 steps a period in `f64`, 512 in `f32`, the error over ten periods is below 1e-12 rad and 1e-5
/// away from the separatrix (`toytop compare` prints it). A step costs four evaluations of the law: 4 sine-cosine
/// pairs (4 exponentials and as many of `expm1` if the motion is aperiodic), 4 square roots and 12 divisions; no step is ever
/// divided.
///
/// Where u is constant (regular precession, sleeping, hanging) a step is exact for any dt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stepper<R> {
    brackets: Brackets<R>,
    law: Nutation<R>,
    tip: TipLaw<R>,
    course: Moving<R>,
    /// A and B.
    phases: [Turns; 2],
    /// τ/2: in turns for the phases, in rad per unit time for their rates.
    drift: (Rate, R),
    /// φ less the sum of the continued arguments, in which it is read off; `None` where φ does not exist.
    phi_origin: Option<Turns>,
}

/// The course of [`Motion`], under way.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Moving<R> {
    /// The rates of A and B, in turns and in rad per unit time.
    Steady([(Rate, R); 2]),
    Nutating(Turns),
    Aperiodic(Compensated<R>),
}

/// A sum of many small terms, with what its rounding leaves over (Knuth's exact addition).
#[derive(Clone, Copy, Debug, PartialEq)]
struct Compensated<R> {
    sum: R,
    rest: R,
}

impl<R: Real> Compensated<R> {
    fn plus(self, term: R) -> Self {
        let term = term + self.rest;
        let sum = self.sum + term;
        let from_term = sum - self.sum;
        Self { sum, rest: (self.sum - (sum - from_term)) + (term - from_term) }
    }

    /// Held within ±1e30, where cos χ has long been 0, so that a step of any size leaves a number.
    fn bounded(self) -> Self {
        let far = R::from_f64(1e30);
        if self.sum.abs() <= far {
            return self;
        }
        Self { sum: if self.sum < R::ZERO { -far } else { far }, rest: R::ZERO }
    }
}

/// Radians of the scalar as an integer phase.
fn turns<R: Real>(radians: R) -> Turns {
    Turns::new((radians * R::from_f64(0.5 * core::f64::consts::FRAC_1_PI)).to_f64())
}

impl<R: Real> Stepper<R> {
    /// At t = 0 of the motion. Everything is computed in double-double and rounded once to `R`.
    #[must_use]
    pub fn new(motion: &Motion) -> Self {
        let (drift, drift_rate) = motion.drift();
        let course = match motion.course() {
            Course::Steady(rates) => {
                let [alpha, beta] = motion.steady_rates().map(|rate| R::from_f64(rate.to_f64()));
                let [alpha_turns, beta_turns] = rates;
                Moving::Steady([(alpha_turns, alpha), (beta_turns, beta)])
            }
            Course::Nutating(chi) => Moving::Nutating(chi),
            Course::Aperiodic(v) => {
                let sum = R::from_f64(v);
                Moving::Aperiodic(Compensated { sum, rest: R::from_f64(v - sum.to_f64()) })
            }
        };
        let mut stepper = Self {
            brackets: motion.brackets(),
            law: motion.law().cast(),
            tip: TipLaw::new(motion),
            course,
            phases: motion.phases(),
            drift: (drift, R::from_f64(drift_rate)),
            phi_origin: None,
        };
        if !motion.regime().is_vertical() {
            let place = stepper.place();
            let [alpha, beta] = stepper.phases;
            let arguments = stepper.brackets.alpha.argument(&place) + stepper.brackets.beta.argument(&place);
            stepper.phi_origin = Some((alpha + beta + arguments).principal() - stepper.continued_phi(&place));
        }
        stepper
    }

    /// The same motion with χ, A and B at another place of it.
    #[cfg(feature = "fixed")]
    pub(super) fn with_phases(mut self, [chi, alpha, beta]: [Turns; 3]) -> Self {
        if let Moving::Nutating(ours) = &mut self.course {
            *ours = chi;
        }
        self.phases = [alpha, beta];
        self
    }

    /// Advances by dt, in the motion's unit of time. A dt that is not finite advances by nothing.
    pub fn step(&mut self, dt: R) {
        if !dt.to_f64().is_finite() {
            return;
        }
        match self.course {
            Moving::Steady(rates) => {
                let elapsed = dt.to_f64();
                for (phase, (rate, _)) in self.phases.iter_mut().zip(rates) {
                    *phase += rate.over(elapsed);
                }
            }
            Moving::Nutating(chi) => {
                let change = runge_kutta(dt, |delta| self.nutating_rates(chi + turns(delta)));
                self.course = Moving::Nutating(chi + turns(change.nutation));
                self.drift_on(dt, &change);
            }
            Moving::Aperiodic(v) => {
                let change = runge_kutta(dt, |delta| {
                    let (tanh, sech) = gudermannian(v.plus(delta).sum);
                    self.law.aperiodic_rates(tanh, sech)
                });
                self.course = Moving::Aperiodic(v.plus(change.nutation).bounded());
                self.drift_on(dt, &change);
            }
        }
    }

    fn drift_on(&mut self, dt: R, change: &PhaseRates<R>) {
        let drift = self.drift.0.over(dt.to_f64());
        let [alpha, beta] = &mut self.phases;
        *alpha += turns(change.alpha) + drift;
        *beta += turns(change.beta) - drift;
    }

    fn nutating_rates(&self, chi: Turns) -> PhaseRates<R> {
        let (sine, cosine) = R::sine_cosine(chi);
        self.law.rates(sine, cosine)
    }

    /// The orientation Φ. Cost: three sine-cosine pairs and twelve products.
    #[must_use]
    pub fn phi(&self) -> Phi<R> {
        self.brackets.phi(&self.place())
    }

    /// Φ and Φ', from which u, u' and ω follow.
    #[must_use]
    pub fn pose(&self) -> Pose<R> {
        let place = self.place();
        Pose { phi: self.brackets.phi(&place), rate: self.brackets.rate(&place, &self.whole_rates(&place)) }
    }

    /// The tip: its place, velocity and angle.
    #[must_use]
    pub fn tip(&self) -> Tip<R> {
        let phi = self.phi_origin.map(|origin| origin + self.continued_phi(&self.place()));
        self.tip.tip(&self.pose(), phi)
    }

    fn place(&self) -> Place<R> {
        let (sine, cosine) = match self.course {
            Moving::Steady(_) => (R::ZERO, R::ONE),
            Moving::Nutating(chi) => R::sine_cosine(chi),
            Moving::Aperiodic(v) => gudermannian(v.sum),
        };
        let [alpha, beta] = self.phases.map(Complex::cis);
        Place { sine, cosine, alpha, beta }
    }

    /// The rates of χ, A and B at a place.
    fn whole_rates(&self, place: &Place<R>) -> PhaseRates<R> {
        let mut rates = match self.course {
            Moving::Steady([(_, alpha), (_, beta)]) => return PhaseRates { nutation: R::ZERO, alpha, beta },
            Moving::Nutating(_) => self.law.rates(place.sine, place.cosine),
            Moving::Aperiodic(_) => {
                let rates = self.law.aperiodic_rates(place.sine, place.cosine);
                PhaseRates { nutation: rates.nutation * place.cosine, ..rates } // χ' = v' sech v
            }
        };
        rates.alpha = rates.alpha + self.drift.1;
        rates.beta = rates.beta - self.drift.1;
        rates
    }

    /// arg α + arg β, continued along the motion.
    fn continued_phi(&self, place: &Place<R>) -> Turns {
        let [alpha, beta] = self.phases;
        let chi = match self.course {
            Moving::Steady(_) => Turns::ZERO,
            Moving::Nutating(chi) => chi,
            Moving::Aperiodic(_) => turns(R::atan2(place.sine, place.cosine)),
        };
        alpha
            + beta
            + self.brackets.alpha.continued_argument(place, chi)
            + self.brackets.beta.continued_argument(place, chi)
    }
}

/// The classical fourth-order step: changes of the phases over dt. The law is a function of the change of the nutation
/// phase since the start of the step.
fn runge_kutta<R: Real>(dt: R, rates: impl Fn(R) -> PhaseRates<R>) -> PhaseRates<R> {
    let half = dt.halved();
    let k1 = rates(R::ZERO);
    let k2 = rates(k1.nutation * half);
    let k3 = rates(k2.nutation * half);
    let k4 = rates(k3.nutation * dt);
    PhaseRates::weighted([k1, k2, k3, k4], dt * R::from_f64(1.0 / 6.0))
}
