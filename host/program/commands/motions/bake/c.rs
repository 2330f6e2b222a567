//! Tables in C99 or C++11: one header with the code that evaluates the table. The code needs no library, and gives the same bits as the
//! crate.
//!
//! Numbers are decimal, because C++ has hexadecimal ones only since C++17, with enough digits to determine every number (9 in single, 17
//! in double precision). The value of the include guard of a table is its checksum, so that another table of the same name is an error.

use super::TableTitle;
use toytop::internal::{COSINE, CUBIC, LINEAR, SINE, SINES, SMALL_SINE, VERSINE};
use toytop::scalar::Float;
use toytop::{Baked, ErrorBound, Table, TableScalar};
use toytop_host::motion::Scalar;

/// Version of the format.
const FORMAT: u32 = Baked::<f32, 16>::FORMAT;

/// Text of a header: a comment, the include guard, size and error bounds as macros, the code and the table. If one file includes several
/// headers, the code that they share is compiled once.
pub fn header<R: TableScalar<Coefficient: Into<f64>>>(
    title: &TableTitle,
    table: &Table<R>,
    crc32: u32,
) -> String {
    let name = title.c_name();
    let (scalar, upper) = (title.scalar.name(), name.to_uppercase());
    let bounds = [table.error_bound(), table.rate_error_bound()];
    let [[error, error_growth], [rate, rate_growth]] =
        bounds.map(|ErrorBound { constant, per_tick }| [constant, per_tick].map(decimal));
    format!(
        "/* {headline}
 *
 * Written by `toytop bake`. Call toytop_at_tick_{scalar}(&{name}, tick), or toytop_next_{scalar} with a cursor; toytop_quaternion_{scalar} and
 * toytop_omega_{scalar} tell more, and toytop_intact_{scalar} whether a bit was changed.
 * The same bits as the Rust crate, in every standard and with any flag but -ffast-math. */
#ifdef {upper}_H
#if {upper}_H != {crc32:#x}
#error two different tables have the name {name}: give one of them another by --name
#endif
#else
#define {upper}_H {crc32:#x}

#define {upper}_RATE {ticks} /* ticks in a unit of time */
#define {upper}_SEGMENTS {segments}
#define {upper}_BYTES {bytes} /* of coefficients */
#define {upper}_ERROR {error} /* at most, rad, at tick 0 */
#define {upper}_ERROR_PER_TICK {error_growth} /* more for each tick from there */
#define {upper}_RATE_ERROR {rate} /* of the angular velocity, rad in a unit of time */
#define {upper}_RATE_ERROR_PER_TICK {rate_growth}

{code}
{table}#endif
",
        code = code(title.scalar),
        table = definition(title, table, crc32),
        headline = title.headline(table),
        ticks = decimal(table.clock().ticks_per_time[0]),
        segments = table.capacity(),
        bytes = size_of_val(table.segments()),
    )
}

/// Definition of a table.
fn definition<R: TableScalar<Coefficient: Into<f64>>>(
    title: &TableTitle,
    table: &Table<R>,
    crc32: u32,
) -> String {
    let (name, scalar) = (title.c_name(), title.scalar.name());
    let is_f64 = title.scalar == Scalar::F64;
    let number = |x: R::Coefficient| {
        let x: f64 = x.into();
        if is_f64 { decimal(x) } else { integer(x as i32) }
    };
    let rows = table.segments().iter().flat_map(|segment| segment.as_ref());
    let rows: Vec<_> = rows.map(|row| format!("    {{{}}},\n", row.map(number).join(", "))).collect();
    let clock = table.clock();
    let scales = [clock.twice_tip_scale, clock.x_rate, clock.mean_sum_rate, clock.spin].map(Float::to_f64);
    format!(
        "static const toytop_coefficient_{scalar} {name}_coefficients[{count}][4] = {{
{rows}}};

static const toytop_{scalar} {name} = {{
    {{
{clock}    }},
    {{{scales}}},
    {name}_coefficients,
}};
",
        count = rows.len(),
        rows = rows.concat(),
        clock = initialisers(table, crc32),
        scales = scales.map(|x| if is_f64 { decimal(x) } else { format!("{:.8e}f", x as f32) }).join(", "),
    )
}

