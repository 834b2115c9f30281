"""The package with CadQuery itself, where it is installed: against what OCCT finds of the same shapes."""

import math
import subprocess
import sys

import pytest

import cspace as cs

cad = pytest.importorskip("cadquery")
WORK = cad.Workplane


def plate():
    return WORK().rect(60, 40).pushPoints([(-20, 0), (20, 5)]).circle(4).extrude(5)


FACES = {
    "slot": WORK().slot2D(40, 10).extrude(1).faces(">Z"),
    "plate": plate().faces(">Z"),
    "front": WORK("XZ").rect(9, 4).extrude(2).faces("<Y"),
    "rounded": WORK().box(20, 10, 3).edges("|Z").fillet(2).faces("<Z"),
}


@pytest.mark.parametrize("name", FACES)
def test_faces_go_both_ways_exactly(name):
    face = FACES[name].val()
    part = cs.Part.from_cad(FACES[name], name=name)
    length = sum(edge.Length() for edge in face.Edges())
    assert part.fitted == 0.0 and abs(part.area - face.Area()) < 1e-9 and abs(part.outline.length - length) < 1e-9
    back = part.to_cadquery()
    assert abs(sum(f.Area() for f in back.faces().vals()) - face.Area()) < 1e-9


def test_sketches_and_curves():
    sketch = cad.Sketch().rect(10, 20).push([(0, 0)]).circle(2, mode="s")
    assert abs(cs.Part.from_cad(sketch).area - (200 - 4 * math.pi)) < 1e-9
    part = cs.Part.from_cad(WORK().ellipse(10, 5).extrude(1).faces(">Z"), tol=1e-4)
    assert 0 < part.fitted <= 1e-4 and abs(part.area - 50 * math.pi) < 49 * 1e-4


def test_solids_go_both_ways():
    solid = WORK().box(10, 20, 4).faces(">Z").workplane().circle(4).extrude(4).faces(">Z").workplane().hole(2)
    part = cs.Part.from_solid(solid, name="hub")
    assert [z for z, _ in part.layers] == [(-2.0, 2.0), (2.0, 6.0)]
    assert abs(part.to_cadquery().val().Volume() - solid.val().Volume()) < 1e-8
    assert abs(cs.Part.from_solid(solid, z=5).area - 15 * math.pi) < 1e-9
    with pytest.raises(cs.Error, match="neither horizontal nor upright"):
        cs.Part.from_solid(WORK().box(4, 4, 4).faces(">Z").chamfer(1))


def both():
    whole = cad.Assembly(WORK().box(10, 10, 4), name="base")
    whole.add(WORK().box(10, 5, 4), name="arm", loc=cad.Location((20, 0, 0), (0, 0, 1), 30))
    return whole


def test_an_assembly_stands_as_occt_has_it():
    model = cs.Model.from_assembly(both())
    assert list(model.parts) == ["base", "arm"]
    (pair,) = model.clearance().pairs
    apart = cad.Shape.distance(*(shape.moved(loc) for shape, _, loc, _ in both()))
    assert abs(pair.gap - apart) < 1e-9


def test_the_command_reads_step_files(tmp_path):
    pair = cad.Assembly(name="pair")
    pair.add(WORK().box(10, 10, 4), name="base").add(WORK().box(10, 5, 4), name="arm", loc=cad.Location((20, 0, 0)))
    pair.export(str(tmp_path / "pair.step"))
    both().export(str(tmp_path / "both.step"))
    cad.exporters.export(WORK().box(1, 2, 3), str(tmp_path / "one.step"))

    def run(*arguments):
        return subprocess.run([sys.executable, "-m", "cspace", *arguments], capture_output=True, text=True, cwd=tmp_path)

    told = run("clearance", "pair.step")
    assert told.returncode == 0 and "10.000000 mm  base, arm" in told.stdout, told
    # CadQuery's reader of assemblies does not find both of these.
    told = run("clearance", "both.step")
    assert told.returncode == 0 and "2 parts, 1 pair: 1 clear" in told.stdout, told
    told = run("info", "one.step")
    assert told.returncode == 0 and "1.000000 by 2.000000" in told.stdout, told
