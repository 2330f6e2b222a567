//! Tables in C as several files: those of one table, and those that all tables share.

use super::{SHARED_HEADER, SHARED_SOURCE, declaration, shared_header, shared_source, source};
use crate::bake::{Label, Parts};
use crate::motion::Scalar;

/// Names and texts of the files that all tables share, and of the header and the source of a table.
#[must_use]
pub fn split_files(label: &Label, parts: &Parts) -> Vec<(String, String)> {
    let name = label.c_name();
    vec![
        (SHARED_HEADER.to_owned(), shared_header()),
        (SHARED_SOURCE.to_owned(), shared_source()),
        (format!("{name}.c"), source(label, parts)),
        (format!("{name}.h"), declaration(label, parts)),
    ]
}

/// Files of a library for Arduino and PlatformIO, with an example.
#[must_use]
pub fn arduino_files(label: &Label, parts: &Parts) -> Vec<(String, String)> {
    let name = label.c_name();
    let mut files = vec![
        ("library.properties".to_owned(), properties()),
        (format!("examples/{name}/{name}.ino"), sketch(&name, parts.scalar)),
    ];
    let sources = split_files(label, parts);
    files.splice(1..1, sources.into_iter().map(|(file, text)| (format!("src/{file}"), text)));
    files
}

fn properties() -> String {
    format!(
        "name=ToytopBaked
version={version}
author=toytop
maintainer=toytop
sentence=The exact motion of a spinning top, from tables that were made on a PC.
paragraph=Written by toytop bake. Each table is one motion; any tick takes the same time, without drift.
category=Data Processing
url=https://github.com/toytop/toytop
architectures=*
",
        version = env!("CARGO_PKG_VERSION"),
    )
}

fn sketch(name: &str, scalar: Scalar) -> String {
    let (scalar, upper) = (scalar.name(), name.to_uppercase());
    let number = match scalar {
        "f64" => "double",
        "q31" => "int32_t",
        "q15" => "int16_t",
        _ => "float",
    };
    format!(
        "// The quaternion w, x, y, z of the top, ten times a second.
#include <{name}.h>

void setup() {{ Serial.begin(115200); }}

void loop() {{
    int64_t tick = (int64_t)(millis() * ({upper}_RATE / 1000.0));
    toytop_sample_{scalar} now = toytop_at_tick_{scalar}(&{name}, tick);
    {number} quaternion[4];
    toytop_quaternion_{scalar}(&now, quaternion);
    for (int i = 0; i < 4; i++) {{
        Serial.print(quaternion[i]);
        Serial.print(i < 3 ? ' ' : '\\n');
    }}
    delay(100);
}}
"
    )
}
