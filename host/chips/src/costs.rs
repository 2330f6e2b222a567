//! Cost of each call, from the log of a run.

use crate::chip::Chip;
use crate::cycles::{BlockCycles, CycleModel, Instruction};
use crate::trace::{self, Block};
use object::{Architecture, File, Object, ObjectSection, ObjectSymbol, SectionKind, SymbolKind};
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::{fs, io};

/// Greatest cost of the measured calls; `None` where it is not measured.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cost {
    /// Cycles by the model of the chip.
    pub cycles: Option<u64>,
    /// Bytes of all functions that the call ran through, with the literals in their code.
    pub flash: Option<u64>,
    /// Exact number of instructions, from the first to the return.
    pub instructions: Option<u64>,
    /// Bytes between calls, as the firmware states.
    pub ram: Option<u64>,
    /// Bytes below the stack pointer of the caller that the firmware found changed.
    pub stack: Option<u64>,
}

impl Cost {
    /// Figures with their names.
    pub fn figures(&self) -> [(&'static str, Option<u64>); 5] {
        [
            ("cycles", self.cycles),
            ("flash", self.flash),
            ("instructions", self.instructions),
            ("ram", self.ram),
            ("stack", self.stack),
        ]
    }
}

/// Costs by the name of the function, without `bench_`.
pub type Costs = BTreeMap<String, Cost>;

const PREFIX: &str = "bench_";

/// Costs of the functions of an ELF that are named `bench_...`, on an emulated chip.
///
/// # Errors
/// [`io::ErrorKind::InvalidInput`]: the file is no ELF, or no such function was called. Other kinds: there is no QEMU, the program did not end
/// with exit code 0, or QEMU's log cannot be read.
pub fn measure(chip: &Chip, elf: &Path) -> io::Result<Costs> {
    let bytes = read(elf)?;
    let image = Image::new(parsed(elf, &bytes)?);
    let cycle_model = chip.timings.map(CycleModel::new).transpose()?;
    let mut measurement = Measurement { image, cycle_model, calls: BTreeMap::new(), end: 0, running: None };
    let printed =
        trace::emulate(chip, elf, &["-d", "in_asm,exec,nochain"], |block| measurement.executed(block))?;
    if measurement.calls.is_empty() {
        return Err(refused(elf, &format!("calls no function named {PREFIX}...")));
    }
    // the firmware prints `bench_NAME stack BYTES ram BYTES`
    for line in printed.lines() {
        let words: Vec<_> = line.split_whitespace().collect();
        let [name, "stack", stack, "ram", ram] = words[..] else { continue };
        if let Some((cost, _)) = name.strip_prefix(PREFIX).and_then(|call| measurement.calls.get_mut(call)) {
            (cost.stack, cost.ram) = (stack.parse().ok(), ram.parse().ok());
        }
    }
    Ok(measurement.calls.into_iter().map(|(call, (cost, _))| (call, cost)).collect())
}

/// Bytes of code, constants and initial values that the linker put into flash.
///
/// # Errors
/// [`io::ErrorKind::InvalidInput`]: the file is no ELF.
pub fn linked_flash(elf: &Path) -> io::Result<u64> {
    let bytes = read(elf)?;
    let in_flash =
        [SectionKind::Text, SectionKind::ReadOnlyData, SectionKind::ReadOnlyString, SectionKind::Data];
    let file = parsed(elf, &bytes)?;
    let sections = file.sections().filter(|section| in_flash.contains(&section.kind()));
    Ok(sections.map(|section| section.size()).sum())
}

fn read(elf: &Path) -> io::Result<Vec<u8>> {
    fs::read(elf).map_err(|error| refused(elf, &error.to_string()))
}

fn parsed<'a>(elf: &Path, bytes: &'a [u8]) -> io::Result<File<'a>> {
    File::parse(bytes).map_err(|error| refused(elf, &format!("must be an ELF: {error}")))
}

