//! Times of the paper's closed forms: set-up, evaluation at one time, and the elliptic functions that they use.

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use toytop::elliptic::{Jacobi, Weierstrass};
use toytop::exact::ClosedForm;
use toytop::{Complex, Motion, Signs, Start, Top, TopParameters};

/// Motion of each kind that has a closed form.
fn motions() -> [(&'static str, Motion); 4] {
    // e4 is exactly 2
    let sliding = Top::sliding(&TopParameters {
        transverse_inertia: 3.0,
        axial_inertia: 2.0,
        com_height: 1.0,
        mass_moment: 1.0,
        gravity: 1.0,
        ..TopParameters::default()
    })
    .expect("a top");
    let held = Top::fixed(&TopParameters {
        transverse_inertia: 3.0,
        axial_inertia: 2.0,
        mass_moment: 1.0,
        gravity: 1.0,
        ..TopParameters::default()
    })
    .expect("a top");
    let motion = |top: &Top, e: [f64; 3]| {
        Motion::from_branch_points(top, e, Signs::default(), &Start::default()).expect("a motion")
    };
    [
        ("constant tilt", motion(&sliding, [0.6, 0.6, 1.7])),
        ("aperiodic", motion(&sliding, [0.2, 1.0, 1.0])),
        ("e3 = e4", motion(&sliding, [0.3, 0.8, 2.0])),
        ("Lagrange", motion(&held, [0.3, 0.8, 2.0])),
    ]
}

fn forms(c: &mut Criterion) {
    for (name, motion) in motions() {
        let form = ClosedForm::of(&motion).expect("a closed form");
        let mut group = c.benchmark_group(format!("closed form, {name}"));
        group.bench_function("set-up", |b| b.iter(|| ClosedForm::of(black_box(&motion))));
        let mut t = 0.0;
        let mut later = || {
            t += 0.37;
            black_box(t)
        };
        group.bench_function("any time, with rates", |b| b.iter(|| form.at(later())));
        group.finish();
    }
}

fn functions(c: &mut Criterion) {
    let lattice = Weierstrass::from_roots([1.3, 0.2, -1.5]).expect("a lattice");
    let jacobi = Jacobi::new(0.7, 0.3).expect("a modulus");
    let z = Complex::new(0.4, 0.3);
    let mut group = c.benchmark_group("elliptic functions");
    group.bench_function("lattice from roots", |b| {
        b.iter(|| Weierstrass::from_roots(black_box([1.3, 0.2, -1.5])))
    });
    group.bench_function("p", |b| b.iter(|| lattice.p(black_box(z))));
    group.bench_function("zeta", |b| b.iter(|| lattice.zeta(black_box(z))));
    group.bench_function("ln sigma", |b| b.iter(|| lattice.ln_sigma(black_box(z))));
    group.bench_function("sn, cn, dn, am", |b| b.iter(|| jacobi.at(black_box(0.8))));
    group.finish();
}

criterion_group!(benches, forms, functions);
criterion_main!(benches);
