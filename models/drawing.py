"""What model files are drawn with: points, edges, outlines, roundings, and the writing and checking of files.

Lengths are in mm, angles in degrees, points are complex numbers. Every outline is a chain of lines and arcs with known
centres; roundings are put on afterwards, with the exact centre and touching points, so joints meant to be tangent are
tangent to rounding error.
"""

import cmath
import math
import re
import sys
from pathlib import Path

from forces import Forces, comment, number
from picture import svg

# ---------------------------------------------------------------- points and intersections


def polar(radius, degrees):
    """The point at a radius and an angle."""
    return cmath.rect(radius, math.radians(degrees))


def unit(z):
    return z / abs(z)


def cross(a, b):
    return a.real * b.imag - a.imag * b.real


def dot(a, b):
    return a.real * b.real + a.imag * b.imag


def meet_lines(p, d, q, e):
    """Where p + s d meets q + t e."""
    return p + d * (cross(q - p, e) / cross(d, e))


def meet_line_circle(p, d, centre, radius):
    """Both points where p + s d meets a circle."""
    d = unit(d)
    foot = p + d * dot(centre - p, d)
    half = math.sqrt(radius * radius - abs(centre - foot) ** 2)
    return foot - d * half, foot + d * half


def meet_circles(c, r, e, s):
    """Both points where two circles meet: first the one to the left of the way from c to e."""
    d = abs(e - c)
    along = (d * d + r * r - s * s) / (2 * d)
    half = math.sqrt(r * r - along * along)
    u = (e - c) / d
    return c + u * complex(along, half), c + u * complex(along, -half)


def circle_through(p, q, r):
    """The centre of the circle through three points."""
    a, b = q - p, r - p
    return p + 1j * (a * abs(b) ** 2 - b * abs(a) ** 2) / (2 * cross(a, b))


def nearest(points, to):
    return min(points, key=lambda p: abs(p - to))


# ---------------------------------------------------------------- edges and outlines


class Edge:
    """A line, or an arc about `centre` (turn +1 counter-clockwise, -1 clockwise)."""

    def __init__(self, start, end, note="", centre=None, turn=0):
        self.start, self.end, self.note = complex(start), complex(end), note
        self.centre, self.turn = centre, turn

    def radius(self):
        return abs(self.start - self.centre)

    def direction(self, at):
        if self.turn == 0:
            return unit(self.end - self.start)
        return 1j * self.turn * unit(at - self.centre)

    def bulge(self):
        if self.turn == 0:
            return 0.0
        swept = self.turn * cmath.phase((self.end - self.centre) / (self.start - self.centre))
        if swept <= 0:
            swept += 2 * math.pi
        if abs(swept - math.pi) < 1e-13:
            return float(self.turn)  # a half circle; the tangent would be one digit off
        return self.turn * math.tan(swept / 4)

    def moved(self, turned, shift):
        centre = None if self.centre is None else self.centre * turned + shift
        return Edge(self.start * turned + shift, self.end * turned + shift, self.note, centre, self.turn)


def fillet(before, after, radius):
    """The arc of a radius tangent to two edges near the corner where they meet."""
    corner = before.end
    side = math.copysign(1, cross(before.direction(corner), after.direction(corner)))

    def locus(edge):  # of the centres: the edge's curve, moved by the radius into the corner
        if edge.turn == 0:
            d = edge.direction(corner)
            return "line", edge.start + 1j * d * side * radius, d
        return "circle", edge.centre, edge.radius() - edge.turn * side * radius

    def touch(edge, centre):
        if edge.turn == 0:
            d = edge.direction(corner)
            return edge.start + d * dot(centre - edge.start, d)
        return edge.centre + unit(centre - edge.centre) * edge.radius()

    a, b = locus(before), locus(after)
    if a[0] == b[0] == "line":
        centre = meet_lines(a[1], a[2], b[1], b[2])
    elif a[0] == "line":
        centre = nearest(meet_line_circle(a[1], a[2], b[1], b[2]), corner)
    elif b[0] == "line":
        centre = nearest(meet_line_circle(b[1], b[2], a[1], a[2]), corner)
    else:
        centre = nearest(meet_circles(a[1], a[2], b[1], b[2]), corner)
    return Edge(touch(before, centre), touch(after, centre), f"R{radius:g}", centre, int(side))


class Outline:
    """A closed outline under the pen. `round` and `chamfer` act on the corner where the pen is."""

    def __init__(self, start):
        self.start = self.at = complex(start)
        self.edges, self.corners = [], {}

    def line(self, to, note=""):
        self.edges.append(Edge(self.at, to, note))
        self.at = complex(to)
        return self

    def arc(self, centre, to, turn, note=""):
        self.edges.append(Edge(self.at, to, note, complex(centre), turn))
        self.at = complex(to)
        return self

    def bow(self, radius, to, note=""):
        """The lesser arc of a radius; a positive one is counter-clockwise."""
        turn = 1 if radius > 0 else -1
        centre = meet_circles(self.at, abs(radius), complex(to), abs(radius))[0 if turn > 0 else 1]
        return self.arc(centre, to, turn, note)

    def round(self, radius, note=""):
        self.corners[len(self.edges)] = (radius, note)
        return self

    def closed(self):
        """The edges, roundings put in. A rounding at the start may be asked for at either end of the chain."""
        edges, n = self.edges, len(self.edges)
        assert abs(self.at - self.start) < 1e-9, "the outline does not close"
        edges[-1].end = edges[0].start
        joins = {}
        for i, (radius, note) in self.corners.items():
            joins[i % n] = fillet(edges[i % n - 1], edges[i % n], radius)
            joins[i % n].note += f" {note}" if note else ""
        result = []
        for i, e in enumerate(edges):
            if i in joins:
                result.append(joins[i])
            start = joins[i].end if i in joins else e.start
            end = joins[(i + 1) % n].start if (i + 1) % n in joins else e.end
            trimmed = Edge(start, end, e.note, e.centre, e.turn)
            result.append(trimmed)
        return result


