"""Writes recorded/NAME.json: shapes of build123d, CadQuery or FreeCAD as the package reads them, for tests without these programs.

    python crates/cspace-python/tests/record.py build123d|cadquery|freecad

`from_cad`, `from_solid` and `from_assembly` are run on real objects, and all that they ask for is kept, with the areas, lengths (of all
edges) and volumes that OCCT finds. Of curves OCCT's own are good to three digits: theirs are those of polygons of many points.
"""

import math
import pathlib
import sys

import replay

import cspace as cs

# Points of a curve: the polygon's area and length are then good to 1e-7 of theirs.
COUNT = 20_000


def polygon(at):
    """Area and length of the polygon through points of a curve, at shares of it."""
    points = [complex(*list(at(k / COUNT))[:2]) for k in range(COUNT + 1)]
    sides = list(zip(points, points[1:] + points[:1]))
    return abs(sum((a.conjugate() * b).imag for a, b in sides)) / 2, sum(abs(b - a) for a, b in sides)


def ellipse(t):
    return 10 * math.cos(math.tau * t), 5 * math.sin(math.tau * t)


FOLDER = pathlib.Path(__file__).parent / "recorded"


def build123d():
    import build123d as cad
    from build123d import Axis, Box, Compound, Cylinder, LinearJoint, Location, Part, Pos, RevoluteJoint, RigidJoint

    cam = cad.make_face(cad.Spline((20, 0), (0, 14), (-12, 0), (0, -11), periodic=True))
    faces = {
        "slotted plate": cad.Rectangle(60, 40) - cad.SlotOverall(30, 8) - cad.GridLocations(50, 30, 2, 2) * cad.Circle(2),
        "upright gusset": cad.Plane.XZ * cad.make_face(cad.Polyline((0, 0), (30, 0), (0, 20), close=True)),
        "ellipse": cad.Ellipse(10, 5),
        "cam": cam,
        "bezier": cad.make_face(cad.Bezier((0, 0), (3, 8), (9, 1)) + cad.Line((9, 1), (0, 0))),
    }
    curved = {
        "ellipse": ellipse,
        "cam": lambda t: cam.edges()[0] @ t,
        "bezier": lambda t: (6 * t * (1 - t) + 9 * t * t, 16 * t * (1 - t) + t * t),
    }
    solids = {"stepped": Box(10, 20, 4) + Pos(0, 0, 4) * Cylinder(4, 4) - Cylinder(1, 20), "cone": cad.Cone(5, 1, 10)}
    base = Part((Pos(20, 12, 0) * Box(40, 4, 4) + Cylinder(2, 4)).wrapped, label="base")
    arm = Part((Pos(15, 0, 0) * Box(40, 6, 4) - Cylinder(2.1, 4)).wrapped, label="arm")
    bolt = Part(Box(4, 2, 4).wrapped, label="bolt")
    RevoluteJoint("hinge", base, Axis.Z, angular_range=(-30, 90)).connect_to(RigidJoint("pin", arm, Location()), angle=10)
    guide = LinearJoint("guide", base, Axis((20, 20, 0), (1, 0, 0)), linear_range=(-5, 15))
    guide.connect_to(RigidJoint("foot", bolt, Location()), position=3)
    post, leaf = Part(Box(4, 4, 4).wrapped, label="post"), Part((Pos(20, 0, 0) * Box(20, 4, 4)).wrapped, label="leaf")
    turned = RevoluteJoint("pivot", post, Axis((0, 0, 0), (0, 0, -1)), angular_range=(0, 120))
    turned.connect_to(RigidJoint("eye", leaf, Location((0, 0, 0), (180, 0, 0))), angle=30)
    asked = {
        "hinge": Compound(children=[base, arm, bolt], label="hinge"),
        "door": Compound(children=[post, leaf], label="door"),
    }
    told = {name: (f.area, sum(e.length for e in f.edges())) for name, f in faces.items()}
    told |= {name: polygon(at) for name, at in curved.items()}
    return cad, faces, solids, asked, told, {name: s.volume for name, s in solids.items()}


