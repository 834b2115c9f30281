#!/usr/bin/env python3
"""Draws the model files of this folder.

    python3 models/draw.py            write every model file
    python3 models/draw.py NAME ...   write these only (gears, ...)
    python3 models/draw.py --check    write nothing; fail if a file differs from its drawing

How outlines are made is told in drawing.py: lengths in mm, angles in degrees, points are complex numbers.
"""

import cmath
import math
import sys
from pathlib import Path

from drawing import (
    Model, Outline, circle, circle_through, meet_circles, meet_line_circle, meet_lines, moved, nearest, number,
    polar, rounded_polygon, unit, write_or_check,
)
from forces import GRAVITY, PLASTIC, STEEL, placed

# ---------------------------------------------------------------- the models


TEETH, TIP = 20, 50.0  # of the ratchet
PAWL_PIVOT = 42 + 56j  # where it works


def ratchet_and_pawl():
    """Outlines of the wheel, its axis at the origin, and of the pawl, engaged with the tooth at the top."""
    teeth, tip, root, undercut, back = TEETH, TIP, 44.0, 8.0, 40.0
    pitch = 360 / teeth

    def crest(k):
        return polar(tip, k * pitch)

    def foot(k):  # where the face, leaning back by the undercut, meets the root circle
        inward = -polar(1, k * pitch - undercut)
        return nearest(meet_line_circle(crest(k), inward, 0, root), crest(k))

    pen = Outline(foot(0))
    for k in range(teeth):
        pen.round(1.0, "root")
        pen.line(crest(k), f"face of tooth {k + 1}").round(0.3, "tip")
        pen.bow(back, foot(k + 1) if k + 1 < teeth else foot(0), "back")
    ratchet = pen.closed()

    # The pawl is laid out where it works, its nose 0.05 from the face of the tooth at the top.
    pivot, boss, top = PAWL_PIVOT, 8.0, 75.0
    face = polar(1, 90 - undercut)  # up along the tooth's face
    gap = 0.05 * (-1j * face)
    nose = polar(tip, 90) + gap - face * 5.0
    brow = nose + face * 7.0
    under = polar(1, 13.5)
    heel = nearest(meet_line_circle(nose, under, pivot, boss), nose)
    hump = meet_circles(brow, top, pivot, top - boss)[1]  # centre of the back: through the brow, tangent to the boss
    crown = hump + unit(pivot - hump) * top
    pen = Outline(heel)
    pen.round(6.0, "boss to belly")
    pen.line(nose, "belly").round(1.2, "nose").line(brow, "face, bears on the tooth").round(1.5, "brow")
    pen.arc(hump, crown, -1, f"R{top:g} back").arc(pivot, heel, -1, f"R{boss:g} boss")
    return ratchet, pen.closed()


def ratchet_mechanism(spring="1e6", brake="1e8"):
    ratchet, pawl = ratchet_and_pawl()
    shaft, throw, disc, play = -100j, 19.5, 26.0, 0.1
    fork = disc + play  # half the fork's width
    stroke = 2 * math.degrees(math.asin(throw / abs(shaft)))

    hub, eye, prong, floor, end = 15.0, 9.0, 12.0, -52.0, -129.0

    def tangent(c, r, e, s):
        """Where the line that leaves a circle on its right and comes to another on its right touches the two."""
        along = unit(e - c)
        normal = along * cmath.exp(-1j * math.acos((r - s) / abs(e - c)))
        return c + normal * r, e + normal * s

    up = tangent(0, hub, PAWL_PIVOT, eye)
    down = tangent(PAWL_PIVOT, eye, 0, hub)
    pen = Outline(complex(-hub, 0))
    pen.line(complex(-hub, -38), "arm").round(8.0).line(complex(-fork - prong, -46), "shoulder").round(8.0)
    pen.line(complex(-fork - prong, end), "prong").round(4.0).line(complex(-fork, end), "end").round(3.0)
    pen.line(complex(-fork, floor), "fork, bears on the eccentric").round(8.0).line(complex(fork, floor), "floor").round(8.0)
    pen.line(complex(fork, end), "fork, bears on the eccentric").round(3.0).line(complex(fork + prong, end), "end").round(4.0)
    pen.line(complex(fork + prong, -46), "prong").round(8.0).line(complex(hub, -38), "shoulder").round(8.0)
    pen.line(meet_lines(hub, 1j, up[0], up[1] - up[0]), "arm").round(12.0)
    pen.line(up[1], "arm to the pawl").arc(PAWL_PIVOT, down[0], 1, f"eye R{eye:g}").line(down[1], "arm to the pawl")
    link = pen.arc(0, pen.start, 1, f"hub R{hub:g}").closed()

    driver = circle(shaft - 1j * throw, disc, f"eccentric, thrown by {throw:g}")
    frame = rounded_polygon([
        (-20 + 20j, 12.0, "post"), (-20 - 75j, 10.0, "post"), (-45 - 135j, 0, "foot"), (-60 - 135j, 3.0, "foot"),
        (-60 - 150j, 0, "base"), (60 - 150j, 0, "foot"), (60 - 135j, 3.0, "foot"), (45 - 135j, 0, "post"),
        (20 - 75j, 10.0, "post"), (20 + 20j, 12.0, "head"),
    ])

    m = Model(
        "ratchet_mechanism.toml",
        "ratchet mechanism",
        f"""
A shaft that turns for ever feeds a ratchet wheel on, tooth by tooth: five parts, six pairs, three classes of them.

The driver is an eccentric of {2 * disc:g}, thrown by {throw:g}. It runs in the fork of the link, {play:g} clear on either side, and rocks
it by {stroke:.1f} deg in all: the fork's sides are parallel to the line to the link's pivot, so that the link follows the
direction of the eccentric's centre. The link has its pivot on the wheel's axis and carries the pawl. On the way
counter-clockwise the pawl bears on the face of a tooth and takes the wheel along; on the way back it rides over a tooth
and drops behind the next, one pitch of {360 / TEETH:g} deg on: {stroke - 360 / TEETH:.1f} deg of the stroke are to spare. What keeps the wheel
from turning back, a brake or a second pawl, is not drawn.

Wheel and pawl are those of ratchet_pawl.toml, here drawn where they work: at zero motion the eccentric points down, the link
is in the middle of its stroke, and the pawl is engaged, 0.05 clear of the face of the tooth at the top. From the back to the
front, frame, driver and link, and wheel and pawl lie in layers of their own; pins and bores are not drawn, the joints stand
for them.
""",
    )
    m.show("Can the pawl be lifted off the ratchet?", ("ratchet", "pawl"))
    m.part("frame", "Stands still.", [("post and foot", frame)], '{ type = "fixed" }')
    m.part("driver", "On the frame's lower bearing.", [(f"eccentric, diameter {2 * disc:g}", driver)],
           '{ type = "revolute", center = [0, -100] }')
    m.part("link", "On the wheel's axis; fork below, eye for the pawl above. There is no room for more than 20 deg either way.",
           [("outline", link)], '{ type = "revolute", center = [0, 0], range = ["-20deg", "20deg"] }')
    m.part("pawl", "On the link; the nose points to -x.", [("outline", pawl)])
    m.part("ratchet", "Axis at the origin; tooth 1 has its tip on the x axis.", [("20 teeth", ratchet)],
           '{ type = "revolute", center = [0, 0] }', TEETH)
    m.joint("revolute", "frame", "driver", shaft)
    m.joint("revolute", "frame", "link", 0j)
    m.joint("revolute", "frame", "ratchet", 0j)
    m.joint("revolute", "link", "pawl", PAWL_PIVOT)
    m.pair("frame", "driver", "Lower pairs.").pair("frame", "link").pair("frame", "ratchet").pair("link", "pawl")
    m.pair("driver", "link", "Fixed axes: u is the driver's turn, v the link's.")
    m.pair("ratchet", "pawl", "Symmetric, 20-fold.")
    m.drive("driver", "360deg", "What moves it: the driver turns, a spring lays the pawl on the wheel, a brake holds the wheel.")
    m.torque("pawl", spring).brake("ratchet", brake)
    return m


