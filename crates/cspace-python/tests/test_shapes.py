"""Parts moved, mirrored and scaled; models of dictionaries and back; where the parts of a mechanism are; spaces that were saved."""

import cmath
import json
import math
import pickle
import subprocess

import numpy as np
import pytest

import cspace as cs
from conftest import CAM, PEG, ROOT

PLATE = cs.Part([[(0, 0, 0.3), (40, 0), (40, 20, -0.2), (0, 20)], {"circle": 3, "at": [10, 10]}], name="plate")
NAMED = {"name": "key", "loops": [[[0, 0], [4, 0], [4, 3], [0, 3]]], "names": {"line 1 of loop 0": "flank"}}
ARBOR = cs.Part.stack([cs.Part([{"circle": 9, "at": [0, 0]}], z=(0, 4)), cs.Part([{"circle": 2, "at": [1, 0]}], z=(4, 10))], name="arbor")


def test_parts_are_moved_as_their_spaces_say():
    moved = PLATE.moved(3, -2, 0.7)
    turn = cmath.rect(1, 0.7)
    for ours, theirs in zip(moved.points(1e-2), PLATE.points(1e-2)):
        images = [turn * complex(*p) + complex(3, -2) for p in theirs]
        assert np.allclose([complex(*p) for p in ours], images, rtol=0, atol=1e-13)
    assert math.isclose(moved.area, PLATE.area, rel_tol=1e-14) and moved.name == "plate"
    coin = cs.Part.circle(1)
    space, there = cs.compute(PLATE, coin), cs.compute(moved, coin)
    for x, y in np.random.default_rng(2).uniform(-10, 45, (50, 2)):
        image = turn * complex(x, y) + complex(3, -2)
        assert space.clearance((x, y, 0)) == pytest.approx(there.clearance((image.real, image.imag, 0)), abs=1e-9, nan_ok=True)


def test_mirror_images():
    for direction, image in [
        ((1, 0), lambda x, y: (x, -y)),
        ((0, -3), lambda x, y: (-x, y)),
        ((2, 2), lambda x, y: (y, x)),
    ]:
        mirrored = PLATE.mirrored(direction)
        assert [[image(x, y) for x, y, _ in loop] for loop in PLATE.loops] == [[(x, y) for x, y, _ in loop] for loop in mirrored.loops]
        assert math.isclose(mirrored.area, PLATE.area, rel_tol=1e-14)
        for x, y in np.random.default_rng(3).uniform(-5, 45, (200, 2)):
            assert PLATE.contains(x, y) == mirrored.contains(*image(x, y))
        assert mirrored.mirrored(direction) == PLATE
    # As a model file mirrors.
    told = {"part": [{"name": "plate", "loops": PLATE.loops, "place": {"mirror": "x"}}]}
    assert cs.Model.from_dict(told).parts["plate"].loops == PLATE.mirrored((1, 0)).loops
    assert PLATE.mirrored((0, 1), origin=(50, 7)).bounds == pytest.approx((60, *PLATE.bounds[1:2], 100, PLATE.bounds[3]))
    for wrong, said in ((lambda: PLATE.mirrored((0, 0)), "no direction"), (lambda: PLATE.mirrored("x"), "`direction`")):
        with pytest.raises(cs.Error, match=said):
            wrong()


def test_scaled_parts_and_centroids():
    large = PLATE.scaled(2, origin=(10, 10))
    assert math.isclose(large.area, 4 * PLATE.area, rel_tol=1e-14) and large.loops[1][0][:2] == (4, 10)
    assert large.centroid == pytest.approx([10 + 2 * (c - 10) for c in PLATE.centroid])
    shapely = pytest.importorskip("shapely")
    assert PLATE.centroid == pytest.approx((PLATE.to_shapely(1e-4).centroid.x, PLATE.to_shapely(1e-4).centroid.y), abs=1e-3), shapely
    for wrong in (0, -1, math.inf, "a"):
        with pytest.raises(cs.Error, match="`factor`"):
            PLATE.scaled(wrong)
    with pytest.raises(cs.Error, match="`width` is 0"):
        cs.Part.rectangle(0, 1)
    with pytest.raises(cs.Error, match="a number that is not finite"):
        cs.Part([[(0, 0), (1, 0), (0, math.nan)]])


