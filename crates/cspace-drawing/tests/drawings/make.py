"""Makes the drawings of this folder with ezdxf, and says in expected.json what is to be found in them.

    pip install ezdxf==1.4.5
    python make.py

Areas, perimeters and counts are computed here from the dimensions, not from the files. Where curves are fitted, `within` is
how far area and perimeter may be off, as a share; lines and arcs are then not counted.
"""

import json
import math
import pathlib

import ezdxf
from ezdxf.math import ConstructionArc, Vec2

HERE = pathlib.Path(__file__).parent
EXPECTED = {}
PI = math.pi


def new(version="R2000"):
    doc = ezdxf.new(version)
    return doc, doc.modelspace()


def save(name, doc, parts, binary=False, within=1e-9, **more):
    path = HERE / f"{name}.dxf"
    if binary:
        doc.saveas(path, fmt="bin")
    else:
        doc.saveas(path)
    EXPECTED[path.name] = {"parts": parts, "within": within, **more}


def text(name, content, parts, within=1e-9, newline="\n", encoding="ascii", **more):
    path = HERE / f"{name}.dxf"
    path.write_bytes(content.replace("\n", newline).encode(encoding))
    EXPECTED[path.name] = {"parts": parts, "within": within, **more}


def part(area, perimeter=None, loops=1, lines=None, arcs=None, name=None):
    return {k: v for k, v in {"area": area, "perimeter": perimeter, "loops": loops,
                              "lines": lines, "arcs": arcs, "name": name}.items() if v is not None}


def slot(length, radius):
    """A slot from (0, 0) to (length, 0): two lines, two arcs."""
    return part(2 * radius * length + PI * radius**2, 2 * length + 2 * PI * radius, lines=2, arcs=2)


def loose_slot(msp, length=40, radius=5, gap=0.0, layer="slot"):
    at = {"layer": layer}
    msp.add_line((0, -radius), (length, -radius), at)
    msp.add_arc((0, 0), radius, 90, 270, dxfattribs=at)
    msp.add_line((length + gap, radius), (gap, radius), at)
    msp.add_arc((length, 0), radius, 270, 90, dxfattribs=at)


# -- lines and arcs, of every version
for version in ["R12", "R2000", "R2004", "R2007", "R2010", "R2013", "R2018"]:
    doc, msp = new(version)
    loose_slot(msp)
    save(f"slot_{version.lower()}", doc, [slot(40, 5) | {"name": "slot"}], used={"LINE": 2, "ARC": 2})
for version in ["R12", "R2000", "R2018"]:
    doc, msp = new(version)
    loose_slot(msp)
    save(f"slot_{version.lower()}_binary", doc, [slot(40, 5)], binary=True)

# -- polylines with bulges
rounded = [(0, 0, 0), (30, 0, math.tan(PI / 8)), (40, 10, 0), (40, 20, 0), (0, 20, 0), (0, 15, -0.5), (0, 5, 0)]
# A plate 40 by 20 with a corner rounded by 10, and a segment of bulge 0.5 cut out of its left side.
sweep = 4 * math.atan(0.5)
area = 40 * 20 - (100 - 25 * PI) - 6.25**2 / 2 * (sweep - math.sin(sweep))
perimeter = 30 + 5 * PI + 10 + 40 + 5 + 6.25 * sweep + 5
plate = part(area, perimeter, lines=5, arcs=2)
doc, msp = new("R12")
msp.add_polyline2d(rounded, format="xyb", close=True)
save("polyline_r12", doc, [plate], used={"POLYLINE": 1})
doc, msp = new("R2000")
msp.add_lwpolyline(rounded, format="xyb", close=True)
save("lwpolyline", doc, [plate], used={"LWPOLYLINE": 1})
doc, msp = new("R2010")
msp.add_lwpolyline(rounded + [rounded[0]], format="xyb", close=True)
save("lwpolyline_first_repeated", doc, [plate])
doc, msp = new("R2010")
open_one = msp.add_lwpolyline(rounded + [(0, 0, 0)], format="xyb", close=False)
save("lwpolyline_not_flagged_closed", doc, [plate])
doc, msp = new("R2000")
msp.add_polyline3d([(0, 0, 3), (10, 0, 3), (10, 10, 3), (0, 10, 3)], close=True)
save("polyline_in_space", doc, [part(100, 40, lines=4, arcs=0)])

