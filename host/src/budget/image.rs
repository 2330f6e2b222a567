//! An ELF: where its functions are, and the bytes of its code.

use crate::Failure;
use object::{Object, ObjectSection, ObjectSymbol, SectionKind, SymbolKind};
use std::fs;
use std::path::Path;

/// A function's symbol.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Function {
    /// As linked.
    pub name: String,
    /// Address of its first instruction.
    pub address: u64,
    /// Bytes, literals after the code included.
    pub size: u64,
}

/// Functions and code of an ELF.
#[derive(Clone, Debug)]
pub struct Image {
    /// By address; of several names for one place the first.
    functions: Vec<Function>,
    code: Vec<(u64, Vec<u8>)>,
}

impl Image {
    /// Reads an ELF.
    ///
    /// # Errors
    /// [`Failure::Input`]: it cannot be read, or is no ELF.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let refuse = |error: &dyn std::fmt::Display| Failure::Input(format!("{}: {error}", path.display()));
        let bytes = fs::read(path).map_err(|error| refuse(&error))?;
        let file = object::File::parse(&*bytes).map_err(|error| refuse(&error))?;
        // the lowest bit of an Arm function's address says Thumb
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
        Ok(Self { functions, code })
    }

    /// The functions whose names begin so.
    pub fn named<'a>(&'a self, prefix: &'a str) -> impl Iterator<Item = &'a Function> {
        self.functions.iter().filter(move |function| function.name.starts_with(prefix))
    }

    /// The function that holds an address.
    #[must_use]
    pub fn around(&self, address: u64) -> Option<&Function> {
        let after = self.functions.partition_point(|function| function.address <= address);
        let function = self.functions.get(after.checked_sub(1)?)?;
        (address < function.address + function.size).then_some(function)
    }

    /// The code of some addresses, if it is in the ELF.
    #[must_use]
    pub fn code(&self, from: u64, to: u64) -> Option<&[u8]> {
        self.code.iter().find_map(|(start, bytes)| {
            let offset = |address: u64| usize::try_from(address.checked_sub(*start)?).ok();
            bytes.get(offset(from)?..offset(to)?)
        })
    }
}
