//! Part of the measurements that a pass reads.

use crate::fit::sensor::Measurement;
use core::iter::Take;

/// Golden ratio times 2³². Its multiples modulo 2³² are spread evenly, whatever the period of the sensors' readings.
const GOLDEN: u32 = 0x9e37_79b9;

/// Choice of measurements: of the first `count`, those of one in `thinning` instants, where `thinning` is at least 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub(super) count: usize,
    pub(super) thinning: usize,
}

impl Part {
    /// All measurements.
    pub(super) const ALL: Self = Self::first(usize::MAX);

    /// First measurements.
    pub(super) const fn first(count: usize) -> Self {
        Self { count, thinning: 1 }
    }

    /// Measurements of this part.
    pub(super) fn of<I: Iterator<Item = Measurement>>(self, measurements: I) -> Window<I> {
        let thinning = u32::try_from(self.thinning).unwrap_or(u32::MAX);
        let limit = u32::MAX.checked_div(thinning).unwrap_or(u32::MAX);
        // the multiple of the first instant becomes 0
        let multiple = 0_u32.wrapping_sub(GOLDEN);
        Window { measurements: measurements.take(self.count), limit, multiple, time: None }
    }
}

/// Iterator over the measurements of a [`Part`].
#[derive(Clone, Debug)]
pub(super) struct Window<I> {
    measurements: Take<I>,
    /// Instants whose multiple of the golden ratio is at most this are kept.
    limit: u32,
    /// Multiple of the golden ratio that belongs to the current instant, and its time.
    multiple: u32,
    time: Option<f64>,
}

impl<I: Iterator<Item = Measurement>> Iterator for Window<I> {
    type Item = Measurement;

    fn next(&mut self) -> Option<Measurement> {
        loop {
            let measurement = self.measurements.next()?;
            // the bits are compared, which is faster on a chip without a unit for `f64`
            if self.time.map(f64::to_bits) != Some(measurement.time.to_bits()) {
                self.time = Some(measurement.time);
                self.multiple = self.multiple.wrapping_add(GOLDEN);
            }
            if self.multiple <= self.limit {
                return Some(measurement);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn readings() -> impl Iterator<Item = Measurement> + Clone {
        // a second sensor reads at every tenth instant only
        (0..1000).flat_map(|n| {
            let of = move |sensor| Measurement { time: f64::from(n), sensor, values: [0.0; 4] };
            [Some(of(0)), (n % 10 == 0).then(|| of(1))].into_iter().flatten()
        })
    }

    #[test]
    fn a_thinned_window_keeps_its_share_of_each_sensor() {
        let part = |count, thinning| Part { count, thinning }.of(readings());
        for thinning in [2, 3, 5, 10] {
            let count = |sensor| part(1100, thinning).filter(|m| m.sensor == sensor).count();
            let off = |count: usize, all: usize| count.abs_diff(all / thinning);
            assert!(
                off(count(0), 1000) <= 3 && off(count(1), 100) <= 3,
                "{thinning}: {} {}",
                count(0),
                count(1)
            );
            let first = part(1100, thinning).next();
            assert_eq!(first.map(|m| m.time), Some(0.0), "the epoch stays");
        }
        assert_eq!(Part::ALL.of(readings()).count(), 1100);
        assert_eq!(part(7, 1).count(), 7);
    }
}