# -- circles, nested: a washer, an island in its hole
doc, msp = new("R2018")
for r in (20, 12, 5, 2):
    msp.add_circle((100, 50), r)
save("rings", doc, [part(PI * (400 - 144), 2 * PI * 32, loops=2, arcs=4, lines=0),
                    part(PI * 21, 2 * PI * 7, loops=2, arcs=4, lines=0)])

# -- blocks
doc, msp = new("R2000")
block = doc.blocks.new("PAWL", base_point=(1, 2))
block.add_lwpolyline([(1, 2, 0), (4, 2, 0.5), (4, 6, 0)], format="xyb", close=True)
half = 2 * math.atan(0.5)
r = 4 / (2 * math.sin(half))
segment = r * r / 2 * (2 * half - math.sin(2 * half))
one, around = 6 + segment, 3 + 5 + r * 2 * half
msp.add_blockref("PAWL", (0, 0))
msp.add_blockref("PAWL", (50, 0), {"rotation": 30, "xscale": 2, "yscale": 2})
msp.add_blockref("PAWL", (0, 50), {"xscale": -1, "rotation": 75})
msp.add_blockref("PAWL", (50, 50), {"xscale": 3, "yscale": -3, "zscale": 3})
save("blocks", doc, [part(one, around, lines=2, arcs=1, name="PAWL 1"),
                     part(4 * one, 2 * around, lines=2, arcs=1, name="PAWL 2"),
                     part(one, around, lines=2, arcs=1, name="PAWL 3"),
                     part(9 * one, 3 * around, lines=2, arcs=1, name="PAWL 4")])
doc, msp = new("R2007")
hole = doc.blocks.new("HOLE")
hole.add_circle((0, 0), 2)
row = doc.blocks.new("ROW")
row.add_blockref("HOLE", (0, 0), {"column_count": 4, "column_spacing": 10})
msp.add_lwpolyline([(-10, -10), (50, -10), (50, 40), (-10, 40)], close=True)
msp.add_blockref("ROW", (0, 0), {"row_count": 3, "row_spacing": 15})
save("nested_arrays", doc, [part(60 * 50 - 12 * PI * 4, 220 + 12 * 4 * PI, loops=13, lines=4, arcs=24)])
doc, msp = new("R2000")
round_one = doc.blocks.new("ROUND")
round_one.add_circle((0, 0), 10)
msp.add_blockref("ROUND", (0, 0), {"xscale": 2, "yscale": 1, "rotation": 20})
a, b = 20, 10
h = ((a - b) / (a + b)) ** 2
ramanujan = PI * (a + b) * (1 + 3 * h / (10 + math.sqrt(4 - 3 * h)))
save("stretched_block", doc, [part(PI * a * b, ramanujan)], within=2e-4)
EXPECTED["stretched_block.dxf"]["fitted"] = 1

# -- ellipses
doc, msp = new("R2000")
msp.add_ellipse((5, 5), major_axis=(20, 0), ratio=0.5)
save("ellipse", doc, [part(PI * 200, ramanujan)], within=2e-4, fitted=1)
doc, msp = new("R2000")
msp.add_ellipse((0, 0), major_axis=(0, 20), ratio=0.5, start_param=0, end_param=PI)
msp.add_line((0, 20), (0, -20))
save("half_ellipse", doc, [part(PI * 100, ramanujan / 2 + 40)], within=2e-4, fitted=1)
doc, msp = new("R2000")
msp.add_ellipse((0, 0), major_axis=(3, 4), ratio=1.0)
save("round_ellipse", doc, [part(PI * 25, 10 * PI, lines=0, arcs=2)])

