//! ELF file: addresses of its functions, and the bytes of its code.

use crate::Failure;
use object::{Object, ObjectSection, ObjectSymbol, SectionKind, SymbolKind};
use std::fs;
use std::path::Path;

/// Symbol of a function.
pub struct Function {
    /// Name of the symbol.
    pub name: String,
    /// Address of its first instruction.
    pub address: u64,
    /// Size in bytes, with the literals after the code.
    pub size: u64,
}

/// Functions and code of an ELF.
pub struct Image {
    /// Functions in the order of their addresses, each with the first of its names.
    functions: Vec<Function>,
    code: Vec<(u64, Vec<u8>)>,
    /// Bytes of code and constants that the linker put into flash.
    pub flash: u64,
}

/// Kinds of section that are in flash; variables with an initial value are there too.
const IN_FLASH: [SectionKind; 4] =
    [SectionKind::Text, SectionKind::ReadOnlyData, SectionKind::ReadOnlyString, SectionKind::Data];

impl Image {
    /// Reads an ELF.
    ///
    /// # Errors
    /// [`Failure::Input`]: it cannot be read, or is no ELF.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let refuse = |error: &dyn std::fmt::Display| Failure::Input(format!("{}: {error}", path.display()));
        let bytes = fs::read(path).map_err(|error| refuse(&error))?;
        let file = object::File::parse(&*bytes).map_err(|error| refuse(&error))?;
        // the lowest bit of an Arm function's address marks Thumb code
        let thumb = u64::from(file.architecture() == object::Architecture::Arm);
        let mut functions: Vec<_> = file
            .symbols()
            .filter(|symbol| symbol.kind() == SymbolKind::Text && symbol.size() > 0)
            .map(|symbol| Function {
                name: symbol.name().unwrap_or_default().to_owned(),
                address: symbol.address() & !thumb,
                size: symbol.size(),
            })
            .collect();
        functions.sort_by(|a, b| (a.address, &a.name).cmp(&(b.address, &b.name)));
        functions.dedup_by_key(|function| function.address);
        let code = file
            .sections()
            .filter(|section| section.kind() == SectionKind::Text)
            .map(|section| Ok((section.address(), section.data()?.to_vec())))
            .collect::<Result<_, object::Error>>()
            .map_err(|error| refuse(&error))?;
        let flash = file
            .sections()
            .filter(|section| IN_FLASH.contains(&section.kind()))
            .map(|section| section.size())
            .sum();
        Ok(Self { functions, code, flash })
    }

    /// Function that contains an address.
    pub fn around(&self, address: u64) -> Option<&Function> {
        let after = self.functions.partition_point(|function| function.address <= address);
        let function = self.functions.get(after.checked_sub(1)?)?;
        (address < function.address + function.size).then_some(function)
    }

    /// Code between two addresses, if the ELF contains it.
    pub fn code(&self, from: u64, to: u64) -> Option<&[u8]> {
        self.code.iter().find_map(|(start, bytes)| {
            let offset = |address: u64| usize::try_from(address.checked_sub(*start)?).ok();
            bytes.get(offset(from)?..offset(to)?)
        })
    }
}
