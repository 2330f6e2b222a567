//! Clock of an ephemeris: the phases at any tick, and at any time between two ticks.

use crate::body::{ParameterError, check};
use crate::integer::{ldexp_i128, mantissa_and_exponent};
use crate::phase::{Phase, WrappedPhase};
use crate::scalar::{Extended, Float};

/// Length of a tick, an exact fraction of a second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tick {
    ticks: u32,
    seconds: u32,
}

impl Tick {
    /// Tick length for a frequency in Hz.
    ///
    /// # Errors
    /// `tick`: the frequency is 0.
    pub fn hertz(frequency: u32) -> Result<Self, ParameterError> {
        Self::ratio(frequency, 1)
    }

    /// Tick length for `ticks` ticks in `seconds` seconds: (44100, 2) means 44100/2 Hz.
    ///
    /// # Errors
    /// `tick`: one of the two is 0.
    pub fn ratio(ticks: u32, seconds: u32) -> Result<Self, ParameterError> {
        check(
            ticks > 0 && seconds > 0,
            "tick",
            "a positive number of ticks in a positive number of seconds",
        )?;
        Ok(Self { ticks, seconds })
    }

    pub(crate) fn length(self) -> Extended {
        quotient(self.seconds, self.ticks)
    }

    /// Number of ticks in a unit of time.
    pub(crate) fn rate(self) -> Extended {
        quotient(self.ticks, self.seconds)
    }
}

fn quotient(a: u32, b: u32) -> Extended {
    Extended::from(f64::from(a)) / Extended::from(f64::from(b))
}

/// Phases and their increments, and the scales of lengths and rates: see `core/docs/table_format.md`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)] // the increments first, in reach of the smallest chip's load instructions
pub struct Clock<W> {
    /// Increments per tick of nutation phase and slow phases, in units of 2^-96 turns, lowest word first.
    pub step: [[u32; 3]; 3],
    /// Argument of the tabulated ab at u = e₁ in quarter turns: 0, or ±1 for e₁ = -1.
    pub tip_start_quarter_turns: i8,
    /// Number of the parameters α and β that pass through 0.
    pub tip_sign_changes: u8,
    /// Whether the tip angle exists: the axis does not stay vertical.
    pub tip_exists: bool,
    /// Whether u has turning points: false where u is constant to 2^-49.
    pub has_turning_points: bool,
    /// Twice [`Top::tip_scale`](crate::Top::tip_scale), 2 s, m; 2 for a fixed tip. The tip is at c = 2 s αβ.
    pub twice_tip_scale: W,
    /// Rate dx/dt on a segment of an eighth of half a period, /s.
    pub x_rate: W,
    /// Mean rate of λ_α + λ_β, rad/s.
    pub slow_sum_rate: W,
    /// Angular velocity (n - K)/C about the axis, rad/s.
    pub axial_rate: W,
    /// Nutation phase and slow phases at tick `i64::MIN`, in units of 2^-64 turns.
    pub first_phases: [u64; 3],
    /// Increments per tick in turns, with whole turns, as sums of two `f64`.
    pub exact_step: [[f64; 2]; 3],
    /// Number of ticks in a unit of time, as the sum of two `f64`.
    pub ticks_per_time: [f64; 2],
    /// Mean tip angle at tick 0, with whole turns, in units of 2^-96 turns, lowest word first.
    pub tip_start: [u32; 4],
    /// Increment of the mean tip angle per tick, in units of 2^-96 turns.
    pub tip_step: [u32; 4],
    /// Tick of the launch, from which the error bounds grow.
    pub epoch: i64,
}

impl<W: Float> Clock<W> {
    pub(crate) const ZERO: Self = Self {
        step: [[0; 3]; 3],
        tip_start_quarter_turns: 0,
        tip_sign_changes: 0,
        tip_exists: false,
        has_turning_points: false,
        twice_tip_scale: W::ZERO,
        x_rate: W::ZERO,
        slow_sum_rate: W::ZERO,
        axial_rate: W::ZERO,
        first_phases: [0; 3],
        exact_step: [[0.0; 2]; 3],
        ticks_per_time: [0.0; 2],
        tip_start: [0; 4],
        tip_step: [0; 4],
        epoch: 0,
    };
}

impl<W: Copy> Clock<W> {
    /// Rates of x on a segment of an eighth of half a period, of A + B, and about the axis.
    #[inline(always)]
    pub(crate) const fn rates(&self) -> [W; 3] {
        [self.x_rate, self.slow_sum_rate, self.axial_rate]
    }

    #[inline(always)]
    pub(crate) fn steps(&self) -> [WrappedPhase; 3] {
        self.step.map(WrappedPhase::new)
    }

