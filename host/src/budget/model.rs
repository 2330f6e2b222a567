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

use super::Chip;
use capstone::arch::ArchDetail;
use capstone::arch::arm::{ArchMode, ArmOperandType, ArmReg};
use capstone::prelude::*;

/// Processor with published timings.
#[derive(Clone, Copy, PartialEq)]
pub enum Model {
    /// Cortex-M0+ with the fast multiplier.
    M0Plus,
    /// Cortex-M4 with its FPU.
    M4,
}

impl Model {
    /// Model of a chip; `None` where no timings are published.
    pub fn of(chip: &Chip) -> Option<Self> {
        match chip.name {
            "m0plus" => Some(Self::M0Plus),
            "m4f" => Some(Self::M4),
            _ => None,
        }
    }

    /// Cycles of consecutive instructions.
    pub fn cycles(self, instructions: &[Instruction]) -> i64 {
        let alone: i64 = instructions.iter().map(|instruction| self.alone(instruction)).sum();
        alone + instructions.windows(2).map(|pair| self.after(&pair[0], &pair[1])).sum::<i64>()
    }

    /// Cycles of an instruction by itself.
    fn alone(self, instruction: &Instruction) -> i64 {
        let cycles = match (self, instruction.kind) {
            (_, Kind::Several { words }) => 1 + words,
            (Self::M0Plus, Kind::Load { .. } | Kind::Store { .. }) => 2,
            (Self::M0Plus, Kind::System) => 3,
            (Self::M0Plus, _) => 1,
            (Self::M4, Kind::Load { .. } | Kind::Store { indexed: true } | Kind::System) => 2,
            (Self::M4, Kind::FloatMove { two: true }) => 2,
            (Self::M4, Kind::Divide) => 12,
            (Self::M4, Kind::FloatMultiplyAdd) => 3,
            (Self::M4, Kind::FloatDivide) => 14,
            (Self::M4, Kind::FloatLoad { words } | Kind::FloatStore { words }) => 1 + words,
            (Self::M4, _) => 1,
        };
        cycles.into()
    }

    /// Additional cycles, which may be negative, because of the instruction before it.
    pub fn after(self, before: &Instruction, instruction: &Instruction) -> i64 {
        if self == Self::M0Plus {
            return 0;
        }
        let waits_for_float = match before.kind {
            Kind::Float | Kind::FloatMultiplyAdd | Kind::FloatDivide => {
                meet(before.writes, instruction.reads)
            }
            _ => false,
        };
        let waits_for_address = before.kind == Kind::Plain && meet(before.writes, instruction.addressing);
        let overlaps = matches!(before.kind, Kind::Load { .. })
            && matches!(instruction.kind, Kind::Load { .. } | Kind::Store { indexed: true })
            && !meet(before.writes, PC)
            && !meet(before.writes, instruction.addressing);
        i64::from(waits_for_float) + i64::from(waits_for_address) - i64::from(overlaps)
    }

    /// Additional cycles of a jump to an instruction other than the next one.
    pub fn jump(self, instruction: &Instruction, target: Option<&Instruction>) -> i64 {
        match (self, instruction.kind) {
            (Self::M0Plus, Kind::Call | Kind::Several { .. }) => 2,
            (Self::M0Plus, _) => 1,
            (Self::M4, Kind::Table) => 5,
            (Self::M4, kind) => {
                let refill = if matches!(kind, Kind::Branch | Kind::Call) { 1 } else { 2 };
                let straddles = target.is_some_and(|target| target.straddles);
                (refill + i64::from(straddles)).min(3)
            }
        }
    }
}

/// Set of registers, as bits at the numbers that Capstone gives them.
type Registers = u128;

/// Program counter.
const PC: Registers = 1 << ArmReg::ARM_REG_PC;

fn set(registers: &[RegId]) -> Registers {
    registers.iter().fold(0, |set, register| set | 1 << register.0)
}

/// Whether two sets have a register in common.
fn meet(a: Registers, b: Registers) -> bool {
    a & b != 0
}

