"""Wheels with teeth or slots: a ratchet, a Geneva drive and a chain gear, with what works on them."""

import cmath
import math

from common import RECONSTRUCTION
from drawing import (
    Model, Outline, circle, dot, meet_circles, meet_line_circle, moved, nearest, polar, unit,
)
from forces import STEEL, placed


def tangent_line(c, r, e, s):
    """Where the line that goes clockwise around two circles touches them."""
    along = unit(e - c)
    normal = along * cmath.exp(1j * math.acos((r - s) / abs(e - c)))
    return c + normal * r, e + normal * s


def ratchet_pawl():
    teeth, tip, root, undercut = 20, 50.0, 44.0, 8.0
    pitch = 360 / teeth

    def crest(k):
        return polar(tip, k * pitch)

    def foot(k):  # where the face, leaning back by the undercut, meets the root circle
        inward = -polar(1, k * pitch - undercut)
        return nearest(meet_line_circle(crest(k), inward, 0, root), crest(k))

    pen = Outline(foot(0))
    for k in range(teeth):
        pen.round(1.0, "root").line(crest(k), f"face of tooth {k + 1}").round(0.3, "tip")
        pen.line(foot(k + 1) if k + 1 < teeth else foot(0), "back")
    ratchet = pen.closed()

    # The pawl is laid out where it works, its nose 0.05 from the face of the tooth at the top.
    pivot, boss, back = 42 + 56j, 8.0, 75.0
    face = polar(1, 90 - undercut)  # up along the tooth's face
    nose = polar(tip, 90) - 0.05j * face - face * 5.0
    brow = nose + face * 7.0
    heel = nearest(meet_line_circle(nose, polar(1, 13.5), pivot, boss), nose)
    hump = meet_circles(brow, back, pivot, back - boss)[1]  # centre of the back: through the brow, around the boss
    crown = hump + unit(pivot - hump) * back
    end, knob = pivot + polar(24, -5), 4.5  # of the tail
    out, to = unit(crown - hump), crown - end
    bend = (abs(to) ** 2 - knob**2) / (2 * (dot(to, out) - knob))  # tangent to the back in the crown, and around the knob
    low = crown - out * bend
    under, below = tangent_line(end, knob, pivot, boss)
    pen = Outline(heel)
    pen.round(6.0, "boss to belly")
    pen.line(nose, "belly").round(1.2, "nose").line(brow, "face, bears on the tooth").round(1.5, "brow")
    pen.arc(hump, crown, -1, f"R{back:g} back")
    pen.arc(low, low + unit(end - low) * bend, -1, "tail").arc(end, under, -1, f"R{knob:g}").line(below, "tail")
    pen.arc(pivot, heel, -1, f"R{boss:g} boss")
    m = Model("ratchet_pawl.toml", "ratchet and pawl", f"""
Ratchet wheel and pawl. 80 + 16 = 96 features; the wheel's symmetry is {teeth}.

{RECONSTRUCTION}

The wheel, {2 * tip:g} across the tips before rounding, has {teeth} teeth: a face undercut by {undercut:g} deg, so that load draws the pawl in,
a straight back, R1 at the root and R0.3 at the tip. It turns counter-clockwise under the pawl, which rides over the backs of the teeth;
clockwise the face of a tooth meets the pawl's nose and locks. The pawl has a tail to lift it by, with a hole for its spring.

The pawl's frame has its origin in the pivot, which stands at (42, 56) from the wheel's axis: at (x, y, theta) = (42, 56, 0)
the pawl is engaged, 0.05 clear of the face of the tooth at the top.
""")
    m.show("Can the pawl be lifted off the ratchet?")
    m.world(restitution=0.3)
    m.part("ratchet", "Axis at the origin; tooth 1 has its tip on the x axis.", [(f"{teeth} teeth", ratchet)], symmetry=teeth,
           keys=["mass = 2 # with its drum", "inertia = 3000", "rate = [0, 0, 4]"])
    m.part("pawl", "Pivot at the origin; the nose points to -x.", [
        ("outline", moved(pen.closed(), 1, -pivot)), ("pivot hole", circle(0, 4.0)), ("spring hole", circle(end - pivot, 1.2)),
        ("lifting hole", circle((end - pivot) * 0.6, 1.5))], keys=[STEEL, placed(pivot.real, pivot.imag)])
    m.mounted("ratchet", [0j], 1e6, 1000, text="The bearings of wheel and pawl.").mounted("pawl", [0j], 1e6, 300, pivot)
    m.torque("ratchet", -20000, "The load: the wheel, set going against it, turns some teeth on, comes back, and the pawl catches it.")
    m.torque("pawl", 3000, "The spring lays the pawl on the wheel.")
    return m.picture({"pawl": (0, pivot)})


