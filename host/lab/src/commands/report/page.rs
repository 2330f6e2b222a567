//! Page in HTML, which needs no other file.

use super::Table;
use std::fmt::Write as _;
use toytop_host::output;

/// Contents of the page.
pub(super) struct Page {
    pub(super) accuracy: Table,
    pub(super) precision: Table,
    pub(super) budget: Table,
    /// Whether the budget contains measured costs (`true`) or limits.
    pub(super) measured: bool,
    /// Title and SVG of each picture.
    pub(super) pictures: Vec<(&'static str, Vec<u8>)>,
}

const STYLE: &str = "body{font:16px/1.5 system-ui,sans-serif;max-width:70rem;margin:2rem auto;padding:0 1rem;color:#222}\
table{border-collapse:collapse;margin:1rem 0;font-variant-numeric:tabular-nums}\
th,td{padding:.2rem .8rem;border-bottom:1px solid #ddd;text-align:right}th:first-child,td:first-child,\
#budget :is(th,td):nth-child(2){text-align:left}\
th{border-bottom:2px solid #888}svg{max-width:100%;height:auto}.scroll{overflow-x:auto}";

impl Page {
    pub(super) fn html(&self) -> String {
        let version = env!("CARGO_PKG_VERSION");
        let mut html = format!(
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>toytop {version}: report</title>\
             <meta name=\"viewport\" content=\"width=device-width\"><style>{STYLE}</style></head><body>\n\
             <h1>toytop {version}</h1>\n<p>Times are those of this machine: {}. Errors are the same on all.</p>\n",
            output::html(&machine()),
        );
        let (mut figures, mut pictures) = (String::new(), self.pictures.iter());
        let section = |html: &mut String, title: &str, text: &str, table: &Table| {
            // writing to a String cannot fail
            let id = title.to_lowercase().replace(' ', "-");
            let markup = markup(table);
            let _ =
                write!(html, "<section id=\"{id}\"><h2>{title}</h2>\n<p>{text}</p>\n{markup}</section>\n");
        };
        section(
            &mut html,
            "Accuracy",
            "2 √(|Δα|² + |Δβ|²) against an integration of the full 3-D equations, which itself is off by some 1e-13 rad \
             (up to 4e-9 rad near the separatrix): <code>toytop compare</code>.",
            &self.accuracy,
        );
        section(
            &mut html,
            "Work and precision",
            "s = A = p = g = 1, C = 0.6, e = 0.7, 0.9, 1.85 (a cusp), against the paper's integrals to thirty digits. An \
             ephemeris looks the orientations up; every other method integrates up to them. multicalc's RK4 lies on ours.",
            &self.precision,
        );
        if let Some((_, svg)) = pictures.next() {
            html.push_str(&String::from_utf8_lossy(svg));
        }
        let text = if self.measured {
            "What a call takes on the chips, as <code>toytop budget --format json</code> says."
        } else {
            "What a call may take on the chips, at most: <code>cargo xtask test --only budget</code> fails where it is more. \
             Instructions are counted, cycles those of a model."
        };
        section(&mut html, "Budget", text, &self.budget);
        for (title, svg) in pictures {
            let _ = write!(figures, "<h3>{title}</h3>\n{}\n", String::from_utf8_lossy(svg));
        }
        html + "<h2>Figures</h2>\n" + &figures + "</body></html>\n"
    }
}

fn markup(table: &Table) -> String {
    let line = |cells: &[String], tag: &str| {
        let cells: String =
            cells.iter().map(|cell| format!("<{tag}>{}</{tag}>", output::html(cell))).collect();
        format!("<tr>{cells}</tr>\n")
    };
    let rows: String = table.rows.iter().map(|row| line(row, "td")).collect();
    format!("<div class=\"scroll\"><table>\n{}{rows}</table></div>\n", line(&table.header, "th"))
}

/// Processor, system and build, as far as they are known.
fn machine() -> String {
    let information = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = information.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    let model = model.map_or(std::env::consts::ARCH, |(_, model)| model);
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let build = if cfg!(debug_assertions) { ", UNOPTIMISED build" } else { "" };
    format!("{model}, {cores} cores, {}{build}", std::env::consts::OS)
}
