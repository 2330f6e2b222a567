//! Name and description of a table in the files of other programs.

use crate::motion::ephemeris::Parts;
use toytop::ErrorBound;

/// Description of the motion of a table, for the comment of a file.
pub struct Label {
    /// Name of the scenario.
    pub name: String,
    /// Length of a tick, as text.
    pub tick: String,
}

impl Label {
    /// Name as an identifier in lower case: letters and digits of ASCII are kept, any other letter or digit becomes `u` and at least four
    /// hexadecimal digits, and everything between becomes one underscore, but not at the ends.
    pub fn identifier(&self) -> String {
        let mut identifier = String::new();
        for c in self.name.chars() {
            match c {
                _ if c.is_ascii_alphanumeric() => identifier.push(c.to_ascii_lowercase()),
                _ if c.is_alphanumeric() => identifier += &format!("u{:04x}", u32::from(c)),
                _ if identifier.is_empty() || identifier.ends_with('_') => {}
                _ => identifier.push('_'),
            }
        }
        let identifier = identifier.trim_end_matches('_');
        if identifier.starts_with(|c: char| c.is_ascii_lowercase()) {
            identifier.to_owned()
        } else {
            format!("top_{identifier}")
        }
    }

    /// Identifier as a name in C and C++, and of a file. A single word or a name that ends in `_t` may belong to the language or to a library
    /// (`int`, `clock`), and a name that begins with `toytop_` may belong to this library. Such a name gets the prefix `top_`.
    pub fn c_name(&self) -> String {
        let name = self.identifier();
        let free = name.contains('_') && !name.ends_with("_t") && !name.starts_with("toytop_");
        if free { name } else { format!("top_{name}") }
    }

    /// Name and properties of the table for a comment, without characters that could end the comment.
    pub fn headline(&self, parts: &Parts) -> String {
        let printable = |c: &char| !c.is_control() && !['*', '/', '\\'].contains(c);
        let name: String = self.name.chars().filter(printable).collect();
        let ([segments, terms], ErrorBound { constant, per_tick }) = (parts.size, parts.error_bound);
        format!(
            "{name}, {}: {segments} x {terms} in {}; within {constant:.1e} rad + {per_tick:.1e} rad a tick",
            self.tick,
            parts.scalar.name(),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_becomes_an_unused_identifier() {
        let named = |name: &str| Label { name: name.to_owned(), tick: String::new() };
        for (name, identifier, c_name) in [
            ("int", "int", "top_int"),
            ("Clock", "clock", "top_clock"),
            ("time_t", "time_t", "top_time_t"),
            ("toytop_f32", "toytop_f32", "top_toytop_f32"),
            ("toy_top", "toy_top", "toy_top"),
            ("2 tops", "top_2_tops", "top_2_tops"),
            ("_a__b_", "a_b", "a_b"),
            ("Kreisel ä", "kreisel_u00e4", "kreisel_u00e4"),
            ("Kreisel ö", "kreisel_u00f6", "kreisel_u00f6"),
            ("陀螺", "u9640u87ba", "top_u9640u87ba"),
            ("...", "top_", "top_"),
        ] {
            let label = named(name);
            assert_eq!([label.identifier(), label.c_name()], [identifier, c_name], "{name}");
        }
    }
}
