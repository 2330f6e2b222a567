//! Unit of a quantity.

/// Unit of a quantity.
#[derive(Clone, Copy)]
pub enum Unit {
    /// Unit with a mass, a length or a time, to which a scenario without units gives no name.
    Si(&'static str),
    /// Unit of an angle or a ratio, which every scenario has; empty for a number without unit.
    Any(&'static str),
}

impl Unit {
    /// Name in SI.
    pub fn name(self) -> &'static str {
        let (Self::Si(name) | Self::Any(name)) = self;
        name
    }
}