def gear_outline(teeth, module, pressure, dedendum, thinning, fillet_radius, first):
    """A spur gear whose flanks are arcs through three points of the involute: at the base circle, half way, at the tip.
    The middle of the first tooth is at the angle `first`."""
    pitch, tip = module * teeth / 2, module * (teeth / 2 + 1)
    root = pitch - dedendum * module
    base = pitch * math.cos(math.radians(pressure))

    def involute(radius):
        angle = math.acos(base / radius)
        return math.tan(angle) - angle

    def half_tooth(radius):  # the angle from the tooth's middle to its flank
        half = math.pi / (2 * teeth) - thinning / (2 * pitch) + involute(pitch) - involute(radius)
        return math.degrees(half)

    radii = [base, (base + tip) / 2, tip]
    low, mid, high = (polar(r, -half_tooth(r)) for r in radii)
    centre = circle_through(low, mid, high)
    foot = nearest(meet_circles(centre, abs(low - centre), 0, root), low)
    pen = None
    for k in range(teeth):
        turned = polar(1, first + 360 * k / teeth)
        right, left = foot * turned, foot.conjugate() * turned
        if pen is None:
            pen = Outline(right)
        else:
            pen.arc(0, right, 1, "root")
        pen.round(fillet_radius)
        pen.arc(centre * turned, high * turned, 1, f"tooth {k + 1}, flank")
        pen.arc(0, high.conjugate() * turned, 1, "tip")
        pen.arc(centre.conjugate() * turned, left, 1, "flank").round(fillet_radius)
    pen.arc(0, pen.start, 1, "root")
    return pen.closed()


GEARS = """
The gears have 12 and 10 teeth of module 4, pressure angle 25 deg, addendum 1 and dedendum 1.25 modules, root fillets R1.
Each flank is one arc, through three points of the involute (base circle, half way, tip), some hundredths off it between
them. Each tooth is thinned by 0.1 at the pitch circle; with what the arcs give way the backlash is from 0.23 to 0.30.

  gear     12 teeth   pitch circle 48   tip circle 56   root circle 38   a tooth points to +x
  pinion   10 teeth   pitch circle 40   tip circle 48   root circle 30   a space points to -x
"""


def gears():
    m = Model("gears.toml", "gears", "A gear and a pinion, free of each other.\n" + GEARS + """
Each is drawn about its own axis. At the centre distance of 44, (x, y, theta) = (44, 0, 0), a tooth of the gear stands in the
middle of a space of the pinion.
""")
    m.show("Can the gears be pulled apart?")
    m.world(friction=0.1, restitution=0.3)
    m.part("gear", "", [("12 teeth", gear_outline(12, 4.0, 25, 1.25, 0.1, 1.0, 0))], symmetry=12, keys=[STEEL])
    m.part("pinion", "", [("10 teeth", gear_outline(10, 4.0, 25, 1.25, 0.1, 1.0, 18))], symmetry=10, keys=[STEEL, placed(44, 0)])
    m.mounted("gear", [0j], 1e5, 100, text="The bearings, 44 apart, give way: both gears move a little aside.")
    m.mounted("pinion", [0j], 1e5, 100, 44)
    m.torque("gear", 1200, "Set going from rest: the teeth meet, bounce in their backlash, and take each other along.")
    m.brake("pinion", 100, "What is driven: its resistance grows with the speed.")
    return m


