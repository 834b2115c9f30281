#!/usr/bin/env python3
"""Draws the models of this folder that are there to move: what drives, loads and springs them, and masses where they matter.

    python3 models/mechanisms.py            write every model file
    python3 models/mechanisms.py NAME ...   write these only (film_advance, woodpecker, ...)
    python3 models/mechanisms.py --check    write nothing; fail if a file differs from its drawing

How outlines are made is told in drawing.py, those that others draw are in draw.py: lengths in mm, angles in degrees,
points are complex numbers; masses in kg and times in s, so forces are in mN and torques in mN mm.
"""

import math
import sys
import textwrap
from pathlib import Path

from draw import (
    ANCHOR_PIVOT, ESCAPE, LIFT, LIP, SWING, cam_profile, catch_section, gear_outline, wheel_and_anchor,
)
from drawing import Model, Outline, circle, meet_circles, moved, number, polar, rounded_polygon, unit, write_or_check
from forces import GRAVITY


def mechanism(file, name, text):
    """A model whose text, paragraph by paragraph, is filled to the width of a page."""
    return Model(file, name, "\n\n".join(textwrap.fill(p, 124) for p in text.strip().split("\n\n")))


def revolute(centre, range_degrees=None):
    within = f', range = ["-{range_degrees:g}deg", "{range_degrees:g}deg"]' if range_degrees else ""
    return f'{{ type = "revolute", center = [{number(centre.real)}, {number(centre.imag)}]{within} }}'


def bar(a, b, radius, note):
    """A bar with round ends about two points."""
    aside = 1j * unit(b - a) * radius
    pen = Outline(a - aside).line(b - aside, note).arc(b, b + aside, 1, f"R{radius:g}").line(a + aside, note)
    return pen.arc(a, pen.start, 1, f"R{radius:g}").closed()


def rectangle(low, high, note=""):
    across = complex(high.real, low.imag), complex(low.real, high.imag)
    return rounded_polygon([(low, 0, note), (across[0], 0, ""), (high, 0, ""), (across[1], 0, "")])


def escapement_pendulum():
    wheel, anchor = wheel_and_anchor()
    bob, disc, period = 0.5, 25.0, 1.0  # the mass of the bob, its radius, and how long the pendulum swings to and fro
    # J / m + l² = g l (T / 2 pi)², J = m r² / 2
    simple = GRAVITY * (period / (2 * math.pi)) ** 2
    long = simple / 2 + math.sqrt(simple**2 / 4 - disc**2 / 2)
    low = ANCHOR_PIVOT - 1j * long
    quality, amplitude = 100, 4.0
    damping = bob * (disc**2 / 2 + long**2) * 2 * math.pi / (quality * period)
    m = mechanism("escapement_pendulum.toml", "dead-beat escapement with its pendulum", f"""
The escapement of escapement.toml as it goes by itself: a pendulum that times it and a weight that drives it.

The pendulum hangs on the anchor and is one part with it; its rod and bob, a disc of {2 * disc:g} with {bob:g} kg, lie behind the wheel and
are not drawn. The bob's centre is {long:.3f} below the pivot, so that small swings take {period:g} s. Its bearing and the air take as
much as makes a quality of {quality}: left alone it would lose 1 part in {quality / (2 * math.pi):.0f} of its energy in each swing. The weight pulls on
the wheel's arbor.

To be seen: it begins in the middle of its swing, about to go to -{amplitude:g} deg, pushed by the first tooth. The wheel stands still while a tooth lies on the arc
of a pallet, and gives the anchor a push of {LIFT:g} deg twice in each swing, one tooth of {ESCAPE} in all; that brings the swing to where
pushes and losses are even, and no farther than {SWING:g} deg, where the anchor would strike its stops. The period is a little
longer than that of small swings.
""")
    m.show("Does the anchor let the wheel turn?")
    m.world(gravity=(0, -GRAVITY), friction=0.1, restitution=0.2)
    m.part("wheel", "Brass, 1 thick and crossed out: the spokes are not drawn.", [(f"{ESCAPE} teeth", wheel)],
           revolute(0j), ESCAPE, ["mass = 0.02", "inertia = 22"])
    m.part("anchor", "With the pendulum.", [("outline", anchor)], revolute(ANCHOR_PIVOT, SWING), keys=[
        f"mass = {bob}", f"inertia = {number(bob * disc**2 / 2)}", f"center_of_mass = [0, {number(low.imag)}]",
        f"rate = {number(-math.radians(amplitude) * 2 * math.pi / period)}"])
    m.torque("wheel", "-3000", "The weight on its drum.").brake("anchor", number(damping), "The bearing, and the air.")
    return m


