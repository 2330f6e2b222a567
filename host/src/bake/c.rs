//! A C header: the table and what evaluates it, in C99 and C++11 or later without a library, to the same bits as the crate.
//!
//! Numbers are decimal, with as many digits as tell every one from its neighbours (9 in single, 17 in double precision): C++ has
//! hexadecimal ones since C++17 only. The include guard of a table is defined as its checksum, so that another table of the
//! same name is an error.

use super::{Coefficients, Label, Parts};
use crate::motion::Scalar;
use toytop::scalar::SINE_CONSTANTS;
use toytop::{Clock, ErrorBound};

/// Phases: the same for every scalar.
const CLOCK: &str = include_str!("clock.h");
/// Functions that read a table, common to all scalars.
const ACCESSORS: &str = include_str!("accessors.h");
/// Checksum of integers.
const INTACT: &str = include_str!("intact.h");

/// The text of a header. Several may be included in one file: what they share is there once.
#[must_use]
pub fn header(label: &Label, parts: &Parts) -> String {
    let name = name(label);
    let (scalar, guard) = (parts.scalar.name(), name.to_uppercase());
    let evaluators = match parts.scalar {
        Scalar::F64 => evaluator("f64", &(series() + include_str!("f64.h")), include_str!("intact_f64.h")),
        // fixed point stands on the integers of f32
        more => {
            let base = evaluator("f32", &(points() + include_str!("f32.h")), INTACT);
            match more {
                Scalar::Q31 => base + &evaluator("q31", include_str!("q31.h"), INTACT),
                Scalar::Q15 => base + &evaluator("q15", include_str!("q15.h"), INTACT),
                _ => base,
            }
        }
    };
    let (ctype, rows) = match &parts.coefficients {
        Coefficients::Integers(rows) => ("int32_t", rows.iter().map(|row| line(row.map(integer))).collect()),
        Coefficients::Shorts(rows) => {
            ("int16_t", rows.iter().map(|row| line(row.map(|x| x.to_string()))).collect())
        }
        Coefficients::Doubles(rows) => ("double", rows.iter().map(|row| line(row.map(decimal))).collect()),
    };
    let rows: String = rows;
    format!(
        "/* {headline}
 *
 * Written by `toytop bake`. Call toytop_at_tick_{scalar}(&{name}, tick), or toytop_next_{scalar} with a cursor; toytop_intact_{scalar} tells
 * whether a bit was changed. As a quaternion the orientation is w = alpha[0], x = beta[1], y = -beta[0], z = alpha[1].
 * The same bits as the Rust crate: with contraction of floating point off (-std=c99 with GCC, otherwise -ffp-contract=off). */
#ifdef {guard}_H
#if {guard}_H != {crc32:#x}
#error two different tables have the name {name}: rename one of the scenario files and bake it again
#endif
#else
#define {guard}_H {crc32:#x}

{CLOCK}
{evaluators}
static const {ctype} {name}_coefficients[{count}][4] = {{
{rows}}};

static const toytop_{scalar} {name} = {{
    {{
{clock}    }},
    {{{scales}}},
    {name}_coefficients,
}};
#endif
",
        headline = label.headline(parts),
        crc32 = parts.crc32,
        count = parts.size[0] * parts.size[1],
        clock = clock(parts),
        scales = scales(parts)
            .map(|x| if parts.scalar == Scalar::F64 { decimal(x) } else { format!("{:.8e}f", x as f32) })
            .join(", "),
    )
}

/// One word may be C's, or a library's (`int`, `clock`); so may what ends in `_t`.
fn name(label: &Label) -> String {
    let name = label.identifier();
    if name.contains('_') && !name.ends_with("_t") { name } else { format!("top_{name}") }
}

/// Evaluator of the tables of a scalar: its own arithmetic, and two templates. Several headers share it.
fn evaluator(scalar: &str, arithmetic: &str, intact: &str) -> String {
    let (name, bits) = (scalar.to_uppercase(), &scalar[1..]);
    let asked = [ACCESSORS, intact].concat().replace("SCALAR", scalar).replace("BITS", bits);
    format!("#ifndef TOYTOP_{name}\n#define TOYTOP_{name}\n{arithmetic}{asked}#endif\n")
}

