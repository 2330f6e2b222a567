//! Interpretation of the bytes: tops, states, motions, ticks.
//!
//! A number is either an arbitrary bit pattern or, so that the constructors do not refuse almost all inputs, a number
//! of a size that they may accept. A byte before the number selects which.

use arbitrary::Unstructured;
use toytop::{
    Complex, InitialAngles, Motion, Orientation, ParameterError, Release, Sign, Signs, State, Tick, Top,
    TopParameters,
};

/// Reader of the bytes from the front; missing bytes count as 0.
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

    /// Number with an arbitrary bit pattern.
    pub(super) fn bits(&mut self) -> f64 {
        f64::from_bits(self.wide() as u64)
    }

    /// Number in [0, 1), from 32 bits.
    fn fraction(&mut self) -> f64 {
        f64::from(self.word()) / (1_u64 << 32) as f64
    }

    /// Number 10^x for x in a range; in one case of 16 an arbitrary bit pattern.
    fn decade(&mut self, low: f64, high: f64) -> f64 {
        match self.byte() {
            0xf0.. => self.bits(),
            _ => 10_f64.powf(low + (high - low) * self.fraction()),
        }
    }

    /// Number of either sign with a magnitude of up to 10^high, or 0, or an arbitrary bit pattern.
    pub(super) fn signed(&mut self, low: f64, high: f64) -> f64 {
        match self.byte() {
            0xf0.. => self.bits(),
            0xe0.. => 0.0,
            choice => {
                let size = 10_f64.powf(low + (high - low) * self.fraction());
                if choice % 2 == 0 { size } else { -size }
            }
        }
    }

    /// One of the limits 0 and `most`, a neighbour of a limit, a number between them, or an arbitrary bit pattern.
    fn within(&mut self, most: f64) -> f64 {
        let near = |input: &mut Self| 10_f64.powf(-20.0 * input.fraction());
        match self.byte() {
            0xf0.. => self.bits(),
            0xe0.. => 0.0,
            0xd0.. => most,
            0xb0.. => most * near(self),
            0x90.. => most * (1.0 - near(self)),
            _ => most * self.fraction(),
        }
    }

    /// Top of either support; most are accepted.
    fn top(&mut self) -> Result<Top, ParameterError> {
        let choice = self.byte();
        let kind = choice % 4;
        let a = self.decade(-6.0, 4.0);
        let c = a * self.decade(-6.5, 0.5);
        if choice >= 0xc0 {
            return self.other_top(choice, a, c);
        }
        let s = self.decade(-4.0, 2.0);
        let g = self.decade(-3.0, 3.0);
        // A/(ps) determines how difficult a top is
        let moment = a / (s * self.decade(-6.5, 6.5));
        let body =
            TopParameters { transverse_inertia: a, axial_inertia: c, gravity: g, ..TopParameters::default() };
        let by_moment = TopParameters { mass_moment: moment, ..body };
        let by_mass = TopParameters { com_height: s, mass: moment / s, ..body };
        match kind {
            0 => Top::sliding(&TopParameters { com_height: s, ..by_moment }),
            1 => Top::sliding(&by_mass),
            2 => Top::fixed(&by_moment),
            _ => Top::fixed(&by_mass),
        }
    }

    /// Top that the paper does not contain: with a rotor, a rod, free, or held without gravity.
    fn other_top(&mut self, choice: u8, a: f64, c: f64) -> Result<Top, ParameterError> {
        let parameters = TopParameters {
            transverse_inertia: a,
            axial_inertia: if choice & 8 == 0 { c } else { 0.0 },
            com_height: self.decade(-4.0, 2.0),
            mass_moment: a / self.decade(-6.5, 6.5),
            gravity: self.decade(-3.0, 3.0),
            rotor_momentum: if choice & 4 == 0 { a * self.signed(-20.0, 13.0) } else { 0.0 },
            ..TopParameters::default()
        };
        match choice % 4 {
            0 => Top::sliding(&parameters),
            1 => Top::fixed(&TopParameters { com_height: 0.0, ..parameters }),
            2 => Top::fixed(&TopParameters { com_height: 0.0, gravity: 0.0, ..parameters }),
            _ => Top::free(&parameters),
        }
    }

    /// Orientation and ω, with ω in units of the growth rate of a fall.
    fn state(&mut self, unit: f64) -> Result<State, ParameterError> {
        if self.byte().is_multiple_of(2) {
            let mut rate = || unit * self.signed(-20.0, 8.0);
            let (spin, precession, nutation) = (rate(), rate(), rate());
            let tilt = self.within(std::f64::consts::PI);
            let (azimuth, roll) = (self.signed(-3.0, 6.1), self.signed(-3.0, 6.1));
            return State::from_release(&Release { tilt, azimuth, roll, spin, precession, nutation });
        }
        let [re_alpha, im_alpha, re_beta, im_beta] = std::array::from_fn(|_| self.signed(-70.0, 0.1));
        let omega = std::array::from_fn(|_| unit * self.signed(-70.0, 8.0));
        let norm = match self.byte() {
            0..=1 => 1.0,
            _ => (re_alpha * re_alpha + im_alpha * im_alpha + re_beta * re_beta + im_beta * im_beta).sqrt(),
        };
        let part = |re: f64, im: f64| Complex::new(re / norm, im / norm);
        State::new(Orientation { alpha: part(re_alpha, im_alpha), beta: part(re_beta, im_beta) }, omega)
    }

    /// Motion from a state or from branch points.
    pub(super) fn motion(&mut self) -> Result<Motion, ParameterError> {
        let top = self.top()?;
        if self.byte().is_multiple_of(2) {
            let state = self.state(match top.is_torque_free() {
                true => 1.0,
                false => (top.mass_moment() * top.gravity() / top.transverse_inertia()).sqrt(),
            })?;
            return Motion::launch(&top, &state);
        }
        let e1 = self.within(2.0) - 1.0;
        let e2 = e1 + self.within(1.0 - e1);
        let e3 = 1.0 + self.signed(-20.0, 14.1).abs();
        let signs = self.byte();
        let sign = |bit: u8| if signs & bit == 0 { Sign::Plus } else { Sign::Minus };
        let signs = Signs { l_plus_n: sign(1), l_minus_n: sign(2) };
        let theta = match self.byte() {
            choice @ 0..8 => f64::from(choice) * std::f64::consts::FRAC_PI_2,
            _ => self.signed(-20.0, 6.1),
        };
        let start =
            InitialAngles { theta, arg_alpha: self.signed(-3.0, 6.1), arg_beta: self.signed(-3.0, 6.1) };
        Motion::from_branch_points(&top, [e1, e2, e3], signs, &start)
    }

    /// Tick length, mostly between a tenth and a millionth of the nutation period.
    pub(super) fn tick(&mut self, motion: &Motion) -> Result<Tick, ParameterError> {
        if self.byte() >= 0xe0 {
            return Tick::ratio(self.word(), self.word());
        }
        let period = motion.period_advance().map_or(1.0, |advance| advance.period);
        let length = (period * self.decade(-6.0, 0.0)).clamp(1e-9, 1e9);
        let seconds = if length < 1.0 { 1.0 } else { length.ceil() };
        Tick::ratio((seconds / length).round() as u32, seconds as u32)
    }

    /// Truncation error allowed for a table, mostly one that a small table can reach.
    pub(super) fn truncation(&mut self) -> f64 {
        self.decade(-8.0, 2.0)
    }
}
