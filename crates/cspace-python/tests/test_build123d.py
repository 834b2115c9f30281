"""The package with build123d itself, where it is installed: against what OCCT finds of the same shapes."""

import math
import re
import subprocess
import sys
import warnings

import pytest
from conftest import ROOT

import cspace as cs

cad = pytest.importorskip("build123d")
from build123d import Axis, Box, Circle, Compound, Cylinder, Location, Part, Pos, Rectangle, RigidJoint, Rot  # noqa: E402

TOL = 1e-3


def gear(teeth=12):
    """A wheel with round tips and roots."""
    edges = []
    tooth = [(9, 0), (11, 0.2), (11, 0.5), (9, 0.7)]
    at = [tuple(cad.Vector(r, 0).rotate(Axis.Z, 360 * (k + s) / teeth)) for k in range(teeth) for r, s in tooth]
    for k in range(0, 4 * teeth, 4):
        a, b, c, d, e = at[k : k + 4] + [at[(k + 4) % len(at)]]
        edges += [cad.Line(a, b), cad.RadiusArc(b, c, -1.8 * math.dist(b, c)), cad.Line(c, d), cad.RadiusArc(d, e, 1.8 * math.dist(d, e))]
    return cad.make_face(edges)


EXACT = {
    "slot": cad.SlotOverall(40, 10),
    "arc slot": cad.SlotArc(cad.CenterArc((0, 0), 20, 10, 130), 6),
    "gear": gear(),
    "plate with holes": Rectangle(60, 40) - cad.GridLocations(20, 15, 3, 2) * Circle(3) - cad.SlotOverall(14, 2),
    "rounded": cad.RectangleRounded(30, 20, 4) - Circle(5),
    "two apart": Circle(4) + Pos(20, 0) * Rectangle(5, 6),
    "island": Circle(9) - Circle(7) + Circle(5) - Pos(1, 1) * Rectangle(2, 2),
    "turned": Rot(0, 0, 33) * Pos(3, 4) * cad.RegularPolygon(7, 5),
    "front": cad.Plane.XZ * Pos(3, 7) * cad.SlotOverall(12, 4),
    "tilted": cad.Plane((1, 2, 3), x_dir=(1, 1, 0), z_dir=(1, -1, 2)) * cad.RectangleRounded(9, 6, 2),
    "far away": Pos(5000, -3000, 80) * cad.Trapezoid(20, 8, 60),
}


@pytest.mark.parametrize("name", EXACT)
def test_lines_and_circles_are_exact(name):
    face = EXACT[name]
    part = cs.Part.from_cad(face, name=name)
    area, length = sum(f.area for f in face.faces()), sum(e.length for e in face.edges())
    assert part.fitted == 0.0
    assert abs(part.area - area) < 1e-9 and abs(part.outline.length - length) < 1e-9
    back = part.to_build123d()
    assert abs(back.area - area) < 1e-9 and len(back.faces()) == len(face.faces()) and back.label == name
    assert abs(cs.Part.from_cad(back).area - area) < 1e-9


CURVES = {
    "ellipse plate": cad.Ellipse(10, 5) - Circle(2),
    "spline cam": cad.make_face(cad.Spline((20, 0), (0, 14), (-12, 0), (0, -11), periodic=True)),
    "around an ellipse": cad.offset(cad.Ellipse(10, 5), 1),
    "bezier": cad.make_face(cad.Bezier((0, 0), (3, 8), (9, 1)) + cad.Line((9, 1), (0, 0))),
}


def test_curves_of_an_assembly_are_said():
    """Two ellipses that overlap by less than their fit: what is answered is not theirs alone, and a warning says so."""
    plate = cad.extrude(cad.Ellipse(10, 4), 3)
    with pytest.warns(UserWarning, match=r"part 0, part 1: .* not told apart: give a smaller `tol`"):
        cs.Model.from_assembly([plate, cad.Pos(3, 7.9) * plate])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        cs.Model.from_assembly([cad.Box(4, 4, 2), cad.Pos(9, 0) * cad.Cylinder(2, 2)])


@pytest.mark.parametrize("tol", [1e-2, 1e-4])
@pytest.mark.parametrize("name", CURVES)
def test_other_curves_are_off_by_what_is_said(name, tol):
    face = CURVES[name]
    part = cs.Part.from_cad(face, tol=tol)
    loops = cs.Loops(part.loops)
    # Places at random shares, so that none is a sample of the fit.
    shares = [(0.5 + 0.618034 * k) % 1 for k in range(3000)]
    mode = cad.PositionMode.PARAMETER
    places = [edge.position_at(share, position_mode=mode) for edge in face.edges() for share in shares]
    off = max(loops.distance(p.X, p.Y) for p in places)
    assert 0.9 * part.fitted < off <= part.fitted <= tol


