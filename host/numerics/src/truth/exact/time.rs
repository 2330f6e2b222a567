//! Time of a place, and place at a time.

use super::side::{Passed, Side, difference, sum};
use super::{Exact, Passage, Place};
use crate::truth::law::{End, Law, LawInF64};
use crate::truth::precise::{Precise, is_positive, precise, to_floor, whole};

impl Exact {
    /// Nutation period; `None` for a motion that does not nutate.
    #[must_use]
    pub fn period(&self) -> Option<Precise> {
        let passage = self.passage.as_ref().filter(|passage| passage.sides[1].is_reached())?;
        Some(passage.half[0].clone() << 1)
    }

    /// Time after the start at which χ has this value, rad; 0 for a steady motion.
    #[must_use]
    pub fn time_of(&self, half_phase: f64) -> Precise {
        self.time_of_place(&Place::near(half_phase))
    }

    pub(super) fn time_of_place(&self, place: &Place) -> Precise {
        self.passage.as_ref().map_or(precise(0.0), |passage| {
            let [there, ..] = passage.passed(&self.law, place);
            there - &passage.start[0]
        })
    }
}

impl Passage {
    /// Advances from χ = 0 to a place.
    pub(super) fn passed(&self, law: &Law, place: &Place) -> Passed {
        let Place { quarter, beyond } = place;
        let side = self.side(*quarter);
        if is_positive(&-beyond) {
            difference(&self.quarters(*quarter), &side.passed(law, &-beyond))
        } else {
            sum(&self.quarters(*quarter), &side.passed(law, beyond))
        }
    }

    /// Place at a time after χ = 0, and the advances there.
    pub(super) fn at(&self, law: &Law, coarse: &LawInF64, time: &Precise) -> (Place, Passed) {
        if !self.sides[1].is_reached() {
            return self.on_the_way_up_or_down(law, coarse, time);
        }
        // times are less than 2^63 ticks, and a period contains many ticks
        let quarter = to_floor(&(time / &self.half[0])).unwrap_or(i64::MAX - 1);
        let beyond = time - whole(quarter) * &self.half[0];
        if beyond <= self.side(quarter).whole()[0] {
            self.after(law, coarse, quarter, &beyond)
        } else {
            self.before(law, coarse, quarter + 1, &(&self.half[0] - beyond))
        }
    }

    fn after(&self, law: &Law, coarse: &LawInF64, quarter: i64, time: &Precise) -> (Place, Passed) {
        let (beyond, passed) = self.side(quarter).at(law, coarse, time);
        (Place { quarter, beyond }, sum(&self.quarters(quarter), &passed))
    }

    fn before(&self, law: &Law, coarse: &LawInF64, quarter: i64, time: &Precise) -> (Place, Passed) {
        let (beyond, passed) = self.side(quarter).at(law, coarse, time);
        (Place { quarter, beyond: -beyond }, difference(&self.quarters(quarter), &passed))
    }

    /// Place of an aperiodic motion at a time, and the advances there. Where |β| is below 1e-24, α turns at a constant rate.
    fn on_the_way_up_or_down(&self, law: &Law, coarse: &LawInF64, time: &Precise) -> (Place, Passed) {
        let falls = is_positive(&-time);
        let distance = if falls { -time } else { time.clone() };
        let (end, last) = self.sides[1].last();
        let to_go = &self.half[0] - &distance;
        let (place, passed) = if distance <= self.sides[0].whole()[0] {
            self.after(law, coarse, 0, &distance)
        } else if to_go >= last[0] {
            self.before(law, coarse, 1, &to_go)
        } else {
            let [then, alpha, beta] = difference(&self.half, last);
            let resting = &distance - then;
            let alpha = alpha + ((&law.momenta[0] * resting) >> 1);
            (Place { quarter: 1, beyond: -end }, [distance, alpha, beta])
        };
        if falls {
            (Place { quarter: -place.quarter, beyond: -place.beyond }, passed.map(|passed| -passed))
        } else {
            (place, passed)
        }
    }

    fn quarters(&self, quarter: i64) -> Passed {
        let count = whole(quarter);
        self.half.each_ref().map(|half| &count * half)
    }

    fn side(&self, quarter: i64) -> &Side {
        match End::of(quarter) {
            End::Lower => &self.sides[0],
            End::Upper => &self.sides[1],
        }
    }
}
