//! A picture before it is written: shapes and text at places in dots, x to the right and y downwards.

/// An RGB colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Colour(pub u8, pub u8, pub u8);

impl Colour {
    /// The colour that is a share of the way from this one to another.
    pub fn towards(self, other: Self, share: f64) -> Self {
        let between = |a: u8, b: u8| {
            let mixed = f64::from(a) + (f64::from(b) - f64::from(a)) * share;
            mixed.round() as u8
        };
        Self(
            between(self.0, other.0),
            between(self.1, other.1),
            between(self.2, other.2),
        )
    }
}

/// A place on a picture, in dots from its upper left corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dot {
    /// To the right.
    pub x: f64,
    /// Downwards.
    pub y: f64,
}

impl Dot {
    /// The place `x` dots to the right and `y` dots below the upper left corner.
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The place moved by `dx` and `dy`.
    #[must_use]
    pub fn moved(self, dx: f64, dy: f64) -> Self {
        Self::new(self.x + dx, self.y + dy)
    }

    /// The distance to another place.
    pub fn distance(self, other: Self) -> f64 {
        (self.x - other.x).hypot(self.y - other.y)
    }
}

/// A step of a path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Step {
    /// Begins a new line at a place.
    Move(Dot),
    /// A straight line to a place.
    Line(Dot),
    /// A circular arc to a place; `bulge` is tan(sweep / 4), positive clockwise, since y is downwards.
    Arc {
        /// End point.
        to: Dot,
        /// tan(sweep / 4).
        bulge: f64,
    },
    /// A straight line to where the path began.
    Close,
}

/// Lines and arcs that follow each other.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Path {
    /// The steps; the first of each line is a [`Step::Move`].
    pub steps: Vec<Step>,
}

impl Path {
    /// A path with nothing in it.
    pub fn new() -> Self {
        Self::default()
    }

    /// A polyline.
    pub fn through(points: impl IntoIterator<Item = Dot>) -> Self {
        let mut path = Self::new();
        path.line_through(points);
        path
    }

    /// A rectangle.
    pub fn rectangle(area: Area) -> Self {
        let Area { lo, hi } = area;
        let corners = [lo, Dot::new(hi.x, lo.y), hi, Dot::new(lo.x, hi.y)];
        let mut path = Self::through(corners);
        path.steps.push(Step::Close);
        path
    }

    /// A circle.
    pub fn circle(center: Dot, radius: f64) -> Self {
        let (left, right) = (center.moved(-radius, 0.0), center.moved(radius, 0.0));
        let half = |to| Step::Arc { to, bulge: 1.0 };
        Self {
            steps: vec![Step::Move(left), half(right), half(left), Step::Close],
        }
    }

    /// Appends a polyline.
    pub fn line_through(&mut self, points: impl IntoIterator<Item = Dot>) {
        for (i, p) in points.into_iter().enumerate() {
            self.steps
                .push(if i == 0 { Step::Move(p) } else { Step::Line(p) });
        }
    }
}

/// A rectangle with sides along the axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Area {
    /// The upper left corner.
    pub lo: Dot,
    /// The lower right corner.
    pub hi: Dot,
}

impl Area {
    /// The rectangle with a corner, a width and a height.
    pub fn new(x: f64, y: f64, width: f64, height: f64) -> Self {
        Self {
            lo: Dot::new(x, y),
            hi: Dot::new(x + width, y + height),
        }
    }

    /// Width of the rectangle.
    pub fn width(&self) -> f64 {
        self.hi.x - self.lo.x
    }

    /// Height of the rectangle.
    pub fn height(&self) -> f64 {
        self.hi.y - self.lo.y
    }

    /// Whether two rectangles have a point in common.
    pub fn meets(&self, other: &Self) -> bool {
        self.lo.x <= other.hi.x
            && other.lo.x <= self.hi.x
            && self.lo.y <= other.hi.y
            && other.lo.y <= self.hi.y
    }

    /// Whether another rectangle lies within this one.
    pub fn holds(&self, other: &Self) -> bool {
        self.lo.x <= other.lo.x
            && other.hi.x <= self.hi.x
            && self.lo.y <= other.lo.y
            && other.hi.y <= self.hi.y
    }
}

/// Style of a line: solid, with round ends and corners.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// Colour of the line.
    pub colour: Colour,
    /// Width in dots.
    pub width: f64,
}

/// Alignment of a text relative to its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// The text begins at the place.
    Start,
    /// The middle of the text is at the place.
    Middle,
    /// The text ends at the place.
    End,
}

/// A line of text.
#[derive(Debug, Clone, PartialEq)]
pub struct Text {
    /// Content.
    pub text: String,
    /// The base line's place.
    pub at: Dot,
    /// The size of the letters in dots.
    pub size: f64,
    /// Colour of the text.
    pub colour: Colour,
    /// Alignment relative to the place.
    pub anchor: Anchor,
    /// Whether the text reads upwards instead of to the right.
    pub upwards: bool,
    /// Whether the text has a white outline, so that it can be read on lines.
    pub halo: bool,
}

/// Something on a picture.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// Lines and arcs, filled by the even-odd rule, drawn along, or both.
    Shape {
        /// The lines.
        path: Path,
        /// The colour inside.
        fill: Option<Colour>,
        /// Style of its outline.
        stroke: Option<Stroke>,
        /// Tooltip, shown under the mouse in formats that can.
        title: Option<String>,
    },
    /// A line of text.
    Text(Text),
    /// Items that are visible only within a rectangle.
    Clipped {
        /// The rectangle.
        area: Area,
        /// The items.
        items: Vec<Item>,
    },
}

impl Item {
    /// A filled shape.
    pub fn filled(path: Path, colour: Colour) -> Self {
        Self::Shape {
            path,
            fill: Some(colour),
            stroke: None,
            title: None,
        }
    }

    /// A line.
    pub fn drawn(path: Path, colour: Colour, width: f64) -> Self {
        Self::Shape {
            path,
            fill: None,
            stroke: Some(Stroke { colour, width }),
            title: None,
        }
    }
}

/// Picture: its size in dots, on white ground, and its items, the last on top.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// The width in dots.
    pub width: f64,
    /// The height in dots.
    pub height: f64,
    /// Description of the picture, for readers that cannot see it.
    pub title: String,
    /// Items of the picture.
    pub items: Vec<Item>,
}