/// The initialisers of a `toytop_clock`.
fn clock(parts: &Parts) -> String {
    let [segments, terms] = parts.size;
    let wide = |bits: u64| format!("{bits:#x}u");
    let phase = |[low, middle, upper]: [u32; 3]| {
        format!("{{{:#x}u, {low:#x}u}}", u64::from(upper) << 32 | u64::from(middle))
    };
    let Clock { step, first, horizon, exact_step, ticks_per_time, tip, turns, .. } = &parts.clock;
    let bound = |ErrorBound { constant, per_tick }: ErrorBound| [constant, per_tick];
    let bounds = [parts.error_bound, parts.rate_error_bound].map(bound);
    let doubles = [exact_step.as_flattened(), ticks_per_time, bounds.as_flattened()].concat();
    let numbers: Vec<_> = doubles.into_iter().map(|x| wide(x.to_bits())).collect();
    let words = |words: [u32; 4]| words.map(|word| format!("{word:#x}u")).join(", ");
    let flags = [tip.quarter as u8, tip.passes, tip.exists.into(), (*turns).into()];
    let lines = [
        format!("{}u, {:#x}u, {segments}u, {terms}u", parts.format, parts.crc32),
        format!("{{{}}}", first.map(wide).join(", ")),
        format!("{{{}}}", step.map(phase).join(", ")),
        format!("{{{}}}", numbers.join(", ")),
        u32::from(horizon.is_some()).to_string(),
        format!("{{{}}}", horizon.unwrap_or_default().map(tick).join(", ")),
        format!("{{{}}}, {{{}}}", words(tip.start), words(tip.step)),
        format!("{{{}}}", flags.map(|flag| flag.to_string()).join(", ")),
        format!("{{{}}}", parts.cells.map(|cell| cell.to_string()).join(", ")),
    ];
    lines.iter().map(|line| format!("        {line},\n")).collect()
}

/// Scale of the tip, the rates of x and of A + B, and the axial angular velocity.
fn scales(parts: &Parts) -> [f64; 4] {
    let Clock { tip_scale, rates: [x, mean, axial], .. } = parts.clock;
    [tip_scale, x, mean, axial]
}

/// The points of the circle, and the coefficients of the rest.
fn points() -> String {
    let ([linear, cubic, versine], secant) = (SINE_CONSTANTS.turn, SINE_CONSTANTS.secant);
    let rows = SINE_CONSTANTS.points.chunks(8);
    let rows: String = rows
        .map(|row| format!("    {},\n", row.iter().map(|&x| integer(x)).collect::<Vec<_>>().join(", ")))
        .collect();
    let count = SINE_CONSTANTS.points.len();
    format!(
        "#define TOYTOP_LINEAR {linear}\n#define TOYTOP_CUBIC {cubic}\n#define TOYTOP_VERSINE {versine}\n\
         #define TOYTOP_SECANT {secant}\n\
         /* 2^31 sin of 0, 1/512, ... turns, at most 2^31 - 1; a quarter turn on is the cosine. */\n\
         static const int32_t toytop_sines[{count}] = {{\n{rows}}};\n"
    )
}

/// sin 2 pi x = x S(x^2), cos 2 pi x = C(x^2).
fn series() -> String {
    let series = |name: &str, coefficients: &[f64]| {
        let rows: String = coefficients.iter().map(|&x| format!("    {},\n", decimal(x))).collect();
        format!("static const double toytop_{name}[{}] = {{\n{rows}}};\n", coefficients.len())
    };
    "/* sin 2 pi x = x S(x^2) and cos 2 pi x = C(x^2) for |x| <= 1/8. */\n".to_owned()
        + &series("sine", SINE_CONSTANTS.sine)
        + &series("cosine", SINE_CONSTANTS.cosine)
}

fn line(row: [String; 4]) -> String {
    format!("    {{{}}},\n", row.join(", "))
}

/// In C, -2147483648 is no constant of 32 bits but the negative of one that does not fit them.
fn integer(x: i32) -> String {
    if x == i32::MIN { "INT32_MIN".to_owned() } else { x.to_string() }
}

fn tick(n: i64) -> String {
    if n == i64::MIN { "INT64_MIN".to_owned() } else { format!("INT64_C({n})") }
}

/// A number of double precision in 17 significant digits, which C and C++ read to the same bits.
fn decimal(x: f64) -> String {
    format!("{x:.16e}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimal_numbers_are_read_as_they_were() {
        for x in [1.0, -0.1, -0.0, f64::from_bits(1), f64::MAX, 1.0 / 3.0] {
            assert_eq!(decimal(x).parse::<f64>().map(f64::to_bits), Ok(x.to_bits()));
        }
        assert_eq!([1.0, -0.0].map(decimal), ["1.0000000000000000e0", "-0.0000000000000000e0"]);
    }

    #[test]
    fn no_name_is_one_of_c() {
        let named = |name: &str| super::name(&Label { name: name.to_owned(), tick: String::new() });
        assert_eq!(["int", "Clock", "time_t"].map(named), ["top_int", "top_clock", "top_time_t"]);
        assert_eq!(["toy_top", "2 tops"].map(named), ["toy_top", "top_2_tops"]);
    }
}
