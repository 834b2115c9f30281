//! Which boxes are near each other, without a look at every two.

use cspace::part::Bounds;

/// Boxes in the order of their left sides.
pub(crate) struct Boxed {
    boxes: Vec<(usize, Bounds)>,
}

impl Boxed {
    pub(crate) fn new(boxes: Vec<Bounds>) -> Self {
        let mut boxes: Vec<(usize, Bounds)> = boxes.into_iter().enumerate().collect();
        boxes.sort_by(|a, b| a.1.min.x.total_cmp(&b.1.min.x).then(a.0.cmp(&b.0)));
        Self { boxes }
    }
}

/// Every two boxes with a gap of no more than `within` along either axis, by their numbers, the lower first.
pub(crate) fn near(boxed: &Boxed, within: f64) -> Vec<[usize; 2]> {
    let boxes = &boxed.boxes;
    let mut found = Vec::new();
    for (place, (i, a)) in boxes.iter().enumerate() {
        let right = a.max.x + within;
        let after = boxes[place + 1..].iter();
        for (j, b) in after.take_while(|(_, b)| b.min.x <= right) {
            if !a.is_apart(*b, within) {
                found.push([*i.min(j), *i.max(j)]);
            }
        }
    }
    found
}
