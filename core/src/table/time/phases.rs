//! Numbers for the three phases of a table.

/// Nutation phase and mean phases Λ_α and Λ_β, or a number for each of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Phases<T> {
    pub(crate) nutation: T,
    pub(crate) alpha: T,
    pub(crate) beta: T,
}

/// Whether u falls at a nutation phase, given by its 64 leading bits.
pub(in crate::table) const fn is_falling(nutation: u64) -> bool {
    (nutation as i64) < 0
}

impl<T> Phases<T> {
    /// Numbers from an array of a [`Clock`](crate::Clock).
    #[inline(always)]
    pub(crate) const fn from_array(array: [T; 3]) -> Self
    where
        T: Copy,
    {
        let [nutation, alpha, beta] = array;
        Self { nutation, alpha, beta }
    }

    #[inline(always)]
    pub(crate) fn into_array(self) -> [T; 3] {
        [self.nutation, self.alpha, self.beta]
    }

    /// Result of a function for each phase.
    #[inline(always)]
    pub(crate) fn map<U>(self, mut function: impl FnMut(T) -> U) -> Phases<U> {
        Phases { nutation: function(self.nutation), alpha: function(self.alpha), beta: function(self.beta) }
    }

    /// Replaces one number after the other, which takes fewer registers than all at once.
    #[inline(always)]
    pub(crate) fn update<U>(&mut self, other: Phases<U>, function: impl Fn(T, U) -> T)
    where
        T: Copy,
    {
        let Self { nutation, alpha, beta } = self;
        for (number, other) in [nutation, alpha, beta].into_iter().zip(other.into_array()) {
            *number = function(*number, other);
        }
    }

    /// Result of a function of two numbers for each phase.
    #[inline(always)]
    pub(crate) fn zip_map<U, V>(self, other: Phases<U>, mut function: impl FnMut(T, U) -> V) -> Phases<V> {
        Phases {
            nutation: function(self.nutation, other.nutation),
            alpha: function(self.alpha, other.alpha),
            beta: function(self.beta, other.beta),
        }
    }
}
