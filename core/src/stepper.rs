//! Stepper: integration of the motion by one Runge-Kutta step for three phases per time step.
//!
//! The rates depend on χ alone. Orientation and first integrals are functions of the phases, so |Φ|, l, n and h do not drift.

use crate::complex::Complex;
use crate::motion::attitude_state::AttitudeState;
use crate::motion::cayley_klein::{Ellipses, PhaseDirections};
use crate::motion::phase_equations::{PhaseEquations, PhaseRates, gudermannian};
use crate::motion::tip::TipConstants;
use crate::motion::{Motion, NutationVariable};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Real};
use crate::su2::Orientation;

/// Stepper of one motion. The steps may have different lengths and either sign.
///
/// Order 4 in dt. Error over ten periods, away from the separatrix: below 1e-12 rad with 4096 steps a period in `f64`, below
/// 1e-5 rad with 512 in `f32`. Where u is constant, a step is exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stepper<R> {
    ellipses: Ellipses<R>,
    equations: PhaseEquations<R>,
    tip: TipConstants<R>,
    nutation: CurrentNutation<R>,
    /// Slow phases A and B.
    phases: [Phase; 2],
    /// Rate τ/2: in turns per unit time for the phases, in rad per unit time for their rates.
    half_tau: (Extended, R),
    /// Difference of φ and the sum of the continued arguments of α and β; `None` where φ does not exist.
    phi_origin: Option<Phase>,
}

/// Variable of the nutation at the current time, by kind of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
enum CurrentNutation<R> {
    /// Rates of A and B, in turns and in rad per unit time.
    Steady([(Extended, R); 2]),
    Nutating(Phase),
    Aperiodic(Compensated<R>),
}

/// Sum of many small terms, with the rounding error of the last addition (Knuth's exact addition).
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

    /// Sum limited to ±1e30, where cos χ is 0 in every scalar, so that a step of any size gives a finite number.
    fn bounded(self) -> Self {
        let far = R::from_f64(1e30);
        if self.sum.abs() <= far {
            return self;
        }
        Self { sum: if self.sum < R::ZERO { -far } else { far }, rest: R::ZERO }
    }
}

/// Angle in rad as an integer phase.
fn turns<R: Real>(radians: R) -> Phase {
    Phase::new((radians * R::from_f64(0.5 * core::f64::consts::FRAC_1_PI)).to_f64())
}

impl<R: Real> Stepper<R> {
    /// Stepper at t = 0 of the motion. Its constants are computed in extended precision and rounded once to `R`.
    #[must_use]
    pub fn new(motion: &Motion) -> Self {
        // in turns and in rad
        let rate = |rate: Extended| (rate.in_turns(), R::from_f64(rate.to_f64()));
        let nutation = match motion.nutation {
            NutationVariable::Steady => CurrentNutation::Steady(motion.steady_rates().map(rate)),
            NutationVariable::Nutating(chi) => CurrentNutation::Nutating(chi),
            NutationVariable::Aperiodic(v) => {
                let sum = R::from_f64(v);
                CurrentNutation::Aperiodic(Compensated { sum, rest: R::from_f64(v - sum.to_f64()) })
            }
        };
        let mut stepper = Self {
            ellipses: motion.ellipses(),
            equations: motion.equations().cast(),
            tip: TipConstants::new(motion),
            nutation,
            phases: motion.phases,
            half_tau: rate(motion.half_tau),
            phi_origin: None,
        };
        if !motion.regime().is_vertical() {
            let directions = stepper.directions();
            let [alpha, beta] = stepper.phases;
            let arguments =
                stepper.ellipses.alpha.argument(&directions) + stepper.ellipses.beta.argument(&directions);
            stepper.phi_origin =
                Some((alpha + beta + arguments).principal() - stepper.continued_phi(&directions));
        }
        stepper
    }

    /// Advances by dt, in the motion's unit of time. A dt that is not finite counts as 0.
    pub fn step(&mut self, dt: R) {
        if !dt.to_f64().is_finite() {
            return;
        }
        match self.nutation {
            CurrentNutation::Steady(rates) => {
                let elapsed = Extended::from(dt.to_f64());
                for (phase, (rate, _)) in self.phases.iter_mut().zip(rates) {
                    *phase += (rate * elapsed).to_phase();
                }
            }
            CurrentNutation::Nutating(chi) => {
                let change = runge_kutta(dt, |delta| self.nutating_rates(chi + turns(delta)));
                self.nutation = CurrentNutation::Nutating(chi + turns(change.nutation));
                self.advance_slow_phases(dt, &change);
            }
            CurrentNutation::Aperiodic(v) => {
                let change = runge_kutta(dt, |delta| {
                    let (tanh, sech) = gudermannian(v.plus(delta).sum);
                    self.equations.aperiodic_rates(tanh, sech)
                });
                self.nutation = CurrentNutation::Aperiodic(v.plus(change.nutation).bounded());
                self.advance_slow_phases(dt, &change);
            }
        }
    }