def geneva():
    crank, pin, play, disc = 40.0, 4.0, 0.1, 27.0
    distance, radius = crank * math.sqrt(2), crank  # of the shafts, and of the wheel: the pin enters along the slot
    half, bottom = pin + play, distance - crank - 0.5  # the slot's half width, and the centre of its round end
    lock = meet_circles(0, radius, distance, disc + play)  # where the locking arc to +x meets the rim
    rim = math.sqrt(radius**2 - half**2)
    pen = None
    for k in range(4):
        turned, middle = 1j**k, polar(1, 90 * k + 45)
        pen = pen or Outline(lock[1])
        pen.arc(distance * turned, lock[0] * turned, -1, f"locking arc {k + 1}").arc(0, complex(rim, -half) * middle, 1, "rim")
        pen.line(complex(bottom, -half) * middle, f"slot {k + 1}")
        pen.arc(bottom * middle, complex(bottom, half) * middle, -1, f"R{half:g}")
        pen.line(complex(rim, half) * middle, "slot").arc(0, lock[1] * turned * 1j if k < 3 else pen.start, 1, "rim")
    wheel = pen.closed()

    # The driver about its own axis, its pin to +x. The hollow for the wheel's horns is about the wheel's axis half way.
    hollow, relief, ease, lead = complex(distance), radius + 1.0, 9.0, 18.0
    horn = meet_circles(0, disc, hollow, relief)[0]
    eased = horn.conjugate() * polar(1, -ease)  # where the lead-in begins
    centre = eased * (1 - lead / disc)
    first = meet_circles(centre, lead, hollow, relief)[1]
    pen = Outline(horn).arc(0, eased, 1, f"locking disc R{disc:g}").arc(centre, first, 1, f"lead-in R{lead:g}")
    body = pen.arc(hollow, horn, -1, f"hollow R{relief:g}").closed()
    shaft, key, deep = 8.0, 2.5, 10.8
    edge = complex(key, math.sqrt(shaft**2 - key**2))
    pen = Outline(edge).line(complex(key, deep), "keyway").line(complex(-key, deep), "keyway")
    bore = pen.line(-edge.conjugate(), "keyway").arc(0, edge, 1, f"bore R{shaft:g}").closed()
    holes = [(f"screw hole {k + 1}", circle(polar(14, 60 + 120 * k), 1.7)) for k in range(3)]
    m = Model("geneva.toml", "Geneva drive", f"""
Geneva wheel of four slots and its driver. 40 + 21 = 61 features; the wheel's symmetry is 4.

{RECONSTRUCTION}

The shafts are {distance:.3f} apart; the crank and the wheel's radius are {crank:g}, so that the pin enters and leaves along the slots. The
pin, of diameter {2 * pin:g}, has {play:g} of play a side; the locking disc R{disc:g} has as much in the wheel's locking arcs. While the pin is in a
slot and drives the wheel by 90 deg, the wheel's horns pass through the hollow of the disc, R{relief:g}. The horn of the disc that comes
first when the driver turns counter-clockwise is eased by an arc R{lead:g}, so that it finds its way into the locking arc. The arm
that carries the pin is screwed on below; it is not in the plane of the wheel, so that disc and pin stand apart.

Each part has its origin in its axis. Wheel turned by w, driver by d: (x, y) is ({distance:.3f}, 0) turned by -w, theta = d - w. With
w = 0 and d = 0 the disc holds a locking arc and the pin is on the far side.
""")
    m.show("Can the driver be taken off the wheel?")
    m.world(friction=0.1, restitution=0.2)
    m.part("wheel", "Slots at 45 deg to the axes.", [("four slots, four locking arcs", wheel)], symmetry=4, keys=[STEEL])
    m.part("driver", "Pin to +x.", [
        ("locking disc", body), (f"pin, diameter {2 * pin:g}", circle(crank, pin)), ("bore with keyway", bore), *holes], keys=[
            "mass = 1 # with its shaft and flywheel", "inertia = 2000", "center_of_mass = [0, 0]", placed(distance, 0), "rate = [0, 0, 6.28]"])
    m.mounted("wheel", [0j], 3e6, 2000, text="The bearings.").mounted("driver", [0j], 3e6, 2000, distance)
    m.torque("driver", 62800, "The motor turns the driver once a second, and the driver steps the wheel by 90 deg a turn.")
    m.brake("driver", 10000, "The motor's speed falls under load.")
    d = math.radians(-30)  # the pin's way to go until it is half way
    w = -math.degrees(math.atan2(crank * math.sin(d), distance - crank * math.cos(d))) - 45
    return m.picture({"wheel": (w, 0), "driver": (180 + math.degrees(d), distance)})


