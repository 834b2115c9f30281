"""A cam, a crank and the cam of a film advance, with what they move."""

import cmath
import math

from common import RECONSTRUCTION, rectangle, stadium
from drawing import Model, Outline, circle, dot, moved, polar, rounded_polygon, unit
from forces import GRAVITY, STEEL, number, placed as start


def cam():
    base, nose, rise = 20.0, 8.0, 24.0
    side = math.degrees(math.acos((base - nose) / rise))  # between the normals of the flanks and the cam's axis
    top = complex(0, rise)
    right, left = polar(1, 90 - side), polar(1, 90 + side)
    pen = Outline(base * right)
    pen.line(top + nose * right, "flank").arc(top, top + nose * left, 1, f"nose R{nose:g}").line(base * left, "flank")
    plate = pen.arc(0, pen.start, 1, f"base circle R{base:g}").closed()

    half, rim, stem, length = 25.0, 2.5, 5.0, 60.0
    pen = Outline(complex(rim - half, 0))
    pen.line(complex(half - rim, 0), "flat face").arc(complex(half - rim, rim), complex(half - rim, 2 * rim), 1, f"rim R{rim:g}")
    pen.line(complex(stem, 2 * rim), "head").round(2.0).line(complex(stem, length), "stem").round(1.0)
    pen.line(complex(-stem, length), "end").round(1.0).line(complex(-stem, 2 * rim), "stem").round(2.0)
    pen.line(complex(rim - half, 2 * rim), "head").arc(complex(rim - half, rim), pen.start, 1, f"rim R{rim:g}")
    follower = pen.closed()
    m = Model("cam.toml", "cam", f"""
Tangent cam and flat-faced mushroom follower. 4 + 12 = 16 features.

{RECONSTRUCTION}

The cam has a base circle R{base:g} and a nose R{nose:g}, {rise:g} from the axis; its flanks are straight and tangent to both, {side:g} deg
to either side of the nose. The follower's face is {2 * half - 2 * rim:g} across between half-round rims. Turned by u about the cam's
axis, the face stands at 8 + 24 cos u while it is on the nose, up to u = {side:g} deg, and at 20 on the base circle: the lift is 12.

The follower's origin is in the middle of its face: (x, y, theta) = (0, 32, 0) is the full lift.
""")
    m.show("Can the follower be taken off the cam?")
    m.world(gravity=(0, -GRAVITY), friction=0.05, restitution=0.2)
    m.part("cam", "Axis at the origin, nose to +y.", [("profile", plate)], keys=[
        "mass = 2 # with its shaft and flywheel", "inertia = 2000", "rate = [0, 0, 31.4]"])
    m.part("follower", "Stem to +y.", [("outline", follower)], keys=[STEEL, start(0, 32.1)])
    m.mounted("cam", [0j], 1e6, 800, text="The cam's bearing: the cam turns, five times a second, and lifts the follower by 12.")
    m.torque("cam", 1e5, "The motor.").brake("cam", 2000, "The motor's speed falls under load.")
    for y in (15, 50):  # stays so long that the follower goes up and down between them
        m.spring("follower", (complex(stem, y), complex(1000, y + 20)), 1e5, 1000 - stem, 10,
                 text="The guide of the stem: two stays from far away." if y == 15 else "")
    m.spring("follower", (complex(0, length), complex(0, length + 52)), 2000, 40, 5,
             text="The follower's spring, from the stem's end up; 40 long when free.")
    return m.picture({"follower": (0, 32j)})


def crank_slider():
    width, height = 20.0, 12.0
    play = 0.1
    bar = stadium(0j, 90 + 0j, 15.0, "edge")
    low, high, half = 25.0, 92.0, height / 2 + play
    slot = rounded_polygon([
        (complex(low, -half), 2.0, "slot"), (complex(high, -half), 2.0, "end"),
        (complex(high, half), 2.0, "slot"), (complex(low, half), 2.0, "end"),
    ])
    r, h = width / 2, height / 2
    die = rounded_polygon([
        (complex(-r, -h), 2.5, "bears on the slot"), (complex(r, -h), 2.5, "end"),
        (complex(r, h), 2.5, "bears on the slot"), (complex(-r, h), 2.5, "end"),
    ])
    m = Model("crank_slider.toml", "crank and slider", f"""
Slotted crank and the block that slides in it, of a quick-return motion. 14 + 10 = 24 features.

{RECONSTRUCTION}

The crank swings about the bore of 16. Its slot is {high - low:g} long and {2 * half:g} wide with corners R2; the block, {width:g} x {height:g} with corners R2.5,
slides in it with {play:g} of play a side and turns with the crank. The bore of the block, for the pin that drives it, stands 2 off
its middle, away from the side that bears.

The block's origin is in its middle: at ({low + r:g}, 0, 0) it is at the inner end of the slot, at ({high - r:g}, 0, 0) at the outer.
""")
    m.show("Can the slider leave the slot?")
    m.world(gravity=(0, -GRAVITY), friction=0.15)
    m.part("crank", "Axis at the origin, slot to +x.", [("outline", bar), ("slot", slot), ("bore", circle(0, 8.0))],
           keys=[STEEL, "rate = [0, 0, 6]"])
    m.part("slider", "", [("block", die), ("bore", circle(2j, 3.5))], keys=[STEEL, start(40, 0), "rate = [0, 240, 6]"])
    m.mounted("crank", [0j], 1e6, 500, text="The crank's bearing.")
    m.torque("crank", 6e5, "The motor turns the crank about once a second; the block slides down the slot each time it points down.")
    m.brake("crank", 1e5, "The motor's speed falls under load.")
    return m.picture({"slider": (0, 70)})