fn refused(elf: &Path, reason: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, format!("{}: {reason}", elf.display()))
}

/// Function of an ELF.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Function {
    address: u64,
    /// First of its names.
    name: String,
    /// Size with the literals after the code, bytes.
    size: u64,
}

/// ELF with its functions by address.
struct Image<'a> {
    file: File<'a>,
    functions: Vec<Function>,
}

impl<'a> Image<'a> {
    fn new(file: File<'a>) -> Self {
        // the lowest bit of an Arm function's address marks Thumb code
        let thumb = u64::from(file.architecture() == Architecture::Arm);
        let mut functions: Vec<_> = file
            .symbols()
            .filter(|symbol| symbol.kind() == SymbolKind::Text && symbol.size() > 0)
            .map(|symbol| Function {
                address: symbol.address() & !thumb,
                name: symbol.name().unwrap_or_default().to_owned(),
                size: symbol.size(),
            })
            .collect();
        functions.sort();
        functions.dedup_by_key(|function| function.address);
        Self { file, functions }
    }

    /// Function that contains an address.
    fn function_at(&self, address: u64) -> Option<&Function> {
        let after = self.functions.partition_point(|function| function.address <= address);
        let function = self.functions.get(after.checked_sub(1)?);
        function.filter(|function| address < function.address + function.size)
    }

    /// Code of a block.
    fn code(&self, block: Block) -> Option<&'a [u8]> {
        let size = block.end - block.start;
        self.file.sections().find_map(|section| section.data_range(block.start, size).ok()?)
    }
}

/// State of the measurement during a run.
struct Measurement<'a> {
    image: Image<'a>,
    cycle_model: Option<CycleModel>,
    /// Costs of the calls that have returned, and addresses of the functions that they ran through.
    calls: BTreeMap<String, (Cost, BTreeSet<u64>)>,
    /// End of the block before the one that is executed.
    end: u64,
    running: Option<Call>,
}

/// Call that has not returned.
#[derive(Default)]
struct Call {
    name: String,
    return_to: u64,
    instructions: u64,
    cycles: i64,
    functions: BTreeSet<u64>,
    last: Option<Instruction>,
}

impl Measurement<'_> {
    fn executed(&mut self, block: Block) -> io::Result<()> {
        if let Some(running) = self.running.take_if(|running| running.return_to == block.start) {
            self.returned(running);
        }
        let function = self.image.function_at(block.start);
        let entered = function.filter(|function| function.address == block.start);
        let name = entered.and_then(|function| function.name.strip_prefix(PREFIX));
        if let (None, Some(name)) = (&self.running, name) {
            self.running = Some(Call { name: name.to_owned(), return_to: self.end, ..Call::default() });
        }
        if let Some(running) = &mut self.running {
            running.instructions += block.count;
            running.functions.extend(function.map(|function| function.address));
            if let Some(cycle_model) = &mut self.cycle_model {
                let BlockCycles { cycles, first, last } =
                    cycle_model.block(block, self.image.code(block).unwrap_or_default())?;
                running.cycles += cycles;
                if let Some(last) = running.last {
                    running.cycles += cycle_model.cycles_after(&last, &first);
                    if self.end != block.start {
                        running.cycles += cycle_model.jump_cycles(&last, Some(&first));
                    }
                }
                running.last = Some(last);
            }
        }
        self.end = block.end;
        Ok(())
    }

    fn returned(&mut self, running: Call) {
        let (cost, functions) = self.calls.entry(running.name).or_default();
        functions.extend(running.functions);
        let size = |address: &u64| self.image.function_at(*address).map_or(0, |function| function.size);
        cost.flash = Some(functions.iter().map(size).sum());
        cost.instructions = cost.instructions.max(Some(running.instructions));
        if let (Some(model), Some(last)) = (&self.cycle_model, running.last) {
            let cycles = running.cycles + model.jump_cycles(&last, None);
            cost.cycles = cost.cycles.max(u64::try_from(cycles).ok());
        }
    }
}
