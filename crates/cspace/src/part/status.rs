//! The pieces of boundary that a sweep line cuts, ordered along it.

/// Placeholder for an item.
const NONE: u32 = u32::MAX;

/// An ordered list of items 0, 1, 2, …, each at most once; an item is inserted by comparison and removed by its number.
///
/// A treap: a search tree in the order of the list and a heap in scrambled numbers, so that its
/// depth is logarithmic whatever the order of insertion. The items are linked as a list as well.
pub(super) struct Status {
    root: u32,
    nodes: Vec<Node>,
}

#[derive(Clone, Copy)]
struct Node {
    parent: u32,
    children: [u32; 2],
    before: u32,
    after: u32,
}

impl Node {
    const LOOSE: Self = Self {
        parent: NONE,
        children: [NONE; 2],
        before: NONE,
        after: NONE,
    };
}

impl Status {
    /// An empty list for `capacity` items.
    pub(super) fn new(capacity: usize) -> Self {
        Self {
            root: NONE,
            nodes: vec![Node::LOOSE; capacity],
        }
    }

    /// The items just before and just after an item of the list.
    pub(super) fn neighbours(&self, item: u32) -> (Option<u32>, Option<u32>) {
        let node = &self.nodes[item as usize];
        (some(node.before), some(node.after))
    }

    /// Inserts an item after exactly those items for which `is_after` holds.
    pub(super) fn insert(&mut self, item: u32, is_after: impl Fn(u32) -> bool) {
        let mut node = Node::LOOSE;
        let (mut place, mut side) = (self.root, 0);
        while place != NONE {
            node.parent = place;
            side = usize::from(is_after(place));
            if side == 1 {
                node.before = place;
            } else {
                node.after = place;
            }
            place = self.nodes[place as usize].children[side];
        }
        self.nodes[item as usize] = node;
        match some(node.parent) {
            Some(parent) => self.nodes[parent as usize].children[side] = item,
            None => self.root = item,
        }
        self.link(node.before, item);
        self.link(item, node.after);
        while let Some(parent) = some(self.nodes[item as usize].parent) {
            if scramble(item) <= scramble(parent) {
                break;
            }
            self.lift(item);
        }
    }

    /// Removes an item.
    pub(super) fn remove(&mut self, item: u32) {
        loop {
            let Node { children, .. } = self.nodes[item as usize];
            match children.map(some) {
                [Some(a), Some(b)] if scramble(a) > scramble(b) => self.lift(a),
                [_, Some(b)] => self.lift(b),
                [Some(a), None] => self.lift(a),
                [None, None] => break,
            }
        }
        let Node {
            parent,
            before,
            after,
            ..
        } = self.nodes[item as usize];
        self.replace_child(parent, item, NONE);
        self.link(before, after);
        self.nodes[item as usize] = Node::LOOSE;
    }

    /// Makes two items (or ends) neighbours in the list.
    fn link(&mut self, before: u32, after: u32) {
        if before != NONE {
            self.nodes[before as usize].after = after;
        }
        if after != NONE {
            self.nodes[after as usize].before = before;
        }
    }

    /// Rotates an item above its parent.
    fn lift(&mut self, item: u32) {
        let parent = self.nodes[item as usize].parent;
        let above = self.nodes[parent as usize].parent;
        let side = usize::from(self.nodes[parent as usize].children[1] == item);
        let moved = self.nodes[item as usize].children[1 - side];
        self.nodes[parent as usize].children[side] = moved;
        if moved != NONE {
            self.nodes[moved as usize].parent = parent;
        }
        self.nodes[item as usize].children[1 - side] = parent;
        self.nodes[parent as usize].parent = item;
        self.nodes[item as usize].parent = above;
        self.replace_child(above, parent, item);
    }

    fn replace_child(&mut self, parent: u32, old: u32, new: u32) {
        match some(parent) {
            Some(parent) => {
                let children = &mut self.nodes[parent as usize].children;
                children[usize::from(children[1] == old)] = new;
            }
            None => self.root = new,
        }
    }
}

fn some(item: u32) -> Option<u32> {
    (item != NONE).then_some(item)
}

/// A fixed mixing of the bits of a number.
fn scramble(item: u32) -> u32 {
    let x = (item ^ (item >> 16)).wrapping_mul(0x7feb_352d);
    let x = (x ^ (x >> 15)).wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

#[cfg(test)]
mod tests {
    use super::Status;

    fn listed(status: &Status, mut item: Option<u32>) -> Vec<u32> {
        let mut list = Vec::new();
        while let Some(i) = item {
            list.push(i);
            item = status.neighbours(i).1;
        }
        list
    }

    #[test]
    fn keeps_items_in_order_whatever_comes_and_goes() {
        let n = 1000;
        let mut status = Status::new(n as usize);
        for k in 0..n {
            let item = (k * 387) % n;
            status.insert(item, |other| item > other);
        }
        assert_eq!(listed(&status, Some(0)), (0..n).collect::<Vec<_>>());
        for k in (0..n).filter(|k| k % 3 != 0) {
            status.remove((k / 3 * 3) + k % 3);
        }
        let thirds: Vec<_> = (0..n).step_by(3).collect();
        assert_eq!(listed(&status, Some(0)), thirds);
        for k in (1..n).step_by(3) {
            status.insert(k, |other| k > other);
        }
        let rest: Vec<_> = (0..n).filter(|k| k % 3 != 2).collect();
        assert_eq!(listed(&status, Some(0)), rest);
    }
}