# -- splines
doc, msp = new("R2000")
w = math.sqrt(0.5)
square = [(10, 0), (10, 10), (0, 10), (-10, 10), (-10, 0), (-10, -10), (0, -10), (10, -10), (10, 0)]
msp.add_rational_spline(square, [1, w, 1, w, 1, w, 1, w, 1], degree=2,
                        knots=[0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4])
save("spline_circle", doc, [part(100 * PI, 20 * PI)], within=1e-4, fitted=1)


def spline_measures(curve, steps=20000):
    """Area and length of a closed curve by many points."""
    points = list(curve.approximate(steps))
    area = sum(p.x * q.y - q.x * p.y for p, q in zip(points, points[1:] + points[:1])) / 2
    return abs(area), sum(p.distance(q) for p, q in zip(points, points[1:]))


doc, msp = new("R2010")
spline = msp.add_open_spline([(0, 0), (10, 30), (30, 35), (45, 10), (60, 0)])
msp.add_line((60, 0), (0, 0))
tool = spline.construction_tool()
area, length = spline_measures(tool)
save("spline_and_line", doc, [part(area, length + 60)], within=2e-4, fitted=1)
doc, msp = new("R2000")
through = [(0, 0), (10, 8), (22, 9), (35, 0)]
msp.add_spline(through)
msp.add_lwpolyline([(35, 0), (35, -10), (0, -10), (0, 0)])
save("spline_through_points", doc, [], within=1e-3, fitted=1, close_to="a natural cubic")

# -- seen from behind
doc, msp = new("R2000")
behind = {"extrusion": (0, 0, -1)}
msp.add_lwpolyline(rounded, format="xyb", close=True, dxfattribs=behind)
save("from_behind", doc, [plate])
doc, msp = new("R2000")
msp.add_line((0, -5), (40, -5))
msp.add_arc((0, 0), 5, 270, 90, dxfattribs=behind)
msp.add_line((40, 5), (0, 5))
msp.add_arc((-40, 0), 5, 90, 270, dxfattribs=behind)
save("arcs_from_behind", doc, [slot(40, 5)])
doc, msp = new("R2000")
block = doc.blocks.new("B")
block.add_lwpolyline(rounded, format="xyb", close=True)
msp.add_blockref("B", (7, 8), {"extrusion": (0, 0, -1), "rotation": 40})
save("block_from_behind", doc, [plate | {"name": "B"}])

# -- layers
doc, msp = new("R2000")
for name in ("outline", "frozen", "off", "Bohrungen ø"):
    doc.layers.add(name)
doc.layers.get("frozen").freeze()
doc.layers.get("off").off()
msp.add_lwpolyline([(0, 0), (50, 0), (50, 30), (0, 30)], close=True, dxfattribs={"layer": "outline"})
msp.add_circle((10, 10), 3, dxfattribs={"layer": "Bohrungen ø"})
msp.add_circle((20, 10), 3, dxfattribs={"layer": "frozen"})
msp.add_circle((30, 10), 3, dxfattribs={"layer": "off"})
save("layers", doc, [part(1500 - 9 * PI, 160 + 6 * PI, loops=2, lines=4, arcs=2)], ignored={"CIRCLE": 2})
doc, msp = new("R2000")
doc.layers.add("frozen").freeze()
doc.layers.add("off").off()
block = doc.blocks.new("B")
block.add_circle((0, 0), 3)
block.add_circle((10, 0), 2, dxfattribs={"layer": "own"})
msp.add_blockref("B", (0, 0), {"layer": "off"})
msp.add_blockref("B", (0, 20), {"layer": "frozen"})
save("layers_of_inserts", doc, [part(4 * PI, 4 * PI, lines=0, arcs=2)], ignored={"CIRCLE": 3})

# -- what is drawn twice
doc, msp = new("R2000")
loose_slot(msp)
loose_slot(msp)
msp.add_line((30, -5), (10, -5))
save("drawn_twice", doc, [slot(40, 5)], removed={"duplicates": 5, "overlaps": 0})
doc, msp = new("R2000")
msp.add_line((0, 0), (25, 0))
msp.add_line((40, 0), (15, 0))
msp.add_line((40, 0), (40, 20))
msp.add_arc((20, 20), 20, 0, 100)
msp.add_arc((20, 20), 20, 60, 180)
msp.add_line((0, 20), (0, 0))
msp.add_line((0, 0), (0, 0))
save("overlapping", doc, [part(800 + 200 * PI, 80 + 20 * PI, lines=3, arcs=1)],
     removed={"overlaps": 2, "tiny": 1})
