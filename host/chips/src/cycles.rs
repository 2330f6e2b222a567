//! Cycles of an instruction: a *model* from published tables, which has not been checked on silicon.
//!
//! The model has memory without wait states, no caches and no interrupts. On the Cortex-M0+ (its Technical Reference Manual, table of
//! instruction timings, with the multiplier of one cycle) every instruction has a fixed number of cycles. For the Cortex-M4F the manual
//! states ranges, of which the model takes:
//!
//! * a taken branch refills the pipeline in 1 to 3 cycles: 1 for an address in the instruction, 2 for a register or a condition, and 1
//!   more, up to 3, if the target is a wide instruction across two words
//! * loads of one word overlap if they follow one another and do not depend on each other
//! * SDIV and UDIV take 2 to 12 cycles: always 12, because the operands are not known
//! * an instruction that a condition skips takes as many cycles as if it were executed

use crate::chip::Timings;
use crate::trace::Block;
use capstone::arch::ArchDetail;
use capstone::arch::arm::{ArchMode, ArmOperandType, ArmReg};
use capstone::prelude::*;
use std::collections::HashMap;
use std::io;

/// Cycles of blocks, each of which is decoded once.
pub struct CycleModel {
    timings: Timings,
    decoder: Capstone,
    decoded: HashMap<Block, BlockCycles>,
}

/// Cycles of a block.
#[derive(Clone, Copy)]
pub struct BlockCycles {
    /// Cycles without those that depend on the block before and the block after.
    pub cycles: i64,
    /// First instruction.
    pub first: Instruction,
    /// Last instruction.
    pub last: Instruction,
}

impl CycleModel {
    /// Model with these timings.
    ///
    /// # Errors
    /// The error of Capstone.
    pub fn new(timings: Timings) -> io::Result<Self> {
        let builder = Capstone::new().arm().mode(ArchMode::Thumb);
        let extra = std::iter::once(capstone::arch::arm::ArchExtraMode::MClass);
        let decoder = builder.extra_mode(extra).detail(true).build().map_err(io::Error::other)?;
        Ok(Self { timings, decoder, decoded: HashMap::new() })
    }

    /// Cycles of a block with this code.
    ///
    /// # Errors
    /// The code cannot be decoded.
    pub fn block(&mut self, block: Block, code: &[u8]) -> io::Result<BlockCycles> {
        if let Some(cycles) = self.decoded.get(&block) {
            return Ok(*cycles);
        }
        let instructions = self.decode(code, block.start).unwrap_or_default();
        let ([first, ..], [.., last]) = (&instructions[..], &instructions[..]) else {
            return Err(io::Error::other(format!("code at {:#x} cannot be decoded", block.start)));
        };
        let alone: i64 =
            instructions.iter().map(|instruction| instruction.cycles[self.timings as usize]).sum();
        let pairs: i64 = instructions.windows(2).map(|pair| self.cycles_after(&pair[0], &pair[1])).sum();
        let cycles = BlockCycles { cycles: alone + pairs, first: *first, last: *last };
        self.decoded.insert(block, cycles);
        Ok(cycles)
    }

    /// Additional cycles, which may be negative, because of the instruction before it.
    pub fn cycles_after(&self, before: &Instruction, instruction: &Instruction) -> i64 {
        if self.timings == Timings::M0Plus {
            return 0;
        }
        let needs_address = intersect(before.writes, instruction.addressing);
        match before.class {
            InstructionClass::Float => i64::from(intersect(before.writes, instruction.reads)),
            InstructionClass::Plain => i64::from(needs_address),
            InstructionClass::Load => {
                let follows =
                    matches!(instruction.class, InstructionClass::Load | InstructionClass::IndexedStore);
                -i64::from(follows && !needs_address && !intersect(before.writes, PC))
            }
            _ => 0,
        }
    }

    /// Additional cycles of a jump to an instruction other than the next one.
    pub fn jump_cycles(&self, instruction: &Instruction, target: Option<&Instruction>) -> i64 {
        match (self.timings, instruction.class) {
            (Timings::M0Plus, InstructionClass::Call | InstructionClass::Several) => 2,
            (Timings::M0Plus, _) => 1,
            (Timings::M4, InstructionClass::Table) => 5,
            (Timings::M4, class) => {
                let refill =
                    if matches!(class, InstructionClass::Branch | InstructionClass::Call) { 1 } else { 2 };
                let straddles = target.is_some_and(|target| target.straddles);
                (refill + i64::from(straddles)).min(3)
            }
        }
    }