/// Initialisers of a `toytop_clock`, a line for those of each type.
fn initialisers<R: TableScalar>(table: &Table<R>, crc32: u32) -> String {
    let clock = table.clock();
    let words = |numbers: &[u64]| {
        let words: Vec<_> = numbers.iter().map(|number| format!("{number:#x}u")).collect();
        format!("{{{}}}", words.join(", "))
    };
    let doubles = |numbers: &[f64]| words(&numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>());
    let phase = |[low, middle, upper, _]: [u32; 4]| {
        words(&[u64::from(upper) << 32 | u64::from(middle), u64::from(low)])
    };
    let bounds = [table.error_bound(), table.rate_error_bound()];
    let bounds = bounds.map(|ErrorBound { constant, per_tick }| [constant, per_tick]);
    let rows = table.capacity() * R::TERMS;
    [
        format!("{FORMAT}u, {crc32:#x}u, {}u, {}u, ~{rows}u", table.capacity(), R::TERMS),
        format!("{}, {:#x}u", words(&clock.first_phases), clock.epoch as u64),
        format!("{{{}}}", clock.increments.map(phase).join(", ")),
        words(&clock.increments.map(|[.., turns]| turns.into())),
        [&clock.ticks_per_time, bounds.as_flattened()].map(doubles).join(", "),
        words(&clock.mean_tip_at_tick_0.map(u64::from)),
        format!(
            "{{{}, {}, {}}}, {}",
            clock.ab_quarter_turns_at_e1 as u8,
            clock.tip_passages,
            u8::from(clock.tip_exists),
            u8::from(clock.has_turning_points)
        ),
        words(&table.cells().map(u64::from)),
    ]
    .map(|line| format!("        {line},\n"))
    .concat()
}

/// Constant of 32 bits in C, which has no literal -2147483648.
fn integer(x: i32) -> String {
    if x == i32::MIN { "INT32_MIN".to_owned() } else { x.to_string() }
}

/// Number in double precision with 17 significant digits, from which C and C++ obtain the same bits.
fn decimal(x: f64) -> String {
    format!("{x:.16e}")
}

/// Code that evaluates a table of this scalar: the clock, and the functions in integers or in double precision. Each part is compiled once.
fn code(scalar: Scalar) -> String {
    let clock =
        concat!(include_str!("c/clock.h"), "\n", include_str!("c/scalar.h"), "\n", include_str!("c/rates.h"));
    let evaluator = match scalar {
        Scalar::F64 => ("F64", series() + include_str!("c/f64.h")),
        _ => ("INTEGER", points() + include_str!("c/integer.h") + include_str!("c/q15.h")),
    };
    let mut text = "#ifndef TOYTOP_API\n#define TOYTOP_API static inline\n#endif\n".to_owned();
    for (guard, code) in [("CLOCK", clock.to_owned()), evaluator] {
        text += &format!(
            "#ifndef TOYTOP_{guard}\n#define TOYTOP_{guard} {FORMAT}\n{code}#elif TOYTOP_{guard} != {FORMAT}\n\
             #error two versions of toytop wrote these headers: write them again\n#endif\n"
        );
    }
    text
}

/// Table of sines in C, and the coefficients of the interpolation.
fn points() -> String {
    let rows = SINES.chunks(8);
    let rows: String = rows
        .map(|row| format!("    {},\n", row.iter().map(|&x| integer(x)).collect::<Vec<_>>().join(", ")))
        .collect();
    let count = SINES.len();
    format!(
        "#define TOYTOP_LINEAR {LINEAR}\n#define TOYTOP_CUBIC {CUBIC}\n#define TOYTOP_VERSINE {VERSINE}\n\
         #define TOYTOP_SECANT {SMALL_SINE}\n\
         /* 2^31 sin of 0, 1/512, ... turns, at most 2^31 - 1; a quarter turn on is the cosine. */\n\
         static const int32_t toytop_sines[{count}] = {{\n{rows}}};\n"
    )
}

/// Coefficients in C of the series sin 2 pi x = x S(x^2), cos 2 pi x = C(x^2).
fn series() -> String {
    let series = |name: &str, coefficients: &[f64]| {
        let rows: String = coefficients.iter().map(|&x| format!("    {},\n", decimal(x))).collect();
        format!("static const double toytop_{name}[{}] = {{\n{rows}}};\n", coefficients.len())
    };
    "/* sin 2 pi x = x S(x^2) and cos 2 pi x = C(x^2) for |x| <= 1/8. */\n".to_owned()
        + &series("sine", &SINE)
        + &series("cosine", &COSINE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimal_numbers_are_read_back_to_the_same_bits() {
        for x in [1.0, -0.1, -0.0, f64::from_bits(1), f64::MAX, 1.0 / 3.0] {
            assert_eq!(decimal(x).parse::<f64>().map(f64::to_bits), Ok(x.to_bits()));
        }
        assert_eq!([1.0, -0.0].map(decimal), ["1.0000000000000000e0", "-0.0000000000000000e0"]);
    }
}