def gears_on_shafts():
    m = Model("gears_on_shafts.toml", "gears on shafts", "A gear and a pinion, each turning on its shaft.\n" + GEARS + """
Both are drawn where they work, the shafts 44 apart. The pinion turns by -12/10 of what the gear turns.
""")
    m.show("Do the gears turn, and with how much play?")
    m.part("gear", "", [("12 teeth", gear_outline(12, 4.0, 25, 1.25, 0.1, 1.0, 0))],
           '{ type = "revolute", center = [0, 0] }', 12)
    pinion = moved(gear_outline(10, 4.0, 25, 1.25, 0.1, 1.0, 18), 1, 44)
    m.part("pinion", "", [("10 teeth", pinion)], '{ type = "revolute", center = [44, 0] }', 10)
    m.drive("gear", "360deg")
    return m


def rack_pinion():
    teeth, module, pressure, dedendum, thinning = 12, 4.0, 25, 1.25, 0.1
    count, travel = 16, 70.0
    pitch, line = math.pi * module, -module * teeth / 2  # the rack's pitch line
    lean = math.tan(math.radians(pressure))
    half = pitch / 4 - thinning / 2  # half a tooth of the rack at the pitch line
    tip, root = line + module, line - dedendum * module
    pen = Outline(complex(-(count + 1) * pitch / 2, root))
    pen.line(complex(pen.start.real, root - 12), "end").round(1.0).line(complex(-pen.start.real, root - 12), "back").round(1.0)
    pen.line(complex(-pen.start.real, root), "end").round(1.0)
    for k in reversed(range(count)):
        middle = (k + 0.5 - count / 2) * pitch
        wide, narrow = half + dedendum * module * lean, half - module * lean
        pen.line(complex(middle + wide, root), "root").round(1.0)
        pen.line(complex(middle + narrow, tip), f"tooth {k + 1}, flank").round(0.4).line(complex(middle - narrow, tip), "tip")
        pen.round(0.4).line(complex(middle - wide, root), "flank").round(1.0)
    rack = pen.line(pen.start, "root").round(1.0).closed()
    m = Model("rack_pinion.toml", "rack and pinion", f"""
A pinion that turns on its shaft and a rack that slides below it.

Module 4, pressure angle 25 deg, dedendum 1.25 modules. The pinion has 12 teeth and is the gear of gears.toml,
turned: each flank one arc, through three points of the involute. The rack has {count} teeth with straight flanks, tips broken by
R0.4. Each tooth of either is thinned by 0.1 at the pitch line. The rack travels {travel:g} to either side, and the pinion always
has a tooth in it: turned by u, it pushes the rack by 24 u.

Both are drawn where they work, the rack in the middle of its travel: a tooth of the pinion points down into a gap of the rack.
""")
    m.show("How far does the pinion drive the rack?")
    m.part("pinion", "Axis at the origin.", [("12 teeth", gear_outline(teeth, module, pressure, dedendum, thinning, 1.0, -90))],
           '{ type = "revolute", center = [0, 0] }', teeth)
    m.part("rack", "", [(f"{count} teeth", rack)],
           f'{{ type = "prismatic", direction = [1, 0], range = [-{travel:g}, {travel:g}] }}')
    m.table("pinion", [(0, 0), (1, 2.5), (3, -2.5), (4, 0)], "To and fro.")
    return m


def cam_profile():
    base, top, shoulder, flank = 22.0, 34.0, 8.0, 60.0
    rise, fall = polar(top - shoulder, 75), polar(top - shoulder, 105)  # the shoulders' centres
    side = meet_circles(0, flank - base, rise, flank - shoulder)[0]
    leave, arrive = unit(-side) * base, rise + unit(rise - side) * shoulder
    across = unit(fall) * cmath.exp(1j * math.acos((base - shoulder) / abs(fall)))  # normal of the straight flank
    pen = Outline(leave)
    pen.arc(side, arrive, 1, f"rise flank R{flank:g}").arc(rise, polar(top, 75), 1, f"shoulder R{shoulder:g}")
    pen.arc(0, polar(top, 105), 1, f"dwell R{top:g}, 30 deg").arc(fall, fall + across * shoulder, 1, f"shoulder R{shoulder:g}")
    pen.line(across * base, "fall flank, straight").arc(0, leave, 1, f"base circle R{base:g}")
    return pen.closed()


def cam_follower():
    cam = cam_profile()
    crown, half, stem = 80.0, 18.0, 6.0
    edge = crown - math.sqrt(crown**2 - half**2)  # how far the face has risen at the head's rim
    pen = Outline(complex(-half, edge))
    pen.round(1.5).arc(complex(0, crown), complex(half, edge), 1, f"face, crowned R{crown:g}").round(1.5)
    pen.line(half + 7j, "rim").round(1.0).line(stem + 9j, "head, coned").round(3.0).line(stem + 54j, "stem")
    pen.line(stem - 1 + 55j, "chamfer 1 x 45 deg").line(-stem + 1 + 55j, "stem end").line(-stem + 54j, "chamfer")
    pen.line(-stem + 9j, "stem").round(3.0).line(-half + 7j, "head, coned").round(1.0).line(pen.start, "rim")
    m = Model("cam_follower.toml", "cam and follower", """
Plate cam and mushroom tappet of a valve gear.

The cam is made of arcs and one line, all joints tangent: base circle R22, a rise flank R60, a dwell of 30 deg at R34 (lift 12)
between two shoulders R8, and a straight fall flank. The tappet's face is crowned R80 against edge bearing, its head is 36
across, its stem 12.

The cam has its axis at the origin and its dwell on top; the tappet has its origin where its axis meets the face, its stem
up. At (x, y, theta) = (0, 34, 0) the tappet stands on the dwell; turned and shifted it may go anywhere about the cam.
""")
    m.show("Can the follower be taken off the cam?")
    m.world(gravity=(0, -GRAVITY), friction=0.05, restitution=0.2)
    m.part("cam", "Axis at the origin, dwell to +y.", [("profile", cam)], keys=[
        "mass = 2 # with its shaft and flywheel", "inertia = 2000", "rate = [0, 0, 31.4]"])
    m.part("follower", "Origin in the middle of the face, stem to +y.", [("outline", pen.closed())], keys=[STEEL, placed(0, 34.1)])
    m.mounted("cam", [0j], 1e6, 800, text="The cam's bearing: the cam turns, five times a second, and lifts the follower by 12.")
    m.torque("cam", 1e5, "The motor.").brake("cam", 2000, "The motor's speed falls under load.")
    for y in (15, 45):  # stays so long that the follower goes up and down between them
        m.spring("follower", (complex(stem, y), complex(1000, y + 22)), 1e5, 1000 - stem, 10,
                 text="The guide of the stem: two stays from far away." if y == 15 else "")
    m.spring("follower", (55j, 109j), 2000, 40, 5, text="The valve's spring, from the stem's end up; 40 long when free.")
    return m