    /// Instructions of a piece of code, up to the first that cannot be decoded.
    fn decode(&self, code: &[u8], address: u64) -> Result<Vec<Instruction>, capstone::Error> {
        let decoded = self.decoder.disasm_all(code, address)?;
        decoded.iter().map(|instruction| self.instruction(instruction)).collect()
    }

    fn instruction(&self, instruction: &capstone::Insn) -> Result<Instruction, capstone::Error> {
        let detail = self.decoder.insn_detail(instruction)?;
        let mut operands = Vec::new();
        let mut addressing = Vec::new();
        let ArchDetail::ArmDetail(arm) = detail.arch_detail();
        for operand in arm.operands() {
            match operand.op_type {
                ArmOperandType::Reg(register) => operands.extend(self.decoder.reg_name(register)),
                ArmOperandType::Mem(memory) => addressing.extend([memory.base(), memory.index()]),
                _ => {}
            }
        }
        // the number 0 is no register
        addressing.retain(|register| register.0 != 0);
        let ([on_m0plus, on_m4], class) = timing(instruction.mnemonic().unwrap_or_default(), &operands);
        let is_indexed = class == InstructionClass::Store && addressing.len() > 1;
        Ok(Instruction {
            cycles: [on_m0plus, on_m4 + i64::from(is_indexed)],
            class: if is_indexed { InstructionClass::IndexedStore } else { class },
            reads: register_set(detail.regs_read()),
            writes: register_set(detail.regs_write()),
            addressing: register_set(&addressing),
            straddles: instruction.len() == 4 && !instruction.address().is_multiple_of(4),
        })
    }
}

/// Set of registers, as bits at the numbers that Capstone gives them.
type Registers = u128;

/// Program counter.
const PC: Registers = 1 << ArmReg::ARM_REG_PC;

fn register_set(registers: &[RegId]) -> Registers {
    registers.iter().fold(0, |set, register| set | 1 << register.0)
}

/// Whether two sets have a register in common.
fn intersect(a: Registers, b: Registers) -> bool {
    a & b != 0
}

/// Class of an instruction, by its effect on the cycles of others.
#[derive(Clone, Copy, PartialEq)]
enum InstructionClass {
    /// Data processing, multiplication included: an address that is its result comes a cycle later.
    Plain,
    /// Load of one word or less, which overlaps with the next.
    Load,
    /// Store of one word or less.
    Store,
    /// Store of one word or less to the sum of two registers.
    IndexedStore,
    /// Transfer of several words between memory and core registers, or VPUSH, VPOP, VLDM, VSTM.
    Several,
    /// VLDR, VSTR.
    FloatTransfer,
    /// Operation of the FPU, whose result is not ready for the next instruction.
    Float,
    /// VMOV, VCMP, VNEG and others.
    FloatMove,
    /// B to an address in the instruction.
    Branch,
    /// BL to an address in the instruction.
    Call,
    /// TBB, TBH.
    Table,
    /// Any other instruction.
    Other,
}

/// Names of instructions (* = any ending), cycles on \[M0+, M4\], and class. The first match counts. Transferred words and a second moved
/// register are added.
const TIMINGS: [(&str, [i64; 2], InstructionClass); 16] = [
    ("b", [1, 1], InstructionClass::Branch),
    ("bl", [1, 1], InstructionClass::Call),
    ("beq bne bcs bhs bcc blo bmi bpl bvs bvc bhi bls bge blt bgt ble", [1, 1], InstructionClass::Other),
    ("bx blx bxns blxns cbz cbnz it*", [1, 1], InstructionClass::Other),
    ("tbb tbh", [1, 1], InstructionClass::Table),
    ("dmb dsb isb mrs msr cpsie cpsid svc bkpt", [3, 2], InstructionClass::Other),
    ("push pop ldm* stm* ldrd* strd* vpush* vpop* vldm* vstm*", [1, 1], InstructionClass::Several),
    ("vldr* vstr*", [1, 1], InstructionClass::FloatTransfer),
    ("vmla* vmls* vnmla* vnmls* vfma* vfms* vfnma* vfnms*", [1, 3], InstructionClass::Float),
    ("vdiv* vsqrt*", [1, 14], InstructionClass::Float),
    ("vadd* vsub* vmul* vnmul* vcvt* vrint*", [1, 1], InstructionClass::Float),
    ("v*", [1, 1], InstructionClass::FloatMove),
    ("ldr*", [2, 2], InstructionClass::Load),
    ("str*", [2, 1], InstructionClass::Store),
    ("sdiv* udiv*", [1, 12], InstructionClass::Other),
    ("*", [1, 1], InstructionClass::Plain),
];

