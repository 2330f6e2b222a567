//! Cost of each call, from the log of a run.

use super::chip::model;
use super::instruction::{Decoder, Instruction};
use super::trace::{self, Block};
use super::{Chip, Image, Model};
use crate::Failure;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::Path;

/// Cost of the costliest of several calls.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Name of the function, without `bench_`.
    pub call: String,
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

/// Costs of the functions of an ELF that are named `bench_...`, on an emulated chip, in the order of their first calls.
///
/// # Errors
/// [`Failure::Input`]: the file is no ELF, or has no such function. [`Failure::Tool`]: there is no QEMU, the program did not end with exit
/// code 0, or QEMU's log cannot be read.
pub fn measure(chip: &Chip, elf: &Path) -> Result<Vec<Cost>, Failure> {
    let image = Image::read(elf)?;
    let entries: HashMap<u64, &str> =
        image.named(PREFIX).map(|function| (function.address, &function.name[PREFIX.len()..])).collect();
    if entries.is_empty() {
        return Err(Failure::Input(format!("{}: no function named {PREFIX}...", elf.display())));
    }
    let mut meter = Meter::new(&image, &entries, model(chip))?;
    let printed = trace::run(chip, elf, |blocks, number| meter.executed(blocks, number))?;
    if meter.costs.is_empty() {
        return Err(Failure::Tool(format!("budget: {}: nothing was called", elf.display())));
    }
    Ok(meter.costs.into_iter().map(|cost| with_report(cost, &printed)).collect())
}

const PREFIX: &str = "bench_";

/// Cost with stack and RAM from the output of the firmware, `bench_NAME stack BYTES ram BYTES`.
fn with_report(mut cost: Cost, printed: &str) -> Cost {
    for line in printed.lines() {
        let mut words = line.split_whitespace();
        if words.next().and_then(|name| name.strip_prefix(PREFIX)) == Some(&cost.call) {
            let words: Vec<_> = words.collect();
            for pair in words.chunks_exact(2) {
                match (pair[0], pair[1].parse().ok()) {
                    ("stack", bytes) => cost.stack = bytes,
                    ("ram", bytes) => cost.ram = bytes,
                    _ => {}
                }
            }
        }
    }
    cost
}

/// State of the measurement during a run.
struct Meter<'a> {
    image: &'a Image,
    entries: &'a HashMap<u64, &'a str>,
    prices: Option<Prices>,
    costs: Vec<Cost>,
    before: Option<usize>,
    running: Option<Running<'a>>,
    /// Functions that a call ran through.
    functions: BTreeMap<&'a str, BTreeSet<u64>>,
}

/// Call that has not returned.
struct Running<'a> {
    call: &'a str,
    return_to: u64,
    instructions: u64,
    cycles: i64,
    blocks: Vec<bool>,
}

impl<'a> Meter<'a> {
    fn new(
        image: &'a Image,
        entries: &'a HashMap<u64, &'a str>,
        model: Option<Model>,
    ) -> Result<Self, Failure> {
        let prices = model.map(Prices::new).transpose()?;
        Ok(Self {
            image,
            entries,
            prices,
            costs: Vec::new(),
            before: None,
            running: None,
            functions: BTreeMap::new(),
        })
    }

    fn executed(&mut self, blocks: &[Block], number: usize) -> Result<(), Failure> {
        let block = &blocks[number];
        let before = self.before.replace(number);
        if self.running.as_ref().is_some_and(|running| running.return_to == block.start()) {
            self.returned(blocks, before)?;
        }
        if self.running.is_none() {
            let (Some(call), Some(caller)) = (self.entries.get(&block.start()), before) else {
                return Ok(());
            };
            let return_to = blocks[caller].end;
            self.running = Some(Running { call, return_to, instructions: 0, cycles: 0, blocks: Vec::new() });
            return self.add(blocks, None, number);
        }
        self.add(blocks, before, number)
    }

    fn add(&mut self, blocks: &[Block], before: Option<usize>, number: usize) -> Result<(), Failure> {
        let Some(running) = &mut self.running else { return Ok(()) };
        running.instructions += blocks[number].addresses.len() as u64;
        if running.blocks.len() <= number {
            running.blocks.resize(blocks.len(), false);
        }
        running.blocks[number] = true;
        if let Some(prices) = &mut self.prices {
            prices.learn(self.image, blocks, number)?;
            running.cycles += prices.of(blocks, before, number);
        }
        Ok(())
    }

