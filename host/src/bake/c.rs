//! A C header: the table and what evaluates it, in C99 without a library, to the same bits as the crate.

use super::{Coefficients, Label, Parts};
use crate::cli::Scalar;
use toytop::real::SINE_CONSTANTS;

/// Phases: the same for every scalar.
const CLOCK: &str = include_str!("clock.h");
/// How a table is asked, whatever it evaluates by.
const ACCESSORS: &str = include_str!("accessors.h");
/// The checksum of integers.
const INTACT: &str = include_str!("intact.h");

/// The header's text. Several may be included in one file: what they share is there once.
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
        Coefficients::Doubles(rows) => {
            ("double", rows.iter().map(|row| line(row.map(hexadecimal))).collect())
        }
    };
    let rows: String = rows;
    format!(
        "/* {headline}
 *
 * Written by `toytop bake`. Call toytop_at_tick_{scalar}(&{name}, tick), or toytop_next_{scalar} with a cursor; toytop_intact_{scalar} tells
 * whether a bit was changed. As a quaternion the orientation is w = alpha[0], x = beta[1], y = -beta[0], z = alpha[1].
 * The same bits as the Rust crate: with contraction of floating point off (-std=c99 with GCC, otherwise -ffp-contract=off). */
#ifndef {guard}_H
#define {guard}_H

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
        count = parts.size[0] * parts.size[1],
        clock = clock(parts),
        scales = parts
            .scales
            .map(|x| hexadecimal(x) + if parts.scalar == Scalar::F64 { "" } else { "f" })
            .join(", "),
    )
}

/// One word may be C's, or a library's (`int`, `clock`); so may what ends in `_t`.
fn name(label: &Label) -> String {
    let name = label.identifier();
    if name.contains('_') && !name.ends_with("_t") { name } else { format!("top_{name}") }
}

/// What evaluates the tables of a scalar: its own arithmetic, and two templates. Several headers share it.
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
    let doubles = [parts.exact_step.as_flattened(), &parts.ticks_per_time, &parts.bound].concat();
    let numbers: Vec<_> = doubles.into_iter().map(|x| wide(x.to_bits())).collect();
    let lines = [
        format!("{}u, {:#x}u, {segments}u, {terms}u", parts.format, parts.checksum),
        format!("{{{}}}", parts.first.map(wide).join(", ")),
        format!("{{{}}}", parts.step.map(phase).join(", ")),
        format!("{{{}}}", numbers.join(", ")),
        u32::from(parts.horizon.is_some()).to_string(),
        format!("{{{}}}", parts.horizon.unwrap_or_default().map(tick).join(", ")),
        format!("{{{}}}", parts.cells.map(|cell| cell.to_string()).join(", ")),
    ];
    lines.iter().map(|line| format!("        {line},\n")).collect()
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
        let rows: String = coefficients.iter().map(|&x| format!("    {},\n", hexadecimal(x))).collect();
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

/// A number as C99 reads it without rounding.
fn hexadecimal(x: f64) -> String {
    const MANTISSA: u64 = (1 << 52) - 1;
    let bits = x.to_bits();
    let sign = if bits >> 63 == 1 { "-" } else { "" };
    let (leading, exponent) = match (bits >> 52 & 0x7ff) as i32 {
        0 => (0, -1022),
        biased => (1, biased - 1023),
    };
    match bits & !(1 << 63) {
        0 => format!("{sign}0.0"),
        _ => format!("{sign}0x{leading}.{:013x}p{exponent}", bits & MANTISSA),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hexadecimal_numbers() {
        for (x, text) in [
            (1.0, "0x1.0000000000000p0"),
            (-0.1, "-0x1.999999999999ap-4"),
            (-0.0, "-0.0"),
            (f64::from_bits(1), "0x0.0000000000001p-1022"),
        ] {
            assert_eq!(hexadecimal(x), text);
        }
    }

    #[test]
    fn no_name_is_one_of_c() {
        let named = |name: &str| super::name(&Label { name: name.to_owned(), tick: String::new() });
        assert_eq!(["int", "Clock", "time_t"].map(named), ["top_int", "top_clock", "top_time_t"]);
        assert_eq!(["toy_top", "2 tops"].map(named), ["toy_top", "top_2_tops"]);
    }
}