def chain_gear():
    teeth, pitch, roller = 14, 12.7, 7.92
    circle_of_pitch = pitch / 2 / math.sin(math.pi / teeth)
    seat = 0.5025 * roller + 0.04
    # One gap, at the top. Its seat is tangent to convex flanks about points on the lines to the neighbouring rollers.
    centre = 1j * circle_of_pitch
    pole = centre - polar(1.4 * roller, 180 / teeth)
    flank = abs(pole - centre) - seat
    foot = pole + unit(centre - pole) * flank
    tip = max(meet_line_circle(0, 1j * polar(1, 180 / teeth), pole, flank), key=abs)  # on the axis of the tooth on the left

    def mirrored(p):
        return -p.conjugate()

    pen = None
    for k in range(teeth):
        turned = polar(1, -90 + 360 * (k + 0.5) / teeth)
        pen = pen or Outline(mirrored(tip) * turned)
        pen.arc(mirrored(pole) * turned, mirrored(foot) * turned, 1, f"tooth {k + 1}, flank")
        pen.arc(centre * turned, foot * turned, -1, f"seat R{seat:.2f}")
        pen.arc(pole * turned, tip * turned if k < teeth - 1 else pen.start, 1, "flank")
    loops = [(f"{teeth} teeth", pen.closed())]
    for ring, (radius, between) in enumerate(((20.6, 0.5), (16.3, 0.0), (12.3, 0.5))):
        for k in range(teeth):
            loops.append((f"hole {k + 1} of ring {ring + 1}", circle(polar(radius, 360 * (k + between) / teeth), 1.8)))
    loops.append(("bore", circle(0, 8.0)))
    link = []
    for side, name in ((-1, "first"), (1, "second")):
        for what, r in (("roller", roller / 2), ("its bore", 2.65), ("bush", 2.6), ("its bore", 2.05), ("pin", 2.0), ("its bore", 1.2)):
            link.append((f"{name} joint, {what}", circle(side * pitch / 2, r)))
    m = Model("chain_gear.toml", "chain gear", f"""
Chain wheel of {teeth} teeth and a link of its roller chain. 142 + 24 = 166 features; the wheel's symmetry is {teeth}.

{RECONSTRUCTION}

The pitch is {pitch:g}, the rollers are {roller:g} across. The wheel's pitch circle is {2 * circle_of_pitch:.3f}; the seats are R{seat:.2f}, tangent to convex
flanks that meet in the tip of the tooth. The disc is lightened by three rings of {teeth} holes.

The link is cut in the middle of the rollers: two hollow pins, bushes and rollers, {pitch:g} apart. The plates lie before and behind
the wheel. The link's origin is half way between the pins, which are on its x axis: at ({circle_of_pitch * math.cos(math.pi / teeth):.6f}, 0) turned by a right
angle it is seated in two gaps.
""")
    m.show("Can the link be lifted off the wheel?")
    seat_at = circle_of_pitch * math.cos(math.pi / teeth)
    m.world(friction=0.1, restitution=0.2)
    m.part("wheel", "Axis at the origin; a tooth points to +x.", loops, symmetry=teeth, keys=[STEEL])
    m.part("link", "", link, keys=[STEEL, placed(seat_at + 9, 2, 80)])
    m.mounted("wheel", [0j], 1e6, 500, text="The wheel's bearing.")
    m.torsion(["wheel"], 1e5, damping=1000, text="What the wheel drives.")
    for side in (-1, 1):  # the next pins of the chain lie one tooth on
        strand = polar(1, side * (90 + 360 / teeth))
        m.spring("link", (complex(side * pitch / 2), complex(seat_at, side * pitch / 2) + strand * 30), 20, 10, 0.5,
                 text="The strands of the chain pull the link, laid on askew, into its two gaps." if side < 0 else "")
    return m.picture({"link": (90, circle_of_pitch * math.cos(math.pi / teeth))})
