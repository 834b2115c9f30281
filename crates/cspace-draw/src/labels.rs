//! Labels that do not lie on each other.

use crate::colour::INK;
use crate::font;
use crate::plot::{haloed, text};
use crate::scene::{Anchor, Area, Colour, Dot, Item};

/// Labels of a picture so far.
pub(crate) struct Placed {
    within: Area,
    taken: Vec<Area>,
    /// Whether labels may overlap each other.
    crowded: bool,
}

impl Placed {
    /// Starts without labels, all of which are to be in a rectangle; `crowded` allows them to overlap.
    pub(crate) fn new(within: Area, crowded: bool) -> Self {
        Self {
            within,
            taken: Vec::new(),
            crowded,
        }
    }

    /// A label in the middle of the first of some places at which it lies on no other; whether there is one.
    pub(crate) fn put(
        &mut self,
        items: &mut Vec<Item>,
        said: &str,
        size: f64,
        places: impl IntoIterator<Item = Dot>,
    ) -> bool {
        self.put_in(items, said, size, INK, places)
    }

    /// As above, in a colour.
    pub(crate) fn put_in(
        &mut self,
        items: &mut Vec<Item>,
        said: &str,
        size: f64,
        colour: Colour,
        places: impl IntoIterator<Item = Dot>,
    ) -> bool {
        let (w, h) = (font::width(said, size) + 0.3 * size, 1.15 * size);
        for at in places {
            let area = Area::new(at.x - 0.5 * w, at.y - 0.5 * h, w, h);
            let free = self.crowded || !self.taken.iter().any(|t| t.meets(&area));
            if self.within.holds(&area) && free {
                let base = Dot::new(at.x, at.y + 0.35 * size);
                items.push(haloed(text(
                    said.to_owned(),
                    base,
                    size,
                    Anchor::Middle,
                    colour,
                )));
                self.taken.push(area);
                return true;
            }
        }
        false
    }

    /// Whether labels that do not fit are left out.
    pub(crate) fn is_sparing(&self) -> bool {
        !self.crowded
    }

    /// Keeps labels away from a rectangle.
    pub(crate) fn keep(&mut self, area: Area) {
        self.taken.push(area);
    }
}