def cam_roller():
    disc, stem, gap = 8.0, 5.0, 0.1
    top = 34.0 + gap + disc  # the roller's centre, above the dwell
    fork = rounded_polygon([
        (complex(-stem, top), 2.0, "fork"), (complex(stem, top), 2.0, "fork"), (complex(stem, top + 60), 1.0, "stem"),
        (complex(-stem, top + 60), 1.0, "stem"),
    ])
    preload, rate, lift = 4e6, 2e5, 12.0
    seat = 1j * (top + 15)
    length = 40.0
    m = mechanism("cam_roller.toml", "cam and roller", f"""
The plate cam of cam_follower.toml on its shaft, a roller that rides on it, and the stem that carries the roller in its guide.

The roller, of diameter {2 * disc:g}, turns on a pin in the stem's fork, which lies in front of the cam. A spring of {rate / 1e3:g} N/mm between a collar on
the stem and the guide above presses it down, by {(preload - rate * (lift + gap)) / 1e3:.0f} N at the least.

Drawn with the cam's dwell on top and the roller {gap:g} above it. To be seen: the roller comes down on the dwell, then on each turn of
the cam falls along the straight flank to the base circle, {lift:g} below, and rises along the flank R60. Without friction it does not turn.
""")
    m.show("Does the cam alone hold the roller?", ("cam", "roller"))
    m.part("cam", "Axis at the origin, dwell to +y.", [("profile", cam_profile())], revolute(0j))
    m.part("roller", f"Diameter {2 * disc:g}.", [(f"diameter {2 * disc:g}", circle(1j * top, disc))])
    m.part("stem", "Up and down.", [("fork and stem", fork)],
           f'{{ type = "prismatic", direction = [0, 1], range = [{-lift - 1:g}, 6] }}')
    m.joint("revolute", "roller", "stem", 1j * top, "The pin.")
    m.pair("cam", "roller").pair("roller", "stem", "Lower pair.")
    m.drive("cam", "360deg", "The cam turns once a second.")
    m.spring("stem", (seat, seat + 1j * (length - preload / rate)), rate, length,
             text="From a collar on the stem to the guide; length is that of the free spring.")
    return m


PERFORATION, PITCH, FILM = 1.27, 7.62, 0.15  # of 16 mm film: length of a hole, from hole to hole, thickness


def film_advance():
    throw, lever, reach, swing = 3.0, 18.0, 12.0, 16.0
    finger, shaft, pivot = 0.7, 0j, 18 - 16j
    pin = shaft + throw
    tail = max(meet_circles(pin, lever, pivot, swing), key=lambda p: p.imag)
    back = unit(tail - pin)
    tip = pin - back * reach
    side = 1j * back
    face = -13.65  # the film's side that is turned to the claw
    holes, below = 14, 3
    low = 3.9 - PITCH * below

    pen = Outline(tip + side * finger / 2)
    pen.round(0.25, "tip").line(tip - side * finger / 2, "tip").round(0.25, "tip")
    pen.line(tip - side * finger / 2 + back * 4, "finger, pulls the film").round(0.8).line(pin - side * 3.5 - back * 3, "shoulder").round(1.0)
    pen.line(pin - side * 3.5, "lever").line(tail - side * 2.5, "lever").arc(tail, tail + side * 2.5, 1, "eye")
    pen.line(pin + side * 3.5, "lever").line(pin + side * 3.5 - back * 3, "lever").round(1.0)
    pen.line(tip + side * finger / 2 + back * 4, "shoulder").round(0.8).line(pen.start, "finger")
    claw = pen.closed()

    pieces = []
    for k in range(holes + 1):
        start = low + PITCH * k
        bridge = start + PERFORATION / 2, start + PITCH - PERFORATION / 2
        pieces.append((f"between holes {k} and {k + 1}", rectangle(complex(face - FILM, bridge[0]), complex(face, bridge[1]))))

    m = mechanism("film_advance.toml", "film advance", f"""
Claw of a 16 mm film projector, in section: a crank moves it into a hole of the film, down, out and up again.

Film of {FILM:g} has holes of {PERFORATION:g} every {PITCH:g}; the section goes through the holes, so it is drawn as the pieces between them. The claw is the coupler of
a four-bar linkage: its middle runs on a crank of {throw:g}, its tail on a rocker of {swing:g}, so that its tip runs around an
oblong of 6 by 10. To the left of x = {face:g} the tip is in a hole; that is so for a stroke a little longer than from hole to hole, and the finger,
{finger:g} thick, has room in the hole to find it.

Drawn with the claw drawn back. To be seen: at each turn the finger enters a hole, takes the film down at its lower edge and leaves it
where it always leaves it, so each turn moves the film by {PITCH:g}, and it stands still for more than half of the turn, which is when
light falls through it. The shutter turns with the crank. The gate holds the film by friction, so it stays where the claw left it.
""")
    m.show("Can the claw be pulled out of the film?", ("film", "claw"))
    m.part("film", "Slides down the gate.", pieces, '{ type = "prismatic", direction = [0, -1] }')
    m.part("crank", "The throw is drawn as a disc.", [("disc", circle(shaft, throw + 3.0))], revolute(shaft))
    m.part("claw", "Tip to -x.", [("outline", claw)])
    m.part("rocker", "On the frame.", [("outline", bar(pivot, tail, 2.5, "arm"))], revolute(pivot))
    m.joint("revolute", "crank", "claw", pin, "The crank's pin.").joint("revolute", "claw", "rocker", tail)
    m.pair("film", "claw").pair("crank", "claw", "Lower pairs.").pair("claw", "rocker")
    m.drive("crank", "360deg", "Once a second; a projector does it 24 times as fast.")
    return m


