//! Decision whether the next cell is tried with segments of twice the length.

/// Limit on the expected errors with which longer segments are tried. A failed trial costs two polynomials; an unnecessary segment takes
/// memory in the table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LongerSegments {
    /// Expected error over the allowed error with which a trial would just succeed, from the last failed trial; at least 1.
    limit: f32,
    /// Expected error of the last trial, over the allowed error.
    trial: Option<f32>,
}

impl LongerSegments {
    /// Limit before the first trial. The error increases less than expected where the motion becomes slower.
    pub(crate) const UNTRIED: Self = Self { limit: 4.0, trial: None };

    /// Whether the next cell may be tried with segments that have this expected error, over the allowed error.
    pub(crate) fn may_do(&mut self, expected: f32) -> bool {
        self.trial = (expected < self.limit).then_some(expected);
        self.trial.is_some()
    }

    /// Notes that the segments of a cell are not accurate enough: their error over the allowed error.
    pub(crate) fn failed(&mut self, error: f32) {
        if let Some(expected) = self.trial.take() {
            self.limit = (expected / error).max(1.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A trial that failed is repeated with an expected error that is smaller by the factor by which it failed. An expected
    /// error below 1 is always tried.
    #[test]
    fn a_failed_trial_is_repeated_with_a_smaller_error() {
        let mut longer = LongerSegments::UNTRIED;
        assert!(!longer.may_do(4.0));
        assert!(longer.may_do(3.0));
        longer.failed(1.5);
        assert!(!longer.may_do(2.0));
        // the failure of a cell whose segments were not longer
        longer.failed(1.5);
        assert!(longer.may_do(1.9));
        assert!(longer.may_do(0.5));
        longer.failed(1.1);
        assert!(longer.may_do(0.9));
        assert!(!longer.may_do(1.0));
    }
}
