//! Tables 1 and 2 and the pole of time: residues by contour quadrature at every possible singularity.

use super::hyperelliptic::{curves, real, size, top};
use toytop::Complex;
use toytop_tests::hyperelliptic::{
    Curve, Form, Point, residue, residue_at_branch_point, residue_at_infinity,
};
use toytop_tests::{greater, tolerance};

/// Finite branch points of these tests' curves; the distances between them, and from ±1, are at least 0.09.
fn branch_points(curve: &Curve) -> Vec<f64> {
    let e4 = top().e4().unwrap();
    match curve.form() {
        Form::General => vec![-0.3, 0.6, 1.4, e4, -e4],
        Form::E3EqualsE4 => vec![-0.3, 0.6, -e4],
        Form::Aperiodic => vec![-0.3, e4, -e4],
        Form::FixedTip => vec![-0.3, 0.6, 1.4],
    }
}

/// Table 1: each logarithmic differential has residue 1 at its zero, -1 at infinity, and no other singularity:
/// neither on the other sheet, nor over the other of ±1, nor at a branch point.
#[test]
fn table_1() {
    let mut worst = 0.0_f64;
    for (_, curve) in curves().into_iter().filter(|(_, curve)| curve.form() != Form::Aperiodic) {
        let zeros = curve.zeros();
        for part in 0..4 {
            let f = |at: &Point| curve.logarithms(at)[part];
            for (i, zero) in zeros.iter().enumerate() {
                let expected = if i == part { Complex::ONE } else { Complex::ZERO };
                worst = greater(worst, size(residue(&curve, zero, 0.1, f) - expected));
            }
            let at_infinity = residue_at_infinity(&curve, 0.3, |at, _| f(at));
            worst = greater(worst, size(at_infinity + Complex::ONE));
            for e in branch_points(&curve) {
                // neither a residue nor a pole of second order
                let (first, second) = (f, |at: &Point| f(at) * (at.u - real(e)));
                worst = greater(worst, size(residue_at_branch_point(&curve, e, 0.3, first)));
                worst = greater(worst, size(residue_at_branch_point(&curve, e, 0.3, second)));
            }
        }
    }
    tolerance::CONTOUR.check("Table 1", worst);
}

/// Table 2: the simple poles of dα/α and dδ/δ on the aperiodic curve; dβ/β and dγ/γ have residue 1/2 at both points
/// over u = 1.
#[test]
fn table_2() {
    let mut worst = 0.0_f64;
    for (_, curve) in curves().into_iter().filter(|(_, curve)| curve.form() == Form::Aperiodic) {
        let [alpha, _, plus, delta] = curve.zeros();
        let (w, minus) = (curve.w_plus_one(), plus.other_sheet());
        let ratio = (curve.w_minus_one() * w.conj()).scaled(0.5 / w.norm_squared());
        let (one, half, zero) = (Complex::ONE, real(0.5), Complex::ZERO);
        let table = [
            [one, zero, -ratio, ratio],
            [zero, zero, half, half],
            [zero, zero, half, half],
            [zero, one, ratio, -ratio],
        ];
        for (part, row) in table.into_iter().enumerate() {
            let f = |at: &Point| curve.logarithms(at)[part];
            for (place, expected) in [alpha, delta, plus, minus].iter().zip(row) {
                worst = greater(worst, size(residue(&curve, place, 0.1, f) - expected));
            }
            worst = greater(worst, size(residue_at_infinity(&curve, 0.3, |at, _| f(at)) + one));
            for e in branch_points(&curve) {
                worst = greater(worst, size(residue_at_branch_point(&curve, e, 0.3, f)));
            }
        }
    }
    tolerance::CONTOUR.check("Table 2", worst);
}

/// Equation (3.9): dt is of the second kind, without residues, and at infinity t = -i√(2s)/v + O(1) in v² = 1/u. For
/// a fixed tip it is of the first kind, without poles; on the aperiodic curve it is of the third kind, with poles
/// over u = 1.
#[test]
fn eqn_t_at_infinity() {
    let mut worst = 0.0_f64;
    for (motion, curve) in curves() {
        let time = |at: &Point| curve.time(at);
        let leading = match curve.form() {
            Form::FixedTip => 0.0,
            _ => (2.0 * motion.top().com_height() / motion.top().gravity()).sqrt(),
        };
        // dt = -c dv/v² for t = c/v: the residue of v dt is -c, with the sign of the sheet
        let pole = residue_at_infinity(&curve, 0.3, |at, v| time(at) * v);
        worst = [pole.re.abs(), (pole.im.abs() - leading).abs()].into_iter().fold(worst, greater);
        worst = greater(worst, size(residue_at_infinity(&curve, 0.3, |at, _| time(at))));
        worst = greater(worst, size(residue_at_infinity(&curve, 0.3, |at, v| time(at) * v * v)));
        for e in branch_points(&curve) {
            worst = greater(worst, size(residue_at_branch_point(&curve, e, 0.3, time)));
        }
        let over_one = size(residue(&curve, &curve.point(Complex::ONE), 0.1, time));
        if curve.form() == Form::Aperiodic {
            assert!(over_one > 0.1, "the aperiodic case");
        } else {
            worst = greater(worst, over_one);
        }
    }
    tolerance::CONTOUR.check("t at infinity", worst);
}