def cam_tappet():
    face, half, stem, low, high = 34.1, 25.0, 6.0, -13.0, 6.0
    tappet = rounded_polygon([
        (complex(-half, face), 1.0, "flat face"), (complex(half, face), 1.0, "rim"), (complex(half, face + 6), 1.0, "head"),
        (complex(stem, face + 8), 3.0, "stem"), (complex(stem, face + 60), 1.0, "end"), (complex(-stem, face + 60), 1.0, "stem"),
        (complex(-stem, face + 8), 3.0, "head"), (complex(-half, face + 6), 1.0, "rim"),
    ])
    m = Model("cam_tappet.toml", "cam and flat tappet", f"""
Plate cam on its shaft and a flat tappet in its guide.

The cam is that of cam_follower.toml: base circle R22, dwell R34, lift 12; its straight flank comes to lie on the tappet's face
all at once. The face is {2 * half:g} across, wide enough for the contact never to leave it.

Drawn with the cam's dwell on top and the tappet 0.1 above it. The tappet can drop by {-low:g}, which is 0.9 more than it ever does:
the cam stops it first.
""")
    m.show("How do cam and tappet move?")
    m.part("cam", "Axis at the origin, dwell to +y.", [("profile", cam_profile())], '{ type = "revolute", center = [0, 0] }')
    m.part("tappet", "Stem to +y.", [("outline", tappet)],
           f'{{ type = "prismatic", direction = [0, 1], range = [{low:g}, {high:g}] }}')
    m.drive("cam", "360deg", "The cam turns, a spring lays the tappet on it.").force("tappet", (0, "-1e6"))
    return m


def cam_plate():
    pin, play, lift, start, end = 6.0, 0.1, 20.0, 30.0, 55.0
    length, bend, half = start + end, 14.0, pin + play
    middle = [0j, complex(start), complex(end, lift), complex(length, lift)]
    slope = unit(middle[2] - middle[1])
    aside = 1j * half

    def corner(i, shift):  # where the lines at one side of the slot's middle meet
        return meet_lines(middle[i] + shift, 1, middle[1] + shift * slope, slope)

    pen = Outline(-aside)
    pen.line(corner(1, -aside), "dwell").round(bend + half).line(corner(2, -aside), "rise").round(bend - half)
    pen.line(middle[3] - aside, "dwell").arc(middle[3], middle[3] + aside, 1, f"end R{half:g}")
    pen.line(corner(2, aside), "dwell").round(bend + half).line(corner(1, aside), "rise").round(bend - half)
    slot = pen.line(aside, "dwell").arc(0, pen.start, 1, f"end R{half:g}").closed()
    plate = rounded_polygon([
        (-22 - 20j, 4.0, "edge"), (complex(length + 22, -20), 4.0, "edge"), (complex(length + 22, lift + 20), 4.0, "edge"),
        (complex(-22, lift + 20), 4.0, "edge"),
    ])
    m = Model("cam_plate.toml", "cam plate and pin", f"""
Cam plate of a lifting gear and the pin it moves, both in straight guides at right angles.

The plate slides to the left and its slot, {2 * half:g} wide, lifts the pin of {2 * pin:g} by {lift:g}: a dwell, a rise of
{math.degrees(cmath.phase(slope)):.1f} deg and another dwell, with bends of R{bend:g} in the middle. The slot's round ends stop the plate.

Drawn with the plate as far right as it works and the pin in the middle of the slot's left end.
""")
    m.show("How far does the plate lift the pin?")
    m.part("plate", "Slides to -x.", [("outline", plate), ("slot", slot)],
           f'{{ type = "prismatic", direction = [-1, 0], range = [-5, {length + 5:g}] }}')
    m.part("pin", "Slides to +y, with the rod that is to be lifted.", [(f"diameter {2 * pin:g}", circle(0, pin))],
           f'{{ type = "prismatic", direction = [0, 1], range = [-5, {lift + 5:g}] }}')
    m.table("plate", [(0, 0), (0.75, length - 5), (1.5, 0), (2.25, length - 5), (3, 0)], "To and fro: the slot lifts the pin and lets it down.")
    m.force("pin", (0, -50000), f"The weight of 5 kg on the rod: the pin rides on the slot's lower side, {play:g} below its middle.")
    return m


ESCAPE = 30  # teeth
ANCHOR_PIVOT = 50j * math.sqrt(2)  # the tangents from there touch the wheel where the pallets are, 90 deg apart
LOCK, LIFT, SWING, DROP = 1.0, 3.0, 6.0, 1.0  # of the anchor, degrees; the drop is the wheel's


