//! Properties of an Arm Thumb instruction that determine its timing.

use capstone::arch::ArchDetail;
use capstone::arch::arm::{ArchMode, ArmOperandType, ArmReg};
use capstone::prelude::*;

/// Set of registers, as bits at the numbers that Capstone gives them.
#[derive(Clone, Copy)]
pub struct Registers(u128);

impl Registers {
    /// Program counter.
    pub const PC: Self = Self(1 << ArmReg::ARM_REG_PC);

    fn new(registers: &[RegId]) -> Self {
        Self(registers.iter().fold(0, |set, register| set | 1 << register.0))
    }

    /// Whether the two sets have a register in common.
    pub fn meet(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }
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
            reads: Registers::new(detail.regs_read()),
            writes: Registers::new(detail.regs_write()),
            addressing: Registers::new(&addressing),
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