def gears_backlash():
    swing, cycles = 10.0, 2.0
    m = mechanism("gears_backlash.toml", "gears with backlash under load", f"""
The gears of gears_on_shafts.toml with a flywheel on the pinion's shaft and a load that holds it back.

Steel, 10 thick. The gear is driven at one turn a second, but not evenly: the joint that drives it leads and lags by {swing:g} deg, {cycles:g} times
a turn. The load presses the pinion's teeth on those that drive them; where the gear slows down by more than the load slows the
flywheel, the pinion runs on, crosses the backlash, and strikes the teeth on the other side.

To be seen: twice a turn the contact goes to the other flank and back again, each time with impacts that die out.
""")
    m.show("Do the gears turn, and with how much play?")
    m.world(friction=0.05, restitution=0.3)
    m.part("gear", "", [("12 teeth", gear_outline(12, 4.0, 25, 1.25, 0.1, 1.0, 0))], revolute(0j), 12, ["density = 7.85e-5"])
    pinion = moved(gear_outline(10, 4.0, 25, 1.25, 0.1, 1.0, 18), 1, 44)
    m.part("pinion", "Its inertia is that of the flywheel as well.", [("10 teeth", pinion)], revolute(44 + 0j), 10,
           ["mass = 0.6", "inertia = 220", f"rate = {number(-2.4 * math.pi * (1 + swing * cycles / 360))}"])
    steps = 36  # points a turn
    points = [(k / steps, f'"{360 * k / steps + swing * math.sin(2 * math.pi * cycles * k / steps):.6f}deg"') for k in range(3 * steps + 1)]
    m.table("gear", points, "Three turns.")
    m.torque("pinion", "3000", "The load: against the way the pinion turns.")
    return m


def snap_in(damping=0):
    slope = math.tan(math.radians(10))
    right, barb, hinge = 3.7, 5.1, 1.95 - 1.5j
    top = LIP - 0.15 - (right - 3.9) * slope
    beam = rounded_polygon([
        (0.2 - 0.3j, 0.0, "beam, tapered 9 deg"), (complex(1.5, top), 0.0, "head, relieved"), (2.4 - 13j, 0.3, "tip"),
        (3.1 - 13j, 0.3, "lead-in 28 deg"), (complex(barb, -13 + (barb - 3.1) / math.tan(math.radians(28))), 0.4, "land"),
        (complex(barb, top - (barb - right) * slope), 0.25, "retention face, 80 deg"),
        (complex(right, top), 0.3, "beam"), (right - 0.3j, 0.0, "root"),
    ])
    cover = rounded_polygon([
        (-6 + 0j, 0.3, "flange, bears on the wall"), (10 + 0j, 0.3, "flange"), (10 + 4j, 1.0, "flange, top"), (-6 + 4j, 1.0, "flange")])
    away = 16.0
    m = mechanism("snap_in.toml", "snap hook pushed in", f"""
A snap hook much like that of snap_fastener.toml, pushed into the same catch and pulled out of it. Its head is relieved outside, so that
there is room in the mouth for it askew.

The hook's beam bends. It stands here as a stiff beam on a hinge with a spring, as one calculates such beams: the hinge lies
where a straight piece best follows the path of the bent beam's end, 0.15 of its length from the root, and the spring is as stiff
as the beam: 2.25 E I / l, with 2 GPa, 2.6 by 6, and a length of 10. The flange is the cover's and is driven, {away:g} down and up again.

To be seen: the lead-in of the head meets the chamfer of the mouth, and the beam is bent until the barb stands in the mouth, 1.2 of
deflection; it slides through, and snaps out behind the lip. Pulled out, the retention face, 10 deg from square, bends it
again. It would hold with a coefficient of friction beyond 0.52: the hinge lies beside the line of the pull.
""")
    m.show("Can a stiff hook leave the catch?", ("catch", "hook"))
    m.part("catch", "The wall's face is the x axis, the mouth reaches from 0 to 3.9.", [("section", catch_section())], '{ type = "fixed" }')
    m.part("cover", "Its flange, up and down; at zero motion it lies on the wall.", [("flange", cover)],
           '{ type = "prismatic", direction = [0, 1] }')
    m.part("hook", "The beam and its head, drawn engaged.", [("outline", beam)], keys=[f"start = [0, {number(away)}, 0]"])
    m.joint("revolute", "cover", "hook", hinge)
    m.pair("catch", "cover").pair("catch", "hook").pair("cover", "hook", "Lower pair.")
    steps, seat = 10, 0.05

    def pushed(s):  # smoothly, from 0 to 1
        return s**3 * (10 - 15 * s + 6 * s * s)

    way = [(k / steps, away + (seat - away) * pushed(k / steps)) for k in range(steps + 1)]
    way += [(1 + 0.5 * k / 5, seat) for k in range(1, 5)] + [(2.5 - t, u) for t, u in reversed(way)]
    m.table("cover", [(t, f"{u:.6f}") for t, u in way], "In, a rest, and out.")
    m.torsion(["hook", "cover"], 4e6, damping=damping, text="The beam's stiffness.")
    return m


