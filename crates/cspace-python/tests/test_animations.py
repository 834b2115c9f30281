"""Animations, tables and the view for notebooks."""

import math

import numpy as np
import pytest

import cspace as cs
from conftest import CAM, ROOT


@pytest.fixture
def space():
    return cs.compute(cs.Part.rectangle(10, 10, name="box"), cs.Part.rectangle(2, 1, name="bar"))


def frames(path):
    image = pytest.importorskip("PIL.Image").open(path)
    found = []
    for k in range(image.n_frames):
        image.seek(k)
        found.append(np.asarray(image.convert("RGB")).astype(int))
    return found


def colour(text):
    return [int(text[i : i + 2], 16) for i in (1, 3, 5)]


@pytest.fixture
def agg():
    pytest.importorskip("matplotlib").use("Agg")


def test_a_motion_as_a_gif(agg, tmp_path):
    simulation = cs.Model.loads(CAM).simulate(1.0, every=0.1)
    simulation.animate(tmp_path / "cam.gif")
    shown = frames(tmp_path / "cam.gif")
    assert len(shown) == len(simulation.t) == 11 and shown[0].shape == (480, 640, 3)
    # The cam turns half round beside its centre: where its colour is, moves.
    from cspace import _draw

    def middle(image):
        is_cam = np.abs(image - (0.9 * np.array(colour(_draw.FILL)) + 0.1 * 255)).max(axis=2) < 6
        return np.argwhere(is_cam).mean(axis=0)

    (_, first), (_, last) = middle(shown[0]), middle(shown[-1])
    assert first - last > 30


def test_a_path_as_a_gif(agg, space, tmp_path):
    for plan in (space.plan((-8, 1, 0), (8, 0, 2)), cs.Model.load(ROOT / "models/peg_hole.toml").plan((40, 30, 0), (0, 2, 0))):
        plan.animate(tmp_path / "way.gif", frames=7, fps=10)
        shown = frames(tmp_path / "way.gif")
        assert len(shown) == 7 and all((a != b).any() for a, b in zip(shown, shown[1:]))


def test_where_parts_are_in_a_frame(agg, space):
    """The outline in a frame is that of the part moved by its pose."""
    plan = space.plan((-8, 1, 0), (8, 0, 2))
    moving = plan.animate(frames=5)
    rows = plan.sample(5)
    for k in (0, 2, 4):
        _, bar, _ = moving._func(k)
        ax = bar.axes
        extents = bar.get_path().transformed(bar.get_transform() - ax.transData).get_extents().get_points().ravel()
        assert extents == pytest.approx(space.moving.moved(*rows[k]).bounds, abs=1e-9)
    moving._draw_was_started = True


def test_what_is_no_animation(agg, space, tmp_path):
    plan = space.plan((-8, 1, 0), (8, 0, 2))
    for wrong, said in (
        (lambda: plan.animate(tmp_path / "way.avi"), "ends in .gif or .mp4"),
        (lambda: plan.animate(tmp_path / "way.gif", fps=0), "`fps`"),
        (lambda: plan.animate(tmp_path / "way.gif", frames=0), "`count`"),
        (lambda: space.plan((0, 0, 0), (8, 0, 2)).animate(), "there is no path"),
        (lambda: cs.Plan(plan.to_dict()).animate(), "not known"),
    ):
        with pytest.raises(cs.Error, match=said):
            wrong()
    from matplotlib import animation

    if not animation.writers.is_available("ffmpeg"):
        with pytest.raises(cs.Error, match="install the program ffmpeg"):
            plan.animate(tmp_path / "way.mp4")


def test_tables_of_answers(models, space, peg):
    pandas = pytest.importorskip("pandas")
    checked = peg.check(sensitivities=True)
    frame = checked.to_dataframe()
    assert frame["name"].tolist() == peg.requirements and frame["value"].tolist() == [row.value for row in checked.requirements]
    assert frame["sensitivities.play"][0] == checked["tilt"].sensitivities["play"]
    cam = cs.Model.loads(CAM)
    assert cam.tolerances().to_dataframe().loc[0, "linear"] == list(cam.tolerances()["backlash"].linear)
    clearance = cs.Model.load(models / "latch_box.toml").clearance()
    assert clearance.to_dataframe()["gap"].tolist() == [pair.gap for pair in clearance.pairs]
    simulation = cam.simulate(1.0, every=0.25)
    motion = simulation.to_dataframe()
    assert motion["t"].tolist() == simulation.t.tolist() and motion["fork.u"].tolist() == simulation.coordinates["fork"].tolist()
    geneva = cs.Model.load(models / "geneva.toml").simulate(3)
    assert geneva.to_dataframe("events")["t"].tolist() == [event.t for event in geneva.events] != []
    plan = space.plan((-8, 1, 0), (8, 0, 2))
    assert np.array_equal(plan.to_dataframe().to_numpy(), plan.path)
    table = cs.sweep(lambda a: 1 / a, a=[0, 2]).to_dataframe()
    assert isinstance(table, pandas.DataFrame) and table["value"][1] == 0.5 and "division" in table["failure"][0]
    assert list(cam.sweep(play=[0.1, 0.2]).to_dataframe()) == ["play", "backlash"]
    for wrong in (lambda: cam.info().to_dataframe("nothing"), lambda: space.plan((0, 0, 0)).to_dataframe()):
        with pytest.raises(cs.Error, match="no rows 'nothing'; its lists are|no path"):
            wrong()


def test_the_view_answers_the_page():
    pytest.importorskip("anywidget")
    space = cs.compute(cs.Part.rectangle(4, 2), cs.Part.rectangle(2, 1))
    view = space.widget()

    def set_by_the_page(**state):
        """A message as the page sends it; what is told and drawn then."""
        view._handle_msg({"content": {"data": {"method": "update", "state": state, "buffer_paths": []}}, "buffers": []})
        return view.told, view.svg

    told, flat = set_by_the_page(at=[0, 3.5])
    assert told.splitlines()[0] == "x = 0, y = 3.5: free" and told.splitlines()[1] == "clearance 2"
    assert "y from 1.5 to inf" in told
    told, turned = set_by_the_page(theta=math.pi / 2)
    assert told.splitlines()[1] == "clearance 1.5" and turned != flat and turned.startswith("<svg")
    told, _ = set_by_the_page(at=[0, 0])
    assert told == "x = 0, y = 0: blocked"
    state = view.get_state()
    assert state["svg"] == view.svg and state["window"] == pytest.approx((-math.pi, math.pi)) and "export default" in view._esm
    with pytest.raises(cs.Error, match="no slices"):
        cs.Model.load(ROOT / "models/cam_plate.toml").compute().widget()
