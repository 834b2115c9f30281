"""Loops, and what is drawn or handed to other packages."""

import math
import pickle
import re
import sys

import numpy as np
import pytest

import cspace as cs
from cspace import _arcs

CIRCLE = [(3.0, 1.0, 1.0), (-1.0, 1.0, 1.0)]
SQUARE = [(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0)]
POINT, SLIT = [(7, 8, 0)], [(5, 0, 0), (6, 1, 0)]

# Bulges of arcs from nearly straight to nearly whole circles.
BULGES = [1e-12, 1e-6, 0.03, 0.1, 0.11, math.sqrt(2) - 1, 1, 2.5, 40]


@pytest.fixture
def axes():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, ax = pyplot.subplots(figsize=(5, 5), dpi=100)
    yield ax
    pyplot.close(figure)


def frame_and_coin():
    frame = [(-12, -12), (12, -12), (12, 12), (-12, 12)]
    hole = [(-10, -10), (10, -10), (10, 10), (-10, 10)]
    return cs.compute(cs.Part([frame, hole], name="frame"), cs.Part.circle(1, name="coin"))


def grown_rectangle():
    return cs.compute(cs.Part.rectangle(4, 2), cs.Part.circle(1))


def pixel(ax, x, y):
    """The colour that is drawn at a point of the plane."""
    ax.figure.canvas.draw()
    image = np.asarray(ax.figure.canvas.buffer_rgba())
    column, row = ax.transData.transform((x, y))
    return tuple(image[image.shape[0] - 1 - int(row), int(column), :3])


WHITE = (255, 255, 255)


def test_areas_and_lengths_of_loops():
    circle, square = cs.Loops([CIRCLE]), cs.Loops([SQUARE])
    assert math.isclose(circle.area, 4 * math.pi, rel_tol=1e-15)
    assert math.isclose(circle.length, 4 * math.pi, rel_tol=1e-15)
    assert (square.area, square.length, square.bounds) == (16, 16, (0, 0, 4, 4))
    assert circle.bounds == pytest.approx((-1, -1, 3, 3), abs=1e-15)
    clockwise = [(x, y, -b) for x, y, b in CIRCLE[::-1]]
    assert math.isclose(cs.Loops([SQUARE, clockwise]).area, 16 - 4 * math.pi, rel_tol=1e-14)
    assert cs.Loops([POINT, SLIT]).area == 0
    assert math.isclose(cs.Loops([POINT, SLIT]).length, 2 * math.sqrt(2))
    far = cs.Loops([CIRCLE]).moved(1e6, -1e6, 1.0)
    assert math.isclose(far.area, 4 * math.pi, rel_tol=1e-9)
    assert cs.Loops().area == cs.Loops().length == 0
    part = cs.Part([[(0, 0, 0.3), (5, 0, -0.2), (5, 4, 1.7), (0, 5, 0)], {"circle": 0.5, "at": [2, 2]}])
    assert math.isclose(part.outline.area, part.area, rel_tol=1e-14)
    assert part.outline.bounds == pytest.approx(part.bounds, abs=1e-14)


def test_outlines_have_the_material_on_the_left():
    def circle(radius, direction):
        return [(-radius, 0, direction), (radius, 0, direction)]

    # Nested three deep, in all directions; the ring between two circles is thinner than their chords are off.
    for directions in np.ndindex(2, 2, 2):
        part = cs.Part([circle(r, 1 - 2 * d) for r, d in zip((4, 3.99, 1), directions)])
        assert [loop[0][2] for loop in part.outline] == [1, -1, 1]
        assert math.isclose(part.outline.area, part.area, rel_tol=1e-14)
        assert math.isclose(part.outline.length, 2 * math.pi * 8.99, rel_tol=1e-14)
    # Backwards, with another bulge on every edge: the same edges, and twice backwards the same loop.
    given = [(0, 0, 0.3), (5, 0, -0.2), (5, 4, 1.7), (0, 5, 0)]
    ccw = cs.Part([given])
    backwards = [(0, 5, -1.7), (5, 4, 0.2), (5, 0, -0.3), (0, 0, 0)]
    cw = cs.Part([backwards])
    assert ccw.outline == [given] and cw.loops == [backwards]
    assert math.isclose(cw.outline.area, cw.area, rel_tol=1e-14)
    assert set(cw.outline[0]) == set(ccw.outline[0])