def swept(base, other, axis, lo, hi):
    """The angle, in degrees, at which a part that turns about an axis begins to overlap another; at `hi` it does."""

    def overlaps(angle):
        both = base.intersect(other.rotate(axis, angle))
        return both is not None and sum(s.volume for s in (both if isinstance(both, list) else [both])) > 1e-7

    assert overlaps(hi) and not overlaps(lo)
    while abs(hi - lo) > 1e-4:
        middle = (lo + hi) / 2
        lo, hi = (lo, middle) if overlaps(middle) else (middle, hi)
    return (lo + hi) / 2


def recipe():
    """The program in the documentation, and the names it leaves."""
    (text,) = re.findall(r"```python hinge\n(.*?)```", (ROOT / "docs/drawings.md").read_text(encoding="utf-8"), re.DOTALL)
    assert len(text.strip().splitlines()) <= 12
    names = {}
    exec(compile(text, "docs/drawings.md", "exec"), names)
    return names


def test_the_recipe_finds_the_limits_that_occt_finds(capsys):
    names = recipe()
    free, limited = capsys.readouterr().out.splitlines()
    assert free.startswith("touches {'leaf': (-3.24") and limited.startswith("clear ((-5.0")
    plate, leaf = names["plate"], names["leaf"]
    cad.RevoluteJoint("pin", plate, Axis.Z).connect_to(names["eye"], angle=0)
    (pair,) = cs.Model.from_assembly([plate, leaf]).clearance().pairs
    lo, hi = map(math.degrees, pair.reach["leaf"])
    assert abs(hi - swept(plate, leaf, Axis.Z, 90, 110)) < 2e-3
    assert abs(lo - swept(plate, leaf, Axis.Z, -180, -195)) < 2e-3
    # At the tightest place OCCT measures the same distance, at one of both heights: where these meet, so do the knuckles.
    cuts = [[cad.section(s, section_by=cad.Plane.XY.offset(z)) for s in (plate, leaf.rotate(Axis.Z, 90))] for z in (5, 15)]
    assert names["pair"].outcome == "clear" and abs(names["pair"].gap - min(a.distance_to(b) for a, b in cuts)) < 1e-9


def labelled(shape, label):
    made = Part(shape.wrapped)
    made.label = label
    return made


def slider():
    rail = labelled(Box(60, 4, 6) - Pos(0, 0, 0) * Box(20, 2, 9) + Pos(28, 6, 0) * Box(4, 16, 6), "rail")
    shoe = labelled(Pos(0, 7, 0) * Box(10, 8, 6), "shoe")
    cad.LinearJoint("way", rail, Axis((0, 0, 0), (1, 0, 0)), linear_range=(-40, 40)).connect_to(
        RigidJoint("foot", shoe, Location()), position=2
    )
    return rail, shoe


def test_a_slider_stops_where_occt_finds_it_overlaps():
    rail, shoe = slider()
    (pair,) = cs.Model.from_assembly(Compound(children=[rail, shoe], label="slide")).clearance().pairs
    lo, hi = pair.reach["shoe"]
    # The shoe's face at x = 7 meets the post at x = 26, and nothing on the other side.
    assert abs(hi - 19) < 1e-9 and abs(lo + 42) < 1e-9

    def at(x):
        both = rail.intersect(shoe.moved(Location((x, 0, 0))))
        return 0 if both is None else sum(s.volume for s in (both if isinstance(both, list) else [both]))

    assert at(hi - 1e-3) < 1e-9 < at(hi + 1e-3)


def test_an_assembly_that_is_moved_is_the_same_mechanism():
    rail, shoe = slider()
    whole = Compound(children=[rail, shoe])
    whole.location = Location((30, -20, 5), (0, 0, 37))
    (pair,) = cs.Model.from_assembly(whole).clearance().pairs
    assert pair.reach["shoe"] == pytest.approx((-42, 19), abs=1e-9)
    # Standing upright, in the plane that it moves in.
    whole.location = Location((30, -20, 5), (90, 0, 0))
    (pair,) = cs.Model.from_assembly(whole, plane=cad.Plane.XZ).clearance().pairs
    assert pair.reach["shoe"] == pytest.approx((-42, 19), abs=1e-9)
    with pytest.raises(cs.Error, match="'way' of 'rail' and 'shoe' has an axis that is not in the plane"):
        cs.Model.from_assembly(whole, plane=cad.Plane.YZ)


