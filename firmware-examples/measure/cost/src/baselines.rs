//! Baselines: calls of other code for the tasks of core's calls.

use micromath::F32Ext;
use multicalc::linear_algebra::Vector;
use multicalc::ode::Rk4;
use toytop::Phase;
use toytop::scalar::{Float, Real};

use crate::calls::Output;
use crate::full_equations::{Constants, Point, orientation, renormalised};

#[inline(always)]
fn step<R: Float>(constants: &Constants<R>, y: &mut Point<R>, out: &mut Output<R>) {
    constants.step(y);
    *out = Output::of(orientation(*y));
}

symbols! {
    fn bench_rk4_f32(constants: &Constants<f32>, y: &mut Point<f32>, out: &mut Output<f32>) {
        step(constants, y, out);
    }

    fn bench_rk4_f64(constants: &Constants<f64>, y: &mut Point<f64>, out: &mut Output<f64>) {
        step(constants, y, out);
    }

    /// Step of the same equations by the Runge-Kutta method of the crate multicalc.
    fn bench_multicalc_rk4_f32(constants: &Constants<f32>, y: &mut Point<f32>, out: &mut Output<f32>) {
        let rates = |_, y: &Vector<6, f32>| Vector::new(constants.rates(y.into_array()));
        *y = renormalised(Rk4::step(&rates, 0.0, &Vector::new(*y), constants.dt).into_array());
        *out = Output::of(orientation(*y));
    }

    /// Sine and cosine of an integer phase, which is the argument in a tick.
    fn bench_sincos_ours_f32(phase: &Phase, out: &mut [f32; 2]) {
        *out = f32::sine_cosine(*phase).into();
    }

    fn bench_sincos_ours_f64(phase: &Phase, out: &mut [f64; 2]) {
        *out = f64::sine_cosine(*phase).into();
    }

    fn bench_sincos_libm_f32(angle: f32, out: &mut [f32; 2]) {
        *out = libm::sincosf(angle).into();
    }

    fn bench_sincos_libm_f64(angle: f64, out: &mut [f64; 2]) {
        *out = libm::sincos(angle).into();
    }

    /// Sine and cosine with an error of 1e-3.
    fn bench_sincos_micromath_f32(angle: f32, out: &mut [f32; 2]) {
        *out = angle.sin_cos().into();
    }
}
