//! Residues by contour quadrature are compared with Tables 1 and 2 and with the pole of time, at every possible singularity.

use super::hyperelliptic_integrals::curves;
use num_complex::Complex64 as C;
use toytop_tests::hyperelliptic_curve::{Form, Place};
use toytop_tests::{check, greater, tolerance};

/// Table 1: each logarithmic differential has residue 1 at its zero, -1 at infinity, and no other singularity:
/// neither on the other sheet, nor over the other of ±1, nor at a branch point. Table 2: on the aperiodic curve dα/α and dδ/δ have simple
/// poles over u = 1 too, and dβ/β and dγ/γ have residue 1/2 at both points there.
#[test]
fn residues_are_those_of_tables_1_and_2() {
    let mut worst = 0.0_f64;
    for (_, curve) in curves() {
        let mut table = [0, 1, 2, 3].map(|part| [0, 1, 2, 3].map(|zero| C::from(f64::from(zero == part))));
        if curve.form == Form::Aperiodic {
            let (ratio, half) = (curve.w_minus_one() / curve.w_plus_one() * 0.5, C::from(0.5));
            (table[0][1], table[0][2], table[3][1], table[3][2]) = (ratio, -ratio, -ratio, ratio);
            (table[1][1], table[1][2], table[2][1], table[2][2]) = (half, half, half, half);
        }
        for (part, row) in table.into_iter().enumerate() {
            let mut off = |place, power, expected: C| {
                let found = curve.around(place, |at, v: C| curve.logarithms(at)[part] * v.powi(power));
                worst = greater(worst, (found - expected).norm());
            };
            for (zero, expected) in curve.zeros().into_iter().zip(row) {
                off(Place::Over(zero), 0, expected);
            }
            off(Place::Infinity, 0, C::from(-1.0));
            for e in &curve.branch_points {
                // neither a residue nor a pole of second order
                off(Place::BranchPoint(*e), 0, C::ZERO);
                off(Place::BranchPoint(*e), 2, C::ZERO);
            }
        }
    }
    check("Tables 1 and 2", worst, tolerance::RESIDUES_TABLES_1_AND_2);
}

/// Equation (3.9): dt is of the second kind, without residues, and at infinity t = -i√(2s)/v + O(1) in v² = 1/u. For
/// a fixed tip it is of the first kind, without poles; on the aperiodic curve it is of the third kind, with poles
/// over u = 1.
#[test]
fn eqn_t_has_its_pole_at_infinity() {
    let mut worst = 0.0_f64;
    for (motion, curve) in curves() {
        let pole = |place, power| curve.around(place, |at, v: C| curve.time(at) * v.powi(power));
        let leading = match curve.form {
            Form::FixedTip => 0.0,
            _ => (2.0 * motion.top().com_height() / motion.top().gravity()).sqrt(),
        };
        // dt = -c dv/v² for t = c/v: the residue of v dt is -c, with the sign of the sheet
        let first = pole(Place::Infinity, 1);
        let mut off = vec![first.re, first.im.abs() - leading];
        off.extend([0, 2].map(|power| pole(Place::Infinity, power).norm()));
        off.extend(curve.branch_points.iter().map(|e| pole(Place::BranchPoint(*e), 0).norm()));
        let over_one = pole(Place::Over(curve.point(C::from(1.0))), 0).norm();
        if curve.form == Form::Aperiodic {
            assert!(over_one > 0.1, "the aperiodic case");
        } else {
            off.push(over_one);
        }
        worst = off.into_iter().map(f64::abs).fold(worst, greater);
    }
    check("t at infinity", worst, tolerance::RESIDUES_T_INFINITY);
}
