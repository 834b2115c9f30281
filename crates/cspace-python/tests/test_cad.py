"""Parts of edges and of CAD. Objects of build123d, CadQuery and FreeCAD are replayed as record.py found them, with OCCT's own figures."""

import cmath
import json
import math
import pathlib
import random
import sys

import numpy as np
import pytest

import cspace as cs
from cspace import _assembly, _step
from cspace._wires import JOIN
from replay import Replay

RECORDED = pathlib.Path(__file__).parent / "recorded"
TOL = 1e-3
# Of these lines and arcs are fitted.
CURVED = {"ellipse", "cam", "bezier", "front"}


@pytest.fixture(params=["build123d", "cadquery", "freecad"])
def tape(request, monkeypatch):
    replayed = Replay(RECORDED / f"{request.param}.json")
    monkeypatch.setitem(sys.modules, request.param, replayed.roots["module"])
    return replayed.roots


@pytest.fixture
def mechanisms(monkeypatch):
    replayed = Replay(RECORDED / "build123d.json")
    monkeypatch.setitem(sys.modules, "build123d", replayed.roots["module"])
    return replayed.roots["assemblies"]


@pytest.fixture
def hinge(mechanisms):
    return mechanisms["hinge"]


def test_planar_faces_have_the_area_and_the_length_that_occt_finds(tape):
    assert len(tape["faces"]) >= 4
    for name, face in tape["faces"].items():
        area, length = tape["areas"][name]
        part = cs.Part.from_cad(face, tol=TOL, name=name)
        assert part.name == name
        if name not in CURVED:
            assert part.fitted == 0.0 and "within" not in repr(part)
            assert abs(part.area - area) < 1e-9 and abs(part.outline.length - length) < 1e-9, name
            continue
        # What lies between two curves at most so far apart.
        assert 0 < part.fitted <= TOL and "of its curves" in repr(part), name
        assert abs(part.area - area) <= 2 * part.fitted * length, name
        # Beside a curve that turns once by all of it.
        assert abs(part.outline.length - length) < 1.1 * math.tau * part.fitted, name
        finer = cs.Part.from_cad(face, tol=TOL / 100)
        assert finer.fitted <= TOL / 100 and abs(finer.area - area) <= 2 * finer.fitted * length, name


def test_solids_have_the_volume_that_occt_finds_in_layers(tape):
    part = cs.Part.from_solid(tape["solids"]["stepped"], name="stepped")
    assert len(part.layers) == 2
    volume = math.fsum((z[1] - z[0]) * cs.Part(loops).area for z, loops in part.layers)
    assert abs(volume - tape["volumes"]["stepped"]) < 1e-9
    (lo, middle), (same, hi) = (z for z, _ in part.layers)
    assert middle == same and hi - lo == 8.0
    with pytest.raises(cs.Error, match=r"face \d+ \(Plane.*\) is at `z`"):
        cs.Part.from_solid(tape["solids"]["stepped"], z=middle)
    with pytest.raises(cs.Error, match="the solid is not at `z`, 99"):
        cs.Part.from_solid(tape["solids"]["stepped"], z=99)


def test_a_solid_is_no_face_and_a_face_no_solid(tape):
    with pytest.raises(cs.Error, match="is a solid\nhelp: Part.from_solid"):
        cs.Part.from_cad(tape["solids"]["stepped"])
    (face, *_) = tape["faces"].values()
    with pytest.raises(cs.Error, match="is not one solid\nhelp: Part.from_cad"):
        cs.Part.from_solid(face)


def test_a_face_that_leans_is_named():
    tape = Replay(RECORDED / "build123d.json").roots
    with pytest.raises(cs.Error, match=r"face \d \(cone, from height -5 to 5\) is neither horizontal nor upright"):
        cs.Part.from_solid(tape["solids"]["cone"])


def test_a_face_is_seen_from_the_front_unless_another_plane_is_given():
    gusset = Replay(RECORDED / "build123d.json").roots["faces"]["upright gusset"]
    assert cs.Part.from_cad(gusset).bounds == pytest.approx((0, 0, 30, 20), abs=1e-12)
    behind = cs.Part.from_cad(gusset, plane=((0, 0, 0), (-1, 0, 0), (0, 1, 0)))
    assert behind.bounds == pytest.approx((-30, 0, 0, 20), abs=1e-12)
    with pytest.raises(cs.Error, match=r"not in one plane: it is 30 high along \(1, 0, 0\)"):
        cs.Part.from_cad(gusset, plane=((0, 0, 0), (0, 1, 0), (1, 0, 0)))
    for plane in (((0, 0, 0), (0, 0, 1), (0, 0, 1)), "XY", 3):
        with pytest.raises(cs.Error, match="plane"):
            cs.Part.from_cad(gusset, plane=plane)


def test_what_is_no_shape_is_refused():
    for given in (3, None, "plate", [None]):
        with pytest.raises(cs.Error, match="no shape of build123d, CadQuery or FreeCAD"):
            cs.Part.from_cad(given)


