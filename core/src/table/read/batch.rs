//! Orientations at consecutive ticks, computed together.

use crate::phase::Phase;
use crate::su2::Orientation;
use crate::table::data::storage::EphemerisView;
use crate::table::read::sample::Sample;
use crate::table::scalar::EphemerisScalar;

/// Number of ticks whose phases are computed before their orientations, which then do not depend on each other.
const BLOCK: usize = 16;

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Fills `out` with the orientations at the ticks first, first + 1, .... The bits are those of [`EphemerisView::at_tick`]; a large
    /// processor takes less time than for separate calls.
    pub fn fill(&self, first: i64, out: &mut [Orientation<R>]) {
        // as 128-bit numbers: three words would have to be assembled for every tick
        let step = self.clock.steps().map(|step| step.to_phase());
        let mut now = self.clock.at(first).map(|phase| phase.to_phase());
        let mut phases = [[0; 3]; BLOCK];
        for block in out.chunks_mut(BLOCK) {
            for phases in phases.iter_mut().take(block.len()) {
                *phases = now.map(Phase::fraction);
                for (now, step) in now.iter_mut().zip(step) {
                    *now += step;
                }
            }
            for (orientation, &phases) in block.iter_mut().zip(&phases) {
                *orientation = Sample { ephemeris: self, phases, mean_tip: Phase::ZERO }.orientation();
            }
        }
    }
}