    fn returned(&mut self, blocks: &[Block], last: Option<usize>) -> Result<(), Failure> {
        let Some(running) = self.running.take() else { return Ok(()) };
        let mut cycles = running.cycles;
        if let (Some(prices), Some(last)) = (&self.prices, last) {
            cycles += prices.leaving(last);
        }
        let functions = self.functions.entry(running.call).or_default();
        let ran = running.blocks.iter().zip(blocks).filter(|(ran, _)| **ran).map(|(_, block)| block.start());
        functions.extend(ran.filter_map(|start| self.image.around(start)).map(|function| function.address));
        let size = |address: &u64| self.image.around(*address).map_or(0, |function| function.size);
        let flash = functions.iter().map(size).sum();
        let index = self.costs.iter().position(|cost| cost.call == running.call).unwrap_or_else(|| {
            self.costs.push(Cost { call: running.call.to_owned(), ..Cost::default() });
            self.costs.len() - 1
        });
        let cost = &mut self.costs[index];
        cost.flash = flash;
        cost.instructions = cost.instructions.max(running.instructions);
        if self.prices.is_some() {
            let cycles = u64::try_from(cycles).unwrap_or_default();
            cost.cycles = cost.cycles.max(Some(cycles));
        }
        Ok(())
    }
}

/// Cycles of blocks; each block is decoded once.
struct Prices {
    model: Model,
    decoder: Decoder,
    blocks: Vec<Option<Priced>>,
    /// Additional cycles between one block and the next.
    edges: HashMap<(usize, usize), i64>,
}

struct Priced {
    /// Cycles without those that depend on the block before and the block after.
    cycles: i64,
    first: Instruction,
    last: Instruction,
}

impl Prices {
    fn new(model: Model) -> Result<Self, Failure> {
        let decoder = Decoder::new().map_err(|error| Failure::Tool(format!("budget: {error}")))?;
        Ok(Self { model, decoder, blocks: Vec::new(), edges: HashMap::new() })
    }

    fn learn(&mut self, image: &Image, blocks: &[Block], number: usize) -> Result<(), Failure> {
        if self.blocks.len() < blocks.len() {
            self.blocks.resize_with(blocks.len(), || None);
        }
        if self.blocks[number].is_none() {
            self.blocks[number] = Some(self.price(image, &blocks[number])?);
        }
        Ok(())
    }

    fn price(&self, image: &Image, block: &Block) -> Result<Priced, Failure> {
        let start = block.start();
        let instructions =
            image.code(start, block.end).and_then(|code| self.decoder.decode(code, start).ok());
        let instructions = instructions.filter(|found| found.len() == block.addresses.len());
        let undecoded = || Failure::Tool(format!("budget: code at {start:#x} cannot be decoded"));
        let instructions = instructions.ok_or_else(undecoded)?;
        let (Some(&first), Some(&last)) = (instructions.first(), instructions.last()) else {
            return Err(undecoded());
        };
        let alone: i64 = instructions.iter().map(|instruction| self.model.alone(instruction)).sum();
        let after: i64 = instructions.windows(2).map(|pair| self.model.after(&pair[0], &pair[1])).sum();
        Ok(Priced { cycles: alone + after, first, last })
    }

    /// Cycles of a block, and of the transition from the block before it.
    fn of(&mut self, blocks: &[Block], before: Option<usize>, number: usize) -> i64 {
        let priced = |number: usize| self.blocks.get(number).and_then(Option::as_ref);
        let Some(block) = priced(number) else { return 0 };
        let Some((index, last)) = before.and_then(|index| Some((index, priced(index)?.last))) else {
            return block.cycles;
        };
        let model = self.model;
        let edge = self.edges.entry((index, number)).or_insert_with(|| {
            let goes_on = blocks[index].end == blocks[number].start();
            let jump = if goes_on { 0 } else { model.jump(&last, Some(&block.first)) };
            model.after(&last, &block.first) + jump
        });
        block.cycles + *edge
    }

    /// Cycles of the return from the last block.
    fn leaving(&self, last: usize) -> i64 {
        let last = self.blocks.get(last).and_then(Option::as_ref);
        last.map_or(0, |block| self.model.jump(&block.last, None))
    }
}