def circle(centre, radius, note=""):
    centre = complex(centre)
    a, b = centre + radius, centre - radius
    return [Edge(a, b, note, centre, 1), Edge(b, a, "", centre, 1)]


def moved(edges, turned=1, shift=0):
    return [e.moved(turned, shift) for e in edges]


def rounded_polygon(corners):
    """An outline of straight lines through (point, radius of the rounding or 0, note of the line that leaves it)."""
    pen = Outline(corners[0][0])
    for i, (_, radius, note) in enumerate(corners):
        if radius:
            pen.round(radius)
        pen.line(corners[(i + 1) % len(corners)][0], note)
    return pen.closed()


# ---------------------------------------------------------------- model files


class Model(Forces):
    def __init__(self, file, name, text):
        self.file, self.name, self.parts, self.pictures = file, name, [], []
        self.out = comment(text) + f'\nname = "{name}"\nunit = "mm"\n'

    def part(self, name, text, loops, motion=None, symmetry=None, keys=()):
        """`loops` is a list of (what it is, edges), `keys` are lines such as `mass = 0.3`."""
        self.parts.append((name, loops))
        self.out += "\n" + comment(text) + f'[[part]]\nname = "{name}"\n'
        if motion:
            self.out += f"motion = {motion}\n"
        if symmetry:
            self.out += f"symmetry = {symmetry}\n"
        for key in keys:
            self.out += f"{key}\n"
        self.out += "loops = [\n"
        for what, edges in loops:
            self.out += f"  [ # {what}\n"
            for e in edges:
                bulge = f", {number(e.bulge())}" if e.turn else ""
                note = f" # {e.note}" if e.note else ""
                self.out += f"    [{number(e.start.real)}, {number(e.start.imag)}{bulge}],{note}\n"
            self.out += "  ],\n"
        self.out += "]\n"
        return self

    def picture(self, placed, ghosts=()):
        """A picture of the parts in a configuration of each: {part: (turn in degrees, shift)}, at rest where not named.
        `ghosts` are outlines that are no parts of the model but help to understand it."""
        shown = [(name, [moved(edges, polar(1, turn), shift) for _, edges in loops])
                 for name, loops in self.parts for turn, shift in [placed.get(name, (0, 0))]]
        path = f"../../docs/paper/{Path(self.file).stem}.svg"
        self.pictures.append((path, svg(self.name, shown, ghosts)))
        return self

    def joint(self, kind, first, second, at, text=""):
        where = f"at = [{number(at.real)}, {number(at.imag)}]"
        self.out += "\n" + comment(text) + f'[[joint]]\ntype = "{kind}"\nparts = ["{first}", "{second}"]\n{where}\n'
        return self

    def pair(self, fixed, moving, text=""):
        self.out += "\n" + comment(text) + f'[[pair]]\nfixed = "{fixed}"\nmoving = "{moving}"\n'
        return self


# ---------------------------------------------------------------- writing and checking

NUMERAL = re.compile(r"-?\d+\.?\d*(?:e[-+]?\d+)?")


def same(a, b):
    """Equal, but for the last digits, in which mathematics libraries differ."""
    if a == b:
        return True
    if NUMERAL.sub("#", a) != NUMERAL.sub("#", b):
        return False
    return all(abs(float(x) - float(y)) < 1e-12 for x, y in zip(NUMERAL.findall(a), NUMERAL.findall(b)))


def write_or_check(makers, folder, arguments):
    """Writes the files that `makers` draw to a folder, or with `--check` compares them. The exit code."""
    check = "--check" in arguments
    names = [a for a in arguments if a != "--check"]
    known = {make.__name__: make for make in makers}
    unknown = [n for n in names if n not in known]
    if unknown:
        print(f"draw.py: no model {', '.join(unknown)}; there are {', '.join(known)}", file=sys.stderr)
        return 2
    bad = 0
    for name in names or known:
        model = known[name]()
        for file, text in [(model.file, model.out), *model.pictures]:
            path = folder / file
            if not check:
                path.write_text(text, encoding="utf-8", newline="\n")
            elif not path.exists():
                print(f"draw.py: {path.name} is missing; run draw.py", file=sys.stderr)
                bad += 1
            elif not same(path.read_text(encoding="utf-8"), text):
                print(f"draw.py: {path.name} differs from its drawing; run draw.py", file=sys.stderr)
                bad += 1
    return 1 if bad else 0