def wheel_and_anchor():
    """Outlines of the escape wheel, its axis at the origin, and of the anchor in the middle of its swing."""
    teeth, tip, root, land, drop = ESCAPE, 50.0, 40.0, 0.8, DROP
    lock, lift, pivot = LOCK, LIFT, ANCHOR_PIVOT
    pitch = 360 / teeth
    half = tip * math.radians(pitch / 2 - drop) / 2  # half a pallet's thickness, along the way of the teeth
    outer, inner = tip + half, tip - half
    release, catch = (lock + lift) / 2, (lock - lift) / 2  # how deep the pallets' corners reach in the middle of the swing

    # The wheel runs clockwise; its teeth lean forward, so that nothing but their tips comes to the pallets.
    pen = None
    for k in range(teeth):
        lead = 4.2 + pitch * k  # the angle of the leading corner of a tip: of one just before the entry pallet's impulse face
        pen = pen or Outline(polar(root, lead + 2.8))
        pen.round(0.8).line(polar(tip, lead), f"tooth {k + 1}, front").round(0.15)
        pen.arc(0, polar(tip, lead + land), 1, "tip").line(polar(root, lead + 6.5), "back").round(0.8)
        pen.arc(0, polar(root, lead + pitch + 2.8) if k + 1 < teeth else pen.start, 1, "root")
    wheel = pen.closed()

    def at(radius, angle):  # about the anchor's pivot
        return pivot + polar(radius, angle)

    pen = Outline(at(9, 90))
    pen.line(at(outer, 205), "arm").round(2.0)
    pen.arc(pivot, at(outer, 225 + catch), 1, "entry pallet, locks the teeth").round(0.15)
    pen.line(at(inner, 225 + release), "impulse face").round(0.15)
    pen.arc(pivot, at(inner, 212), -1, "entry pallet, inside").round(3.0)
    pen.line(at(9, 270), "arm").round(10.0).line(at(inner, 328), "arm").round(3.0)
    pen.arc(pivot, at(inner, 315 - catch), -1, "exit pallet, locks the teeth").round(0.15)
    pen.line(at(outer, 315 - release), "impulse face").round(0.15)
    pen.arc(pivot, at(outer, 335), 1, "exit pallet, outside").round(2.0)
    return wheel, pen.line(pen.start, "arm").round(6.0).closed()


def escapement():
    wheel, anchor = wheel_and_anchor()
    teeth, pivot, pitch = ESCAPE, ANCHOR_PIVOT, 360 / ESCAPE
    lock, lift, swing, drop = LOCK, LIFT, SWING, DROP
    m = Model("escapement.toml", "dead-beat escapement", f"""
Dead-beat escapement of a pendulum clock, after Graham: escape wheel and anchor.

The wheel of {teeth} teeth, 100 across, runs clockwise. The anchor spans 7 1/2 of them; its pivot is where the tangents of the wheel at
the pallets meet, so that a tooth moves along the pallets' radius. A tooth rests on an arc about the anchor's pivot, and
while the anchor swings on the wheel stands still; then it slides over the impulse face and drives the anchor by {lift:g} deg, drops by
{drop:g} deg of the wheel, and another is caught on the other side, {lock:g} deg from the corner. For each swing to and fro the wheel turns
by one tooth, {pitch:g} deg. Pallets and teeth have corners of R0.15.

Both are drawn where they work, the anchor in the middle of its swing and a tooth about to drive it; {swing:g} deg to either side
are possible.
""")
    m.show("Does the anchor let the wheel turn?")
    m.part("wheel", "Axis at the origin.", [(f"{teeth} teeth", wheel)], '{ type = "revolute", center = [0, 0] }', teeth)
    m.part("anchor", "Entry pallet on the left.", [("outline", anchor)],
           f'{{ type = "revolute", center = [0, {number(pivot.imag)}], range = ["-{swing:g}deg", "{swing:g}deg"] }}')
    swings = [(0, '"0deg"')] + [(0.25 + 0.5 * k, f'"{4 * (-1) ** k}deg"') for k in range(20)]
    m.table("anchor", swings, "A weight drives the wheel; the anchor swings once a second, as its pendulum lets it, for ten seconds.")
    m.torque("wheel", "-1e7")
    return m


def fixture_plate():
    land, flat = 1.2, 3.4  # half the land and half the breadth of the diamond pin
    r = 4.0
    high = math.sqrt(r * r - land * land)
    pen = Outline(complex(land, high))
    pen.arc(0, complex(-land, high), 1, "land").line(-flat, "relief").round(0.5).line(complex(-land, -high), "relief")
    pen.arc(0, complex(land, -high), 1, "land").line(flat, "relief").round(0.5).line(pen.start, "relief")
    diamond = moved(pen.closed(), 1, 60)
    corner = 72 + 20j + polar(5 + 0.6, 45)

    pen = Outline(-20 - 28j)
    pen.round(6.0).line(80 - 28j, "front edge").round(6.0).line(80 + 12j, "right edge").line(64 + 28j, "chamfer 16 x 45 deg")
    pen.line(37 + 28j, "rear edge").round(1.5).line(37 + 23j, "notch 14 wide")
    pen.arc(30 + 23j, 23 + 23j, -1, "R7 notch").line(23 + 28j, "notch").round(1.5).line(-20 + 28j, "rear edge").round(6.0)
    pen.line(pen.start, "left edge")
    plate = pen.closed()
    w, reach = 4.05, 2.0  # the slot is 8.1 wide, 12.1 long
    slot = Outline(complex(60 - reach, -w)).line(complex(60 + reach, -w), "slot")
    slot.arc(60 + reach, complex(60 + reach, w), 1, f"R{w:g}").line(complex(60 - reach, w), "slot")
    slot = slot.arc(60 - reach, slot.start, 1, f"R{w:g}").closed()

    m = Model("fixture_plate.toml", "fixture and plate", """
Drilling fixture with four locators, and the plate it holds, seen from above at the height of the plate.

A round pin of 10 in a bore of 10.1 fixes the plate's place, a diamond pin of 8 in a slot 8.1 wide fixes its direction: 0.05
of play at either. A guard pin of 12 in the notch and one of 10 at the chamfered corner, with 1 and 0.6 to spare, keep a plate
from being laid in turned over or end for end.

Both parts have their origin in the axis of the round pin, or of the bore: (x, y, theta) = (0, 0, 0) is the plate in place.
""")
    m.show("Does the fixture hold the plate?")
    m.world(friction=0.05, restitution=0.3)
    m.part("fixture", "Four pins that stand apart; the ground plate below them is not in this plane.", [
        ("round pin, diameter 10", circle(0, 5.0)),
        ("diamond pin, diameter 8, lands 2.4 wide", diamond),
        ("guard pin in the notch, diameter 12", circle(30 + 23j, 6.0)),
        ("guard pin at the chamfer, diameter 10", circle(corner, 5.0)),
    ], keys=["mass = 20", "inertia = 40000"])
    m.part("plate", "100 x 56, corners R6.", [
        ("outline", plate), ("bore, diameter 10.1", circle(0, 5.05)), ("slot, 8.1 x 12.1", slot)], keys=[STEEL, placed(0, 0, 180)])
    m.mounted("fixture", [-20 - 40j, 80 - 40j, 30 + 60j], 2e6, 4000, text="The machine's table, on which the fixture is clamped.")
    m.torque("plate", 3e4, "Laid in the wrong way round, the bore on the round pin, and turned: the guard pin of 12 stops the corner at -89 deg.")
    m.brake("plate", 1e4, "Oil below the plate.")
    return m


