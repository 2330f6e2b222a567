//! Words for regimes and tip curves in the output.

use toytop::{Regime, TipClass};

/// Word for a regime: `nutating`, `regular_precession`, ...
pub fn regime(regime: Regime) -> &'static str {
    match regime {
        Regime::Nutating => "nutating",
        Regime::SlowPrecession | Regime::FastPrecession => "regular_precession",
        Regime::SleepingStable => "sleeping_stable",
        Regime::SleepingUnstable => "sleeping_unstable",
        Regime::Hanging => "hanging",
        Regime::Aperiodic => "aperiodic",
        _ => "unknown",
    }
}

/// Word for a class of tip curve: `smooth`, `cusp`, `loops`, ...
pub fn tip_class(class: TipClass) -> &'static str {
    match class {
        TipClass::Smooth => "smooth",
        TipClass::Cusp => "cusp",
        TipClass::Loops => "loops",
        TipClass::Circle => "circle",
        TipClass::ThroughOrigin => "through_origin",
        TipClass::Spiral => "spiral",
        TipClass::Point => "point",
        _ => "unknown",
    }
}