doc, msp = new("R2000")
for _ in range(2):
    msp.add_lwpolyline(rounded, format="xyb", close=True)
msp.add_circle((20, 10), 3)
msp.add_arc((20, 10), 3, 30, 200)
msp.add_ellipse((20, 10), major_axis=(1, 0), ratio=0.5)
msp.add_ellipse((20, 10), major_axis=(1, 0), ratio=0.5)
area_of = plate["area"] - 9 * PI + PI / 2
save("polylines_drawn_twice", doc, [part(plate["area"] - 9 * PI, perimeter + 6 * PI, loops=2),
                                    part(PI / 2, 4.844224110273838)], within=2e-3, fitted=1)

doc, msp = new("R2000")
# Parts side by side, one of them drawn twice, the second time from another vertex and the other way around.
for x in (0, 10, 20):
    msp.add_lwpolyline([(x, 0), (x + 10, 0), (x + 10, 10), (x, 10)], close=True, dxfattribs={"layer": f"at {x}"})
msp.add_lwpolyline([(20, 10), (20, 0), (10, 0), (10, 10)], close=True, dxfattribs={"layer": "again"})
msp.add_line((3, 0), (8, 0))
save("side_by_side", doc, [part(100, 40, lines=4, arcs=0, name=f"at {x}") for x in (0, 10, 20)], removed={"duplicates": 5})

# -- loose ends
doc, msp = new("R2000")
loose_slot(msp, gap=2e-5)
save("small_gaps", doc, [slot(40, 5)], within=1e-6, joined=2)

# -- what is no outline
doc, msp = new("R2010")
msp.add_lwpolyline([(0, 0), (50, 0), (50, 30), (0, 30)], close=True, dxfattribs={"layer": "plate"})
msp.add_text("PLATE 50x30", dxfattribs={"insert": (5, 5)})
msp.add_mtext("two\nlines")
msp.add_point((1, 1))
hatch = msp.add_hatch()
hatch.paths.add_polyline_path([(0, 0), (50, 0), (50, 30), (0, 30)], is_closed=True)
msp.add_linear_dim(base=(0, -5), p1=(0, 0), p2=(50, 0)).render()
msp.add_solid([(60, 0), (61, 0), (60, 1)])
msp.add_ray((0, 0), (1, 1))
doc.layout("Layout1").add_line((0, 0), (1, 1))
save("texts_and_dimensions", doc, [part(1500, 160, lines=4, arcs=0, name="plate")],
     ignored={"TEXT": 1, "MTEXT": 1, "POINT": 1, "HATCH": 1, "DIMENSION": 1, "SOLID": 1, "RAY": 1, "LINE": 1})

# -- outlines of hatches: polylines, and edges of all kinds, some of them clockwise
doc, msp = new("R2010")


def hatch(layer):
    return msp.add_hatch(dxfattribs={"layer": layer}).paths