def test_windings():
    # Beside the arcs of a lens, a heart's arc of more than half a turn, and an arc that is nearly straight.
    lens = cs.Loops([[(-1, 0, 0.4), (1, 0, 0.4)]])
    assert lens.winding(0, 0.39) == lens.winding(0, -0.39) == 1 and lens.winding(0, 0.41) == lens.winding(0, -0.41) == 0
    keyhole = cs.Loops([[(0, 0, 3), (0.1, 0, 0), (0.1, 2, 0), (0, 2, 0)]])
    circle = cs.Loops([[(0, 0, 3), (0.1, 0, 0)]])
    x0, y0, x1, _ = circle.bounds
    for x, y in np.random.default_rng(8).uniform((x0, y0), (x1, 0), (200, 2)):
        inside = math.hypot(x - 0.05, y - (y0 + (x1 - x0) / 2)) < (x1 - x0) / 2
        assert circle.winding(x, y) == keyhole.winding(x, y) == inside
    assert keyhole.winding(0.05, 1.9) == 1 and keyhole.winding(0.11, 1.9) == 0
    flat = cs.Loops([[(0, 0, -1e-9), (1, 0, 0), (0.5, 1, 0)]])
    assert flat.winding(0.5, 4e-10) == 0 and flat.winding(0.5, 6e-10) == 1
    assert cs.Loops([[(x, y, -b) for x, y, b in CIRCLE]]).winding(1, 1) == -1


@pytest.mark.parametrize("bulge", BULGES)
def test_arcs(bulge):
    start, end = 1 + 2j, 4 - 2j
    angle, radius = 4 * math.atan(bulge), _arcs.radius(start, end, bulge)
    assert math.isclose(_arcs.length(start, end, bulge), radius * angle, rel_tol=1e-14)
    segment = _arcs.area_beside(start, end, bulge)
    assert segment == -_arcs.area_beside(start, end, -bulge)
    if bulge < 1e-4:
        assert math.isclose(segment, 25 * bulge / 3, rel_tol=1e-10)
    else:
        assert math.isclose(segment, radius**2 / 2 * (angle - math.sin(angle)), rel_tol=1e-8)
    # An arc to the left of travel has its middle on the right of the chord.
    middle = _arcs.at(start, end, bulge, 0.5)
    assert abs(middle - ((start + end) / 2 + bulge * (end - start) / 2 * -1j)) < 1e-13 * max(1, bulge) * 5
    if bulge > 1e-4:
        centre = (start + end) / 2 + (end - start) / 2 * 1j * (1 - bulge**2) / (2 * bulge)
        for share in np.linspace(0, 1, 9):
            assert abs(abs(_arcs.at(start, end, bulge, share) - centre) - radius) < 1e-11 * radius


def test_the_area_beside_a_chord_has_no_step():
    below, above = _arcs._FLAT, math.nextafter(_arcs._FLAT, 1)
    assert math.isclose(_arcs.area_beside(0, 1, below), _arcs.area_beside(0, 1, above), rel_tol=2e-14)


@pytest.mark.parametrize("bulge", [b for b in BULGES if b > 1e-4] + [-0.5, -3])
def test_beziers_are_on_their_arc(bulge):
    start, end = 1 + 2j, 4 - 2j
    radius = _arcs.radius(start, end, bulge)
    centre = (start + end) / 2 + (end - start) / 2 * 1j * (1 - bulge**2) / (2 * bulge)
    curves = list(_arcs.beziers(start, end, bulge))
    assert len(curves) == math.ceil(abs(4 * math.atan(bulge)) / math.radians(45))
    t, here, turned = np.linspace(0, 1, 101), start, 0.0
    for first, second, there in curves:
        points = (1 - t) ** 3 * here + 3 * (1 - t) ** 2 * t * first + 3 * (1 - t) * t**2 * second + t**3 * there
        assert np.abs(np.abs(points - centre) / radius - 1).max() < 1e-5
        around = np.unwrap(np.angle(points - centre))
        assert (np.diff(around) * np.sign(bulge) > 0).all()
        turned += around[-1] - around[0]
        here = there
    assert here == end and math.isclose(turned, 4 * math.atan(bulge), rel_tol=1e-9)


def test_points_of_loops():
    (points,) = cs.Loops([CIRCLE]).points(0.01)
    ends = np.array(points + points[:1]) - (1, 1)
    assert np.allclose(np.hypot(*ends.T), 2, rtol=0, atol=1e-14)
    off = 2 - np.hypot(*((ends[1:] + ends[:-1]) / 2).T)
    assert 0.005 < off.max() <= 0.01
    assert cs.Loops([SQUARE, POINT, SLIT]).points(1) == [[v[:2] for v in loop] for loop in (SQUARE, POINT, SLIT)]
    # As many as a part has.
    part = cs.Part([CIRCLE])
    assert len(part.points(0.01)[0]) == len(cs.Loops(part.loops).points(0.01)[0])
    assert np.allclose(part.points(0.01), cs.Loops(part.loops).points(0.01), rtol=0, atol=1e-14)