LIP = -8.0  # of the catch: how far below the wall's face


def catch_section():
    lip, slope = LIP, math.tan(math.radians(10))
    return rounded_polygon([
        (-1 + 0j, 0.2, "chamfer 1 x 45 deg"), (-1j, 0.2, "mouth"), (-15.5j, 1.0, "pocket floor"),
        (8 - 15.5j, 1.0, "pocket"), (complex(8, lip - (8 - 3.9) * slope), 0.5, "lip, retention face"),
        (complex(3.9, lip), 0.25, "mouth"), (3.9 - 1j, 0.2, "chamfer 1 x 45 deg"), (4.9 + 0j, 0.2, "wall"),
        (13 + 0j, 1.5, "side"), (13 - 19j, 1.5, "foot"), (-6 - 19j, 1.5, "side"), (-6 + 0j, 1.5, "wall"),
    ])


def snap_fastener():
    slope = math.tan(math.radians(10))
    m = Model("snap_fastener.toml", "snap hook and catch", """
Cantilever snap hook of a plastic cover, and the catch in its housing, in section.

The beam tapers from 3.5 to about 2.2 and carries a head with a lead-in of 28 deg and a retention face at 80 deg to the axis.
The catch is a mouth of 3.9 in a wall 8 thick, with lead-in chamfers 1 x 45 deg, over a pocket undercut by 4.1 on the
head's side. Engaged, the root fills the mouth with 0.2 a side, the flange lies on the wall, and the head stands 0.15 below
the lip, which it overlaps by 1.2: stiff parts cannot come apart, the beam has to bend.

Both are drawn engaged: at (x, y, theta) = (0, 0.05, 0) the hook is free, at (0, 0, 0) its flange touches the wall.
""")
    m.show("Can the hook leave the catch without bending?")
    lip, gap = LIP, 0.15
    right, barb = 3.7, 5.1
    top = lip - gap - (right - 3.9) * slope
    hook = rounded_polygon([
        (-6 + 4j, 1.0, "flange"), (-6 + 0j, 0.3, "flange, bears on the wall"), (0.2 + 0j, 0.8, "beam, tapered 9 deg"),
        (complex(1.5, top), 0.0, "head, outside"), (1.7 - 13j, 0.6, "tip"), (3.1 - 13j, 0.8, "lead-in 28 deg"),
        (complex(barb, -13 + (barb - 3.1) / math.tan(math.radians(28))), 0.4, "land"),
        (complex(barb, top - (barb - right) * slope), 0.25, "retention face, 80 deg"),
        (complex(right, top), 0.3, "beam"), (complex(right, 0), 0.8, "flange, bears on the wall"),
        (10 + 0j, 0.3, "flange"), (10 + 4j, 1.0, "flange, top"),
    ])
    catch = catch_section()
    m.world(friction=0.15, restitution=0.3)
    m.part("catch", "The wall's face is the x axis, the mouth reaches from 0 to 3.9.", [("section", catch)], keys=[PLASTIC])
    m.part("hook", "Drawn engaged.", [("outline", hook)], keys=[
        "mass = 0.3 # with its cover", "inertia = 60", "center_of_mass = [2, 4]", placed(0, 16)])
    m.mounted("catch", [-6 - 19j, 13 - 19j], 1e6, 100, text="The housing, which gives way a little.")
    m.mounted("hook", [-2 + 4j, 6 + 4j], 100, 10, 3j,
              text="A soft hand pushes the hook in. Its head goes aside at the chamfer and into the mouth, but it is stiff: it stays there.")
    return m


def peg_hole():
    block = rounded_polygon([
        (-6.05 + 0j, 0, "chamfer 1 x 45 deg"), (-5.05 - 1j, 0, "bore"), (-5.05 - 20j, 0.8, "bottom"),
        (5.05 - 20j, 0.8, "bore"), (5.05 - 1j, 0, "chamfer 1 x 45 deg"), (6.05 + 0j, 0, "face"),
        (20 + 0j, 2.0, "side"), (20 - 32j, 2.0, "foot"), (-20 - 32j, 2.0, "side"), (-20 + 0j, 2.0, "face"),
    ])
    run = 1.5 * math.tan(math.radians(30))
    peg = rounded_polygon([
        (-5 + 0j, 0.6, "shank"), (-5 - 16.5j, 0, "chamfer 1.5 x 30 deg"), (complex(-5 + run, -18), 0.5, "end"),
        (complex(5 - run, -18), 0.5, "chamfer"), (5 - 16.5j, 0, "shank"), (5 + 0j, 0.6, "collar, seats on the face"),
        (8 + 0j, 0.5, "collar"), (8 + 6j, 2.0, "top"), (-8 + 6j, 2.0, "collar"), (-8 + 0j, 0.5, "collar, seats on the face"),
    ])
    m = Model("peg_hole.toml", "peg in hole", """
Collared peg of diameter 10 and a blind hole of diameter 10.1, in section.

The shank is 18 long, with an end chamfer 1.5 x 30 deg and a fillet R0.6 under the collar; the hole is 20 deep, chamfered
1 x 45 deg at the mouth, R0.8 at the bottom. The collar, 16 across, seats on the face before the shank reaches the bottom.

The block has its origin in the middle of the mouth, the peg in the middle of the collar's underside: (x, y, theta) = (0, 0, 0)
is the seated peg, (0, 18, 0) the peg with its end in the mouth.
""")
    m.show("Can the peg be pulled out of the hole?")
    m.world(gravity=(0, -GRAVITY), friction=0.15, restitution=0.3)
    m.part("block", "40 x 32, corners R2.", [("section", block)], keys=[STEEL])
    m.part("peg", "Shank to -y.", [("outline", peg)], keys=[STEEL, placed(0.4, 24, 2)])
    m.mounted("block", [-16 - 30j, 16 - 30j], 1e6, 1000, text="The block stands on the bench. The peg falls askew, finds the chamfer, and comes to rest on its collar.")
    return m


