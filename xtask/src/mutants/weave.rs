//! All mutants of a file in one text: each function gets, beside its own body, one for each of its mutants, and chooses at run
//! time. So one build serves hundreds of them.

use std::ops::Range;

use super::list::{Mutant, Place, Span};

/// In front of a body that is no mutant's.
const OWN: &str = "_ => { // mutant none";

/// A mutant among those of a build.
#[derive(Clone, Copy)]
pub(super) struct Chosen<'a> {
    /// Its own, from 1.
    pub(super) number: u32,
    /// That of the first mutant of the same function, which stands for the function.
    pub(super) function: u32,
    pub(super) mutant: &'a Mutant,
}

/// A file's text with these mutants of it, which stand in the order of the text.
pub(super) fn weave(text: &str, mutants: &[Chosen]) -> String {
    let mut woven = String::new();
    let mut done = 0;
    for group in mutants.chunk_by(|a, b| a.function == b.function) {
        let body = body(text, &bytes(text, group[0].mutant.function));
        woven += &text[done..body.start];
        woven += &format!("match crate::mutant::chosen({}) {{\n", group[0].function);
        for Chosen { number, mutant, .. } in group {
            let span = bytes(text, mutant.span);
            let (before, after) = (&text[body.start..span.start], &text[span.end..body.end]);
            let change = &mutant.replacement;
            // the space: what follows may be a number, or an operator that would be another one together with this
            woven += &format!("{number} => {{ // mutant {number}\n{before}{change} {after}\n}}\n");
        }
        woven += &format!("{OWN}\n{}\n}}\n}}\n", &text[body.clone()]);
        done = body.end;
    }
    woven + &text[done..]
}

/// The mutant that a line of a woven text belongs to, from 1.
pub(super) fn at_line(woven: &str, line: usize) -> Option<u32> {
    let heads = woven.lines().take(line).filter_map(|line| line.split_once("// mutant "));
    heads.last().and_then(|(_, number)| number.parse().ok())
}

/// Between a function's braces.
fn body(text: &str, function: &Range<usize>) -> Range<usize> {
    let mut start = function.start;
    // braces of documentation and attributes are not the body's
    for line in text[function.clone()].split_inclusive('\n') {
        let code = line.trim_start();
        match line.find('{') {
            Some(brace) if !code.starts_with("//") && !code.starts_with("#[") => {
                start += brace + 1;
                break;
            }
            _ => start += line.len(),
        }
    }
    start..function.end - 1
}

fn bytes(text: &str, span: Span) -> Range<usize> {
    byte(text, span.start)..byte(text, span.end)
}

/// Columns count characters.
fn byte(text: &str, (line, column): Place) -> usize {
    let before: usize = text.split_inclusive('\n').take(line - 1).map(str::len).sum();
    before + text[before..].chars().take(column - 1).map(char::len_utf8).sum::<usize>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_mutant_has_a_body() {
        let text = "/// {\nfn f() -> i32 {\n    1 + 2\n}\nfn g() {}\n";
        let function = Span { start: (1, 1), end: (4, 2) };
        let mutant = |span, replacement: &str| Mutant {
            name: String::new(),
            file: String::new(),
            function,
            span,
            replacement: replacement.into(),
        };
        let minus = mutant(Span { start: (3, 7), end: (3, 8) }, "-");
        let zero = mutant(Span { start: (3, 5), end: (3, 10) }, "0");
        let chosen = |number, mutant| Chosen { number, function: 7, mutant };
        let woven = weave(text, &[chosen(7, &minus), chosen(8, &zero)]);
        assert!(
            woven.starts_with("/// {\nfn f() -> i32 {match crate::mutant::chosen(7) {\n7 => {"),
            "{woven}"
        );
        assert!(woven.contains("1 -  2") && woven.contains("    0 \n"), "{woven}");
        assert!(woven.contains("1 + 2") && woven.ends_with("}\nfn g() {}\n"), "{woven}");
        let line = |what| 1 + woven.lines().position(|line| line.contains(what)).unwrap();
        assert_eq!(at_line(&woven, line("1 -  2")), Some(7));
        assert_eq!(at_line(&woven, line("    0 ")), Some(8));
        assert_eq!(at_line(&woven, line("1 + 2")), None);
    }
}