def slider_crank_clearance():
    crank, rod, half, high, clear = 153.0, 306.0, 50.0, 25.0, 1.0
    end = crank + rod
    spin, back = 150.0, -75.0
    wall = high + clear
    m = mechanism("slider_crank_clearance.toml", "slider-crank with clearance", f"""
A slider-crank whose slider has clearance in its guide: the example of P. Flores, R. Leine and C. Glocker, "Modeling and analysis
of planar rigid multibody systems with translational clearance joints based on the non-smooth dynamics approach", Multibody
System Dynamics 23 (2010), with its dimensions, masses, friction and restitution.

Crank {crank:g}, rod {rod:g}, slider {2 * half:g} by {2 * high:g} with {clear:g} of clearance above and below. Nothing drives it: the crank begins at
{spin:g} rad/s, the rod at {back:g} rad/s, so that the slider is at rest in the middle of its guide. The slider may move, turn and strike with each of its
four corners.

To be seen: the slider falls on the guide, strikes it with one corner and the other, slides along it on one or two corners, and changes
sides where the rod pushes it. Impacts follow each other ever faster until the slider lies on.
""")
    m.show("Can the slider leave its guide?", ("guide", "slider"))
    m.world(gravity=(0, -GRAVITY), friction=0.01, restitution=0.4)
    walls = [("below", rectangle(complex(80, -wall - 12), complex(540, -wall), "guide")),
             ("above", rectangle(complex(80, wall), complex(540, wall + 12), "guide"))]
    m.part("guide", "Both sides of it.", walls, '{ type = "fixed" }')
    m.part("crank", "Drawn to the right.", [("bar", bar(0j, complex(crank), 10.0, "side"))], revolute(0j), keys=[
        "mass = 0.038", "inertia = 74", f"center_of_mass = [{number(crank / 2)}, 0]", f"rate = {spin}"])
    lift = crank * spin - crank * back  # of the rod's frame, whose origin is the crank's axis
    m.part("rod", "", [("bar", bar(complex(crank), complex(end), 8.0, "side"))], keys=[
        "mass = 0.038", "inertia = 590", f"center_of_mass = [{number(crank + rod / 2)}, 0]", f"rate = [0, {number(lift)}, {back}]"])
    m.part("slider", "", [("block", rectangle(complex(end - half, -high), complex(end + half, high)))], keys=[
        "mass = 0.076", "inertia = 2.7", f"center_of_mass = [{number(end)}, 0]"])
    m.joint("revolute", "crank", "rod", complex(crank)).joint("revolute", "rod", "slider", complex(end))
    m.pair("guide", "slider").pair("crank", "rod", "Lower pairs.").pair("rod", "slider")
    return m