/// Class of an instruction by its cycles.
#[derive(Clone, Copy, PartialEq)]
pub enum Kind {
    /// Data processing, multiplication included.
    Plain,
    /// IT.
    IfThen,
    /// SDIV, UDIV.
    Divide,
    /// Barrier, or access to a special register.
    System,
    /// Load of one word or less; `indexed` if a register is added to the address.
    Load { indexed: bool },
    /// Store of one word or less; `indexed` if a register is added to the address.
    Store { indexed: bool },
    /// Transfer of this many words: LDM, STM, LDRD, STRD, PUSH, POP, VLDM, VSTM.
    Several { words: u32 },
    /// VADD, VMUL, VCVT and others, whose result is not ready for the next instruction.
    Float,
    /// VMLA, VFMA and others.
    FloatMultiplyAdd,
    /// VDIV, VSQRT.
    FloatDivide,
    /// VMOV, VCMP, VNEG and others; `two` if two core registers are moved.
    FloatMove { two: bool },
    /// VLDR.
    FloatLoad { words: u32 },
    /// VSTR.
    FloatStore { words: u32 },
    /// B to an address in the instruction.
    Branch,
    /// BL to an address in the instruction.
    Call,
    /// B with a condition, CBZ, CBNZ.
    Conditional,
    /// BX, BLX.
    ToRegister,
    /// TBB, TBH.
    Table,
}

/// Decoded instruction.
#[derive(Clone, Copy)]
pub struct Instruction {
    /// Class by its cycles.
    pub kind: Kind,
    /// Registers that it reads.
    pub reads: Registers,
    /// Registers that it writes.
    pub writes: Registers,
    /// Registers that it computes an address from.
    pub addressing: Registers,
    /// Whether it has four bytes at an address that is no multiple of four, which makes a jump to it slow.
    pub straddles: bool,
}

/// Decoder of Thumb code.
pub struct Decoder(Capstone);

impl Decoder {
    /// Decoder for every Cortex-M.
    ///
    /// # Errors
    /// The errors of Capstone.
    pub fn new() -> Result<Self, capstone::Error> {
        let builder = Capstone::new().arm().mode(ArchMode::Thumb);
        let extra = std::iter::once(capstone::arch::arm::ArchExtraMode::MClass);
        Ok(Self(builder.extra_mode(extra).detail(true).build()?))
    }

    /// Instructions of a piece of code, up to the first that cannot be decoded.
    ///
    /// # Errors
    /// The errors of Capstone.
    pub fn decode(&self, code: &[u8], address: u64) -> Result<Vec<Instruction>, capstone::Error> {
        let decoded = self.0.disasm_all(code, address)?;
        decoded.iter().map(|instruction| self.facts(instruction)).collect()
    }

    fn facts(&self, instruction: &capstone::Insn) -> Result<Instruction, capstone::Error> {
        let detail = self.0.insn_detail(instruction)?;
        let mut operands = Vec::new();
        let mut addressing = Vec::new();
        let ArchDetail::ArmDetail(arm) = detail.arch_detail();
        for operand in arm.operands() {
            match operand.op_type {
                ArmOperandType::Reg(register) => operands.extend(self.0.reg_name(register)),
                ArmOperandType::Mem(memory) => addressing.extend([memory.base(), memory.index()]),
                _ => {}
            }
        }
        // the number 0 is no register
        addressing.retain(|register| register.0 != 0);
        let mnemonic = instruction.mnemonic().unwrap_or_default();
        Ok(Instruction {
            kind: kind(mnemonic, &operands, addressing.len() > 1),
            reads: set(detail.regs_read()),
            writes: set(detail.regs_write()),
            addressing: set(&addressing),
            straddles: instruction.len() == 4 && !instruction.address().is_multiple_of(4),
        })
    }
}

