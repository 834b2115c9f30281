//! Numbers of the elements of a space. Each kind has its own type, so that they cannot be confused.

macro_rules! id {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "serde", serde(transparent))]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        pub struct $name(pub u32);

        impl $name {
            /// The number as an index, from 0.
            pub const fn index(self) -> usize {
                self.0 as usize
            }
        }

        impl core::fmt::Display for $name {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                self.0.fmt(f)
            }
        }
    };
}

id! {
    /// The number of a contact patch, in the order of [`PairSpace::patches`](crate::PairSpace::patches).
    PatchId
}
id! {
    /// The number of a free region, in the order of [`PairSpace::regions`](crate::PairSpace::regions).
    RegionId
}
id! {
    /// The number of a link between two patches, in the order of [`PairSpace::links`](crate::PairSpace::links).
    LinkId
}