def latch_box():
    box = rounded_polygon([
        (-8 - 8j, 3.0, "foot"), (88 - 8j, 3.0, "right wall"), (88 + 40j, 0, "sill of the bolt"), (80 + 40j, 0, "right wall"),
        (80 + 0j, 2.0, "floor"), (0 + 0j, 2.0, "left wall"), (0 + 40j, 0, "lip over the lid"), (6 + 40j, 0, "lip"),
        (6 + 46j, 2.0, "top"), (-8 + 46j, 2.0, "left wall"),
    ])
    keeper = rounded_polygon([(80 + 46j, 0, "over the bolt"), (88 + 46j, 0, "side"), (88 + 54j, 2.0, "top"), (80 + 54j, 2.0, "side")])
    block = rounded_polygon([(10 + 0j, 2.5, "bottom"), (70 + 0j, 2.5, "side"), (70 + 34j, 1.0, "top"), (10 + 34j, 1.0, "side")])
    lid = rounded_polygon([(1 + 34j, 1.0, "on the block"), (79 + 34j, 1.0, "end"), (79 + 40j, 1.0, "top"), (1 + 40j, 1.0, "end")])
    bolt = rounded_polygon([(70 + 40j, 0, "on the lid"), (100 + 40j, 1.0, "handle"), (100 + 46j, 1.0, "top"), (70 + 46j, 1.0, "end")])
    m = Model("latch_box.toml", "box with a latch", """
Box with a lid and a bolt, in section, and a block that fills it up to the lid: to be taken apart.

The lid lies on the block, with one end under a lip of the box and the other under the bolt, which goes through a keeper on the
right wall. The keeper is a piece of the box: what joins the two lies before and behind the section. Parts touch where they bear on
each other, and are drawn so.
""")
    m.show("How does the box come apart?", ("box", "bolt"))
    m.world(gravity=(0, -GRAVITY), friction=0.15, restitution=0.3)
    m.part("box", "96 x 62.", [("section", box), ("keeper", keeper)], '{ type = "fixed" }')
    m.part("block", "60 x 34.", [("outline", block)], keys=[STEEL])
    m.part("lid", "78 x 6, 1 clear at both ends.", [("outline", lid)], keys=[STEEL])
    m.part("bolt", "30 x 6.", [("outline", bolt)], keys=[STEEL, placed(25, 0)])
    m.mounted("bolt", [76 + 43j, 100 + 43j], 300, 3, 27, text="A hand has drawn the bolt out of the keeper, which it fills, and holds it.")
    m.spring("lid", (79 + 40j, 75 + 95j), 60, 20, 30,
             text="A spring with a damper lifts the lid's free end: it turns on the block, its other end goes down, and it stays open at some 29 deg.")
    return m


def ball_in_c():
    inner, outer, half = 12.0, 20.0, 25.0
    pen = Outline(polar(outer, half))
    pen.round(3.0).arc(0, polar(outer, -half), 1, f"outside R{outer:g}").round(3.0).line(polar(inner, -half), "lip").round(2.0)
    pen.arc(0, polar(inner, half), -1, f"inside R{inner:g}").round(2.0).line(pen.start, "lip")
    m = Model("ball_in_c.toml", "ball in a C", """
Ball of diameter 20 caged in a C-shaped clip.

The clip has R12 inside and R20 outside and is open over 50 deg to +x; its lips are rounded R2 inside and R3 outside and leave a
mouth of some 11, so the ball, with play of 2 all round, cannot leave: at every orientation its free space is in two pieces,
inside and outside.
""")
    m.show("Can the ball leave the clip?")
    m.part("clip", "", [("outline", pen.closed())])
    m.part("ball", "", [("diameter 20", circle(0, 10.0))])
    return m