def test_fitted_arcs_are_as_far_from_an_ellipse_as_is_said():
    part = cs.Part.from_cad(Replay(RECORDED / "build123d.json").roots["faces"]["ellipse"])
    loops, turns = cs.Loops(part.loops), np.linspace(0, math.tau, 20_001)
    off = max(loops.distance(10 * math.cos(t), 5 * math.sin(t)) for t in turns)
    assert 0.9 * part.fitted <= off <= part.fitted
    # And none of them leaves the ellipse: the level is divided by its slope.
    for x, y in part.points(1e-4)[0]:
        level, slope = (x / 10) ** 2 + (y / 5) ** 2 - 1, math.hypot(x / 50, 2 * y / 25)
        assert abs(level) / slope < TOL + 2e-4


def test_fitted_is_told_of_that_part_alone():
    part = cs.Part.from_cad(Replay(RECORDED / "build123d.json").roots["faces"]["cam"])
    assert part.fitted and part.offset(1).fitted is None and cs.Part.circle(1).fitted is None


# Edges.

SLOT = [((0, 0), (9, 0)), ((9, 4), (9, 0), (11, 2)), ((0, 4), (9, 4)), ((0, 4), (0, 0), (-2, 2))]


def test_the_order_and_the_direction_of_edges_do_not_matter():
    flat = [(0, 0), (9, 0), (0, 4), (9, 4)]
    rng = random.Random(4)
    for _ in range(50):
        edges = [(e[1], e[0], *e[2:]) if rng.random() < 0.5 else e for e in rng.sample(SLOT, 4)]
        part = cs.Part.from_edges([edges])
        assert abs(part.area - (36 + 4 * math.pi)) < 1e-12
        assert sorted((x, y) for x, y, _ in part.loops[0]) == sorted(flat)


def test_a_middle_is_any_point_of_an_arc():
    for turn in (0.01, 1.0, math.pi, 4.0, 6.2):
        start, end = cmath.rect(3, 0.4), cmath.rect(3, 0.4 + turn)
        for share in (0.01, 0.3, 0.99):
            middle = cmath.rect(3, 0.4 + share * turn)
            a, b, m = ((p.real, p.imag) for p in (start, end, middle))
            part = cs.Part.from_edges([[(a, b, m), (b, a)]])
            assert abs(part.area - 4.5 * (turn - math.sin(turn))) < 1e-10, (turn, share)


def test_circles_and_holes():
    part = cs.Part.from_edges([[((5, 0), (5, 0), (-5, 0))], [((1, 0), (0, 1)), ((0, 1), (0, 0)), ((1, 0), (0, 0), None)]])
    assert abs(part.area - (25 * math.pi - 0.5)) < 1e-12 and part.fitted == 0.0


def test_points_are_those_of_a_spline():
    turns = np.linspace(0, math.pi, 200)[1:-1]
    part = cs.Part.from_edges([[((3, 0), (-3, 0), [(3 * math.cos(t), 3 * math.sin(t)) for t in turns]), ((3, 0), (-3, 0))]])
    assert 0 <= part.fitted <= TOL and abs(part.area - 4.5 * math.pi) < 3 * math.pi * (TOL + 1e-6)
    ring = [(3 * math.cos(t), 3 * math.sin(t)) for t in np.linspace(0, math.tau, 400)[1:-1]]
    assert abs(cs.Part.from_edges([[((3, 0), (3, 0), np.array(ring))]]).area - 9 * math.pi) < 6 * math.pi * (TOL + 1e-6)


@pytest.mark.parametrize(
    ("wires", "message"),
    [
        ([], "there are no wires"),
        ([SLOT, []], "wire 1 has no edges"),
        ([SLOT[:3]], r"edge 2 of wire 0 ends at \(0, 4\), 4 from the nearest end that is left, of edge 0: more than `join`, 2e-07"),
        ([SLOT, [((1, 1), (2, 1)), ((2, 1.25), (1, 1))]], r"edge 0 of wire 1 ends at \(2, 1\), 0.25 from .* edge 1"),
        ([[((0, 0),)]], "edge 0 of wire 0 is no edge"),
        ([[((0, 0), (1, 0), (2, 0), 4)]], "it has 4 entries"),
        ([[((0, 0), (1, math.nan))]], "is not finite"),
        ([[((0, 0), (1, 0), (1, 0))]], "its middle point is at an end"),
        ([SLOT, SLOT], "two edges lie on each other"),
        ([SLOT, [((1, 1), (1, 1), (3, 9))]], "wire 0, wire 1, at .*: outlines cross here"),
    ],
)
def test_what_is_wrong_with_edges_is_named(wires, message):
    with pytest.raises(cs.Error, match=message):
        cs.Part.from_edges(wires)


def test_gaps_are_closed_within_join_alone():
    def gap(by):
        return [((0, 0), (9, 0)), ((9, by), (0, 4)), ((0, 4), (0, 0))]

    assert abs(cs.Part.from_edges([gap(0.9 * JOIN)]).area - 18) < 1e-5
    with pytest.raises(cs.Error, match="more than `join`"):
        cs.Part.from_edges([gap(1.1 * JOIN)])
    assert abs(cs.Part.from_edges([gap(0.1)], join=0.2).area - 18) < 1
    with pytest.raises(cs.Error, match="`tol` is 0"):
        cs.Part.from_edges([SLOT], tol=0)


