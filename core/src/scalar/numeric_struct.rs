//! Struct whose fields are numbers of one type.

/// Defines the struct with its zero and its conversion to another type, so that the fields are listed once.
macro_rules! numeric_struct {
    (
        $(#[$attribute:meta])*
        $visibility:vis struct $Name:ident<$F:ident $(= $default:ty)?> {
            $($(#[$field_attribute:meta])* $field_visibility:vis $field:ident,)*
        }
    ) => {
        $(#[$attribute])*
        $visibility struct $Name<$F $(= $default)?> {
            $($(#[$field_attribute])* $field_visibility $field: $F,)*
        }

        #[allow(dead_code)] // not every struct needs both
        impl<$F: crate::scalar::Ring> $Name<$F> {
            pub(crate) const ZERO: Self = Self { $($field: $F::ZERO,)* };

            /// Numbers in another type.
            #[inline(never)]
            pub(crate) fn map<G>(&self, convert: fn($F) -> G) -> $Name<G> {
                $Name { $($field: convert(self.$field),)* }
            }
        }
    };
}
pub(crate) use numeric_struct;
