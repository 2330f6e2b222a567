//! Table of a steady motion, in which u is constant.

use crate::cayley_klein::Brackets;
use crate::ephemeris::polynomial::Store;
use crate::ephemeris::tabulated::Tabulated;
use crate::law::series::{TERMS, UNIT};
use crate::motion::Motion;
use crate::phase::Phase;

/// Tabulation of a steady motion: α and β at χ = 0, which are constant.
#[inline(never)]
pub(crate) fn constant(motion: &Motion, store: &mut Store<'_>) -> Tabulated {
    let brackets: Brackets<f64> = motion.brackets();
    for (which, bracket) in [&brackets.alpha, &brackets.beta].into_iter().enumerate() {
        let [plus, minus] = bracket.exponentials();
        let mut re = [0; TERMS];
        re[0] = libm::round((plus + minus) / UNIT) as i64;
        store(0, which, &[re, [0; TERMS]]);
    }
    let [alpha, beta] = motion.phases();
    Tabulated { start: [Phase::ZERO, alpha, beta], ..Tabulated::EMPTY }
}