# Assemblies.


def test_a_joint_becomes_a_motion_with_its_range(hinge):
    made = _assembly.model(hinge, TOL, None, None, None, JOIN)[0]
    base, arm, bolt = made["part"]
    assert base["motion"] == {"type": "fixed"}
    assert arm["motion"]["type"] == "revolute" and np.allclose(arm["motion"]["center"], 0, atol=1e-12)
    assert np.allclose(arm["motion"]["range"], np.radians([-40, 80]), atol=1e-12)
    assert bolt["motion"]["direction"] == [1, 0] and np.allclose(bolt["motion"]["range"], [-8, 12], atol=1e-12)


def test_a_joint_whose_axis_points_down_turns_the_other_way(mechanisms):
    def ranges(ground):
        made = _assembly.model(mechanisms["door"], TOL, None, ground, None, JOIN)[0]
        return {p["name"]: p["motion"].get("range") for p in made["part"]}

    # 30° of 120° have passed, clockwise.
    assert np.allclose(ranges(None)["leaf"], np.radians([-90, 30]), atol=1e-12) and ranges(None)["post"] is None
    assert np.allclose(ranges("leaf")["post"], np.radians([-30, 90]), atol=1e-12)


def test_a_hinge_turns_until_its_arm_meets_the_base(hinge):
    model = cs.Model.from_assembly(hinge)
    pair = next(p for p in model.clearance().pairs if {p.fixed, p.moving} == {"base", "arm"})
    lo, hi = pair.reach["arm"]
    # The corner (35, 3) of the arm, drawn at 10°, meets the bar at y = 10.
    meets = math.asin(10 / math.hypot(35, 3)) - math.atan2(3, 35) - math.radians(10)
    assert abs(hi - meets) < 1e-9 and abs(lo + math.radians(40)) < 1e-9
    assert [end.end for end in pair.stopped] == ["hi"]


def test_what_cannot_be_a_mechanism_is_named(hinge):
    cases = [
        ({"ground": "frame"}, "there is no part named 'frame'\nhelp: the parts are base, arm, bolt"),
        ({"motion": {"lid": {}}}, "there is no part named 'lid'"),
        ({"ground": "bolt"}, "the joint 'hinge' of 'base' and 'arm' has a range, and neither part stands still"),
    ]
    for given, message in cases:
        with pytest.raises(cs.Error, match=message):
            cs.Model.from_assembly(hinge, **given)


def test_parts_of_cadquery_are_free_unless_a_motion_is_given(monkeypatch):
    tape = Replay(RECORDED / "cadquery.json").roots
    monkeypatch.setitem(sys.modules, "cadquery", tape["module"])
    two = tape["assemblies"]["two"]
    base, arm = _assembly.model(two, TOL, None, None, None, JOIN)[0]["part"]
    assert (base["name"], base["motion"]) == ("base", {"type": "fixed"}) and (arm["name"], arm["motion"]) == ("arm", {"type": "planar"})
    model = cs.Model.from_assembly(two, motion={"arm": {"type": "revolute", "center": [20, 0]}})
    (pair,) = model.clearance().pairs
    # The arm's corners are hypot(5, 2.5) from its axis, which is 15 from the base.
    assert pair.over == "ranges" and abs(pair.gap - (15 - math.hypot(5, 2.5))) < 1e-9


def test_objects_of_a_freecad_document_stand_where_they_are():
    two = Replay(RECORDED / "freecad.json").roots["assemblies"]["two"]
    (pair,) = cs.Model.from_assembly(two).clearance().pairs
    # Boxes of FreeCAD are cubes of 10 from their corner.
    assert (pair.fixed, pair.moving) == ("Block", "Stop") and abs(pair.gap - 2) < 1e-12


# STEP files.


def test_a_step_file_is_read_into_a_model_that_has_its_name(hinge, monkeypatch, tmp_path, capfdbinary):
    monkeypatch.setattr(_step, "_read", lambda path: hinge)
    file = str(tmp_path / "hinge.STEP")
    assert _step.run(["info", file, "--json"]) == 0
    assert [part["name"] for part in json.loads(capfdbinary.readouterr().out)["parts"]] == ["base", "arm", "bolt"]
    assert _step.run(["info", file, "--set", "pin=3"]) == 2
    said = capfdbinary.readouterr()
    assert file.encode() in said.err and b".json" not in said.err


def test_a_step_file_that_cannot_be_read_is_named(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(_step.importlib.util, "find_spec", lambda name: None)
    missing, there = str(tmp_path / "none.stp"), tmp_path / "plate.step"
    there.write_text("ISO-10303-21;")
    assert _step.run(["clearance", missing]) == 2
    assert capsys.readouterr().err == f"error: {missing}: there is no such file\n  help: check the path\n"
    assert _step.run(["clearance", "--json", str(there)]) == 2
    error = json.loads(capsys.readouterr().out)["error"]
    assert error["message"].startswith(f"{there}: STEP files are read by") and error["help"] == "pip install build123d"
