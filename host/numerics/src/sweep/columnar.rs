//! Parquet file of a complete sweep: the rows of its CSV file, with types, in groups.
//!
//! A Parquet file ends with an index of the whole file, so that rows cannot be appended to it, and an incomplete file
//! cannot be read. Both are possible with a CSV file. Therefore rows are first written as CSV, and a complete CSV file
//! is converted.

use super::Rows;
use crate::Failure;
use crate::output::progress::Progress;
use crate::output::whole_file::write_by;
use parquet::basic::{Compression, ZstdLevel};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::{ParquetError, Result as Written};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::parser::parse_message_type;
use std::fs::File;
use std::io;
use std::path::Path;
use std::str::FromStr;
use std::sync::Arc;

/// Number of fields of a group of rows, which is in memory at once: some 40 MB.
const FIELDS: usize = 1 << 22;

/// Parquet type of a column. An absent value is null.
fn physical_type(name: &str) -> &'static str {
    match name {
        "version" | "regime" | "tip_class" | "crc32" => "binary {} (string)",
        "index" | "motions" | "seed" => "int64 {} (integer(64,false))",
        "sign_l_plus_n" | "sign_l_minus_n" | "segments_f32" => "int32 {}",
        _ => "double {}",
    }
}

/// Metadata of a file of joined shards: the version only.
#[must_use]
pub fn version() -> Vec<KeyValue> {
    vec![KeyValue::new("toytop.version".to_owned(), env!("CARGO_PKG_VERSION").to_owned())]
}

/// Metadata of a file: the version, and the options of the command that writes it.
#[must_use]
pub fn metadata(rows: &Rows, [shard, of]: [u64; 2]) -> Vec<KeyValue> {
    let seed = rows.motions.seed().map(|seed| seed.to_string());
    let entries = [
        ("toytop.version", Some(env!("CARGO_PKG_VERSION").to_owned())),
        ("toytop.seed", seed),
        ("toytop.sweep", Some(format!("{rows} --shard {shard}/{of}"))),
    ];
    let entry = |(key, value): (&str, Option<String>)| Some(KeyValue::new(key.to_owned(), value?));
    entries.into_iter().filter_map(entry).collect()
}

/// Number of rows of the file; `None` if it does not exist.
///
/// # Errors
/// [`Failure::Input`]: the file is not one of this sweep, or must not be resumed.
pub fn rows_there(path: &Path, rows: &Rows, shard: [u64; 2], resume: bool) -> Result<Option<u64>, Failure> {
    let wrong = |reason: &str| Failure::Input(format!("--output: {}: {reason}", path.display()));
    super::part::must_be_regular(path)?;
    let Ok(file) = File::open(path) else { return Ok(None) };
    if !resume {
        return Err(wrong("exists; --resume continues it"));
    }
    let reader = SerializedFileReader::new(file).map_err(|_| wrong("is no Parquet; nothing was changed"))?;
    let said = reader.metadata().file_metadata();
    let entries = said.key_value_metadata().map_or(&[][..], Vec::as_slice);
    if !metadata(rows, shard).iter().all(|entry| entries.contains(entry)) {
        return Err(wrong("is of another sweep, shard or version; nothing was changed"));
    }
    Ok(Some(said.num_rows().unsigned_abs()))
}

/// Converts a complete CSV file with `len` rows. The Parquet file is on the disk when the function returns, so that the
/// CSV file can be removed.
///
/// # Errors
/// One of the two files cannot be read or written; no incomplete file remains.
pub fn write(csv: &Path, path: &Path, metadata: Vec<KeyValue>, len: u64) -> Result<(), Failure> {
    let mut progress = Progress::new(len, "rows written as Parquet");
    write_by("--output", path, |file| {
        transcribe(csv, file, metadata, &mut progress).map_err(of_system)?;
        file.sync_all()
    })
}

/// Error of the operating system, if it is the cause of the error of Parquet.
fn of_system(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(cause) => match cause.downcast::<io::Error>() {
            Ok(error) => *error,
            Err(other) => io::Error::other(other),
        },
        error => io::Error::other(error),
    }
}

fn transcribe(csv: &Path, file: &mut File, metadata: Vec<KeyValue>, progress: &mut Progress) -> Written<()> {
    let of_csv = |error: csv::Error| ParquetError::External(Box::new(io::Error::from(error)));
    let mut csv = csv::Reader::from_path(csv).map_err(of_csv)?;
    let names: Vec<String> = csv.headers().map_err(of_csv)?.iter().map(str::to_owned).collect();
    let fields = names.iter().map(|name| format!("optional {};", physical_type(name).replace("{}", name)));
    let schema = parse_message_type(&format!("message sweep {{ {} }}", fields.collect::<String>()))?;
    let properties = WriterProperties::builder()
        .set_compression(Compression::ZSTD(ZstdLevel::default()))
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_key_value_metadata(Some(metadata))
        .build();
    let mut writer = SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))?;
    let most = (FIELDS / names.len()).max(1);
    let mut records = csv.records();
    loop {
        let block: Vec<_> = records.by_ref().take(most).collect::<Result<_, _>>().map_err(of_csv)?;
        if block.is_empty() {
            break;
        }
        let mut group = writer.next_row_group()?;
        write_group(&mut group, &block)?;
        group.close()?;
        progress.add(block.len() as u64);
    }
    writer.close().map(drop)
}

fn write_group<W: io::Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    block: &[csv::StringRecord],
) -> Written<()> {
    for place in 0.. {
        let Some(mut column) = group.next_column()? else { break };
        let texts = || block.iter().map(move |row| row.get(place).unwrap_or_default());
        let present: Vec<i16> = texts().map(|text| i16::from(!text.is_empty())).collect();
        let texts = || texts().filter(|text| !text.is_empty());
        let present = Some(&present[..]);
        match column.untyped() {
            ColumnWriter::Int32ColumnWriter(writer) => writer.write_batch(&read(texts())?, present, None)?,
            ColumnWriter::Int64ColumnWriter(writer) => {
                // an unsigned number is stored by its bits
                let numbers: Vec<u64> = read(texts())?;
                let bits: Vec<i64> = numbers.into_iter().map(u64::cast_signed).collect();
                writer.write_batch(&bits, present, None)?
            }
            ColumnWriter::DoubleColumnWriter(writer) => writer.write_batch(&read(texts())?, present, None)?,
            ColumnWriter::ByteArrayColumnWriter(writer) => {
                writer.write_batch(&texts().map(ByteArray::from).collect::<Vec<_>>(), present, None)?
            }
            _ => return Err(ParquetError::General("a column of no such type".into())),
        };
        column.close()?;
    }
    Ok(())
}

/// Numbers of these texts.
fn read<'a, T: FromStr>(texts: impl Iterator<Item = &'a str>) -> Written<Vec<T>> {
    let number = |text: &str| text.parse().map_err(|_| ParquetError::General(format!("{text}: no number")));
    texts.map(number).collect()
}
