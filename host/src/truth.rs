//! Two references: the paper's integrals by quadrature in numbers of 640 bits (192 digits), and an integration of the full 3-D equations.
//!
//! Both use the core's type `Orientation`. The quadrature shares no formula with the core. The integration takes the state at t = 0 from the
//! core if a launch is given by branch points.
//!
//! The arithmetic of the quadrature is dashu's. Its relative error is 1e-37, which at tick 2^62 is below 1e-17 rad.
//!
//! | module | contents |
//! |---|---|
//! | [`motion_input`] | top, and branch points or a state |
//! | [`float640`] | arithmetic in numbers of 640 bits |
//! | `nutation` | rates of a motion, and their integrals over a nutation |
//! | `launch_constants` | constants from branch points or a state |
//! | [`quadrature`] | orientation and rates at a time by quadrature |
//! | [`full_solver`] | integration of the full 3-D equations |

pub mod motion_input;

pub mod float640;
mod nutation;

mod launch_constants;
pub mod quadrature;

pub mod full_solver;

#[cfg(test)]
mod tests {
    use super::float640::{Float640, Orientation640, to_f64};
    use super::motion_input::MotionInput;
    use super::quadrature::Quadrature;
    use crate::input::scenario::Launch;
    use dashu_float::FBig;
    use dashu_float::round::mode::HalfEven;
    use serde_json::Value;
    use std::path::Path;
    use toytop::{Complex, InitialAngles, Orientation, Sign, Signs, Support, TopParameters};

    /// Reference vector of this name.
    fn read(name: &str) -> Value {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/reference/vectors");
        let text = std::fs::read_to_string(folder.join(format!("{name}.json"))).expect("the vector");
        serde_json::from_str(&text).expect("JSON")
    }

    /// Number of a text of thirty digits, rounded to `f64`.
    fn number(json: &Value) -> f64 {
        json.as_str().expect("a text").parse().expect("a number")
    }

    /// Number of a text of thirty digits, with all of them.
    fn digits(json: &Value) -> Float640 {
        let decimal: FBig<HalfEven, 10> = json.as_str().expect("a text").parse().expect("a number");
        decimal.with_precision(80).value().with_base_and_precision::<2>(640).value()
    }

    /// Samples of a vector, with those after many periods.
    fn samples(json: &Value) -> impl Iterator<Item = &Value> {
        let list = |key: &str| json[key].as_array().expect("samples").iter();
        list("samples").chain(list("huge_samples"))
    }

    /// Distance 2 √(|Δα|² + |Δβ|²) of an orientation from a sample, rad.
    fn error(phi: &Orientation640, sample: &Value) -> f64 {
        let parameter = |key: &str| [0, 1].map(|i| digits(&sample[key][i]));
        phi.distance(&Orientation640 { alpha: parameter("alpha"), beta: parameter("beta") })
    }

    /// Relative error of a number against a text of thirty digits.
    fn relative(found: &Float640, json: &Value) -> f64 {
        to_f64(&(found / digits(json) - Float640::ONE)).abs()
    }

    /// Top of a vector, in units with g = 1, with a launch.
    fn input(json: &Value, launch: Launch) -> MotionInput {
        let [a, c, s, p] = ["A", "C", "s", "p"].map(|key| number(&json["params"][key]));
        let top = TopParameters {
            transverse_inertia: a,
            axial_inertia: c,
            com_height: s,
            mass_moment: p,
            gravity: 1.0,
            ..TopParameters::default()
        };
        MotionInput { support: if s > 0.0 { Support::Sliding } else { Support::Fixed }, top, launch }
    }

    /// Reference vector that is given by branch points, all exact in f64.
    fn branch_points_vector(name: &str) -> (MotionInput, Value) {
        let json = read(name);
        let params = |key: &str| number(&json["params"][key]);
        let sign = |key: &str| if json[key] == -1 { Sign::Minus } else { Sign::Plus };
        let launch = Launch::BranchPoints {
            e: ["e1", "e2", "e3"].map(|key| number(&json[key])),
            signs: Signs { l_plus_n: sign("s_plus"), l_minus_n: sign("s_minus") },
            phases: InitialAngles {
                theta: params("theta0"),
                arg_alpha: params("arg_alpha0"),
                arg_beta: params("arg_beta0"),
            },
        };
        (input(&json, launch), json)
    }

    #[test]
    fn samples_known_to_thirty_digits() {
        let names = [
            "generic_pp",
            "generic_pm",
            "generic_mp",
            "generic_mm",
            "small_A",
            "lagrange",
            "fast_spin",
            "e3_1",
            "e1_m1",
            "e2_1",
            "planar",
            "near_vertical_pass",
            "near_downward_pass",
            "near_separatrix_e2_1",
            "near_separatrix_straddle",
            "tiny_nutation",
        ];
        let mut checked = 0;
        for name in names {
            let (input, json) = branch_points_vector(&format!("exact_{name}"));
            let exact = Quadrature::new(&input);
            let period = exact.period().expect("a period");
            let off = relative(&period, &json["period"]["T"]);
            assert!(off < 1e-29, "{name}: period off by {off:e}");
            for sample in samples(&json) {
                let error = error(&exact.at(&digits(&sample["t"])), sample);
                assert!(error < 1e-28, "{name} at {}: {error:e}", sample["t"]);
                checked += 1;
            }
        }
        assert!(checked > 300);
    }

    /// Reference vector that is given by a state, all exact in f64.
    fn state_vector(name: &str) -> (MotionInput, Value) {
        let json = read(name);
        let params = &json["params"];
        let z = |key: &str| Complex::new(number(&params[key][0]), number(&params[key][1]));
        let omega = [0, 1, 2].map(|i| number(&params["omega0"][i]));
        let orientation = Orientation { alpha: z("alpha0"), beta: z("beta0") };
        let launch = Launch::State { orientation, omega };
        (input(&json, launch), json)
    }

    #[test]
    fn states_known_to_thirty_digits() {
        let mut checked = 0;
        for name in ["generic", "off_norm", "vertical", "vertical_spin", "downward"] {
            let (input, json) = state_vector(&format!("exact_state_{name}"));
            let exact = Quadrature::new(&input);
            let off = relative(&exact.period().expect("a period"), &json["period"]["T"]);
            assert!(off < 1e-29, "{name}: period off by {off:e}");
            for sample in samples(&json) {
                let error = error(&exact.at(&digits(&sample["t"])), sample);
                assert!(error < 1e-28, "{name} at {}: {error:e}", sample["t"]);
                checked += 1;
            }
        }
        assert!(checked > 60);
    }
}
