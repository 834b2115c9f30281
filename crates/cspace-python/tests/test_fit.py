"""Places of a part in a container among others, at any orientation."""

import itertools
import math
import pathlib
import runpy

import numpy as np
import pytest

import cspace as cs

SHEET = cs.Part.rectangle(10, 8, center=(5, 4), name="sheet")
BAR = cs.Part.rectangle(3, 1, name="bar")
EXAMPLES = pathlib.Path(__file__).parents[1] / "examples"


def test_the_lowest_is_flat_in_the_left_corner():
    found = cs.fit(SHEET, [], BAR)
    assert found and len(found.regions) == 1 and found.regions[0].caged
    place = found.lowest()
    assert place.at == pytest.approx((1.5, 0.5, 0), abs=1e-12) and place.length == pytest.approx(4)
    assert place.part.bounds == pytest.approx((0, 0, 3, 1), abs=1e-12) and place.part.name == "bar"
    assert {owner for owner, _, _ in place.touching} == {None}
    assert {own for _, _, own in place.touching} >= {"vertex 0 of loop 0", "vertex 1 of loop 0"}
    assert {wall.kind for _, wall, _ in place.touching} == {"line"}
    assert found.space.classify(np.add(place.at, (1e-6, 1e-6, 0))) == cs.FREE
    # In another direction, of another point: up and, seen so, to the right.
    top = found.lowest((0, 1), about=(1.5, 0))
    assert top.at[1] == pytest.approx(6.5) and abs(top.at[2]) == pytest.approx(math.pi / 2)
    assert top.at[0] == pytest.approx(9.5)


def test_beside_placed_parts_and_with_spacing():
    first = cs.fit(SHEET, [], BAR).lowest()
    found = cs.fit(SHEET, [first.part], BAR)
    second = found.lowest()
    assert second.at == pytest.approx((4.5, 0.5, 0), abs=1e-12)
    assert 0 in {owner for owner, _, _ in second.touching}
    assert cs.fit(SHEET, [(BAR, first.at)], BAR).lowest().at == pytest.approx(second.at, abs=1e-12)
    apart = cs.fit(SHEET, [first.part], BAR, spacing=0.25).lowest()
    assert apart.at == pytest.approx((4.75, 0.75, 0), abs=1e-9)
    # Upright it shares a side with the wall and an end, and a side with the bar.
    tight = cs.fit(SHEET, [(BAR, (5, 0.5, 0))], BAR).tightest()
    assert tight.length == pytest.approx(4) and tight.at[1] == pytest.approx(0.5)


def test_exact_fits_are_places():
    cell = cs.Part.rectangle(1, 3, center=(2, 2), name="cell")
    found = cs.fit(cell, [], BAR)
    assert found and found.regions == []
    place = found.lowest()
    assert place.at[:2] == pytest.approx((2, 2)) and place.length == pytest.approx(8)
    assert not cs.fit(cell, [], cs.Part.rectangle(3.001, 1))
    assert cs.fit(cell, [], cs.Part.rectangle(3.001, 1)).lowest() is None
    assert cs.fit(cell, [], cs.Part.rectangle(3.001, 1)).tightest() is None
    assert cs.fit(cell, [], cs.Part.circle(0.5)).lowest().at == pytest.approx((2, 1, 0))


def test_windows_and_single_orientations():
    tilted = cs.fit(SHEET, [], BAR, window=(0.2, 1.0)).lowest()
    assert tilted.at[1:] == pytest.approx((1.5 * math.sin(0.2) + 0.5 * math.cos(0.2), 0.2))
    upright = cs.fit(SHEET, [], BAR, orientations=[math.pi / 2])
    assert upright and upright.lowest().at == pytest.approx((0.5, 1.5, math.pi / 2))
    with pytest.raises(cs.Error, match="orientations"):
        upright.space
    with pytest.raises(cs.Error, match="both given"):
        cs.fit(SHEET, [], BAR, window=(0, 1), orientations=[0])


