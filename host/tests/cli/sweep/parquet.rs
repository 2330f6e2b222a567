//! Parquet out of `toytop sweep`: the table of the CSV file, as safe from being killed.

use super::{GRID, KILLED, killed, no_file, refused, sweep, words};
use crate::{run, stderr};
use parquet::basic::Compression;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// A Parquet file that is not there, nor the CSV file on its way.
fn no_parquet(name: &str) -> PathBuf {
    // no other test has files of this name: what stands there goes
    let path = no_file(&format!("parquet_{name}")).with_extension("parquet");
    for left_over in [path.clone(), path.with_extension("parquet.csv")] {
        // from an earlier run, or never there
        let _ = fs::remove_file(left_over);
    }
    path
}

fn sweep_to(path: &Path, more: &[&str]) {
    let output = run(&words(path, more));
    assert_eq!(output.status.code(), Some(0), "{more:?}: {}", stderr(&output));
    assert!(!path.with_extension("parquet.csv").exists(), "the CSV file is gone");
}

fn open(path: &Path) -> SerializedFileReader<File> {
    SerializedFileReader::new(File::open(path).expect("the file")).expect("Parquet")
}

/// Text of a field of the CSV file, if it has the value of the field of the other file.
fn as_csv(field: &Field, text: &str) -> String {
    match field {
        Field::Null => String::new(),
        Field::Str(word) => word.clone(),
        Field::Int(number) => number.to_string(),
        Field::ULong(number) => number.to_string(),
        Field::Double(x) if text.parse::<f64>().is_ok_and(|expected| expected.to_bits() == x.to_bits()) => {
            text.to_owned()
        }
        other => format!("{other:?}"),
    }
}

#[test]
fn the_table_of_the_csv_file() {
    let all = "regime,tip_class,l,n,h,period,alpha_turns,beta_turns,phi_per_period,min_normal_force,u,phi,tip,error_f32,\
               bound_f32,segments_f32,full_error_f64,full_error_f32";
    let columns = ["--columns", all, "--ticks", "2"];
    let sample =
        [&["--motions", "30", "--seed", "18446744073709551615", "--shard", "2/3"][..], &columns].concat();
    // places with e1 > e2 have nulls
    let grid = [&GRID[..], &columns].concat();
    for (name, more, seed, nulls) in
        [("sample", sample, Some("18446744073709551615"), false), ("grid", grid, None, true)]
    {
        let text = sweep(&no_file(&format!("typed_{name}")), &more);
        let path = no_parquet(&format!("typed_{name}"));
        sweep_to(&path, &more);
        let reader = open(&path);
        let mut rows = text.lines();
        let header: Vec<_> = rows.next().expect("a header").split(',').collect();
        let mut count = 0;
        for row in reader.get_row_iter(None).expect("rows") {
            let row = row.expect("a row");
            let expected: Vec<_> = rows.next().expect("as many rows").split(',').collect();
            let names: Vec<_> = row.get_column_iter().map(|(name, _)| name.as_str()).collect();
            assert_eq!(names, header);
            let fields = row.get_column_iter().zip(&expected).map(|((_, field), text)| as_csv(field, text));
            assert_eq!(fields.collect::<Vec<_>>(), expected);
            count += 1;
        }
        assert!(rows.next().is_none() && count >= 10, "{count} rows");
        assert_eq!(text.contains(",refused,,,"), nulls);
        let said = reader.metadata().file_metadata().key_value_metadata().expect("metadata");
        let of =
            |key: &str| said.iter().find(|entry| entry.key == key).and_then(|entry| entry.value.as_deref());
        assert_eq!(of("toytop.version"), Some(env!("CARGO_PKG_VERSION")));
        assert_eq!(of("toytop.seed"), seed);
        // the options that it states make it again
        let options: Vec<_> = of("toytop.sweep").expect("options").split(' ').collect();
        let again = no_parquet(&format!("again_{name}"));
        sweep_to(&again, &options);
        assert!(fs::read(again).expect("a file") == fs::read(path).expect("a file"), "{options:?}");
    }
}

/// Each column of each group of rows, also of joined shards, whose table is that of the whole.
#[test]
fn columns_are_compressed_and_have_statistics() {
    let whole = no_parquet("statistics");
    sweep_to(&whole, &GRID);
    let parts: Vec<String> = (1..=2)
        .map(|shard| {
            let path = no_file(&format!("parquet_part_{shard}"));
            sweep(&path, &[&GRID[..], &["--shard", &format!("{shard}/2")]].concat());
            path.to_str().expect("UTF-8").to_owned()
        })
        .collect();
    let joined = no_parquet("joined");
    let output = run(&["sweep", "join", &parts[1], &parts[0], "-o", joined.to_str().expect("UTF-8")]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let rows =
        |path| -> Vec<_> { open(path).into_iter().map(|row| row.expect("a row").to_string()).collect() };
    assert!(rows(&whole) == rows(&joined) && !joined.with_extension("parquet.csv").exists());
    for group in open(&whole).metadata().row_groups() {
        for column in group.columns() {
            assert!(matches!(column.compression(), Compression::ZSTD(_)), "{}", column.column_path());
            assert!(
                column.statistics().is_some_and(|of| of.null_count_opt().is_some()),
                "{}",
                column.column_path()
            );
        }
    }
}

#[test]
fn a_killed_sweep_goes_on_as_csv_does() {
    let path = no_parquet("killed");
    let csv = path.with_extension("parquet.csv");
    killed(&path, &csv, 1000);
    assert!(!path.exists() && csv.exists(), "what is not whole is no Parquet");
    sweep_to(&path, &KILLED);
    let whole = no_parquet("whole");
    sweep_to(&whole, &KILLED);
    let bytes = fs::read(&path).expect("a file");
    assert!(bytes == fs::read(&whole).expect("a file"));
    // as if it had been killed between the last two of its deeds
    sweep(&csv, &KILLED);
    sweep_to(&path, &KILLED);
    assert!(bytes == fs::read(&path).expect("a file"));
}

#[test]
fn what_is_there_is_not_overwritten() {
    let path = no_parquet("there");
    sweep_to(&path, &["--motions", "30"]);
    refused(&path, &["--motions", "30"], "--resume");
    for other in
        [["--seed", "2"], ["--columns", "u"], ["--shard", "1/2"], ["--e1", "-0.9..1"], ["--motions", "31"]]
    {
        let mut more = vec!["--resume"];
        if other[0] != "--motions" {
            more.extend(["--motions", "30"]);
        }
        more.extend(other);
        refused(&path, &more, "another sweep");
    }
    fs::write(&path, "something else").expect("writable");
    refused(&path, &["--motions", "30", "--resume"], "no Parquet");
    assert!(!path.with_extension("parquet.csv").exists());
}