def test_loops_are_a_list_that_is_sent():
    loops = cs.Loops([CIRCLE, POINT])
    again = pickle.loads(pickle.dumps(loops))
    assert type(again) is cs.Loops and again == loops and again == [CIRCLE, [(7.0, 8.0, 0.0)]]
    assert repr(loops) == "Loops(2 loops, 3 vertices)" and repr(cs.Loops([POINT])) == "Loops(1 loop, 1 vertex)"
    assert cs.Loops(np.array([SQUARE])) == [SQUARE]
    ((x, y, bulge),) = loops.moved(1, 2, math.pi / 2)[1]
    assert (x, y, bulge) == pytest.approx((1 - 8, 2 + 7, 0))
    for call, words in [
        (lambda: cs.Loops([[(1, 2)]]), "loop 0 is no list of vertices (x, y, bulge)"),
        (lambda: cs.Loops([SQUARE, []]), "loop 1 has no vertices"),
        (lambda: loops.points(0), "`tolerance`"),
        (lambda: cs.Loops().bounds, "no loops"),
    ]:
        with pytest.raises(cs.Error) as caught:
            call()
        assert words in str(caught.value)


def test_slices_are_loops():
    slice = grown_rectangle().slice(0.3)
    assert type(slice) is cs.Loops
    assert math.isclose(slice.area, 8 + 2 * (4 + 2) + math.pi, rel_tol=1e-10)
    assert math.isclose(slice.length, 2 * (4 + 2) + 2 * math.pi, rel_tol=1e-10)
    assert slice.bounds == pytest.approx((-3, -2, 3, 2), abs=1e-10)
    # The frame is on the left of both its boundaries.
    slice = frame_and_coin().slice(0.0)
    assert math.isclose(slice.area, 26**2 - (4 - math.pi) - 18**2, rel_tol=1e-10)


def test_svg_has_arcs_dots_and_lines():
    svg = cs.Loops([CIRCLE, POINT, SLIT])._repr_svg_()
    (data,) = re.findall(r'<path d="(.*?)"', svg)
    assert data == "M3 -1A2 2 0 0 0 -1 -1A2 2 0 0 0 3 -1Z" "M5 0L6 -1L5 0Z"
    (dot,) = re.findall(r'<circle cx="(.*?)" cy="(.*?)"', svg)
    assert dot == ("7", "-8")
    x, y, width, height = map(float, re.search(r'viewBox="(.*?)"', svg)[1].split())
    # All of it, with a margin, and y points down.
    assert x < -1 and x + width > 7 and y < -8 and y + height > 1
    large = cs.Loops([[(0, 0, 2), (1, 0, 0)], [(0, 0, -0.5), (1, 0, 0)]])._repr_svg_()
    assert "A1.25 1.25 0 1 0 1 0" not in large and "A0.625 0.625 0 1 0 1 0" in large and "A0.625 0.625 0 0 1 1 0" in large
    part = cs.Part([CIRCLE, [(v[0] / 4 + 0.75, v[1] / 4 + 0.75, 1) for v in CIRCLE]])
    assert part._repr_svg_() == part.outline._repr_svg_() and part._repr_svg_().count("A2 2") == 2
    assert "<path" in cs.Loops()._repr_svg_() and "nan" not in cs.Loops([POINT])._repr_svg_()


def test_parts_are_plotted(axes):
    plate = cs.Part([[(0, 0), (40, 0), (40, 20), (0, 20)], {"circle": 3, "at": [10, 10]}], name="plate")
    assert plate.plot(axes) is axes
    (patch,) = axes.patches
    path = patch.get_path()
    assert (path.codes == path.CURVE4).sum() == 3 * 8
    corners = path.get_extents().get_points()
    assert corners.tolist() == [[0, 0], [40, 20]]
    hole = path.vertices[path.codes == path.CURVE4][2::3]
    assert np.allclose(np.hypot(*(hole - 10).T), 3, rtol=0, atol=1e-14)
    assert axes.get_aspect() == 1 and (axes.get_xlabel(), axes.get_ylabel()) == ("x", "y")
    assert pixel(axes, 10, 10) == WHITE != pixel(axes, 30, 10)


def test_loops_are_plotted_on_the_current_axes(axes):
    ax = cs.Loops([CIRCLE, POINT, SLIT]).plot(facecolor="red", edgecolor="blue", lw=3)
    assert ax is axes
    (patch,), (dot,) = ax.patches, ax.lines
    assert patch.get_facecolor() == (1, 0, 0, 1) and patch.get_linewidth() == 3
    assert (dot.get_xdata(), dot.get_ydata()) == ([7], [8]) and dot.get_color() == "blue"
    assert pixel(ax, 1, 1) == (255, 0, 0)
    assert pixel(ax, 5.5, 0.5) == pixel(ax, 7, 8) == (0, 0, 255)
    assert pixel(ax, 5.5, 3) == WHITE


