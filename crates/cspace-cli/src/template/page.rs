//! The text of a model while it is written.

use crate::failure::Failure;

/// A coordinate nearer to 0 than this share of the model's size is the rounding of a sine or a difference.
const NOTHING: f64 = 1e-13;

/// The shortest and longest length of a template, in the unit of the model. Between them no dimension vanishes beside
/// another, and numbers are written without exponents.
const LENGTHS: (f64, f64) = (1e-3, 1e6);

/// The line of a part of steel, 10 mm thick.
pub(super) const STEEL: &str = "density = 7.85e-5";

/// A model as text, part by part.
pub(super) struct Page {
    text: String,
    size: f64,
}

impl Page {
    /// Begins with a comment and the name; `size` is about that of the whole.
    pub(super) fn new(comment: &str, name: &str, size: f64) -> Self {
        let mut page = Self {
            text: String::new(),
            size,
        };
        page.comment(comment);
        page.text += &format!("\nname = \"{name}\"\nunit = \"mm\"\n");
        page
    }

    fn comment(&mut self, comment: &str) {
        for line in comment.lines() {
            self.text += format!("# {line}").trim_end();
            self.text.push('\n');
        }
    }

    /// Lines that go for the whole model, such as gravity. They come before the names of the dimensions.
    pub(super) fn world(&mut self, lines: &str) {
        self.text += &format!("{lines}\n");
    }

    /// Begins the names of the model's dimensions.
    pub(super) fn parameters(&mut self) {
        self.text += "\n[parameter]\n";
    }

    /// A dimension with its value.
    pub(super) fn parameter(&mut self, name: &str, value: f64, note: &str) {
        let before = if note.is_empty() { "" } else { " # " };
        self.text += &format!("{name} = {}{before}{note}\n", number(value));
    }

    /// A dimension that follows from others.
    pub(super) fn derived(&mut self, name: &str, expression: &str) {
        self.text += &format!("{name} = \"{expression}\"\n");
    }

    /// Adds a requirement; `lines` are the keys of its table.
    pub(super) fn requirement(&mut self, comment: &str, lines: &str) {
        self.text.push('\n');
        self.comment(comment);
        self.text += &format!("[[requirement]]\n{lines}\n");
    }

    /// Begins a part; `motion` is what stands behind `motion =`, empty for a part that moves freely.
    pub(super) fn part(&mut self, comment: &str, name: &str, motion: &str) {
        self.part_with(comment, name, motion, &[]);
    }

    /// Begins a part as [`Page::part`] does; `keys` are further lines, such as its mass or its start.
    pub(super) fn part_with(&mut self, comment: &str, name: &str, motion: &str, keys: &[&str]) {
        self.text.push('\n');
        self.comment(comment);
        self.text += &format!("[[part]]\nname = \"{name}\"\n");
        if !motion.is_empty() {
            self.text += &format!("motion = {motion}\n");
        }
        for key in keys {
            self.text += &format!("{key}\n");
        }
        self.text += "loops = [\n";
    }

    pub(super) fn end_part(&mut self) {
        self.text += "]\n";
    }

    pub(super) fn begin_loop(&mut self, what: &str) {
        self.text += &format!("  [ # {what}\n");
    }

    pub(super) fn end_loop(&mut self) {
        self.text += "  ],\n";
    }

    /// Begins entries that are turned so often about the origin and joined.
    pub(super) fn begin_repeat(&mut self, count: &str) {
        let count = value(count);
        self.text += &format!("    {{ repeat = {count}, about = [0, 0], path = [\n");
    }

    pub(super) fn end_repeat(&mut self) {
        self.text += "    ] },\n";
    }

    /// Adds a drive that moves a part at a constant rate.
    pub(super) fn driven(&mut self, comment: &str, part: &str, rate: &str) {
        self.text.push('\n');
        self.comment(comment);
        self.text += &format!("[[drive]]\npart = \"{part}\"\nrate = \"{rate}\"\n");
    }

    /// A load on a part, as the line that says it.
    pub(super) fn load(&mut self, comment: &str, part: &str, line: &str) {
        self.text.push('\n');
        self.comment(comment);
        self.text += &format!("[[load]]\npart = \"{part}\"\n{line}\n");
    }

    /// A spring without length from a point of a part to a point of the ground, both in expressions of the dimensions.
    pub(super) fn mount(
        &mut self,
        comment: &str,
        part: &str,
        at: [[&str; 2]; 2],
        stiffness: &str,
        damping: &str,
    ) {
        self.text.push('\n');
        self.comment(comment);
        let [from, to] = at.map(|[x, y]| format!("[{}, {}]", value(x), value(y)));
        let (stiffness, damping) = (value(stiffness), value(damping));
        self.text += &format!(
            "[[spring]]\nparts = [\"{part}\"]\nat = [{from}, {to}]\nstiffness = {stiffness}\nlength = 0\ndamping = {damping}\n"
        );
    }