paths = hatch("plate")
paths.add_polyline_path([(0, 0), (10, 0), (10, 10), (0, 10)], is_closed=True, flags=1)
paths.add_edge_path(flags=16).add_arc((5, 5), 2, 0, 360, ccw=False)
# The box of a text, which is no outline.
paths.add_polyline_path([(4, 4), (6, 4), (6, 6), (4, 6)], is_closed=True, flags=8)
edges = hatch("slot").add_edge_path(flags=1)
edges.add_line((20, 0), (26, 0))
edges.add_arc((26, 2), 2, 270, 90)
edges.add_line((26, 4), (20, 4))
edges.add_arc((20, 2), 2, 90, 270)
edges = hatch("half").add_edge_path(flags=1)
edges.add_ellipse((33, 0), (3, 0), 0.5, 0, 180)
edges.add_line((30, 0), (36, 0))
edges = hatch("notched").add_edge_path(flags=1)
edges.add_line((40, 0), (50, 0))
edges.add_line((50, 0), (50, 10))
edges.add_line((50, 10), (43, 10))
edges.add_ellipse((40, 10), (3, 0), 0.5, 270, 360, ccw=False)
edges.add_line((40, 8.5), (40, 0))
edges = hatch("mouth").add_edge_path(flags=1)
edges.add_line((54, 3), (54, 0))
edges.add_line((54, 0), (62, 0))
edges.add_line((62, 0), (62, 6))
edges.add_line((62, 6), (54, 6))
edges.add_line((54, 6), (54, 5))
edges.add_arc((54, 4), 1, 270, 90, ccw=False)
edges = hatch("oblique").add_edge_path(flags=1)
# A quarter by its parameters, which are not its angles.
edges.add_ellipse((64, 0), (4, 0), 0.25, math.degrees(math.atan2(0.25, 1)), 90)
edges.add_line((64, 1), (64, 0))
edges.add_line((64, 0), (64 + 4 * math.sqrt(0.5), math.sqrt(0.5)))
edges = hatch("parabola").add_edge_path(flags=1)
edges.add_spline(control_points=[(70, 0), (75, 10), (80, 0)], degree=2, knot_values=[0, 0, 0, 1, 1, 1])
edges.add_line((80, 0), (70, 0))
hatch("disc").add_polyline_path([(84, 0, 1), (88, 0, 1)], is_closed=True)
save("hatches", doc, [
    part(100 - 4 * PI, loops=2, name="plate"), part(24 + 4 * PI, name="slot"),
    part(2.25 * PI, name="half"), part(100 - 1.125 * PI, name="notched"),
    part(48 - PI / 2, name="mouth"), part(PI / 2, name="oblique"),
    part(100 / 3, name="parabola"), part(4 * PI, name="disc"),
], within=1e-3, hatches=True, fitted=4, used={"HATCH": 9})

# -- units
for number, label in [(1, "in"), (4, "mm"), (6, "m")]:
    doc, msp = new("R2000")
    doc.header["$INSUNITS"] = number
    msp.add_circle((0, 0), 1)
    save(f"unit_{label}", doc, [part(PI, 2 * PI, lines=0, arcs=2)], unit=label)

# -- text files of other programs
bare = """0
SECTION
2
ENTITIES
0
LINE
8
0
10
0.0
20
0.0
11
3.0
21
0.0
0
LINE
8
0
10
3
20
0
11
0
21
4
0
LINE
8
0
10
0
20
4.
11
.0
21
-0.0
0
ENDSEC
0
EOF
"""
triangle = part(6, 12, lines=3, arcs=0)
text("bare", bare, [triangle])
text("bare_crlf", bare, [triangle], newline="\r\n")
text("bare_cr", bare, [triangle], newline="\r")
padded = "\n".join(f"{line:>3}" if i % 2 == 0 else line for i, line in enumerate(bare.splitlines())) + "\n\n\n"
text("padded_codes", "999\nmade by hand\n" + padded, [triangle])
text("code_page_1252", """0
SECTION
2
HEADER
9
$ACADVER
1
AC1009
9
$DWGCODEPAGE
3
ANSI_1252
0
ENDSEC
0
SECTION
2
ENTITIES
0
CIRCLE
8
Gehäuse
10
1
20
1
40
2
0
ENDSEC
0
EOF
""", [part(4 * PI, 4 * PI, lines=0, arcs=2, name="Gehäuse")], encoding="cp1252")


# -- gears
def involute_flank(base, outer, side, at, steps):
    """Points of an involute from the base circle outwards."""
    top = math.sqrt((outer / base) ** 2 - 1)
    points = []
    for k in range(steps + 1):
        t = top * k / steps
        x, y = base * (math.cos(t) + t * math.sin(t)), base * (math.sin(t) - t * math.cos(t))
        points.append(Vec2(x, side * y).rotate(at))
    return points


