"""Answers: against closed forms, and against the command to the last bit."""

import copy
import json
import math
import pickle
import subprocess

import numpy as np
import pytest

import cspace as cs
from conftest import PEG, ROOT


def printed(*args):
    """The answer of a command, whether it is yes or no."""
    done = subprocess.run([*args, "--json"], capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    return json.loads(done.stdout)


def test_a_coin_in_a_box():
    frame = [(-12, -12), (12, -12), (12, 12), (-12, 12)]
    hole = [(-10, -10), (10, -10), (10, 10), (-10, 10)]
    space = cs.compute(cs.Part([frame, hole], name="frame"), cs.Part.circle(1, name="coin"))
    rng = np.random.default_rng(3)
    q = rng.uniform([-16, -16, -7], [16, 16, 7], (20_000, 3))
    inside = np.abs(q[:, :2]).max(axis=1)
    # The distance of a point from the frame.
    apart = np.where(
        inside < 10,
        10 - inside,
        np.where(inside <= 12, 0, np.hypot(*np.maximum(np.abs(q[:, :2]) - 12, 0).T)),
    )
    sure = np.abs(apart - 1) > 1e-9
    expected = np.where(apart < 1, cs.BLOCKED, cs.FREE)
    found = space.classify(q)
    assert found.dtype == np.uint8
    assert (found == expected)[sure].all()
    free = found == cs.FREE
    clearance = space.clearance(q)
    assert np.allclose(clearance[free], apart[free] - 1, rtol=0, atol=1e-9)
    assert np.isnan(clearance[found == cs.BLOCKED]).all()
    # One by one the same, also once it is prepared.
    for i in range(300):
        assert space.classify(tuple(q[i])) == found[i]
        assert space.classify(q[i]) == found[i]
    caged = [r.caged for r in space.regions]
    assert sorted(caged) == [False, True]
    region = space.region(q)
    assert (region[free & (inside < 10)] == caged.index(True)).all()
    assert (region[free & (inside > 12)] == caged.index(False)).all()
    assert (region[~free] == -1).all()


def test_answers_are_those_of_the_command(command, models, tmp_path):
    path = models / "peg_hole.toml"
    model = cs.Model.load(path)
    space = model.compute(*model.pairs[0])
    told = printed(command, "compute", str(path))
    assert len(space.patches) == told["pairs"][0]["patches"]
    rng = np.random.default_rng(5)
    (x0, y0, x1, y1), size = space.fixed.bounds, 1.0
    q = rng.uniform([x0 - size, y0 - size, -math.pi], [x1 + size, y1 + size, math.pi], (300, 3))
    rows = "x,y,theta\n" + "".join(f"{x!r},{y!r},{t!r}\n" for x, y, t in q.tolist())
    out = subprocess.run([command, "classify", str(path)], input=rows, capture_output=True, text=True, check=True)
    names = ["free", "blocked", "contact"]
    classes = [line.rsplit(",", 1)[1] for line in out.stdout.split()[1:]]
    assert classes == [names[c] for c in space.classify(q)]
    start, by = [0, 60, 0.02], [0, -80, 0]
    told = printed(
        command, "play", str(path), "--at=" + ",".join(map(str, start)), "--by=" + ",".join(map(str, by))
    )
    told = told["pairs"][0]["motion"]
    moved = space.move(start, by)
    assert (moved.outcome, moved.fraction) == (told["result"], told["fraction"])
    assert moved.to_dict()["touching"] == told["touching"]


def test_requirements_are_those_of_the_command(command, peg, tmp_path):
    file = tmp_path / "peg.toml"
    file.write_text(PEG)
    told = printed(command, "check", str(file), "--sensitivities", "--set", "play=0.08")
    found = peg(play=0.08).check(sensitivities=True)
    for row in told["requirements"]:
        checked = found[row["name"]]
        assert checked.value == row["value"] and checked.met == row["met"] and checked.margin == row["margin"]
        assert checked == row and checked.sensitivities == row["sensitivities"]
    rows = printed(command, "sweep", str(file), "--vary", "play=0.05:0.25:5", "--measure", "tilt")["rows"]
    table = peg.sweep(["tilt"], play=[r["play"] for r in rows])
    assert table["tilt"].tolist() == [r["tilt"] for r in rows]
    solved = printed(command, "solve", str(file), "--vary", "play=0.01:0.5", "--so-that", "tilt = 0.01")
    assert peg.solve("tilt", "=", 0.01, play=(0.01, 0.5)).solutions == solved["solutions"]


def test_simulations_are_those_of_the_command(command, models):
    path = models / "geneva.toml"
    told = printed(command, "simulate", str(path), "--time", "3")
    found = cs.simulate(cs.Model.load(path), 3)
    assert found.status == told["status"] and json.loads(json.dumps(found.events)) == told["events"]
    for name in told["parts"]:
        assert found.coordinates[name].tolist() == [s[name] for s in told["samples"]]


def test_any_name_of_a_parameter_is_given():
    """What is called as an argument, as a keyword, or as no word at all is given in a dictionary."""
    text = """
[parameter]
self = 1
set = 1
measures = 1
rows = 1
value = 1
vary = 1
lambda = 1
[[part]]
name = "table"
loops = [[[-9, -9], [9, -9], [9, 0], [-9, 0]]]
[[part]]
name = "coin"
loops = [{ circle = "self + set + measures + rows + value + vary + lambda", at = [0, 0] }]
[[requirement]]
name = "apart"
measure = "clearance"
pair = ["table", "coin"]
at = { y = 20 }
"""
    model = cs.Model.loads(text)
    for name in model.parameters:
        assert model({name: 3}).parameters[name] == model(set={name: 3}).parameters[name] == 3
        assert np.allclose(model.sweep(vary={name: [1, 2]})["apart"], [13, 12])
        assert model.solve("apart", "=", 12.5, vary={name: (1, 2)}).solutions == [{name: pytest.approx(1.5)}]
    assert model({"rows": 3}, measures=2).parameters["measures"] == 2
    assert cs.sweep(lambda map, rows: map * rows, vary={"map": [1, 2], "rows": 3})["value"].tolist() == [3, 6]
    assert len(cs.monte_carlo(lambda seed, samples: samples, 5, vary={"samples": cs.distributions.normal(0, 1)})["samples"]) == 5
    for wrong, said in (
        (lambda: model(set=3), "`set` is 3: give a dictionary"),
        (lambda: model({"rows": 3}, rows=3), "rows is given twice"),
        (lambda: model.sweep(vary=[1]), "`vary` is .*: give a dictionary"),
        (lambda: model.solve("apart", "=", 1, vary={3: (0, 1)}), "`vary` is"),
    ):
        with pytest.raises(cs.Error, match=said):
            wrong()


def test_plans_and_proofs(peg):
    space = peg.compute()
    inside, outside = (0, -15, 0), (0, 40, 0)
    plan = space.plan(inside, outside, widest=True)
    assert plan and plan.verdict == "path"
    assert plan.path.shape[1] == 3 and (space.classify(plan.path) == cs.FREE).all()
    assert math.isclose(plan.clearance, 0.05, rel_tol=1e-5)
    tight = peg(play=-0.1).compute()
    assert tight.plan(inside, outside).verdict == "from-blocked"
    ball = cs.Part([[(-5, -5), (5, -5), (5, 5), (-5, 5)], [(-3, -3), (3, -3), (3, 3), (-3, 3)]])
    caged = cs.compute(ball, cs.Part.circle(1)).plan((0, 0, 0), (20, 0, 0))
    assert caged.verdict == "no-path" and not caged and caged.touching


def test_play_and_nearest(peg):
    space = peg.compute()
    play = space.play((0, -15, 0))
    assert math.isclose(play["x"].length, 0.1, rel_tol=1e-9)
    assert math.isclose(play["theta"].length, peg.check()["tilt"].value, rel_tol=1e-12)
    assert play["y"].upper == math.inf and math.isclose(play["y"].lower, -21, rel_tol=1e-12)
    nearest = space.nearest((0.02, -15, 0))
    assert math.isclose(nearest.distance, 0.03, abs_tol=1e-9)


def test_motions_from_afar():
    space = cs.compute(cs.Part.rectangle(4, 4), cs.Part.circle(1))
    for far in (1e2, 1e5, 1e6, 1e7, 1e9):
        moved = space.move((far, 0.3, 0.1), (-2 * far, 0, 0))
        assert moved.outcome == "contact" and math.isclose(moved.at[0], 3, abs_tol=1e-12 * far)
        assert math.isclose(space.play((far, 0.3, 0.1))["x"].lower, 3, abs_tol=1e-12 * far)
        assert space.move((far, 4, 0), (-2 * far, 0, 0)).outcome == "free"
        assert space.move((far, 0, 0), (2 * far, 0, 1)).outcome == "free"


def test_slices_meshes_and_links():
    space = cs.compute(cs.Part.rectangle(4, 2, name="table"), cs.Part.circle(1))
    (loop,) = space.slice(0.3)
    # A rectangle grown by a disc: four sides, and arcs that turn once in all.
    assert sum(b == 0 for _, _, b in loop) == 4
    assert math.isclose(sum(4 * math.atan(b) for _, _, b in loop), 2 * math.pi, rel_tol=1e-9)
    grown = cs.Part([loop])
    assert math.isclose(grown.area, 8 + 2 * (4 + 2) + math.pi, rel_tol=1e-9)
    vertices, faces = space.mesh()
    assert vertices.shape[1] == 3 and faces.shape[1] == 3 and faces.max() < len(vertices)
    first, second, lo, hi = space.links()
    assert first.shape == second.shape == lo.shape == hi.shape
    assert max(first.max(), second.max()) < len(space.patches)


def test_parts():
    plate = cs.Part([[(0, 0), (40, 0), (40, 20), (0, 20)], {"circle": 3, "at": [10, 10]}], name="plate")
    assert math.isclose(plate.area, 800 - 9 * math.pi)
    assert plate.bounds == (0, 0, 40, 20)
    assert plate.contains(1, 1) and not plate.contains(10, 10)
    assert cs.Part(np.array([[[0, 0], [4, 0], [4, 3]]]), name="t") == cs.Part([[(0, 0), (4, 0), (4, 3)]], name="t")
    (points,) = cs.Part.circle(5).points(0.01)
    radii = np.hypot(*np.array(points).T)
    assert np.allclose(radii, 5)
    ends = np.array(points + points[:1])
    middles = (ends[1:] + ends[:-1]) / 2
    assert 0 < 5 - np.hypot(*middles.T).min() <= 0.01
    assert "<path" in plate._repr_svg_() and "A3 3 0" in plate._repr_svg_()
    grown = plate.offset(1)
    assert math.isclose(grown.area, 800 + 2 * 60 + math.pi - 4 * math.pi, rel_tol=1e-9)
    with pytest.raises(cs.Error, match="finite number"):
        plate.offset(math.nan)


def test_drawings(tmp_path):
    drawn = cs.Part.from_dxf(ROOT / "crates/cspace-drawing/tests/drawings/slot_r2000.dxf", name="slot")
    assert drawn.area > 0 and drawn.name == "slot"
    file = tmp_path / "plate.svg"
    file.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="40" height="40"><circle cx="9" cy="9" r="5"/></svg>')
    assert math.isclose(cs.Part.from_svg(file, scale=1).area, 25 * math.pi, rel_tol=1e-9)
    with pytest.raises(cs.Error, match="nowhere.dxf"):
        cs.Part.from_dxf("nowhere.dxf")


def test_shapely():
    pytest.importorskip("shapely")
    plate = cs.Part([[(0, 0), (40, 0), (40, 20), (0, 20)], {"circle": 3, "at": [10, 10]}])
    shape = plate.to_shapely(1e-4)
    assert math.isclose(shape.area, plate.area, rel_tol=1e-4)
    assert math.isclose(cs.Part.from_shapely(shape).area, shape.area, rel_tol=1e-12)


def test_threads_make_no_difference(peg):
    q = np.random.default_rng(1).uniform(-20, 20, (30_000, 3))
    found = []
    for threads in (1, 2, 0):
        cs.set_threads(threads)
        space = peg.compute()
        found.append((space.classify(q).tobytes(), space.clearance(q[:500]).tobytes(), space.patches))
    assert found[0] == found[1] == found[2]


def test_tolerances_are_those_of_the_command(models, command):
    """Worst cases, margin and samples of a shipped model."""
    model = cs.Model.load(models / "tolerances" / "geneva_lock.toml")
    found = model.tolerances("dwell", samples=2000, seed=3)["dwell"]
    options = ["--samples", "2000", "--seed", "3"]
    told = printed(command, "tolerances", str(models / "tolerances" / "geneva_lock.toml"), *options)["requirements"][0]
    assert found == told and found.exact == told["exact"] and found.monte_carlo == told["monte_carlo"]
    assert found.margin == told["margin"] and abs(found.exact["lo"]["value"] - 0.0018991519) < 1e-9
    assert model.tolerances()["dwell"].linear == found.linear
    with pytest.raises(cs.Error, match="no such requirement"):
        model.tolerances("dwel")
    with pytest.raises(cs.Error, match="`samples` is -1"):
        model.tolerances(samples=-1)


def test_modes_are_those_of_the_command(models, command):
    """All that is told of three parts, in their order or another, and what is no three parts or no configuration."""
    file = str(models / "shift_interlock.toml")
    model = cs.Model.load(file)
    names = ["second rail", "plunger", "first rail"]
    for parts, options in ((None, ["--at", "u=8"]), (names, ["--parts", ",".join(names), "--at", "u=8"])):
        found = model.modes(parts, at=(8, 0, 0))
        told = printed(command, "modes", file, *options)
        del told["seconds"], found["seconds"]
        assert found == told and json.loads(json.dumps(found.to_dict())) == told
        assert [part["name"] for part in found.parts] == (names if parts else names[::-1])
    assert model.modes().requested["mode"] == 0 and found.doubts == 0
    for wrong, said in (
        ({"parts": names[:2]}, "`parts` is .* where three names"),
        ({"parts": "abc"}, "`parts` is 'abc' where three names"),
        ({"parts": ["first rail", "plunger", "rail"]}, "there is no part \"?rail"),
        ({"parts": ["plunger", "plunger", "first rail"]}, "is named twice"),
        ({"at": (1, 2)}, "`at` is .* where three numbers"),
        ({"at": (0, 0, float("nan"))}, "`at` is nan"),
    ):
        with pytest.raises(cs.Error, match=said):
            model.modes(**wrong)


def test_answers_about_one_pair_are_whole(models):
    """A path is an answer with its frame, whose pair is near at hand; wrong arguments are named as they are called here."""
    model = cs.Model.load(models / "peg_hole.toml")
    names = model.pairs[0]
    plan = model.plan((40, 30, 0), (0, 2, 0), pair=names)
    assert plan.outcome == "path" and plan.units.length == "mm" and plan.path.shape[1] == 3
    assert plan["clearance"] == plan.pairs[0].clearance > 0 and plan.gap is None and set(plan.to_dict()) == set(plan)
    assert copy.copy(plan) == pickle.loads(pickle.dumps(plan)) == plan.copy() == plan
    with pytest.raises(AttributeError, match="takes no 'gap'"):
        plan.gap = 1
    for wrong, said in (
        (lambda: model.plan((1, 2)), "`start`"),
        (lambda: model.plan((40, 30, None)), "`start` is .*: give one configuration"),
        (lambda: model.plan((40, 30, 0), clearance=-1), "`clearance` is -1"),
        (lambda: model.plan((40, 30, 0), clearance=math.nan), "`clearance` is nan"),
        (lambda: model.plan((40, 30, 0), clearance=1, widest=True), "`widest` and `clearance` are both given"),
        (lambda: model.clearance(within=math.nan), "`within` is nan"),
        (lambda: model.play(pair=3), "`pair` is 3: give the names"),
        (lambda: model.play(np.zeros((3, 3))), "`at` is"),
    ):
        with pytest.raises(cs.Error, match=said):
            wrong()


def test_nothing_infinite_is_solved(peg):
    for value, ends in ((math.inf, (0.01, 0.5)), (0.01, (0.01, math.inf))):
        with pytest.raises(cs.Error, match="finite"):
            peg.solve("tilt", "=", value, play=ends)
    assert peg.solve("tilt", ">=", 1e308, play=(0.01, 0.5)).outcome == "none"
