//! Types and functions in C that evaluate a table, and that all tables share.

use super::{decimal, integer};
use crate::motion::Scalar;
use toytop::scalar::sine::{COSINE, CUBIC, LINEAR, SECANT, SINE, SINES, VERSINE};

/// Name of the header that declares the shared code.
pub const SHARED_HEADER: &str = "toytop_baked.h";
/// Name of the source that defines the shared code.
pub const SHARED_SOURCE: &str = "toytop_baked.c";

/// Part of the code: its types and its functions, of which the public ones begin with [`API`].
struct Part {
    /// Macro that is defined if the part is included.
    guard: String,
    types: String,
    functions: String,
}

/// Text before a public function in the sources.
const API: &str = "TOYTOP_API ";

/// Part from its template, in which a line separates types and functions.
fn part(name: &str, template: &str, constants: &str, more: &str) -> Part {
    let (types, functions) = template.split_once("/* Functions. */\n").unwrap_or((template, ""));
    let guard = format!("TOYTOP_{}", name.to_uppercase());
    Part { guard, types: types.to_owned(), functions: [constants, functions, more].concat() }
}

/// Part for a scalar: its arithmetic, and the functions that are written for all scalars.
fn evaluator(scalar: &Scalar) -> Part {
    let (name, intact) = (scalar.name(), include_str!("intact.h"));
    let (template, constants, intact, number) = match scalar {
        Scalar::F32 => (include_str!("f32.h"), points(), intact, "float"),
        Scalar::Q31 => (include_str!("q31.h"), String::new(), intact, "int32_t"),
        Scalar::Q15 => (include_str!("q15.h"), String::new(), intact, "int16_t"),
        Scalar::F64 => (include_str!("f64.h"), series(), include_str!("intact_f64.h"), "double"),
    };
    let functions = [include_str!("accessors.h"), intact].concat();
    let functions = functions.replace("SCALAR", name).replace("BITS", &name[1..]).replace("NUMBER", number);
    part(name, template, &constants, &functions)
}

/// Part for phases, and those of the scalars.
fn parts(scalars: &[Scalar]) -> Vec<Part> {
    let clock = part("clock", include_str!("clock.h"), "", "");
    std::iter::once(clock).chain(scalars.iter().map(evaluator)).collect()
}

/// Scalars of the shared files. Each but the last needs the code of those before it: fixed point uses the integers of f32, and 16 bits
/// the vectors of 32 bits.
const SCALARS: [Scalar; 4] = [Scalar::F32, Scalar::Q31, Scalar::Q15, Scalar::F64];

/// Version of the format, the value of the macros.
const FORMAT: u32 = toytop::Baked::<f32, 16>::FORMAT;

/// Code for a header that needs no other file: every function is `static inline`, and included once.
pub fn inlined(scalar: Scalar) -> String {
    let needed = match scalar {
        Scalar::F32 => &SCALARS[..1],
        Scalar::Q31 => &SCALARS[..2],
        Scalar::Q15 => &SCALARS[..3],
        Scalar::F64 => &SCALARS[3..],
    };
    let mut text = "#ifndef TOYTOP_API\n#define TOYTOP_API static inline\n#endif\n".to_owned();
    for Part { guard, types, functions } in parts(needed) {
        text += &format!("#ifndef {guard}\n#define {guard} {FORMAT}\n{types}\n{functions}#endif\n");
    }
    text
}

/// Text of [`SHARED_HEADER`].
pub fn header() -> String {
    let mut text = format!(
        "/* What all tables of `toytop bake` share: types and functions, defined in {SHARED_SOURCE}. C99 and C++11 or later. */\n\
         #ifndef TOYTOP_BAKED_H\n#define TOYTOP_BAKED_H\n"
    );
    let parts = parts(&SCALARS);
    for Part { guard, types, .. } in &parts {
        text += &format!("#define {guard} {FORMAT}\n{types}");
    }
    text += "\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n";
    parts.iter().for_each(|part| text += &declarations(&part.functions));
    text + "#ifdef __cplusplus\n}\n#endif\n#endif\n"
}

/// Text of [`SHARED_SOURCE`].
pub fn source() -> String {
    let mut text = format!(
        "/* What all tables of `toytop bake` share: the functions. C99. */\n#include \"{SHARED_HEADER}\"\n\n#define TOYTOP_API\n"
    );
    parts(&SCALARS).iter().for_each(|part| text += &format!("\n{}", part.functions));
    text
}

/// Declarations of the public functions, each with its comment.
fn declarations(functions: &str) -> String {
    let mut text = String::new();
    let mut comment = String::new();
    for line in functions.lines() {
        if line.starts_with("/*") {
            comment.clear();
        }
        if line.starts_with("/*") || line.starts_with(" *") {
            comment += &format!("{line}\n");
        } else if let Some(signature) = line.strip_prefix(API) {
            text += &format!("{comment}{};\n", signature.trim_end_matches([' ', '{']));
        }
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
         #define TOYTOP_SECANT {SECANT}\n\
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
    fn every_public_function_is_declared_with_its_comment() {
        let declared = header();
        let defined = source().matches(&format!("\n{API}")).count();
        assert_eq!(declared.matches(");\n").count(), defined);
        assert_eq!(declared.matches("*/\nvoid toytop_omega_").count(), 4 * 2);
        assert!(defined > 20 && !declared.contains("static inline"), "{defined}");
    }
}