    fn advance_slow_phases(&mut self, dt: R, change: &PhaseRates<R>) {
        let half_tau = (self.half_tau.0 * dt.to_f64().into()).to_phase();
        let [alpha, beta] = &mut self.phases;
        *alpha += turns(change.alpha) + half_tau;
        *beta += turns(change.beta) - half_tau;
    }

    fn nutating_rates(&self, chi: Phase) -> PhaseRates<R> {
        let (sine, cosine) = R::sine_cosine(chi);
        self.equations.rates(sine, cosine)
    }

    /// Orientation Φ. Cost: three sine-cosine pairs and twelve products.
    #[must_use]
    pub fn orientation(&self) -> Orientation<R> {
        self.ellipses.orientation(&self.directions())
    }

    /// Orientation and its rate, from which u' and the angular velocity follow.
    #[must_use]
    pub fn attitude_state(&self) -> AttitudeState<R> {
        let directions = self.directions();
        let rate = self.ellipses.rate(&directions, &self.whole_rates(&directions));
        AttitudeState { orientation: self.ellipses.orientation(&directions), rate }
    }

    /// Tip position c = 2 s αβ, in m, relative to the point of the plane below the centre of mass; for a fixed tip 2αβ.
    #[must_use]
    pub fn tip(&self) -> Complex<R> {
        self.tip.tip(&self.orientation())
    }

    /// Velocity c' of the tip, m per unit time.
    #[must_use]
    pub fn tip_velocity(&self) -> Complex<R> {
        self.tip.velocity(&self.attitude_state())
    }

    /// Tip angle φ = arg c, continuous from φ(0) in (-1/2, 1/2] turn; `None` where the axis is vertical at all times. Where the
    /// curve passes through the centre, the radius changes sign instead.
    #[must_use]
    pub fn tip_angle(&self) -> Option<Phase> {
        self.phi_origin.map(|origin| origin + self.continued_phi(&self.directions()))
    }

    /// Rate φ' of the tip angle, rad per unit time (equation (4.1) of the paper); at most the largest finite `f32`, and 0 where the
    /// axis is vertical at all times.
    #[must_use]
    pub fn tip_angle_rate(&self) -> R {
        self.tip.angle_rate(&self.orientation())
    }

    fn directions(&self) -> PhaseDirections<R> {
        let (sine, cosine) = match self.nutation {
            CurrentNutation::Steady(_) => (R::ZERO, R::ONE),
            CurrentNutation::Nutating(chi) => R::sine_cosine(chi),
            CurrentNutation::Aperiodic(v) => gudermannian(v.sum),
        };
        let [alpha, beta] = self.phases.map(Complex::cis);
        PhaseDirections { sine, cosine, alpha, beta }
    }

    /// Rates of χ, A and B at these phases, rad per unit time.
    fn whole_rates(&self, directions: &PhaseDirections<R>) -> PhaseRates<R> {
        let mut rates = match self.nutation {
            CurrentNutation::Steady([(_, alpha), (_, beta)]) => {
                return PhaseRates { nutation: R::ZERO, alpha, beta };
            }
            CurrentNutation::Nutating(_) => self.equations.rates(directions.sine, directions.cosine),
            CurrentNutation::Aperiodic(_) => {
                let rates = self.equations.aperiodic_rates(directions.sine, directions.cosine);
                PhaseRates { nutation: rates.nutation * directions.cosine, ..rates } // χ' = v' sech v
            }
        };
        rates.alpha = rates.alpha + self.half_tau.1;
        rates.beta = rates.beta - self.half_tau.1;
        rates
    }

    /// Sum arg α + arg β, continuous in time.
    fn continued_phi(&self, directions: &PhaseDirections<R>) -> Phase {
        let [alpha, beta] = self.phases;
        let chi = match self.nutation {
            CurrentNutation::Steady(_) => Phase::ZERO,
            CurrentNutation::Nutating(chi) => chi,
            CurrentNutation::Aperiodic(_) => turns(R::atan2(directions.sine, directions.cosine)),
        };
        alpha
            + beta
            + self.ellipses.alpha.continued_argument(directions, chi)
            + self.ellipses.beta.continued_argument(directions, chi)
    }
}

/// Changes of the phases over dt by a Runge-Kutta step of fourth order. The rates depend on the change of the nutation phase.
fn runge_kutta<R: Real>(dt: R, rates: impl Fn(R) -> PhaseRates<R>) -> PhaseRates<R> {
    let half = dt.halved();
    let k1 = rates(R::ZERO);
    let k2 = rates(k1.nutation * half);
    let k3 = rates(k2.nutation * half);
    let k4 = rates(k3.nutation * dt);
    PhaseRates::weighted([k1, k2, k3, k4], dt * R::from_f64(1.0 / 6.0))
}

#[cfg(feature = "defmt")]
impl<R: Real + defmt::Format> defmt::Format for Stepper<R> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "stepper at {}", self.orientation());
    }
}