/// Decoded instruction.
#[derive(Clone, Copy)]
pub struct Instruction {
    /// Cycles by itself on the Cortex-M0+ and the Cortex-M4.
    cycles: [i64; 2],
    class: InstructionClass,
    reads: Registers,
    writes: Registers,
    /// Registers that it computes an address from.
    addressing: Registers,
    /// Whether it has four bytes at an address that is no multiple of four, which makes a jump to it slow.
    straddles: bool,
}

/// Cycles and class of an instruction by its name without width, condition and data types, and by the names of its registers.
fn timing(mnemonic: &str, registers: &[String]) -> ([i64; 2], InstructionClass) {
    let name = mnemonic.split('.').next().unwrap_or_default();
    let fits =
        |pattern: &str| pattern.strip_suffix('*').map_or(name == pattern, |start| name.starts_with(start));
    let row = TIMINGS.iter().find(|(patterns, ..)| patterns.split(' ').any(fits));
    let (_, cycles, class) = *row.unwrap_or(&TIMINGS[TIMINGS.len() - 1]);
    let words =
        |registers: &[String]| registers.iter().map(|name| if name.starts_with('d') { 2 } else { 1 }).sum();
    let more: i64 = match class {
        InstructionClass::Several if name.starts_with("ldrd") || name.starts_with("strd") => 2,
        // the first register has the address
        InstructionClass::Several if name.contains("ldm") || name.contains("stm") => {
            words(registers.get(1..).unwrap_or_default())
        }
        InstructionClass::Several | InstructionClass::FloatTransfer => words(registers),
        InstructionClass::FloatMove => i64::from(registers.len() > 2),
        _ => 0,
    };
    (cycles.map(|cycles| cycles + more), class)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cycles of a piece of Thumb code that runs from top to bottom and returns.
    fn cycles(timings: Timings, code: &[u16]) -> i64 {
        let bytes: Vec<u8> = code.iter().flat_map(|half| half.to_le_bytes()).collect();
        let mut model = CycleModel::new(timings).unwrap();
        let block = Block { start: 0, end: bytes.len() as u64, count: 0 };
        let BlockCycles { cycles, last, .. } = model.block(block, &bytes).unwrap();
        cycles + model.jump_cycles(&last, None)
    }

    #[test]
    fn an_m0plus_has_fixed_cycles() {
        // push {r4, lr}; ldr r0, [r1]; muls r0, r2; str r0, [r1]; pop {r4, pc}
        assert_eq!(cycles(Timings::M0Plus, &[0xb510, 0x6808, 0x4350, 0x6008, 0xbd10]), 3 + 2 + 1 + 2 + 5);
        // bx lr
        assert_eq!(cycles(Timings::M0Plus, &[0x4770]), 2);
    }

    #[test]
    fn an_m4_waits_for_results_and_overlaps_loads() {
        let bx = 0x4770;
        // ldr r0, [r2]; ldr r1, [r3]: these loads overlap. ldr r0, [r2]; ldr r1, [r0]: the second load needs the result of the first
        assert_eq!(cycles(Timings::M4, &[0x6810, 0x6819, bx]), 2 + 1 + 3);
        assert_eq!(cycles(Timings::M4, &[0x6810, 0x6801, bx]), 2 + 2 + 3);
        // adds r0, r0, r1; ldr r1, [r0]: the load waits for its address
        assert_eq!(cycles(Timings::M4, &[0x1840, 0x6801, bx]), 1 + 3 + 3);
        // vadd.f32 s0, s0, s1; then vmul.f32 of s0, which waits for the sum, or of s3, which does not
        assert_eq!(cycles(Timings::M4, &[0xee30, 0x0a20, 0xee20, 0x1a00, bx]), 1 + 2 + 3);
        assert_eq!(cycles(Timings::M4, &[0xee30, 0x0a20, 0xee21, 0x1aa1, bx]), 1 + 1 + 3);
        // vdiv.f32 s0, s0, s1; vldr s2, [r0]
        assert_eq!(cycles(Timings::M4, &[0xee80, 0x0a20, 0xed90, 0x1a00, bx]), 14 + 2 + 3);
    }
}