def test_joints_that_are_none_in_a_plane_are_named():
    def two(joint, **given):
        a, b = labelled(Box(4, 4, 4), "a"), labelled(Pos(9, 0, 0) * Box(4, 4, 4), "b")
        joint(a).connect_to(RigidJoint("foot", b, Location()), **given)
        return [a, b]

    of = "of 'a' and 'b'"
    cases = [
        (two(lambda a: cad.RevoluteJoint("lid", a, Axis.X), angle=0), f"'lid' {of} has an axis that is not normal to .* 90° off"),
        (two(lambda a: cad.BallJoint("ball", a)), "'ball' of 'a' and 'b' is a .*, which is no joint in a plane"),
        (two(lambda a: cad.LinearJoint("way", a, Axis.X), position=1), r"'way' of 'a' and 'b' has the range \(0, inf\)"),
    ]
    for parts, message in cases:
        with pytest.raises(cs.Error, match=message):
            cs.Model.from_assembly(parts)
    parts = two(lambda a: cad.RevoluteJoint("pin", a, Axis.Z, angular_range=(0, 90)), angle=20)
    parts[1].location = Location((0, 0, 0), (0, 0, -10))
    with pytest.raises(cs.Error, match="'pin' of 'a' and 'b' is not where its parts are"):
        cs.Model.from_assembly(parts)
    with pytest.raises(cs.Error, match="'foot' is of a part that is not in the assembly|'pin' is of a part"):
        cs.Model.from_assembly(parts[:1])


def test_a_linkage_has_joints_between_its_moving_parts():
    frame, crank, rod = (labelled(Pos(0, 0, 6 * k) * Box(30, 4, 4), n) for k, n in enumerate(("frame", "crank", "rod")))
    pin = cad.RevoluteJoint("pin", crank, Axis((12, 0, 0), (0, 0, 1)))
    cad.RevoluteJoint("shaft", frame, Axis.Z).connect_to(RigidJoint("hub", crank, Location()), angle=40)
    pin.connect_to(RigidJoint("eye", rod, Location((-12, 0, 0))), angle=300)
    plate = labelled(Box(5, 5, 2), "plate")
    RigidJoint("seat", rod, Location((3, 0, 0))).connect_to(RigidJoint("back", plate, Location()))
    info = cs.Model.from_assembly([frame, crank, rod, plate]).info()
    assert [p.name for p in info.parts] == ["frame", "crank", "rod + plate"]
    (joint,) = info.joints
    assert {*joint.parts} == {"crank", "rod + plate"}
    assert tuple(joint.at) == pytest.approx((12 * math.cos(math.radians(40)), 12 * math.sin(math.radians(40))))


SOLIDS = {
    "stepped": Box(10, 20, 4) + Pos(0, 0, 4) * Cylinder(4, 4) - Cylinder(1, 20),
    "bridge": Box(20, 4, 10) - Pos(0, 0, -2) * Box(10, 9, 4),
    "lying": Rot(0, 90, 0) * Box(3, 4, 5),
    "bored across layers": Box(20, 20, 9) - Pos(0, 0, 3) * Cylinder(6, 3) - Cylinder(2, 20),
    "two with a gap": Compound([Box(4, 4, 2), Pos(0, 0, 10) * Box(2, 2, 2)]),
    "prism of a gear": cad.extrude(gear(), 5),
}


@pytest.mark.parametrize("name", SOLIDS)
def test_layers_have_the_solids_volume_both_ways(name):
    solid = SOLIDS[name]
    part = cs.Part.from_solid(solid, name=name)
    volume = math.fsum((z[1] - z[0]) * cs.Part(loops).area for z, loops in part.layers)
    assert abs(volume - solid.volume) < 1e-8
    back = part.to_build123d()
    assert back.is_valid and abs(back.volume - solid.volume) < 1e-8
    assert cs.Part.from_solid(back).layers[0][0] == part.layers[0][0]


def test_a_section_at_a_height_is_that_of_any_solid():
    assert abs(cs.Part.from_solid(cad.Cone(5, 1, 10), z=0).area - 9 * math.pi) < 1e-9
    assert abs(cs.Part.from_solid(cad.Sphere(5), z=3).area - 16 * math.pi) < 1e-9
    with pytest.raises(cs.Error, match=r"face \d+ \(CylindricalSurface, from height .* is neither horizontal nor upright"):
        cs.Part.from_solid(cad.fillet(Box(3, 3, 3).edges().group_by(Axis.Z)[-1], 0.5))


def test_the_command_reads_step_files(tmp_path):
    block, stop = labelled(Box(10, 10, 3), "block"), labelled(Pos(12, 0, 0) * Box(10, 10, 3), "stop")
    cad.export_step(Compound(children=[block, stop], label="two"), str(tmp_path / "two.step"))
    cad.export_step(cad.Cone(3, 1, 3), str(tmp_path / "cone.step"))

    def run(*arguments):
        return subprocess.run([sys.executable, "-m", "cspace", *arguments], capture_output=True, text=True, cwd=tmp_path)

    told = run("clearance", "two.step")
    assert told.returncode == 0 and "2.000000 mm  block, stop" in told.stdout, told
    told = run("info", "cone.step")
    assert told.returncode == 2 and told.stderr.startswith("error: cone.step: ") and "cone" in told.stderr
    (tmp_path / "torn.step").write_text("ISO-10303-21;\nnothing")
    told = run("info", "torn.step")
    assert told.returncode == 2 and "error: torn.step: " in told.stderr, told
