//! Cost of each call, from the log of a run.

use super::chips::Chip;
use super::model::{Decoder, Instruction, Model};
use super::trace::{self, Block};
use crate::Failure;
use object::{Architecture, File, Object, ObjectSection, ObjectSymbol, SectionKind, SymbolKind};
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fs;
use std::path::Path;

/// Cost of the costliest of several calls.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Cost {
    /// Exact number of instructions, from the first to the return.
    pub instructions: u64,
    /// Cycles by the model of the chip.
    pub cycles: Option<u64>,
    /// Stack in bytes: memory below the stack pointer of the caller that the firmware found changed.
    pub stack: Option<u64>,
    /// Flash in bytes: size of all functions that the call ran through, with the literals in their code.
    pub flash: u64,
    /// RAM between calls in bytes, as the firmware states it.
    pub ram: Option<u64>,
}

/// Costs by the name of the function, without `bench_`.
pub type Costs = BTreeMap<String, Cost>;

const PREFIX: &str = "bench_";

/// Costs of the functions of an ELF that are named `bench_...`, on an emulated chip.
///
/// # Errors
/// [`Failure::Input`]: the file is no ELF, or no such function was called. [`Failure::Tool`]: there is no QEMU, the program did not end with
/// exit code 0, or QEMU's log cannot be read.
pub fn measure(chip: &Chip, elf: &Path) -> Result<Costs, Failure> {
    let bytes = read(elf)?;
    let image = Image::new(parsed(elf, &bytes)?);
    let prices = Model::of(chip).map(Prices::new).transpose()?;
    let mut meter = Meter { image, prices, calls: BTreeMap::new(), end: 0, running: None };
    let printed = trace::run(chip, elf, &["-d", "in_asm,exec,nochain"], |block| meter.executed(block))?;
    if meter.calls.is_empty() {
        return Err(Failure::Input(format!("{}: calls no function named {PREFIX}...", elf.display())));
    }
    // the firmware prints `bench_NAME stack BYTES ram BYTES`
    for line in printed.lines() {
        let words: Vec<_> = line.split_whitespace().collect();
        let [name, "stack", stack, "ram", ram] = words[..] else { continue };
        if let Some((cost, _)) = name.strip_prefix(PREFIX).and_then(|call| meter.calls.get_mut(call)) {
            (cost.stack, cost.ram) = (stack.parse().ok(), ram.parse().ok());
        }
    }
    Ok(meter.calls.into_iter().map(|(call, (cost, _))| (call, cost)).collect())
}

/// Bytes of code, constants and initial values that the linker put into flash.
///
/// # Errors
/// [`Failure::Input`]: the file is no ELF.
pub fn flash(elf: &Path) -> Result<u64, Failure> {
    let bytes = read(elf)?;
    let in_flash =
        [SectionKind::Text, SectionKind::ReadOnlyData, SectionKind::ReadOnlyString, SectionKind::Data];
    let file = parsed(elf, &bytes)?;
    let sections = file.sections().filter(|section| in_flash.contains(&section.kind()));
    Ok(sections.map(|section| section.size()).sum())
}

fn read(elf: &Path) -> Result<Vec<u8>, Failure> {
    fs::read(elf).map_err(|error| Failure::Input(format!("{}: {error}", elf.display())))
}

fn parsed<'a>(elf: &Path, bytes: &'a [u8]) -> Result<File<'a>, Failure> {
    File::parse(bytes).map_err(|error| Failure::Input(format!("{}: {error}", elf.display())))
}

/// ELF with its functions in the order of their addresses: address, first name, and size with the literals after the code.
struct Image<'a> {
    file: File<'a>,
    functions: Vec<(u64, String, u64)>,
}

impl<'a> Image<'a> {
    fn new(file: File<'a>) -> Self {
        // the lowest bit of an Arm function's address marks Thumb code
        let thumb = u64::from(file.architecture() == Architecture::Arm);
        let mut functions: Vec<_> = file
            .symbols()
            .filter(|symbol| symbol.kind() == SymbolKind::Text && symbol.size() > 0)
            .map(|symbol| {
                (symbol.address() & !thumb, symbol.name().unwrap_or_default().to_owned(), symbol.size())
            })
            .collect();
        functions.sort();
        functions.dedup_by_key(|(address, ..)| *address);
        Self { file, functions }
    }

