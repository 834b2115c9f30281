//! Colours of pictures: those of Okabe and Ito, which the colour-blind can distinguish.

use cspace::{FeatureKind, FeatureName, RegionId};

use crate::scene::Colour;

pub(crate) const WHITE: Colour = Colour(0xff, 0xff, 0xff);
pub(crate) const INK: Colour = Colour(0x22, 0x22, 0x22);
pub(crate) const GRID: Colour = Colour(0xe6, 0xe6, 0xe6);
pub(crate) const BLOCKED: Colour = Colour(0xc9, 0xcc, 0xd1);
/// Colour of highlights: contacts, gaps of a drawing.
pub(crate) const MARK: Colour = Colour(0xd0, 0x00, 0x2a);

/// Colours of contact curves by the kinds of features that touch.
pub(crate) const KINDS: [(Colour, &str); 3] = [
    (Colour(0x00, 0x5a, 0x9c), "contact: line of the fixed part"),
    (Colour(0xc4, 0x4e, 0x00), "contact: line of the moving part"),
    (Colour(0x00, 0x7a, 0x57), "contact: arcs and vertices"),
];

/// Index of a contact's kind in [`KINDS`].
pub(crate) fn kind(fixed: FeatureName, moving: FeatureName) -> usize {
    match (fixed.kind, moving.kind) {
        (FeatureKind::Line, _) => 0,
        (_, FeatureKind::Line) => 1,
        _ => 2,
    }
}

/// Colour of a contact in a row of them, and a legible text colour on it, by the number of its pair of features.
pub(crate) fn bar(number: usize) -> (Colour, Colour) {
    const BARS: [(Colour, Colour); 7] = [
        (Colour(0x00, 0x72, 0xb2), WHITE),
        (Colour(0xe6, 0x9f, 0x00), INK),
        (Colour(0x00, 0x9e, 0x73), WHITE),
        (Colour(0xcc, 0x79, 0xa7), INK),
        (Colour(0x56, 0xb4, 0xe9), INK),
        (Colour(0xd5, 0x5e, 0x00), WHITE),
        (Colour(0xf0, 0xe4, 0x42), INK),
    ];
    BARS[number % BARS.len()]
}

/// The ground of a free region, by its number.
pub(crate) fn region(id: RegionId) -> Colour {
    const GROUNDS: [Colour; 7] = [
        WHITE,
        Colour(0xff, 0xf3, 0xb8),
        Colour(0xcf, 0xe8, 0xfa),
        Colour(0xfd, 0xd9, 0xc4),
        Colour(0xcc, 0xee, 0xdf),
        Colour(0xf3, 0xd6, 0xe7),
        Colour(0xe4, 0xdf, 0xf7),
    ];
    // The first is mostly that of far away; it comes once.
    match id.index() {
        0 => GROUNDS[0],
        n => GROUNDS[1 + (n - 1) % (GROUNDS.len() - 1)],
    }
}

/// The inside and the outline of a part, by its number.
pub(crate) fn part(number: usize) -> (Colour, Colour) {
    const PARTS: [(Colour, Colour); 6] = [
        (Colour(0xd8, 0xdc, 0xe1), Colour(0x3d, 0x45, 0x50)),
        (Colour(0xf9, 0xd9, 0x9a), Colour(0x8f, 0x5c, 0x00)),
        (Colour(0xb9, 0xdd, 0xf3), Colour(0x00, 0x4f, 0x80)),
        (Colour(0xb5, 0xe3, 0xd0), Colour(0x00, 0x5e, 0x43)),
        (Colour(0xf3, 0xc8, 0xdf), Colour(0x8a, 0x34, 0x66)),
        (Colour(0xf7, 0xc3, 0xa6), Colour(0x95, 0x3c, 0x00)),
    ];
    PARTS[number % PARTS.len()]
}