    pub(crate) fn exact_steps(&self) -> [Extended; 3] {
        self.exact_step.map(Extended::from_parts)
    }

    /// Number of ticks in a unit of time.
    pub(crate) fn tick_rate(&self) -> Extended {
        Extended::from_parts(self.ticks_per_time)
    }

    /// Number of ticks until a time; 0 if it is not finite.
    pub(crate) fn ticks(&self, t: f64) -> Extended {
        self.tick_rate() * if t.is_finite() { t } else { 0.0 }.into()
    }

    /// 64 leading bits of nutation phase and slow phases, and the mean tip angle, at a time (0 if not finite).
    ///
    /// `None` beyond 2^62 ticks, and for fast ticks, in which a phase turns by half a turn or more.
    #[inline(always)]
    pub(crate) fn at_time(&self, t: f64) -> Option<([u64; 3], Phase)> {
        const MOST_TICKS: f64 = (1_u64 << 62) as f64;
        let [hi, lo] = self.ticks_per_time;
        let near = (t * hi).abs() < MOST_TICKS || !t.is_finite();
        let slow = self.exact_step.iter().all(|[turns, _]| turns.abs() < 0.5);
        if !(near && slow) {
            return None;
        }
        let (time, exponent) = mantissa_and_exponent(t);
        let product = |rate: f64| {
            let (rate, rate_exponent) = mantissa_and_exponent(rate);
            ldexp_i128(i128::from(time) * i128::from(rate), exponent + rate_exponent + 64)
        };
        // in units of 2^-64 ticks
        let ticks = if lo == 0.0 { product(hi) } else { product(hi).wrapping_add(product(lo)) };
        let (tick, fraction) = ((ticks >> 64) as i64, ticks as u64);
        let since_first = tick.wrapping_sub(i64::MIN) as u64;
        let ([nutation, a, b], [nutation_step, a_step, b_step]) = (self.first_phases, self.steps());
        let after = |first: u64, step: WrappedPhase| {
            first.wrapping_add(step.leading_bits_after(since_first, fraction))
        };
        let phases = [after(nutation, nutation_step), after(a, a_step), after(b, b_step)];
        Some((phases, self.mean_tip(tick) + self.tip_step().times_part(fraction)))
    }

    /// Nutation phase and slow phases at tick n.
    #[inline(always)]
    pub(crate) fn at(&self, n: i64) -> [WrappedPhase; 3] {
        let since_first = n.wrapping_sub(i64::MIN) as u64;
        let after =
            |first: u64, step: [u32; 3]| WrappedPhase::new(step).times(since_first).plus_leading_bits(first);
        let [nutation, a, b] = &self.first_phases;
        // by reference: an array of all steps would take nine registers at once
        let [nutation_step, a_step, b_step] = &self.step;
        [after(*nutation, *nutation_step), after(*a, *a_step), after(*b, *b_step)]
    }

    /// Phases, without whole turns, and mean tip angle at any number of ticks, with a fraction.
    #[cold]
    #[inline(never)]
    pub(crate) fn at_ticks(&self, ticks: Extended) -> ([WrappedPhase; 3], Phase) {
        let (ticks, fraction) = ticks.floor_and_fraction();
        let since_first = ticks.wrapping_sub(i64::MIN.into());
        let turned = |step: Phase, ticks: i128| Phase::from_bits(step.to_bits().wrapping_mul(ticks));
        let mut phases = self.steps();
        for ((phase, turns), first) in phases.iter_mut().zip(self.exact_steps()).zip(self.first_phases) {
            let part = (turns * fraction).to_phase();
            *phase = WrappedPhase::from_phase(turned(phase.to_phase(), since_first) + part)
                .plus_leading_bits(first);
        }
        let part = (self.exact_tip_step() * fraction).to_phase();
        (phases, Phase::from_words(self.tip_start) + turned(self.tip_step(), ticks) + part)
    }

    /// Increment of the mean tip angle per tick.
    #[inline(always)]
    pub(crate) fn tip_step(&self) -> Phase {
        Phase::from_words(self.tip_step)
    }

    #[inline(always)]
    pub(crate) fn mean_tip(&self, n: i64) -> Phase {
        Phase::from_words(self.tip_start) + self.tip_step() * n
    }

    /// Increment of the mean tip angle per tick, in turns. It lacks the half turn per period of a parameter that passes through 0.
    pub(in crate::table) fn exact_tip_step(&self) -> Extended {
        let [nutation, a, b] = self.exact_steps();
        a + b - nutation * Extended::from(0.5 * f64::from(self.tip_sign_changes))
    }
}