    /// Function that contains an address.
    fn around(&self, place: u64) -> Option<&(u64, String, u64)> {
        let after = self.functions.partition_point(|(address, ..)| *address <= place);
        let function = self.functions.get(after.checked_sub(1)?);
        function.filter(|(address, _, size)| place < address + size)
    }

    /// Code of a block.
    fn code(&self, block: Block) -> Option<&'a [u8]> {
        let size = block.end - block.start;
        self.file.sections().find_map(|section| section.data_range(block.start, size).ok()?)
    }
}

/// State of the measurement during a run.
struct Meter<'a> {
    image: Image<'a>,
    prices: Option<Prices>,
    /// Costs of the calls that have returned, and addresses of the functions that they ran through.
    calls: BTreeMap<String, (Cost, BTreeSet<u64>)>,
    /// End of the block before the one that is executed.
    end: u64,
    running: Option<Running>,
}

/// Call that has not returned.
#[derive(Default)]
struct Running {
    call: String,
    return_to: u64,
    instructions: u64,
    cycles: i64,
    functions: BTreeSet<u64>,
    last: Option<Instruction>,
}

impl Meter<'_> {
    fn executed(&mut self, block: Block) -> Result<(), Failure> {
        if let Some(running) = self.running.take_if(|running| running.return_to == block.start) {
            self.returned(running);
        }
        let function = self.image.around(block.start);
        let call = function.filter(|(address, ..)| *address == block.start);
        let call = call.and_then(|(_, name, _)| name.strip_prefix(PREFIX));
        if let (None, Some(call)) = (&self.running, call) {
            self.running = Some(Running { call: call.to_owned(), return_to: self.end, ..Running::default() });
        }
        if let Some(running) = &mut self.running {
            running.instructions += block.count;
            running.functions.extend(function.map(|(address, ..)| *address));
            if let Some(prices) = &mut self.prices {
                let Priced { cycles, first, last } = prices.price(&self.image, block)?;
                running.cycles += cycles;
                if let Some(last) = running.last {
                    running.cycles += prices.model.after(&last, &first);
                    if self.end != block.start {
                        running.cycles += prices.model.jump(&last, Some(&first));
                    }
                }
                running.last = Some(last);
            }
        }
        self.end = block.end;
        Ok(())
    }

    fn returned(&mut self, running: Running) {
        let (cost, functions) = self.calls.entry(running.call).or_default();
        functions.extend(running.functions);
        let size = |address: &u64| self.image.around(*address).map_or(0, |(_, _, size)| *size);
        cost.flash = functions.iter().map(size).sum();
        cost.instructions = cost.instructions.max(running.instructions);
        if let (Some(Prices { model, .. }), Some(last)) = (&self.prices, running.last) {
            let cycles = running.cycles + model.jump(&last, None);
            cost.cycles = cost.cycles.max(u64::try_from(cycles).ok());
        }
    }
}

/// Cycles of blocks; each block is decoded once.
struct Prices {
    model: Model,
    decoder: Decoder,
    known: HashMap<Block, Priced>,
}

#[derive(Clone, Copy)]
struct Priced {
    /// Cycles without those that depend on the block before and the block after.
    cycles: i64,
    first: Instruction,
    last: Instruction,
}

impl Prices {
    fn new(model: Model) -> Result<Self, Failure> {
        let decoder = Decoder::new().map_err(|error| Failure::Tool(format!("budget: {error}")))?;
        Ok(Self { model, decoder, known: HashMap::new() })
    }

    fn price(&mut self, image: &Image<'_>, block: Block) -> Result<Priced, Failure> {
        if let Some(known) = self.known.get(&block) {
            return Ok(*known);
        }
        let code = image.code(block).unwrap_or_default();
        let instructions = self.decoder.decode(code, block.start).unwrap_or_default();
        let ([first, ..], [.., last]) = (&instructions[..], &instructions[..]) else {
            return Err(Failure::Tool(format!("budget: code at {:#x} cannot be decoded", block.start)));
        };
        let priced = Priced { cycles: self.model.cycles(&instructions), first: *first, last: *last };
        self.known.insert(block, priced);
        Ok(priced)
    }
}