def gear(msp, teeth, center=(0, 0), phase=0.0, thinner=0.0, layer="0", module=2.0, pressure=math.radians(20)):
    """Involute flanks as splines through points, tips and roots as arcs, as gear generators draw them."""
    center = Vec2(center)
    at = {"layer": layer}
    pitch = module * teeth / 2
    base, outer, root = pitch * math.cos(pressure), pitch + module, pitch - 1.25 * module
    half = PI / (2 * teeth) + math.tan(pressure) - pressure - thinner / pitch
    for k in range(teeth):
        turn = phase + 2 * PI * k / teeth
        right = involute_flank(base, outer, 1, turn - half, 12)
        left = involute_flank(base, outer, -1, turn + half, 12)
        for flank in (right, left):
            msp.add_cad_spline_control_frame([center + p for p in flank], dxfattribs=at)
            msp.add_line(center + flank[0].normalize(root), center + flank[0], at)
        tips = [math.degrees(p[-1].angle) for p in (right, left)]
        msp.add_arc(center, outer, *tips, dxfattribs=at)
        nexts = [math.degrees(left[0].angle), math.degrees(right[0].rotate(2 * PI / teeth).angle)]
        msp.add_arc(center, root, *nexts, dxfattribs=at)
    msp.add_circle(center, 4, at)


doc, msp = new("R2000")
gear(msp, 18)
save("gear_splines", doc, [], fitted=36, loops=2, within=1e-3)
# Two gears that mesh, with some play between their teeth.
doc, msp = new("R2000")
doc.header["$INSUNITS"] = 4
gear(msp, 18, thinner=0.02, layer="GEAR")
gear(msp, 24, center=(42, 0), phase=PI + PI / 24, thinner=0.02, layer="MATE")
save("gear_pair", doc, [], fitted=84, within=1e-3)

# -- random outlines, each on a layer of its name
chance = __import__("random").Random(23)


def random_outline(center):
    """A star of lines and arcs; its vertices with bulges, area and perimeter."""
    n = chance.randint(3, 9)
    angles = [2 * PI * (k + 0.6 * chance.random()) / n for k in range(n)]
    vertices = [(center[0] + r * math.cos(t), center[1] + r * math.sin(t), chance.choice([0, 0, 1]) * chance.uniform(-0.12, 0.3))
                for t in angles for r in [chance.uniform(4, 10)]]
    area = around = 0
    for (x0, y0, b), (x1, y1, _) in zip(vertices, vertices[1:] + vertices[:1]):
        chord = math.hypot(x1 - x0, y1 - y0)
        area += (x0 * y1 - x1 * y0) / 2
        if b:
            sweep = 4 * math.atan(b)
            r = chord / (2 * math.sin(sweep / 2))
            area += r * r / 2 * (sweep - math.sin(sweep))
            around += abs(r * sweep)
        else:
            around += chord
    arcs = sum(1 for v in vertices if v[2])
    return vertices, area, around, n - arcs, arcs


def add_loose(msp, vertices, layer):
    """Its lines and arcs one by one, in any order and direction."""
    pieces = list(zip(vertices, vertices[1:] + vertices[:1]))
    chance.shuffle(pieces)
    for (x0, y0, b), (x1, y1, _) in pieces:
        if b == 0:
            ends = [(x0, y0), (x1, y1)]
            chance.shuffle(ends)
            msp.add_line(*ends, {"layer": layer})
        else:
            center, start, end, radius = ezdxf.math.bulge_to_arc((x0, y0), (x1, y1), b)
            msp.add_arc(center, radius, math.degrees(start), math.degrees(end), dxfattribs={"layer": layer})


