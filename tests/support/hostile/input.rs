//! What the bytes describe: tops, states, motions, ticks.
//!
//! A number is arbitrary bits or, so that constructors do not refuse nearly all, of any size that they might accept; which of
//! the two is said by a byte before it.

use arbitrary::Unstructured;
use toytop::{Complex, Heaviness, LaunchError, Motion, Phi, Release, Sign, Signs, Start, State, Tick, Top};

/// Reads the bytes from the front; those that are missing are 0.
pub(super) struct Input<'a>(Unstructured<'a>);

impl<'a> Input<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self(Unstructured::new(bytes))
    }

    pub(super) fn byte(&mut self) -> u8 {
        self.0.arbitrary().unwrap_or_default()
    }

    pub(super) fn word(&mut self) -> u32 {
        self.0.arbitrary().unwrap_or_default()
    }

    pub(super) fn wide(&mut self) -> i64 {
        self.0.arbitrary().unwrap_or_default()
    }

    /// Any bits.
    pub(super) fn bits(&mut self) -> f64 {
        f64::from_bits(self.wide() as u64)
    }

    /// In [0, 1), by 32 bits.
    fn share(&mut self) -> f64 {
        f64::from(self.word()) / (1_u64 << 32) as f64
    }

    /// 10^x for x in a range; from one byte in 16 on, any bits instead.
    fn decade(&mut self, low: f64, high: f64) -> f64 {
        match self.byte() {
            0xf0.. => self.bits(),
            _ => 10_f64.powf(low + (high - low) * self.share()),
        }
    }

    /// Of either sign and any size up to 10^high, or 0; or any bits.
    pub(super) fn signed(&mut self, low: f64, high: f64) -> f64 {
        match self.byte() {
            0xf0.. => self.bits(),
            0xe0.. => 0.0,
            choice => {
                let size = 10_f64.powf(low + (high - low) * self.share());
                if choice % 2 == 0 { size } else { -size }
            }
        }
    }

    /// One of the numbers that cases are told by, one beside it, or any between 0 and `most`.
    fn place(&mut self, most: f64) -> f64 {
        let near = |input: &mut Self| 10_f64.powf(-20.0 * input.share());
        match self.byte() {
            0xf0.. => self.bits(),
            0xe0.. => 0.0,
            0xd0.. => most,
            0xb0.. => most * near(self),
            0x90.. => most * (1.0 - near(self)),
            _ => most * self.share(),
        }
    }

    /// A top of either support; most are accepted.
    fn top(&mut self) -> Result<Top, LaunchError> {
        let kind = self.byte() % 4;
        let a = self.decade(-6.0, 4.0);
        let c = a * self.decade(-6.5, 0.5);
        let s = self.decade(-4.0, 2.0);
        let g = self.decade(-3.0, 3.0);
        // A/(ps) decides how hard a top is
        let moment = a / (s * self.decade(-6.5, 6.5));
        match kind {
            0 => Top::sliding(a, c, s, Heaviness::MassMoment(moment), g),
            1 => Top::sliding(a, c, s, Heaviness::Mass(moment / s), g),
            2 => Top::fixed(a, c, moment, g),
            _ => Top::fixed_with_mass(a, c, s, moment / s, g),
        }
    }

    /// Orientation and ω in rates of the top's fall.
    fn state(&mut self, unit: f64) -> Result<State, LaunchError> {
        if self.byte().is_multiple_of(2) {
            let mut rate = || unit * self.signed(-20.0, 8.0);
            let (spin, precession, nutation) = (rate(), rate(), rate());
            let tilt = self.place(std::f64::consts::PI);
            let (azimuth, roll) = (self.signed(-3.0, 6.1), self.signed(-3.0, 6.1));
            return State::release(&Release { tilt, azimuth, roll, spin, precession, nutation });
        }
        let [re_alpha, im_alpha, re_beta, im_beta] = std::array::from_fn(|_| self.signed(-70.0, 0.1));
        let omega = std::array::from_fn(|_| unit * self.signed(-70.0, 8.0));
        let norm = match self.byte() {
            0..=1 => 1.0,
            _ => (re_alpha * re_alpha + im_alpha * im_alpha + re_beta * re_beta + im_beta * im_beta).sqrt(),
        };
        let part = |re: f64, im: f64| Complex::new(re / norm, im / norm);
        State::new(Phi { alpha: part(re_alpha, im_alpha), beta: part(re_beta, im_beta) }, omega)
    }

    /// A launch from a state or from branch points.
    pub(super) fn motion(&mut self) -> Result<Motion, LaunchError> {
        let top = self.top()?;
        if self.byte().is_multiple_of(2) {
            return Motion::launch(&top, &self.state((top.p() * top.g() / top.a()).sqrt())?);
        }
        let e1 = self.place(2.0) - 1.0;
        let e2 = e1 + self.place(1.0 - e1);
        let e3 = 1.0 + self.signed(-20.0, 14.1).abs();
        let signs = self.byte();
        let sign = |bit: u8| if signs & bit == 0 { Sign::Plus } else { Sign::Minus };
        let signs = Signs { l_plus_n: sign(1), l_minus_n: sign(2) };
        let theta = match self.byte() {
            choice @ 0..8 => f64::from(choice) * std::f64::consts::FRAC_PI_2,
            _ => self.signed(-20.0, 6.1),
        };
        let start = Start { theta, arg_alpha: self.signed(-3.0, 6.1), arg_beta: self.signed(-3.0, 6.1) };
        Motion::from_branch_points(&top, [e1, e2, e3], signs, &start)
    }

    /// Mostly between a tenth and a millionth of the nutation period.
    pub(super) fn tick(&mut self, motion: &Motion) -> Result<Tick, LaunchError> {
        if self.byte() >= 0xe0 {
            return Tick::ratio(self.word(), self.word());
        }
        let period = motion.averages().map_or(1.0, |averages| averages.period);
        let length = (period * self.decade(-6.0, 0.0)).clamp(1e-9, 1e9);
        let seconds = if length < 1.0 { 1.0 } else { length.ceil() };
        Tick::ratio((seconds / length).round() as u32, seconds as u32)
    }

    /// How far a table may miss: mostly what a small one can.
    pub(super) fn truncation(&mut self) -> f64 {
        self.decade(-8.0, 2.0)
    }
}