    /// A vertex that a line leads to.
    pub(super) fn vertex(&mut self, at: (f64, f64), note: &str) {
        let entry = self.point(at);
        self.entry(&entry, note);
    }

    /// A vertex by expressions of its coordinates, or numbers.
    pub(super) fn corner(&mut self, x: &str, y: &str, note: &str) {
        self.entry(&format!("[{}, {}]", value(x), value(y)), note);
    }

    /// An arc of at most half a turn, counter-clockwise, by expressions.
    pub(super) fn bow(&mut self, x: &str, y: &str, radius: &str, note: &str) {
        let (x, y, radius) = (value(x), value(y), value(radius));
        self.entry(
            &format!("{{ arc_to = [{x}, {y}], radius = {radius} }}"),
            note,
        );
    }

    /// An arc about a centre, by expressions.
    pub(super) fn turn(&mut self, to: [&str; 2], center: [&str; 2], turn: Turn, note: &str) {
        let [[x, y], [cx, cy]] = [to, center].map(|at| at.map(value));
        let entry = format!(
            "{{ arc_to = [{x}, {y}], center = [{cx}, {cy}], direction = \"{}\" }}",
            turn.name()
        );
        self.entry(&entry, note);
    }

    pub(super) fn fillet(&mut self, radius: f64, note: &str) {
        let entry = format!("{{ fillet = {} }}", number(radius));
        self.entry(&entry, note);
    }

    pub(super) fn rounding(&mut self, radius: &str, note: &str) {
        self.entry(&format!("{{ fillet = {} }}", value(radius)), note);
    }

    pub(super) fn arc_about(&mut self, to: (f64, f64), center: (f64, f64), turn: Turn, note: &str) {
        let entry = format!(
            "{{ arc_to = {}, center = {}, direction = \"{}\" }}",
            self.point(to),
            self.point(center),
            turn.name()
        );
        self.entry(&entry, note);
    }

    pub(super) fn arc_through(&mut self, to: (f64, f64), through: (f64, f64), note: &str) {
        let entry = format!(
            "{{ arc_to = {}, through = {} }}",
            self.point(to),
            self.point(through)
        );
        self.entry(&entry, note);
    }

    /// A circle, which is a loop of its own, by expressions.
    pub(super) fn circle(&mut self, radius: &str, [x, y]: [&str; 2], note: &str) {
        let [radius, x, y] = [radius, x, y].map(value);
        self.text += &format!("  {{ circle = {radius}, at = [{x}, {y}] }}, # {note}\n");
    }

    fn entry(&mut self, entry: &str, note: &str) {
        let before = if note.is_empty() { "" } else { " # " };
        self.text += &format!("    {entry},{before}{note}\n");
    }

    /// A point as models have it.
    pub(super) fn point(&self, (x, y): (f64, f64)) -> String {
        let clean = |x: f64| {
            if x.abs() < NOTHING * self.size {
                0.0
            } else {
                x
            }
        };
        format!("[{}, {}]", number(clean(x)), number(clean(y)))
    }

    /// The model, once it is known that it can be read.
    pub(super) fn finish(self) -> Result<String, Failure> {
        match cspace_io::model::from_toml(&self.text, "the model") {
            Ok(_) => Ok(self.text),
            Err(error) => Err(Failure::new(format_args!(
                "these dimensions do not go together: {error}"
            ))
            .help("change them towards the defaults, which --help lists")),
        }
    }
}

/// The direction in which an arc turns.
#[derive(Clone, Copy)]
pub(super) enum Turn {
    Left,
    Right,
}

impl Turn {
    fn name(self) -> &'static str {
        match self {
            Self::Left => "ccw",
            Self::Right => "cw",
        }
    }
}

/// A number as it stands, an expression in quotes.
fn value(text: &str) -> String {
    match text.parse::<f64>() {
        Ok(_) => text.to_owned(),
        Err(_) => format!("\"{text}\""),
    }
}

/// A number without the digits that computing it has left at its end: 14 of them are kept.
pub(super) fn number(x: f64) -> String {
    let rounded = format!("{x:.13e}").parse().unwrap_or(x);
    format!("{rounded}")
}

/// To so many decimals, for comments.
pub(super) fn about(x: f64, decimals: usize) -> String {
    let text = format!("{x:.decimals$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// The point at a radius and an angle in degrees.
pub(super) fn polar(radius: f64, degrees: f64) -> (f64, f64) {
    let (sin, cos) = degrees.to_radians().sin_cos();
    (radius * cos, radius * sin)
}

/// A length on the command line.
pub(super) fn length(text: &str) -> Result<f64, String> {
    let (least, most) = LENGTHS;
    (text.trim().parse::<f64>().ok())
        .filter(|x| (least..=most).contains(x))
        .ok_or_else(|| format!("give a length of more than 0, from {least} to {most}"))
}

/// A length, or 0 for none.
pub(super) fn length_or_none(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(0.0) => Ok(0.0),
        _ => length(text).map_err(|e| format!("{e}, or 0 for none")),
    }
}