def test_heights_and_names_stay():
    named = cs.Model.from_dict({"part": [NAMED]}).parts["key"]
    for part in (named, named.moved(1, 2, 3), named.mirrored((1, 1)), named.scaled(3), pickle.loads(pickle.dumps(named))):
        assert part.feature("flank").kind == "line" and part.feature("flank").loop == 0
    for part in (ARBOR.moved(5, 0), ARBOR.scaled(0.5), pickle.loads(pickle.dumps(ARBOR))):
        assert [z for z, _ in part.layers] == [(0, 4), (4, 10)]
    # The pinion is no hole in the wheel.
    assert math.isclose(ARBOR.outline.area, math.pi * (81 + 4), rel_tol=1e-14)
    assert pickle.loads(pickle.dumps(ARBOR)) == ARBOR != cs.Part(ARBOR.loops[:1], name="arbor")
    assert len({ARBOR, pickle.loads(pickle.dumps(ARBOR)), PLATE}) == 2


def test_models_are_made_of_dictionaries():
    model = cs.Model.from_dict({"unit": "mm", "part": [NAMED, {"name": "coin", "loops": [{"circle": np.float64(2), "at": np.zeros(2)}]}]})
    assert model.unit == "mm" and model.compute().moving.name == "coin" and pickle.loads(pickle.dumps(model)).to_dict() == model.to_dict()
    assert cs.Model.from_dict({"part": [{"name": "plate", "loops": PLATE.outline}]}).parts["plate"].area == PLATE.area
    for text, name in ((CAM, "cam.toml"), (PEG, "peg.toml"), (json.dumps({"part": [NAMED]}), "key.json")):
        told = cs.Model.loads(text, name)
        again = cs.Model.from_dict(told.to_dict())
        assert again.parts == told.parts and again.pairs == told.pairs and again.parameters == told.parameters
        if told.requirements:
            assert [row.value for row in again.check().requirements] == [row.value for row in told.check().requirements]
    peg = cs.Model.loads(PEG)(play=0.2)
    assert cs.Model.from_dict(peg.to_dict()).parameters == peg.parameters == {**cs.Model.loads(PEG).parameters, "play": 0.2}
    drawn = {"part": [{"name": "slot", "dxf": "slot_r2000.dxf"}]}
    folder = ROOT / "crates/cspace-drawing/tests/drawings"
    assert cs.Model.from_dict(drawn, folder).parts["slot"].area == cs.Part.from_dxf(folder / "slot_r2000.dxf").area


def test_errors_in_a_dictionary_name_no_text():
    def part(loops, **keys):
        return {"part": [{"name": "key", "loops": loops, **keys}]}

    for given, said in (
        (part([[[0, 0], [4, 0], [4, "x"]]]), '^part 0 "key", loop 0, vertex 2'),
        (part([[[0, 0], [4, 0], [4, 3]]], nmae=1), 'unknown key "nmae"\nhelp: did you mean `name`'),
        (part([[[0, 0], [4, 0], [4, math.nan]]]), "not finite"),
        (part([[[0, 0], [4, 0], [4, object()]]]), "no number, text, list or dictionary"),
        ({}, "^the model has no parts"),
        ([1], "give a dictionary"),
    ):
        with pytest.raises(cs.Error, match=said) as caught:
            cs.Model.from_dict(given)
        assert "model.json" not in str(caught.value)
    with pytest.raises(cs.Error, match="^the model has no requirements"):
        cs.Model.from_dict({"part": [NAMED]}).check()
    with pytest.raises(cs.Error, match='^part 0 "plate"'):
        cs.Part([[(0, 0), (1, 1)]], name="plate")
    with pytest.raises(cs.Error, match="there is no part named 'pegg': the parts are slot, peg"):
        cs.Model.loads(PEG).parts["pegg"]