def cadquery():
    import cadquery as cad

    work = cad.Workplane
    sketch = cad.Sketch().rect(10, 20).push([(0, 0)]).circle(2, mode="s")
    faces = {
        "slot": work().slot2D(40, 10).extrude(1).faces(">Z"),
        "front": work("XZ").ellipse(10, 5).extrude(2).faces("<Y"),
        "sketch": sketch,
        "cam": work().spline([(20, 0), (0, 14), (-12, 0), (0, -11)], periodic=True).close().extrude(1).faces(">Z"),
    }
    solids = {"stepped": work().box(10, 20, 4).faces(">Z").workplane().circle(4).extrude(4)}
    both = cad.Assembly(work().box(10, 10, 4), name="base")
    both.add(work().box(10, 5, 4), name="arm", loc=cad.Location((20, 0, 0), (0, 0, 1), 30))
    shape = {name: sketch._faces if f is sketch else f.val() for name, f in faces.items()}
    told = {name: (f.Area(), sum(e.Length() for e in f.Edges())) for name, f in shape.items()}
    told |= {"front": polygon(ellipse), "cam": polygon(lambda t: shape["cam"].Edges()[0].positionAt(t).toTuple())}
    return cad, faces, solids, {"two": both}, told, {name: s.val().Volume() for name, s in solids.items()}


def freecad():
    # Debian's package keeps it there.
    sys.path.insert(0, "/usr/lib/freecad-python3/lib")
    import FreeCAD
    import Part as cad

    def face(*edges):
        return cad.Face(cad.Wire(list(edges)))

    at = FreeCAD.Vector
    spline = cad.BSplineCurve()
    spline.interpolate([at(20, 0, 0), at(0, 14, 0), at(-12, 0, 0), at(0, -11, 0)], PeriodicFlag=True)
    slot = [cad.makeLine(at(0, 0), at(9, 0)), cad.Arc(at(9, 0), at(11, 2), at(9, 4)).toShape()]
    slot += [cad.makeLine(at(9, 4), at(0, 4)), cad.Arc(at(0, 4), at(-2, 2), at(0, 0)).toShape()]
    box = cad.makeBox(10, 20, 4)
    faces = {
        "slot": face(*slot),
        "side": box.Faces[0],
        "ellipse": face(cad.Ellipse(at(0, 0, 0), 10, 5).toShape()),
        "cam": face(spline.toShape()),
    }
    solids = {"stepped": box.fuse(cad.makeCylinder(4, 4, at(5, 10, 4))).cut(cad.makeCylinder(1, 20, at(5, 10, 0)))}
    told = {name: (f.Area, sum(e.Length for e in f.Edges)) for name, f in faces.items()}
    period = spline.LastParameter - spline.FirstParameter
    told |= {"ellipse": polygon(ellipse), "cam": polygon(lambda t: spline.value(spline.FirstParameter + t * period))}
    document = FreeCAD.newDocument()
    both = [document.addObject("Part::Box", name) for name in ("Block", "Stop")]
    both[1].Placement.Base = at(12, 3, 0)
    document.recompute()
    return cad, faces, solids, {"two": both}, told, {name: s.Volume for name, s in solids.items()}


def main():
    (name,) = sys.argv[1:]
    module, faces, solids, assemblies, areas, volumes = {f.__name__: f for f in (build123d, cadquery, freecad)}[name]()
    tape = replay.Recorder()
    # Solids are cut by functions of the program.
    sys.modules[name] = tape.wrap(module)
    readers = cs.Part.from_cad, cs.Part.from_solid, cs.Model.from_assembly
    roots = {}
    for kind, read, real in zip(("faces", "solids", "assemblies"), readers, (faces, solids, assemblies)):
        roots[kind] = {name: tape.wrap(given) for name, given in real.items()}
        for given in roots[kind].values():
            try:
                read(given)
            except cs.Error as error:
                print(error)
    roots |= {"module": sys.modules[name], "areas": areas, "volumes": volumes}
    tape.save(FOLDER / f"{name}.json", roots)


if __name__ == "__main__":
    main()
