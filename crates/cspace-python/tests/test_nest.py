"""Positions of parts beside and within others, exact fits among them."""

import math
import pickle

import numpy as np
import pytest

import cspace as cs

SQUARE = cs.Part.rectangle(2, 2, name="square")
L = cs.Part([[(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (0, 2)]], name="L")


def test_a_disc_in_a_frame_of_its_size_has_one_position():
    fits = cs.inner_fit(cs.Part.circle(200, (10, 20)), cs.Part.circle(200))
    assert len(fits) == 1 and len(fits[0]) == 1 and not fits.doubtful
    assert fits[0][0] == pytest.approx((10, 20, 0), abs=1e-12)
    assert cs.inner_fit(cs.Part.circle(200), cs.Part.circle(200.001)) == []


def test_a_part_fits_its_own_shape_at_one_orientation():
    for theta in (0.3, 2.0):
        around = cs.Part.rectangle(40, 40)
        frame = cs.Part([around.loops[0], *L.outline.moved(1, 2, theta)])
        found = cs.nfp(frame, L, [theta, theta + 0.01])
        points = [loop for loop in found[0] if len(loop) == 1]
        assert points == [[pytest.approx((1, 2, 0), abs=1e-11)]]
        assert len(found[1]) == 1


def test_a_slit_goes_there_and_back():
    slot = cs.Part([[(0, 0), (10, 0), (10, 2), (0, 2)]])
    fits = cs.inner_fit(slot, SQUARE)
    assert sorted(fits[0]) == [pytest.approx((1, 1, 0)), pytest.approx((9, 1, 0))]
    assert fits.length == pytest.approx(16) and fits.area == pytest.approx(0)


def test_areas_are_those_of_minkowski():
    triangle = cs.Part([[(0, 0), (4, 1), (1, 3)]])
    disc = cs.Part.circle(0.5)
    loops = cs.nfp(triangle, disc)
    perimeter = triangle.outline.length
    assert loops.area == pytest.approx(triangle.area + 0.5 * perimeter + math.pi / 4, rel=1e-13)
    # Spacing is a disc more.
    assert cs.nfp(triangle, disc, spacing=0.25).area == pytest.approx(
        triangle.area + 0.75 * perimeter + math.pi * 0.75**2, rel=1e-13
    )
    assert cs.inner_fit(SQUARE, disc, spacing=0.1).area == pytest.approx(-(0.8**2))


def test_beside_shapely():
    pytest.importorskip("shapely")
    from shapely import affinity
    from shapely.geometry import Polygon

    a, b = cs.Part([[(0, 0), (5, 0), (5, 1), (2, 2), (3, 4), (0, 4)]]), L
    rng = np.random.default_rng(3)
    for theta in (0.0, 0.7, math.pi / 2):
        region = cs.nfp(a, b, theta)
        turned = affinity.rotate(b.to_shapely(1), theta, origin=(0, 0), use_radians=True)
        for x, y in rng.uniform(-6, 8, (300, 2)):
            overlap = a.to_shapely(1).intersection(affinity.translate(turned, x, y)).area
            if overlap > 1e-9 or overlap == 0:
                assert (region.winding(x, y) > 0) == (overlap > 0), (x, y, theta)
    assert Polygon([p[:2] for p in cs.nfp(a, b)[0]]).is_valid


def test_parts_that_are_placed():
    ring = [(SQUARE, (2 * i, 2 * j, 0)) for i in range(3) for j in range(3) if (i, j) != (1, 1)]
    fits = cs.nfp(ring, SQUARE)
    assert sorted(len(loop) for loop in fits) == [1, 4]
    assert fits[[len(loop) for loop in fits].index(1)][0] == pytest.approx((2, 2, 0), abs=1e-12)
    with pytest.raises(cs.Error, match="0 and 1 overlap"):
        cs.nfp([(SQUARE, (0, 0, 0)), (SQUARE, (1, 1, 0))], SQUARE)


def test_separation():
    assert cs.separation(SQUARE, SQUARE, (1.5, 0.1, 0)) == pytest.approx((0.5, 0), abs=1e-12)
    assert cs.separation(SQUARE, SQUARE, (2, 0, 0)) == (0, 0)
    assert cs.separation(SQUARE, SQUARE, (5, 0, 1)) == (0, 0)
    dx, dy = cs.separation(cs.Part.circle(3), cs.Part.circle(2), (1, 1, 0.5))
    assert (dx, dy) == pytest.approx((5 / math.sqrt(2) - 1,) * 2)


def test_what_is_refused():
    for call in (
        lambda: cs.nfp(SQUARE, "L"),
        lambda: cs.nfp("L", SQUARE),
        lambda: cs.nfp([], SQUARE),
        lambda: cs.nfp([(SQUARE, (0, 0))], SQUARE),
        lambda: cs.nfp(SQUARE, SQUARE, math.nan),
        lambda: cs.nfp(SQUARE, SQUARE, "a"),
        lambda: cs.nfp(SQUARE, SQUARE, spacing=-1),
        lambda: cs.inner_fit(SQUARE, SQUARE, spacing=math.inf),
        lambda: cs.separation(SQUARE, SQUARE, (0, 0)),
    ):
        with pytest.raises(cs.Error):
            call()


def test_answers_are_sent():
    fits = cs.nfp(SQUARE, L)
    again = pickle.loads(pickle.dumps(fits))
    assert again == fits and type(again) is cs.Loops


def test_positions_are_told_apart():
    rng = np.random.default_rng(4)
    disc, theta = cs.Part.circle(0.7), 0.4
    beside, within = cs.nfp(L, disc, theta), cs.inner_fit(cs.Part.circle(3), L, theta)
    space = cs.compute(L, disc)
    for x, y in rng.uniform(-3, 5, (500, 2)):
        assert beside.blocks(x, y) == (space.classify((x, y, theta)) == cs.BLOCKED)
        if space.classify((x, y, theta)) == cs.FREE:
            assert beside.distance(x, y) == pytest.approx(space.clearance((x, y, theta)), abs=1e-9)
        corners = [(x + p * math.cos(theta) - q * math.sin(theta), y + p * math.sin(theta) + q * math.cos(theta)) for p, q, _ in L.loops[0]]
        assert within.blocks(x, y) == any(math.hypot(*corner) > 3 for corner in corners)
    # Far from an edge that is hardly bent, and beside a whole circle.
    flat = cs.Loops([[(0, 0, 1e-7), (1, 0, 0), (0.5, -1, 0)]])
    assert flat.distance(0.5, 1) == pytest.approx(1 + 0.5e-7, abs=1e-12)
    circle = cs.nfp(disc, disc)
    assert circle.distance(0, 0) == pytest.approx(1.4) and circle.distance(0.4, 0) == pytest.approx(1.0)
    nothing = cs.inner_fit(disc, L)
    assert nothing.blocks(0, 0) and nothing.distance(0, 0) == math.inf