def test_parts_have_poses():
    """Against the definitions: a turn takes q to c + R (q - c), a slide to q + t d / |d|, and a configuration is a pose itself."""
    model = cs.Model.from_dict(
        {
            "part": [
                {"name": "frame", "loops": PLATE.loops, "motion": {"type": "fixed"}},
                {"name": "wheel", "loops": [{"circle": 2, "at": [60, 5]}], "motion": {"type": "revolute", "center": [60, 4]}},
                {"name": "slide", "loops": [{"circle": 2, "at": [90, 0]}], "motion": {"type": "prismatic", "direction": [3, 4]}},
                {"name": "loose", "loops": [{"circle": 2, "at": [0, 90]}]},
            ]
        }
    )
    t, free = np.linspace(-3, 3, 7), np.random.default_rng(1).uniform(-3, 3, (7, 3))
    poses = model.poses({"wheel": t, "slide": t, "loose": free})
    assert poses["frame"].tolist() == [0, 0, 0] and np.array_equal(poses["loose"], free)
    about = 60 + 4j
    shift = about - np.exp(1j * t) * about
    assert np.allclose(poses["wheel"], np.column_stack([shift.real, shift.imag, t]), rtol=0, atol=1e-13)
    assert np.allclose(poses["slide"], np.column_stack([0.6 * t, 0.8 * t, 0 * t]), rtol=0, atol=1e-15)
    assert model.poses({"wheel": 0.5})["wheel"].shape == (3,) and set(model.poses()) == set(model.parts)
    space = model.compute("wheel", "slide")
    fixed, moving = space.poses(np.column_stack([t, t[::-1]]))
    assert np.array_equal(fixed, poses["wheel"]) and np.array_equal(moving, poses["slide"][::-1])
    assert [pose.shape for pose in space.poses((0.1, 0.2))] == [(3,), (3,)]
    for wrong, said in (
        ({"frame": 1}, "frame does not move"),
        ({"wheeel": 1}, 'no part named "wheeel"'),
        ({"wheel": (1, 2, 3, math.nan)}, "wheel are not a number or an array of n"),
        ({"loose": (1, 2)}, "loose are not .x, y, theta."),
        ({"slide": np.zeros((2, 2))}, "slide are not"),
    ):
        with pytest.raises(cs.Error, match=said):
            model.poses(wrong)


@pytest.mark.parametrize("name", ["peg_hole", "cam_plate", "latch_box"])
def test_saved_spaces_are_read(name, tmp_path):
    model = cs.Model.load(ROOT / f"models/{name}.toml")
    space = model.compute(*model.pairs[0])
    space.save(tmp_path / "space.json")
    again = cs.ContactSpace.load(tmp_path / "space.json")
    width = 2 if space.pair_class == "fixed-axes" else 3
    q = np.random.default_rng(7).uniform(-3, 3, (2000, width))
    assert again.unit == space.unit == model.unit and again.window == space.window and repr(again) == repr(space)
    assert (again.classify(q) == space.classify(q)).all() and again.patches == space.patches
    assert np.array_equal(again.poses(q)[1], space.poses(q)[1])
    sent = pickle.loads(pickle.dumps(again))
    assert (sent.classify(q) == space.classify(q)).all() and sent.unit == model.unit
    plan = space.plan(q[0]) if width == 3 else space.plan(q[0], q[1])
    assert plan.units.length == model.unit
    (tmp_path / "text.json").write_text((tmp_path / "space.json").read_text()[:-30])
    with pytest.raises(cs.Error, match="text.json"):
        cs.ContactSpace.load(tmp_path / "text.json")


def test_the_commands_spaces_are_read(command, tmp_path):
    out = tmp_path / "peg.json"
    subprocess.run([command, "export", str(ROOT / "models/peg_hole.toml"), "-o", str(out)], check=True, capture_output=True)
    space = cs.Model.load(ROOT / "models/peg_hole.toml").compute()
    again = cs.ContactSpace.load(out)
    assert again.patches == space.patches and again.unit == "mm"