def woodpecker():
    bore, tall, pole = 3.1, 5.8, 2.5
    arm, body, beak, high = 10.0, 15.0, 20.1, 20.0  # to the spring; to the bird's centre; from there to the beak; its height
    wall, tip, slant = 1.5, 0.5, 20.0
    nib = arm + body - beak
    point = nib + tip - tip / math.sin(math.radians(slant))
    rise = (14 - point) * math.tan(math.radians(slant))
    left = rectangle(complex(-bore - wall, -tall), complex(-bore, tall), "outside")
    right = rounded_polygon([
        (complex(bore, -tall), 0, "end"), (complex(bore + wall, -tall), 0, "outside"), (complex(bore + wall, -1), 0.5, "arm"),
        (complex(arm + 1, -1), 0.9, "end"), (complex(arm + 1, 1), 0.9, "arm"), (complex(bore + wall, 1), 0.5, "outside"),
        (complex(bore + wall, tall), 0, "end"), (complex(bore, tall), 0, "bore"),
    ])
    bird = rounded_polygon([
        (complex(point, high), tip, "beak"), (complex(14, high - rise), 2.0, "throat"), (17 + 10j, 3.0, "breast"),
        (9 + 2j, 0.8, "spring"), (9 - 2j, 0.8, "spring"), (18 - 6j, 4.0, "belly"), (30 - 28j, 1.0, "tail"), (34 - 27j, 1.0, "back"),
        (34 + 4j, 10.0, "back"), (28 + 23j, 5.0, "head"), (20 + 27j, 4.0, "crown"), (complex(14, high + rise), 1.5, "beak"),
    ])
    tilt, lean = -0.1, -0.2788  # of the sleeve and of the bird at the start
    fall, peck = -341.1, -7.4583
    hinge = arm * (polar(1, math.degrees(tilt)) - polar(1, math.degrees(lean)))
    speed = complex(0, fall) - 1j * peck * arm * polar(1, math.degrees(lean))
    m = mechanism("woodpecker.toml", "woodpecker toy", f"""
The woodpecker that pecks its way down a pole, after C. Glocker, "Dynamik von Starrkörpersystemen mit Reibung und Stößen" (1995),
with his dimensions, masses, spring, friction and restitution.

A sleeve with a bore of {2 * bore:g}, {2 * tall:g} long, has play on the pole of {2 * pole:g}. A spring at {arm:g} from the pole's axis carries the bird, whose centre of mass
is {body:g} farther out and whose beak stands {high:g} above and {nib - pole:g} away from the pole. Glocker's equations are linear in the angles, have the
sleeve's axis on the pole's, and count contacts on one side of the pole; here parts turn as they do, and the sleeve moves to either side and touches the pole on
both, with the lower edge of its bore on the bird's side and the upper edge on the other, or the reverse. The sleeve holds and lets go with both edges, so this
toy is quicker and comes down less: a period of some 0.126 s and a drop of some 7.5 in each, where Glocker has 0.146 s and 19.4. Up to the
first stroke of the beak, at 0.0779 s, the two are alike.

To be seen: the sleeve, askew, holds by friction while the bird swings; as the bird comes in, the sleeve comes free and falls, the
beak strikes the pole, and the sleeve holds again. It begins just after that, as the sleeve is about to hold.
""")
    m.show("Can the sleeve come off the pole?", ("pole", "sleeve"))
    m.world(gravity=(0, -GRAVITY), friction=0.3, restitution=0.0)
    m.part("pole", "", [("pole", rectangle(complex(-pole, -400), complex(pole, 60)))], '{ type = "fixed" }')
    m.part("sleeve", "In section: what joins its two sides lies before and behind the pole.", [("left side", left), ("right side and arm", right)],
           keys=["mass = 0.0003", "inertia = 0.005", "center_of_mass = [0, 0]", f"start = [0, 0, {tilt}]", f"rate = [0, {fall}, 0]"])
    m.part("bird", "", [("outline", bird)], keys=[
        "mass = 0.0045", "inertia = 0.7", f"center_of_mass = [{number(arm + body)}, 0]",
        f"start = [{number(hinge.real)}, {number(hinge.imag)}, {lean}]",
        f"rate = [{number(speed.real)}, {number(speed.imag)}, {peck}]"])
    m.joint("revolute", "sleeve", "bird", complex(arm), "The spring, as a hinge.")
    m.pair("pole", "sleeve").pair("pole", "bird")
    m.out += "restitution = 0.5\n"
    m.pair("sleeve", "bird", "Lower pair.")
    m.torsion(["bird", "sleeve"], 5600)
    return m


MODELS = [escapement_pendulum, cam_roller, film_advance, gears_backlash, snap_in, slider_crank_clearance, woodpecker]


if __name__ == "__main__":
    sys.exit(write_or_check(MODELS, Path(__file__).resolve().parent, sys.argv[1:]))