def test_what_is_wrong_is_told():
    with pytest.raises(cs.Error, match="placed parts 0 and 1 overlap"):
        cs.fit(SHEET, [(BAR, (3, 3, 0)), (BAR, (4, 3, 1))], BAR)
    with pytest.raises(cs.Error, match="part 0, counted from 0, overlaps the outside"):
        cs.fit(SHEET, [(BAR, (0, 3, 0))], BAR)
    with pytest.raises(cs.Error, match="`placed` has"):
        cs.fit(SHEET, [BAR, 3], BAR)
    with pytest.raises(cs.Error, match="`placed` is"):
        cs.fit(SHEET, BAR, BAR)
    with pytest.raises(cs.Error, match="no length"):
        cs.fit(SHEET, [], BAR).lowest((0, 0))
    with pytest.raises(cs.Error, match="layers"):
        cs.fit(SHEET, [], cs.Part(BAR.loops, z=(0, 1)))
    with pytest.raises(cs.Error, match='`unit` is "ell"'):
        cs.write_dxf("none.dxf", [BAR], unit="ell")


def random_part(rng, name):
    corners = rng.integers(3, 7)
    angles = (np.arange(corners) + rng.uniform(-0.3, 0.3, corners)) * 2 * np.pi / corners
    radii = rng.uniform(0.5, 1.6, corners)
    bulges = np.where(rng.random(corners) < 0.4, rng.uniform(-0.2, 0.4, corners), 0)
    return cs.Part([list(zip(radii * np.cos(angles), radii * np.sin(angles), bulges))], name=name)


def test_nests_overlap_nowhere():
    """Beside shapely: the parts where they are placed, with fine polygons for arcs, share no area with each other, and are in the sheet."""
    pytest.importorskip("shapely")
    rng = np.random.default_rng(5)
    fine = 1e-5
    for spacing in (0.0, 0.1):
        placed, shapes = [], []
        for i in range(7):
            found = cs.fit(SHEET, placed, random_part(rng, f"part {i}"), spacing=spacing)
            place = found.tightest() if i % 3 == 2 else found.lowest()
            shape = place.part.to_shapely(fine)
            # Chords are inside convex arcs, and outside concave ones by no more than the tolerance.
            for other in shapes:
                assert shape.buffer(-2 * fine).intersection(other).area == 0
                assert shape.distance(other) >= spacing - 3 * fine
            assert SHEET.to_shapely(fine).buffer(2 * fine - spacing).contains(shape)
            assert place.touching
            # Nothing of it is as drawn but where it is.
            assert place.part.area == pytest.approx(found.part.area, rel=1e-12)
            placed.append(place.part)
            shapes.append(shape)


def test_a_drawing_is_read_back_as_written(tmp_path):
    half = cs.Part([[(-1, 0, 1), (1, 0)]], name="half")
    path = tmp_path / "two.dxf"
    cs.write_dxf(path, [BAR, (half, (2, 1, 0.3))], unit="mm")
    assert cs.Part.from_dxf(path, name="bar", layer="bar") == BAR
    again = cs.Part.from_dxf(path, layer="half")
    assert np.array(again.loops[0]) == pytest.approx(np.array(half.outline.moved(2, 1, 0.3)[0]), abs=1e-15)


def test_the_example_nests(tmp_path, capsys):
    example = runpy.run_path(str(EXAMPLES / "nest.py"))
    out = tmp_path / "nest.dxf"
    heights = example["main"](["--parts", "6", "--width", "110", "-o", str(out)])
    assert "quarter turns" in capsys.readouterr().out
    written = [cs.Part.from_dxf(out, layer=name) for name in example["COUNTS"]]
    assert max(part.bounds[3] for part in written) == pytest.approx(min(heights.values()), abs=1e-9)
    drawn = example["parts"](EXAMPLES / "nest.dxf", 6)
    assert sum(part.area for part in written) == pytest.approx(sum(part.area for part in drawn), rel=1e-12)


def test_the_whole_example_is_apart(capsys):
    """Spaced parts have arcs about the corners of others, of which many touch in the same places."""
    pytest.importorskip("shapely")
    example = runpy.run_path(str(EXAMPLES / "nest.py"))
    queue, spacing, fine = example["parts"](EXAMPLES / "nest.dxf", 20), 2.0, 1e-4
    sheet = cs.Part.rectangle(200, 400, center=(100, 200), name="sheet")
    placed = example["nest"](sheet, queue, spacing, None)
    shapes = [part.to_shapely(fine) for part in placed]
    nearest = min(a.distance(b) for a, b in itertools.combinations(shapes, 2))
    assert nearest == pytest.approx(spacing, abs=2 * fine)
    assert all(sheet.to_shapely(fine).buffer(2 * fine - spacing).contains(shape) for shape in shapes)
    assert len(placed) == 20 and max(part.bounds[3] for part in placed) < 163