/// Class of an instruction by its name without width, condition and data types.
fn kind(mnemonic: &str, operands: &[String], indexed: bool) -> Kind {
    let name = mnemonic.split('.').next().unwrap_or_default();
    let of = |prefixes: &[&str]| prefixes.iter().any(|prefix| name.starts_with(prefix));
    let words = |names: &[String]| names.iter().map(|name| if name.starts_with('d') { 2 } else { 1 }).sum();
    match name {
        "b" => Kind::Branch,
        "bl" => Kind::Call,
        "bx" | "blx" | "bxns" | "blxns" => Kind::ToRegister,
        "cbz" | "cbnz" => Kind::Conditional,
        "tbb" | "tbh" => Kind::Table,
        "push" | "pop" => Kind::Several { words: words(operands) },
        "dmb" | "dsb" | "isb" | "mrs" | "msr" | "cpsie" | "cpsid" | "svc" | "bkpt" => Kind::System,
        _ if name.len() == 3 && name.starts_with('b') && name != "bic" && name != "bfi" && name != "bfc" => {
            Kind::Conditional
        }
        _ if name.starts_with("it") => Kind::IfThen,
        _ if of(&["vldr"]) => Kind::FloatLoad { words: words(operands) },
        _ if of(&["vstr"]) => Kind::FloatStore { words: words(operands) },
        _ if of(&["vpush", "vpop"]) => Kind::Several { words: words(operands) },
        _ if of(&["vldm", "vstm"]) => Kind::Several { words: words(operands.get(1..).unwrap_or_default()) },
        _ if of(&["vmla", "vmls", "vnmla", "vnmls", "vfma", "vfms", "vfnma", "vfnms"]) => {
            Kind::FloatMultiplyAdd
        }
        _ if of(&["vdiv", "vsqrt"]) => Kind::FloatDivide,
        _ if of(&["vadd", "vsub", "vmul", "vnmul", "vcvt", "vrint"]) => Kind::Float,
        _ if name.starts_with('v') => Kind::FloatMove { two: operands.len() > 2 },
        _ if of(&["ldrd", "strd"]) => Kind::Several { words: 2 },
        _ if of(&["ldm", "stm"]) => Kind::Several { words: words(operands.get(1..).unwrap_or_default()) },
        _ if of(&["ldr"]) => Kind::Load { indexed },
        _ if of(&["str"]) => Kind::Store { indexed },
        _ if of(&["sdiv", "udiv"]) => Kind::Divide,
        _ => Kind::Plain,
    }
}

#[cfg(test)]
mod tests {
    use super::Decoder;
    use super::*;

    /// Cycles of a piece of Thumb code that runs from top to bottom and returns.
    fn cycles(model: Model, code: &[u16]) -> i64 {
        let bytes: Vec<u8> = code.iter().flat_map(|half| half.to_le_bytes()).collect();
        let instructions = Decoder::new().unwrap().decode(&bytes, 0).unwrap();
        model.cycles(&instructions) + model.jump(instructions.last().unwrap(), None)
    }

    #[test]
    fn an_m0plus_has_fixed_cycles() {
        // push {r4, lr}; ldr r0, [r1]; muls r0, r2; str r0, [r1]; pop {r4, pc}
        assert_eq!(cycles(Model::M0Plus, &[0xb510, 0x6808, 0x4350, 0x6008, 0xbd10]), 3 + 2 + 1 + 2 + 5);
        // bx lr
        assert_eq!(cycles(Model::M0Plus, &[0x4770]), 2);
    }

    #[test]
    fn an_m4_waits_for_results_and_overlaps_loads() {
        let bx = 0x4770;
        // ldr r0, [r2]; ldr r1, [r3]: these loads overlap. ldr r0, [r2]; ldr r1, [r0]: the second load needs the result of the first
        assert_eq!(cycles(Model::M4, &[0x6810, 0x6819, bx]), 2 + 1 + 3);
        assert_eq!(cycles(Model::M4, &[0x6810, 0x6801, bx]), 2 + 2 + 3);
        // adds r0, r0, r1; ldr r1, [r0]: the load waits for its address
        assert_eq!(cycles(Model::M4, &[0x1840, 0x6801, bx]), 1 + 3 + 3);
        // vadd.f32 s0, s0, s1; then vmul.f32 of s0, which waits for the sum, or of s3, which does not
        assert_eq!(cycles(Model::M4, &[0xee30, 0x0a20, 0xee20, 0x1a00, bx]), 1 + 2 + 3);
        assert_eq!(cycles(Model::M4, &[0xee30, 0x0a20, 0xee21, 0x1aa1, bx]), 1 + 1 + 3);
        // vdiv.f32 s0, s0, s1; vldr s2, [r0]
        assert_eq!(cycles(Model::M4, &[0xee80, 0x0a20, 0xed90, 0x1a00, bx]), 14 + 2 + 3);
    }
}