def film_advance():
    pull, r, play = 19.0, 3.0, 0.05
    breadth = pull + 2 * r
    corners = [polar(pull / math.sqrt(3), 90 + 120 * k) for k in range(3)]
    pen = None
    for k in range(3):
        here, after, before = corners[k], corners[(k + 1) % 3], corners[(k - 1) % 3]
        pen = pen or Outline(here + unit(here - after) * r)
        pen.arc(here, here + unit(here - before) * r, 1, f"corner {k + 1}, R{r:g}")
        pen.arc(before, after + unit(after - before) * r if k < 2 else pen.start, 1, f"side R{pull + r:g}")
    lobes = pen.closed()

    def reach(direction):
        """How far the cam, untouched, reaches from its middle in a direction."""
        for c in corners:  # either a corner stands out that way, or the side opposite to one does
            if abs(cmath.phase(direction / c)) <= math.radians(30) + 1e-9:
                return dot(c, direction) + r
        return breadth - reach(-direction)

    def placed(turn):
        """The cam's middle in the frame's window."""
        t = polar(1, -turn)
        return complex(*((reach(-d * t) - reach(d * t)) / 2 for d in (1, 1j)))

    w = breadth / 2 + play
    window = rounded_polygon([(complex(x, y), 1.0, "window") for x, y in ((-w, -w), (w, -w), (w, w), (-w, w))])
    edge, arm, claw, middle = 22.0, 16.0, 1.6, 17.5
    pen = Outline(complex(-edge, -edge))
    pen.round(3.0).line(complex(edge, -edge), "frame").round(3.0).line(complex(edge, edge - claw), "frame").round(2.0)
    pen.line(complex(edge + arm + claw, edge - claw), "claw, pulls the film")
    pen.arc(complex(edge + arm, edge - claw), complex(edge + arm, edge), 1, "claw, back")
    pen.line(complex(-edge, edge), "frame and arm").round(3.0).line(pen.start, "frame")
    loops = [("outline", pen.closed()), ("window", window)]
    for k in range(4):
        loops.append((f"guide slot {k + 1}", moved(stadium(complex(-6, middle), complex(6, middle), 1.5, "slot"), 1j**k)))
    for k in range(4):
        loops.append((f"screw hole {k + 1}", circle(complex(middle, middle) * 1j**k, 1.25)))
    for k, x in enumerate((25.0, 31.0)):
        loops.append((f"dowel hole {k + 1}", circle(complex(x, edge - claw / 2), 0.4)))
    m = Model("film_advance.toml", "film advance", f"""
Three-lobed cam of a film projector and the frame with the claw that it moves. 47 + 6 = 53 features; the cam's symmetry is 3.

{RECONSTRUCTION}

The cam has constant breadth: arcs R{pull + r:g} about the corners of a triangle of {pull:g}, its corners rounded R{r:g}, so that it is {breadth:g}
across in every direction and fills the window of {2 * w:g}. The shaft stands in one of the triangle's corners. The frame is kept
from turning by guide slots. While the shaft turns clockwise, it rests for 60 deg, is carried by {pull:g} within 120, rests for 60 and returns, to and
fro and, a quarter of a turn later, up and down: the claw enters a perforation, pulls 35 mm film by one picture, which is {pull:g},
withdraws, and goes back up.

The frame's origin is in the middle of the window, the cam's in the middle of the triangle. The cam's orientation in
the window settles its position, but for {play:g} to any side: ({placed(0).real:g}, {placed(0).imag:.6f}, 0) is one of them.
""")
    m.show("Can the cam leave the window of the frame?")
    shaft = corners[0] + placed(0)
    m.world(friction=0.1, restitution=0.2)
    m.part("frame", "Claw to +x.", loops, keys=[STEEL])
    m.part("cam", "A corner to +y.", [("three lobes", lobes)], symmetry=3, keys=[
        "mass = 1 # with its shaft and flywheel", "inertia = 500", f"center_of_mass = [0, {number(corners[0].imag)}]",
        start(placed(0).real, placed(0).imag), f"rate = [{number(-6 * corners[0].imag)}, 0, -6]"])
    m.spring("cam", (corners[0], shaft), 1e6, 0, 1000, text="The bearing of the shaft.")
    m.torque("cam", -12000, "The motor turns the cam once a second: it carries the frame around a square of 19.")
    m.brake("cam", 2000, "The motor's speed falls under load.")
    m.torsion(["frame"], 1e7, damping=10000, text="The guide slots keep the frame from turning.")
    turn, film, hole, apart = 75.0, edge + arm - 3.0, 1.98, 4.75
    webs = [rectangle(complex(film, low + hole), complex(film + 0.6, low + apart))
            for low in (edge - claw - 0.05 + apart * k for k in range(-4, 1))]
    return m.picture({"cam": (turn, placed(turn))}, webs)