def geneva():
    slots, distance = 6, 60.0
    crank, wheel_radius = distance * math.sin(math.pi / slots), distance * math.cos(math.pi / slots)
    pin, play, disc = 4.0, 0.1, 23.0
    half, bottom = pin + play, distance - crank - 0.4  # the slot's half width, and the centre of its round bottom
    pen = None
    lock = meet_circles(0, wheel_radius, distance, disc + play)  # where the locking arc to +x meets the rim
    rim = math.sqrt(wheel_radius**2 - half**2)
    for k in range(slots):
        turned, middle = polar(1, 60 * k), polar(1, 60 * k + 30)
        if pen is None:
            pen = Outline(lock[1])
        pen.arc(distance * turned, lock[0] * turned, -1, f"locking arc {k + 1}")
        pen.arc(0, complex(rim, -half) * middle, 1, "rim").round(0.5)
        pen.line(complex(bottom, -half) * middle, f"slot {k + 1}")
        pen.arc(bottom * middle, complex(bottom, half) * middle, -1, f"R{half:g}")
        pen.line(complex(rim, half) * middle, "slot").round(0.5)
        pen.arc(0, lock[1] * turned * polar(1, 60) if k + 1 < slots else pen.start, 1, "rim")
    wheel = pen.closed()
    relief = wheel_radius + 0.5
    axis = complex(distance)
    horn = meet_circles(axis, disc, 2 * axis, relief)
    driver = Outline(horn[0]).arc(axis, horn[1], 1, f"locking disc R{disc:g}").round(0.4)
    driver = driver.arc(2 * axis, horn[0], -1, f"relief R{relief:.2f}").round(0.4).closed()
    m = Model("geneva.toml", "Geneva drive", f"""
Geneva wheel of six slots and its driver, shafts 60 apart.

The wheel's radius is 60 cos 30 deg = {wheel_radius:.2f}, the driver's crank 60 sin 30 deg = 30. The pin, of diameter 8,
runs with 0.1 of play a side in slots 8.2 wide; the locking disc R23 with 0.1 in the wheel's locking arcs. The disc is relieved
by an arc R{relief:.2f}, concentric with the wheel at half step, which lets the wheel's horns pass while the pin drives.

Both are drawn at dwell: the pin points away from the wheel, the disc holds a locking arc. One turn of the driver steps the
wheel by 60 deg the other way. The crank's arm lies below the wheel and is not in this plane, so disc and pin stand apart.
""")
    m.show("Does the driver step the wheel, and hold it between?")
    m.part("wheel", "", [("six slots, six locking arcs", wheel)], '{ type = "revolute", center = [0, 0] }', slots)
    m.part("driver", "", [("locking disc", driver), ("pin, diameter 8", circle(axis + crank, pin))],
           '{ type = "revolute", center = [60, 0] }')
    m.drive("driver", "360deg")
    return m


BONE = "density = 5.7e-5 # bone, 30 thick"


def knee():
    # The femur's condyle: from the back, arcs whose radii grow and shrink again, each tangent to the next.
    distal, back, front = 36.0, 21.0, 27.0
    c_distal = complex(0, distal)
    join_back, join_front = polar(1, -108), polar(1, -55)
    c_back = c_distal + join_back * (distal - back)
    c_front = c_distal + join_front * (distal - front)
    lean = polar(1, 92)  # the shaft leans back a little
    hind, fore = -17 + 60j, 17 + 60j
    hind_foot = nearest(meet_line_circle(hind, lean, c_back, back), -20 + 50j)
    fore_foot = max(meet_line_circle(fore, lean, c_front, front), key=lambda p: p.imag)
    hind_head, fore_head = hind + lean * 45, fore + lean * 45
    pen = Outline(hind_head)
    pen.round(2.0).line(hind_foot, "shaft, back").round(10.0)
    pen.arc(c_back, c_distal + join_back * distal, 1, f"condyle, back R{back:g}")
    pen.arc(c_distal, c_distal + join_front * distal, 1, f"condyle, below R{distal:g}")
    pen.arc(c_front, fore_foot, 1, f"trochlea R{front:g}").round(25.0)
    pen.line(fore_head, "shaft, front").round(2.0).line(pen.start, "cut")
    femur = pen.closed()

    dish = 48.0
    low = complex(0, dish)
    def plateau(x):
        return complex(x, dish - math.sqrt(dish * dish - x * x))
    pen = Outline(plateau(-24))
    pen.round(5.0).arc(low, plateau(19), 1, f"plateau R{dish:g}").round(4.0)
    pen.bow(-40.0, 22 - 26j, "front slope").round(12.0)
    pen.line(27 - 34j, "tuberosity").round(6.0).line(14 - 60j, "tuberosity").round(25.0)
    pen.line(11 - 95j, "shaft, front").round(2.0).line(-15 - 95j, "cut").round(2.0).line(-17 - 45j, "shaft, back").round(30.0)
    pen.line(-27 - 12j, "back").round(8.0).line(pen.start, "back")
    tibia = pen.closed()
    m = Model("knee.toml", "knee", f"""
Femur and tibia of a knee prosthesis' test rig, in the plane of flexion, approximated by arcs.

The condyle is three tangent arcs: R{back:g} behind, R{distal:g} below, R{front:g} for the trochlea, blended into the shaft
by R10 and R25. The tibia's plateau is a dish R{dish:g}, less curved than the condyle, with rounded rims; the tuberosity stands
out in front. Front is +x.

The femur has its origin in the lowest point of the condyle, the tibia in the lowest point of the plateau: in extension they
touch at (x, y, theta) = (0, 0, 0); in flexion the tibia turns clockwise, to about -110 deg.
""")
    m.show("Does the shape of the joint alone hold the tibia?")
    m.world(gravity=(0, -GRAVITY), friction=0.02)
    m.part("femur", "", [("outline", femur)], keys=[BONE])
    m.part("tibia", "", [("outline", tibia)], keys=[BONE])
    m.mounted("femur", [-12 + 100j, 12 + 100j], 1e6, 1000, text="The rig holds the femur.")
    m.spring(("tibia", "femur"), (-12j, c_back), 3000, 20, 20, text="The ligaments hold the tibia to the condyle; they end in the middle of its back arc.")
    m.torque("tibia", -120000, "The flexor: the tibia swings back, and rests bent by some 56 deg, where torque, weight and ligaments balance.")
    m.torsion(["tibia", "femur"], 0, damping=60000, text="What the tissue about the joint takes.")
    return m


MODELS = [ratchet_mechanism, gears, gears_on_shafts, rack_pinion, cam_follower, cam_tappet, cam_plate, escapement,
          fixture_plate, snap_fastener, peg_hole, latch_box, ball_in_c, geneva, knee]


if __name__ == "__main__":
    sys.exit(write_or_check(MODELS, Path(__file__).resolve().parent, sys.argv[1:]))
