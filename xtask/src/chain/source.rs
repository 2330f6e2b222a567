//! Rust source, as far as the reading rule needs it: code without comments, strings and tests, and its `use` paths.

/// The code of a file: comments, contents of strings, and `#[cfg(test)]` items replaced by spaces.
pub(crate) struct Code {
    text: String,
}

/// A path that the code mentions.
pub(crate) struct Use {
    pub(crate) line: usize,
    pub(crate) path: Vec<String>,
}

impl Code {
    pub(crate) fn new(source: &str) -> Self {
        Self { text: without_tests(&without_comments(source)) }
    }

    /// The numbers of the lines that contain a word.
    pub(crate) fn lines_with(&self, word: &str) -> impl Iterator<Item = usize> {
        self.text.lines().enumerate().filter(move |(_, line)| line.contains(word)).map(|(index, _)| index + 1)
    }

    /// All paths that begin with `crate`, `super` or `self`, those with braces written out.
    pub(crate) fn uses(&self) -> Vec<Use> {
        let mut uses = Vec::new();
        for start in ["crate::", "super::", "self::"] {
            for (at, _) in self.text.match_indices(start) {
                let before = self.text[..at].chars().next_back();
                if before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == ':') {
                    continue; // inside a longer path
                }
                let line = self.text[..at].matches('\n').count() + 1;
                let mut paths = Vec::new();
                write_out(&self.text[at..], &mut Vec::new(), &mut paths);
                uses.extend(paths.into_iter().map(|path| Use { line, path }));
            }
        }
        uses
    }

    /// The path that a name is re-exported from: of `pub use a::{B, c::D}`, a::B for B.
    pub(crate) fn reexport(&self, name: &str) -> Option<Vec<String>> {
        let statements = self.text.split(';').filter_map(|statement| {
            let at = statement.rfind("use ")?;
            statement[..at].contains("pub").then(|| statement[at + 4..].trim_start())
        });
        statements.into_iter().find_map(|tree| {
            let mut paths = Vec::new();
            write_out(tree, &mut Vec::new(), &mut paths);
            paths.into_iter().find(|path| path.len() > 1 && path.last().is_some_and(|last| last == name))
        })
    }
}

/// Writes out a `use` tree, or a plain path: returns what is left of the text behind it.
fn write_out<'a>(text: &'a str, prefix: &mut Vec<String>, paths: &mut Vec<Vec<String>>) -> &'a str {
    let depth = prefix.len();
    let mut rest = text.trim_start();
    loop {
        if let Some(inside) = rest.strip_prefix('{') {
            rest = inside.trim_start();
            while !rest.starts_with('}') && !rest.is_empty() {
                rest = write_out(rest, prefix, paths).trim_start();
                rest = rest.strip_prefix(',').unwrap_or(rest).trim_start();
            }
            rest = rest.strip_prefix('}').unwrap_or(rest);
            break;
        }
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        if end == 0 {
            // `*`, or something that is no path: skip a character, so that the walk goes on
            rest = rest.get(rest.chars().next().map_or(0, char::len_utf8)..).unwrap_or("");
            paths.push(prefix.clone());
            break;
        }
        prefix.push(rest[..end].to_owned());
        rest = &rest[end..];
        if let Some(more) = rest.strip_prefix("::") {
            rest = more.trim_start();
        } else {
            let renamed = rest.trim_start().strip_prefix("as ").map(str::trim_start);
            if let Some(renamed) = renamed {
                rest = renamed.trim_start_matches(|c: char| c.is_alphanumeric() || c == '_');
            }
            paths.push(prefix.clone());
            break;
        }
    }
    prefix.truncate(depth);
    rest
}

/// Blanks comments and the contents of strings and characters; keeps line ends.
fn without_comments(source: &str) -> String {
    let mut out = String::with_capacity(source.len());
    let mut rest = source;
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if first == '"' {
            string_length(rest)
        } else if let Some(raw) = raw_string_length(rest, &out) {
            raw
        } else if first == '\'' {
            character_length(rest)
        } else {
            out.push(first);
            rest = &rest[first.len_utf8()..];
            continue;
        };
        out.extend(rest[..length].chars().map(|c| if c == '\n' { '\n' } else { ' ' }));
        rest = &rest[length..];
    }
    out
}

fn string_length(text: &str) -> usize {
    let mut escaped = true; // the opening quote
    for (at, c) in text.char_indices() {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            '"' => return at + 1,
            _ => {}
        }
    }
    text.len()
}

fn raw_string_length(text: &str, before: &str) -> Option<usize> {
    if before.ends_with(|c: char| c.is_alphanumeric() || c == '_') {
        return None;
    }
    let hashes = text.strip_prefix('r')?.chars().take_while(|&c| c == '#').count();
    text.get(hashes + 1..)?.strip_prefix('"')?;
    let close = format!("\"{}", "#".repeat(hashes));
    let body = hashes + 2;
    Some(text[body..].find(&close).map_or(text.len(), |end| body + end + close.len()))
}

/// A character literal; a lifetime's quote stands for itself.
fn character_length(text: &str) -> usize {
    let mut characters = text.char_indices().skip(1);
    match (characters.next(), characters.next()) {
        (Some((_, '\\')), _) => text[3..].find('\'').map_or(1, |end| end + 4),
        (_, Some((at, '\''))) => at + 1,
        _ => 1,
    }
}

/// Blanks the items behind `#[cfg(test)]`.
fn without_tests(code: &str) -> String {
    const MARK: &str = "#[cfg(test)]";
    let mut out = String::with_capacity(code.len());
    let mut rest = code;
    while let Some(at) = rest.find(MARK) {
        out += &rest[..at];
        let length = MARK.len() + item_length(&rest[at + MARK.len()..]);
        out.extend(rest[at..at + length].chars().filter(|&c| c == '\n'));
        rest = &rest[at + length..];
    }
    out + rest
}

/// Up to the `;`, or to the `}` of the first `{`.
fn item_length(text: &str) -> usize {
    let mut depth = 0;
    for (at, c) in text.char_indices() {
        match c {
            ';' if depth == 0 => return at + 1,
            '{' => depth += 1,
            '}' if depth == 1 => return at + 1,
            '}' => depth -= 1,
            _ => {}
        }
    }
    text.len()
}
