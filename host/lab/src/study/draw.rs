//! Ticks of a motion at which it is compared with the truth.

use std::f64::consts::{FRAC_PI_2, PI};
use toytop_host::input::random::Random;
use toytop_host::motion::ephemeris::RateSample;
use toytop_host::truth::exact::{Course, Exact};
use toytop_host::truth::precise::{Precise, precise, to_f64, to_floor, to_nearest, whole};

/// Motion with ticks, whose number in a unit of time is a power of two, so that the time of a tick is exact.
pub(super) struct Ticks<'a> {
    pub(super) exact: &'a Exact,
    /// Ticks in a unit of time.
    pub(super) rate: f64,
    /// Natural time of the top, which replaces the period of a motion that has none.
    pub(super) natural_time: f64,
}

/// Binary logarithms of the distant ticks that are moved to the fastest part of a period.
const FAST_POWERS: [u32; 3] = [40, 50, 62];

/// Number of periods that are searched for the tick closest to the fastest part.
const SEARCHED: i64 = 64;

impl Ticks<'_> {
    /// Time of a tick.
    pub(super) fn time(&self, tick: i64) -> Precise {
        whole(tick) / precise(self.rate)
    }

    /// Rates at a tick.
    pub(super) fn rates(&self, tick: i64) -> RateSample {
        self.exact.rates(&self.time(tick), self.period())
    }

    /// Ticks of the first period: `count` random ones, and as many close to a turning point, where the motion is fastest or slowest. For an
    /// aperiodic motion, ticks on the way up or down; for a motion with constant u, ticks in the natural time.
    pub(super) fn near(&self, count: usize, random: &mut Random) -> Vec<i64> {
        let mut ticks = Vec::new();
        for _ in 0..count {
            match self.exact.course() {
                Course::Steady => ticks.push(self.within(self.natural_time, random)),
                Course::Aperiodic => {
                    ticks.extend(self.at(2.0 * (0.5 * random.between(-12.0, 12.0)).tanh().atan()));
                }
                Course::Nutating => {
                    ticks.push(self.within(self.period(), random));
                    let turning = (random.between(0.0, PI) / FRAC_PI_2).round() * FRAC_PI_2;
                    let side = if random.one_in(2) { 1.0 } else { -1.0 };
                    ticks.extend(self.at(turning + side * random.scale(1e-6, 0.3)));
                }
            }
        }
        ticks
    }

    /// Ticks that follow each of these by a random whole number of periods, at most `most`.
    pub(super) fn periods_after(&self, ticks: &[i64], most: f64, random: &mut Random) -> Vec<i64> {
        let later = |&tick: &i64| {
            let periods = random.scale(1.0, most).round();
            tick.saturating_add((periods * self.period() * self.rate) as i64)
        };
        ticks.iter().map(later).collect()
    }

    /// Distant ticks: `count` random ones from ±2^40 to ±2^62, and near ±2^40, ±2^50 and ±2^62 the tick closest to the fastest part of a
    /// period, if there is one.
    pub(super) fn far(&self, count: usize, random: &mut Random) -> Vec<i64> {
        let mut ticks: Vec<i64> = (0..count)
            .map(|_| {
                let size = random.scale(40_f64.exp2(), 62_f64.exp2()) as i64;
                if random.one_in(2) { size } else { -size }
            })
            .collect();
        let fast = self.exact.fastest();
        for power in FAST_POWERS {
            ticks.extend([1, -1].map(|sign| self.nearest_to_fast(&fast, sign * (1_i64 << power))));
        }
        ticks
    }

    /// Tick nearest to the fastest part of the first period.
    pub(super) fn fast(&self) -> Vec<i64> {
        let is_nutating = self.exact.course() == Course::Nutating;
        is_nutating
            .then(|| to_nearest(&(self.exact.fastest() * precise(self.rate))))
            .flatten()
            .into_iter()
            .collect()
    }

    /// Tick that is closest to the fastest part of a period, among the periods after a tick.
    fn nearest_to_fast(&self, fast: &Precise, tick: i64) -> i64 {
        let Some(period) = self.exact.period() else { return tick };
        let rate = precise(self.rate);
        let (fast, period) = (fast * &rate, period * rate);
        let first = to_floor(&((whole(tick) - &fast) / &period)).unwrap_or(0);
        let there = |periods: i64| {
            let place = &fast + whole(periods) * &period;
            let nearest = to_nearest(&place)?;
            Some((to_f64(&(whole(nearest) - place)).abs(), nearest))
        };
        let found = (0..SEARCHED).filter_map(|i| there(first + i)).min_by(|a, b| a.0.total_cmp(&b.0));
        found.map_or(tick, |(_, nearest)| nearest)
    }

    fn period(&self) -> f64 {
        self.exact.period().map_or(self.natural_time, |period| to_f64(&period))
    }

    fn within(&self, time: f64, random: &mut Random) -> i64 {
        (random.share() * time * self.rate) as i64
    }

    /// Tick nearest to a half phase, rad.
    fn at(&self, half_phase: f64) -> Option<i64> {
        to_nearest(&(self.exact.time_of(half_phase) * precise(self.rate)))
    }
}