def test_slices_are_plotted(axes):
    space = frame_and_coin()
    space.plot(theta=0.5, ax=axes)
    assert pixel(axes, 0, 0) == pixel(axes, 8.5, 8.5) == WHITE
    blocked = pixel(axes, 9.5, 0)
    assert blocked == pixel(axes, -12.5, 3) != WHITE
    before = len(axes.patches)
    space.plot(at=(5, 0), ax=axes)
    assert len(axes.patches) == before + 3
    coin = axes.patches[-1].get_path().get_extents().get_points()
    assert np.allclose(coin, [[4, -1], [6, 1]], rtol=0, atol=1e-5)
    assert pixel(axes, 5.5, 0.5) not in (WHITE, blocked) and pixel(axes, -5, 0) == WHITE
    with pytest.raises(cs.Error, match=r"give a position \(x, y\)"):
        space.plot(at=(1, 2, 3))
    with pytest.raises(cs.Error, match="not finite"):
        space.plot(at=(1, math.nan))


def test_parts_are_plotted_turned(axes):
    space = cs.compute(cs.Part.rectangle(4, 2), cs.Part.rectangle(6, 1))
    space.plot(theta=math.pi / 2, at=(10, 0), ax=axes)
    moved = axes.patches[-1].get_path().get_extents().get_points()
    assert np.allclose(moved, [[9.5, -3], [10.5, 3]], rtol=0, atol=1e-12)


def test_two_parts_on_axes_are_drawn_by_the_command(command, tmp_path, models):
    import subprocess

    space = cs.Model.load(models / "cam_plate.toml").compute()
    assert space.pair_class == "fixed-axes"
    with pytest.raises(cs.Error, match="cspace slice space.json -o space.svg"):
        space.plot()
    space.save(tmp_path / "space.json")
    subprocess.run([command, "slice", "space.json", "-o", "space.svg"], cwd=tmp_path, check=True, capture_output=True)
    assert "<svg" in (tmp_path / "space.svg").read_text()


def test_the_surface_as_a_mesh():
    pytest.importorskip("trimesh")
    space = grown_rectangle()
    vertices, faces = space.mesh(1e-4)
    mesh = space.to_trimesh(1e-4)
    assert np.array_equal(mesh.vertices, vertices) and np.array_equal(mesh.faces, faces)
    patches = mesh.face_attributes["patch"]
    assert set(patches.tolist()) == set(range(len(space.patches)))
    # The boundary of a slice, which is the same at every orientation, times a turn.
    assert math.isclose(mesh.area, (12 + 2 * math.pi) * 2 * math.pi, rel_tol=1e-3)


def test_patches_as_a_graph():
    networkx = pytest.importorskip("networkx")
    space = frame_and_coin()
    graph = space.to_networkx()
    assert sorted(graph.nodes) == list(range(len(space.patches)))
    for number, patch in enumerate(space.patches):
        assert cs.Patch(**graph.nodes[number]) == patch
    assert [(a, b, d["lo"], d["hi"]) for a, b, d in sorted(graph.edges(data=True), key=str)] == sorted(
        zip(*(column.tolist() for column in space.links())), key=lambda link: str((*link[:2], {"lo": link[2], "hi": link[3]}))
    )
    # Inside the frame and around it.
    pieces = list(networkx.weakly_connected_components(graph))
    assert len(pieces) == 2
    assert all(len({graph.nodes[n]["region"] for n in piece}) == 1 for piece in pieces)


@pytest.mark.parametrize(
    "missing, call",
    [
        ("matplotlib", lambda space: space.plot()),
        ("matplotlib", lambda space: space.fixed.plot()),
        ("matplotlib", lambda space: space.slice(0).plot()),
        ("trimesh", lambda space: space.to_trimesh()),
        ("networkx", lambda space: space.to_networkx()),
        ("shapely", lambda space: space.fixed.to_shapely(0.1)),
    ],
)
def test_a_package_that_is_missing_is_named(missing, call, monkeypatch):
    space = grown_rectangle()
    for name in [name for name in sys.modules if name.split(".")[0] == missing]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, missing, None)
    with pytest.raises(cs.Error, match=f"pip install {missing}"):
        call(space)


def test_nothing_optional_is_imported():
    import subprocess

    code = "import sys, cspace; print([n for n in ('matplotlib', 'shapely', 'trimesh', 'networkx', 'ompl') if n in sys.modules])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "[]\n"
