//! Page in HTML, which needs no other file.

use super::Table;
use std::process::Command;
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

const STYLE: &str = ":root{color-scheme:light dark;--paper:#fff;--ink:#222;--line:#ddd;--rule:#888}\
@media(prefers-color-scheme:dark){:root{--paper:#16181c;--ink:#e9e7e1;--line:#343942;--rule:#9a9da4}\
svg{filter:invert(.9) hue-rotate(180deg)}}\
body{font:16px/1.5 system-ui,sans-serif;max-width:70rem;margin:2rem auto;padding:0 1rem;background:var(--paper);color:var(--ink)}\
table{border-collapse:collapse;margin:1rem 0;font-variant-numeric:tabular-nums}\
th,td{padding:.2rem .8rem;border-bottom:1px solid var(--line);text-align:right}th:first-child,td:first-child,\
#budget :is(th,td):nth-child(2){text-align:left}\
th{border-bottom:2px solid var(--rule)}svg{max-width:100%;height:auto}.scroll{overflow-x:auto}\
summary{cursor:pointer}summary h2{display:inline}";

impl Page {
    /// Page with the figures first, then the tables. The long table of the budget is collapsed.
    pub(super) fn html(&self) -> String {
        let version = env!("CARGO_PKG_VERSION");
        let date = chrono::Utc::now().format("%Y-%m-%d");
        let mut html = format!(
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>toytop {version}: report</title>\
             <meta name=\"viewport\" content=\"width=device-width\"><style>{STYLE}</style></head><body>\n\
             <h1>toytop {version}</h1>\n<p>{date}{}. Times are those of this machine: {}. Errors are the same on all.</p>\n",
            revision().map_or(String::new(), |revision| format!(", revision {revision}")),
            output::html(&machine()),
        );
        for (title, svg) in &self.pictures {
            html += &format!("<section><h2>{title}</h2>\n{}</section>\n", String::from_utf8_lossy(svg));
        }
        html += &section(
            "Errors after 1000 periods",
            "s = A = p = g = 1, C = 0.6, e = 0.7, 0.9, 1.85 (a cusp), against the paper's integrals to thirty digits. An \
             ephemeris looks the orientations up; every other method integrates up to them. multicalc's RK4 lies on ours.",
            &self.precision,
        );
        html += &section(
            "Accuracy",
            "2 √(|Δα|² + |Δβ|²) against an integration of the full 3-D equations, which itself is off by some 1e-13 rad \
             (up to 4e-9 rad near the separatrix): <code>toytop compare</code>.",
            &self.accuracy,
        );
        let text = if self.measured {
            "What a call takes on the chips, as <code>toytop budget --format json</code> says."
        } else {
            "What a call may take on the chips, at most: <code>cargo xtask test --only budget</code> fails where it is more. \
             Instructions are counted, cycles those of a model."
        };
        html += &format!(
            "<details id=\"budget\"><summary><h2>Budget</h2></summary>\n<p>{text}</p>\n{}</details>\n",
            markup(&self.budget)
        );
        html + "</body></html>\n"
    }
}

fn section(title: &str, text: &str, table: &Table) -> String {
    format!("<section><h2>{title}</h2>\n<p>{text}</p>\n{}</section>\n", markup(table))
}

/// The revision of the sources, in a checkout with git.
fn revision() -> Option<String> {
    let git = ["-C", env!("CARGO_MANIFEST_DIR"), "describe", "--always", "--dirty"];
    let output = Command::new("git").args(git).output().ok().filter(|output| output.status.success())?;
    Some(String::from_utf8_lossy(&output.stdout).trim().to_owned())
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