for version, form in [("R12", "loose"), ("R2018", "loose"), ("R12", "polyline"), ("R2007", "polyline"), ("R2000", "block")]:
    doc, msp = new(version)
    parts = []
    for k in range(40):
        vertices, area, around, lines, arcs = random_outline((25 * (k % 8), 25 * (k // 8)))
        layer = f"PART_{k}"
        factor = 1
        if form == "loose":
            add_loose(msp, vertices, layer)
        elif form == "polyline" and version == "R12":
            msp.add_polyline2d(vertices, format="xyb", close=True, dxfattribs={"layer": layer})
        elif form == "polyline":
            msp.add_lwpolyline(vertices, format="xyb", close=True, dxfattribs={"layer": layer})
        else:
            factor = chance.uniform(0.5, 2)
            block = doc.blocks.new(layer, base_point=vertices[0][:2])
            add_loose(block, vertices, "0")
            msp.add_blockref(layer, (50 * (k % 8), 50 * (k // 8)), {
                "rotation": chance.uniform(0, 360), "xscale": factor, "yscale": chance.choice([-1, 1]) * factor})
        parts.append(part(abs(area) * factor**2, around * factor, lines=lines, arcs=arcs, name=layer))
    save(f"random_{form}_{version.lower()}", doc, parts, binary=version == "R2018", within=1e-9)

# -- SVG
def svg(name, body, parts, head='width="100mm" height="80mm" viewBox="0 0 100 80"', within=1e-9, **more):
    path = HERE / f"{name}.svg"
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" {head}>\n{body}\n</svg>\n')
    EXPECTED[path.name] = {"parts": parts, "within": within, **more}


svg("shapes", """<rect x="10" y="10" width="40" height="20" rx="5"/>
<circle cx="70" cy="20" r="8" fill="none" stroke="red"/>
<ellipse cx="70" cy="50" rx="20" ry="10"/>
<polygon points="10,50 30,50 30,70"/>
<text x="0" y="0">no outline</text>""",
    [part(800 - 100 + 25 * PI, 80 + 10 * PI, lines=4, arcs=4), part(64 * PI, 16 * PI, lines=0, arcs=2),
     part(200 * PI, ramanujan), part(200, 40 + math.sqrt(800), lines=3, arcs=0)],
    within=2e-4, fitted=1, ignored={"text": 1}, unit="mm")
svg("path_arcs", '<path id="slot" d="M5-5h40a5 5 0 0 1 0 10H5A5 5 0 1 1 5-5z"/>', [slot(40, 5)], unit="mm")
svg("path_large_arcs", '<path d="M0 0 A10 10 0 1 0 10 10 L0 10Z"/>',
    [part(75 * PI, 15 * PI + 20, lines=2, arcs=1)], head="")
svg("path_relative", '<path d="m 10,10 10,0 0,10 -10,0 z m 3,3 v4 h4 v-4 z"/>', [part(100 - 16, 56, loops=2, lines=8, arcs=0)])
k = 4 / 3 * (math.sqrt(2) - 1) * 10
svg("bezier_circle", f'<path d="M10 0C10 {k} {k} 10 0 10S-10 {k}-10 0S-{k}-10 0-10S10-{k} 10 0Z"/>',
    [part(100 * PI, 20 * PI)], within=1e-3, fitted=1)
svg("transforms", """<g transform="translate(50 40) rotate(30) scale(2)"><g transform="matrix(-1 0 0 1 3 4)">
<path d="M0 0 H10 A10 10 0 0 1 0 10 Z"/></g></g>""", [part(100 * PI, 40 + 10 * PI, lines=2, arcs=1)])
svg("used", """<defs><circle id="hole" r="3"/><symbol id="s" viewBox="0 0 10 10"><circle cx="5" cy="5" r="5"/></symbol></defs>
<rect x="0" y="0" width="60" height="40"/>
<use href="#hole" x="10" y="10"/><use xlink:href="#hole" transform="translate(30 20)"/>
<use href="#s" x="70" y="0" width="20" height="20"/>""",
    [part(2400 - 18 * PI, 200 + 12 * PI, loops=3, lines=4, arcs=4), part(100 * PI, 20 * PI, lines=0, arcs=2)])
svg("inches", '<rect x="0" y="0" width="96" height="48"/>', [part(0.5, 3, lines=4, arcs=0)],
    head='width="2in" height="1in" viewBox="0 0 192 96"', unit="in")
svg("pixels", '<rect width="1cm" height="1in"/>', [part(37.79527559055118 * 96, 2 * (37.79527559055118 + 96))],
    head='width="100px" height="100px"', unit="px")
svg("styles", """<style>.a, .b { fill: none; stroke: #000 } .c { display: none }</style>
<path class="a" d="M0 0H10"/><path class="b" d="M10 0V10"/><path style="fill:none;stroke:red" d="M10 10L0 0"/>
<rect class="c" width="50" height="50"/><rect fill="none" width="40" height="40"/>
<g visibility="hidden"><rect width="30" height="30"/></g>
<path d="M20 0H30V10"/>""", [part(50, 20 + math.sqrt(200), lines=3, arcs=0)] * 2, ignored={"rect": 3})
svg("doctype", '<path d="M0 0H10V10Z"/>', [part(50, 20 + math.sqrt(200), lines=3, arcs=0)])
path = HERE / "doctype.svg"
path.write_text("""<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd" [
<!ENTITY ns_svg "http://www.w3.org/2000/svg">
]>
""" + path.read_text().replace('"http://www.w3.org/2000/svg"', '"&ns_svg;"'))

# -- measured points
random = __import__("random").Random(4)


def csv(name, points, parts, within, head="x,y\n", scatter=0.0, **more):
    path = HERE / f"{name}.csv"
    rows = (f"{x + random.gauss(0, scatter):.9g},{y + random.gauss(0, scatter):.9g}" for x, y in points)
    path.write_text(head + "\n".join(rows) + "\n")
    EXPECTED[path.name] = {"parts": parts, "within": within, "fitted": 1, **more}


def along(*pieces, step):
    """Points at even steps along lines (p, q) and arcs (center, radius, from, to)."""
    for piece in pieces:
        if len(piece) == 2:
            p, q = map(Vec2, piece)
            n = max(1, round(p.distance(q) / step))
            yield from ((p.lerp(q, k / n).x, p.lerp(q, k / n).y) for k in range(n))
        else:
            (cx, cy), r, a, b = piece
            n = max(1, round(abs(b - a) * r / step))
            for k in range(n):
                t = a + (b - a) * k / n
                yield cx + r * math.cos(t), cy + r * math.sin(t)


slot_pieces = [((0, -5), (40, -5)), ((40, 0), 5, -PI / 2, PI / 2), ((40, 5), (0, 5)), ((0, 0), 5, PI / 2, 3 * PI / 2)]
csv("slot_points", along(*slot_pieces, step=0.25), [slot(40, 5) | {"lines": 2, "arcs": 2}], 1e-3)
csv("slot_scattered", along(*slot_pieces, step=0.1), [slot(40, 5) | {"lines": 2, "arcs": 2}], 5e-3, scatter=0.01, fit=0.05)
square_points = [((0, 0), (10, 0)), ((10, 0), (10, 10)), ((10, 10), (0, 10)), ((0, 10), (0, 0))]
csv("square_points", along(*square_points, step=0.3), [part(100, 40, lines=4, arcs=0)], 1e-9)
shifted = [p for i, p in enumerate(along(*square_points, step=0.1)) if i % 7 == 3]
csv("square_corners_missing", shifted, [part(100, 40, lines=4, arcs=0)], 1e-9, head="# scanned\n")
csv("square_of_four", [(0, 0), (10, 0), (10, 10), (0, 10)], [part(100, 40, lines=4, arcs=0)], 1e-9, head="")
csv("circle_points", [(3 + 7 * math.cos(t / 20), 7 * math.sin(t / 20)) for t in range(125)],
    [part(49 * PI, 14 * PI, lines=0, arcs=2)], 1e-3)
# A cam: a radius that rises and falls without a corner.
cam = [(20 + 4 * (1 - math.cos(t)) + math.sin(2 * t)) for t in (k * PI / 180 for k in range(360))]
cam_points = [(r * math.cos(k * PI / 180), r * math.sin(k * PI / 180)) for k, r in enumerate(cam)]
csv("cam_points", cam_points, [], 1e-3)
csv("cam_scattered", cam_points, [], 1e-2, scatter=0.005, fit=0.02)

(HERE / "expected.json").write_text(json.dumps(EXPECTED, indent=1, ensure_ascii=False) + "\n")
