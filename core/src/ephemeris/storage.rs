//! Ephemeris of one motion: clock, error bound, cells and segments.

use crate::ephemeris::cell::{CELLS, Cell, PAIRS};
use crate::ephemeris::clock::Clock;
use crate::ephemeris::error_bound::ErrorBound;
use crate::ephemeris::evaluation::EphemerisScalar;
use core::ops::{Deref, DerefMut};

/// Ephemeris of one motion with a capacity of `SEGMENTS` segments, at least 8 and at most 4096.
///
/// It is immutable after set-up, so any number of readers may share it without locks. Readers take an
/// [`EphemerisView`], to which it dereferences. Half a nutation period is divided into segments, which are short
/// where α and β change fast; each segment has polynomials of [`EphemerisScalar::TERMS`] coefficients. Size: 4 ·
/// SEGMENTS · TERMS coefficients and about 300 bytes.
///
/// ```
/// use toytop::{EphemerisF32, Motion, Release, State, Tick, Top, TopParameters};
/// let top = Top::sliding(&TopParameters {
///     transverse_inertia: 3.0e-5,
///     axial_inertia: 2.0e-5,
///     com_height: 0.03,
///     mass: 0.05,
///     ..TopParameters::default()
/// })?;
/// let release = Release { tilt: 0.35, spin: 150.0, ..Release::default() };
/// let motion = Motion::launch(&top, &State::release(&release)?)?;
/// let ephemeris = EphemerisF32::new(&motion, Tick::hertz(1000)?)?;
/// let mut cursor = ephemeris.cursor(0);
/// let now = cursor.next(&ephemeris); // tick 0; cannot fail
/// let in_a_century = ephemeris.at_tick(3_155_760_000_000);
/// assert!(now.u() > 0.93 && in_a_century.u() > 0.8);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub type Ephemeris<R, const SEGMENTS: usize> =
    EphemerisStorage<R, [<R as EphemerisScalar>::Segment; SEGMENTS]>;

/// Ephemeris of any capacity, behind a reference: the argument type of cursors, samples and all other readers.
pub type EphemerisView<R> = EphemerisStorage<R, [<R as EphemerisScalar>::Segment]>;

/// Common type of [`Ephemeris`], whose segments are an array, and [`EphemerisView`], whose segments are a slice.
#[derive(Debug, PartialEq)]
#[repr(C)] // the increments lie first, within the short address range of the smallest chip's load instructions
pub struct EphemerisStorage<R: EphemerisScalar, S: ?Sized> {
    pub(crate) clock: Clock<R::Wide>,
    pub(crate) error_bound: ErrorBound,
    pub(crate) rate_error_bound: ErrorBound,
    /// Cells, as [`crate::ephemeris::cell::Cell::to_bits`].
    pub(crate) cells: [u16; CELLS],
    pub(crate) segments: S,
}

/// Ephemeris in `f32`, 2 KiB. It is large enough for every motion with (e₃ - e₂)/(e₂ - e₁) >= 0.1 and A/(ps) >= 0.25.
pub type EphemerisF32 = Ephemeris<f32, 25>;

/// Ephemeris in `f64`, 17 KiB, for the motions of [`EphemerisF32`] with A/(ps) >= 0.4. Where A/(ps) >= 1, `Ephemeris<f64, 32>` (11 KiB)
/// is large enough.
pub type EphemerisF64 = Ephemeris<f64, 48>;

/// Ephemeris in fixed point of 32 bits, 2 KiB. It is large enough for the top of the README; many motions need 64
/// segments.
#[cfg(feature = "fixed")]
pub type EphemerisQ31 = Ephemeris<fixed::types::I2F30, 32>;

/// Ephemeris in fixed point of 16 bits, 0.6 KiB. It is large enough for the top of the README; many motions need 32
/// segments.
#[cfg(feature = "fixed")]
pub type EphemerisQ15 = Ephemeris<fixed::types::I2F14, 16>;

impl<R: EphemerisScalar, const SEGMENTS: usize> EphemerisStorage<R, [R::Segment; SEGMENTS]> {
    /// Assertion on the capacity, evaluated by the compiler when the type is used.
    const SIZE_IS_VALID: () = assert!(SEGMENTS >= PAIRS && SEGMENTS <= Cell::MOST_SEGMENTS);

    /// Ephemeris before its set-up, for a `static` that [`EphemerisView::set_up`] fills. All its bits are 0,
    /// so that it takes no flash.
    pub const EMPTY: Self = {
        let () = Self::SIZE_IS_VALID;
        Self {
            clock: Clock::STOPPED,
            error_bound: ErrorBound::NONE,
            rate_error_bound: ErrorBound::NONE,
            cells: [0; CELLS],
            segments: [R::ZERO_SEGMENT; SEGMENTS],
        }
    };

    /// Ephemeris without the capacity in its type.
    #[inline(always)]
    #[must_use]
    pub fn view(&self) -> &EphemerisView<R> {
        self
    }
}

impl<R: EphemerisScalar, const SEGMENTS: usize> Deref for EphemerisStorage<R, [R::Segment; SEGMENTS]> {
    type Target = EphemerisView<R>;

    #[inline(always)]
    fn deref(&self) -> &EphemerisView<R> {
        self
    }
}

impl<R: EphemerisScalar, const SEGMENTS: usize> DerefMut for EphemerisStorage<R, [R::Segment; SEGMENTS]> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut EphemerisView<R> {
        self
    }
}

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Number of segments that the memory can hold.
    #[must_use]
    pub fn capacity(&self) -> usize {
        self.segments.len()
    }

    /// Upper bound on the orientation error, rad.
    #[must_use]
    pub fn error_bound(&self) -> ErrorBound {
        self.error_bound
    }

    /// Upper bound on the error of the angular velocity, |Δω| or |ΔΩ|, and of u', rad per unit time. The bound for the
    /// velocity of the tip is s times as large; for a fixed tip it is equally large.
    #[must_use]
    pub fn rate_error_bound(&self) -> ErrorBound {
        self.rate_error_bound
    }
}
