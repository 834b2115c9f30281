"""The knee: femur and tibia in the plane of flexion, and the patella in the groove of the femur."""

from common import RECONSTRUCTION
from drawing import Edge, Model, Outline, meet_line_circle, meet_lines, nearest, polar, rounded_polygon
from forces import placed

BONE = "density = 5.7e-5 # bone, 30 thick"


def chain(start, heading, steps):
    """Tangent arcs from a point on: (radius, degrees), a positive radius turning to the left."""
    edges = []
    for radius, degrees in steps:
        centre = start + radius * polar(1, heading + 90)
        turn = 1 if radius > 0 else -1
        end = centre + (start - centre) * polar(1, turn * degrees)
        edges.append(Edge(start, end, f"R{abs(radius):g}", centre, turn))
        start, heading = end, heading + turn * degrees
    return edges, heading


def backwards(edges):
    return [Edge(e.end, e.start, e.note, e.centre, -e.turn) for e in reversed(edges)]


def follow(pen, edges):
    for e in edges:
        pen.arc(e.centre, e.end, e.turn, e.note)
    return pen


# From the lowest point on, (radius, degrees): of the femur's condyle to the front and to the back, of the tibia's plateau and rims.
FEMUR_FRONT = [(44, 14), (37, 18), (31, 22), (26, 50)]
FEMUR_BACK = [(-40, 16), (-33, 20), (-27, 26), (-23, 36), (-20, 40), (-18, 40)]
TIBIA_FRONT = [(60, 20), (-9, 50), (-5, 80)]
TIBIA_BACK = [(-66, 20), (7, 50), (5, 72)]


def femur_outline():
    fore, _ = chain(0j, 0, FEMUR_FRONT)
    hind, _ = chain(0j, 180, FEMUR_BACK)
    lean, length = polar(1, 92), 45.0  # of the shaft
    back_foot, front_foot = -13 + 60j, 17 + 60j

    def cut_off(edges, foot, pick):
        """The last arc ends where it meets the shaft's line."""
        last = edges[-1]
        end = pick(meet_line_circle(foot, lean, last.centre, last.radius()))
        edges[-1] = Edge(last.start, end, last.note, last.centre, last.turn)
        return end

    back = cut_off(hind, back_foot, lambda points: nearest(points, back_foot - 7j))
    cut_off(fore, front_foot, lambda points: max(points, key=lambda p: p.imag))
    head = back_foot + lean * length
    pen = Outline(head).round(3.0).line(back, "shaft, back").round(12.0)
    follow(follow(pen, backwards(hind)), fore).round(25.0)
    return pen.line(front_foot + lean * length, "shaft, front").round(3.0).line(head, "cut").closed()


def tibia_outline():
    fore, down = chain(0j, 0, TIBIA_FRONT)
    hind, under = chain(0j, 180, TIBIA_BACK)
    front, back = fore[-1].end, hind[-1].end
    shaft, tuberosity, cut = polar(1, -93), 27 - 42j, -95.0
    notch = meet_lines(back, polar(1, under), -15 - 60j, shaft)
    neck = meet_lines(front, polar(1, down), tuberosity, polar(1, 100))
    pen = follow(follow(Outline(front), backwards(fore)), hind)
    pen.line(notch, "back").round(50.0).line(meet_lines(notch, shaft, 1j * cut, 1), "shaft, back").round(3.0)
    pen.line(complex(13, cut), "cut").round(3.0).line(15 - 60j, "shaft, front").round(30.0)
    pen.line(tuberosity, "tuberosity").round(6.0).line(neck, "tuberosity").round(12.0)
    return pen.line(front, "front").closed()


def radii(steps):
    return ", ".join(f"R{abs(radius):g} over {degrees:g}" for radius, degrees in steps)


def tibia_femur():
    femur, tibia = femur_outline(), tibia_outline()
    # The marrow stays some 5 from the surface.
    canals = [rounded_polygon([(p, 3.0, "marrow") for p in corners]) for corners in (
        (-8 + 58j, 12 + 58j, 10.5 + 98j, -9.5 + 98j), (-6 - 30j, -8 - 89j, 6 - 89j, 8 - 30j))]
    m = Model("tibia_femur.toml", "tibia and femur", f"""
The knee in the plane of flexion: tibia and femur, as chains of tangent arcs. 27 + 25 = 52 features.

{RECONSTRUCTION}

The femur's condyle is made of arcs whose radii shrink to both sides of its lowest point, in mm and deg: to the front
{radii(FEMUR_FRONT[:-1])} and R{FEMUR_FRONT[-1][0]:g}; to the back
{radii(FEMUR_BACK[:-1])} and R{-FEMUR_BACK[-1][0]:g}.
The tibia's plateau is a dish, R{TIBIA_FRONT[0][0]:g} in front and R{-TIBIA_BACK[0][0]:g} behind, between rounded rims; its tuberosity stands out in
front. The bones are cut through the shaft, and show their marrow. Front is +x.

The femur's origin is the lowest point of its condyle, the tibia's the lowest point of its plateau: in extension they touch at
(x, y, theta) = (0, 0, 0). Flexed by theta, up to 115 deg, the femur slides in the dish, and its arcs come to
bear one after the other.
""")
    m.show("Does the shape of the joint alone hold the femur?")
    m.world(friction=0.02)
    m.part("tibia", "Plateau on top.", [("outline", tibia), ("marrow", canals[1])], keys=[BONE])
    m.part("femur", "Condyle below.", [("outline", femur), ("marrow", canals[0])], keys=[BONE, placed(0, 0.5, 5)])
    m.mounted("tibia", [-12 - 90j, 10 - 90j], 1e6, 1000, text="The tibia is held.")
    m.spring(("femur", "tibia"), (-8 + 24j, -4 - 12j), 3000, 20, 20, text="The ligaments hold the condyle to the plateau.")
    m.torque("femur", 60000, "The flexor: the femur rolls and slides in the dish and comes to rest bent, where the extensor balances it.")
    m.torsion(["femur", "tibia"], 40000, damping=30000, text="The extensor.")
    flexed, joint = 60.0, -90.0
    centre, before, left = 0j, 0.0, flexed  # of the arc that bears on the lowest point of the dish
    for radius, degrees in FEMUR_BACK:
        centre += (before + radius) * polar(1, joint)
        before = -radius
        if left <= degrees:
            break
        left, joint = left - degrees, joint - degrees
    return m.picture({"femur": (flexed, complex(0, before) - centre * polar(1, flexed))})


def patella_femur():
    lateral, medial = -22 + 11j, 20 + 7j  # the ridges, from the bottom of the groove
    femur = rounded_polygon([
        (0j, 9.0, "groove, lateral side"), (lateral, 6.0, "lateral side"), (-33 - 28j, 14.0, "lateral condyle"),
        (-8 - 46j, 6.0, "notch"), (1 - 22j, 5.0, "notch"), (24 - 42j, 8.0, "medial side"), (medial, 5.0, "groove, medial side"),
    ])
    patella = rounded_polygon([
        (0j, 10.0, "medial facet"), (medial * 1.1, 3.0, "medial edge"), (12 + 19j, 9.0, "front"),
        (-12 + 20j, 9.0, "lateral edge"), (lateral * 1.1, 3.0, "lateral facet"),
    ])
    m = Model("patella_femur.toml", "patella and femur", f"""
The knee from below, bent: the patella in the groove of the femur. 14 + 10 = 24 features.

{RECONSTRUCTION}

The section goes through the femur's condyles. The groove between the ridges is R9, its lateral side rises by 11 in 22, its medial side by
7 in 20; behind, the notch parts the condyles. The patella has a facet for either side and a keel R10 between. Front is +y,
lateral is -x.

At (x, y, theta) = (0, 0, 0) both facets lie on the sides of the groove, which holds the patella sideways.
""")
    m.show("Does the groove alone hold the patella?")
    m.part("femur", "The sides of the groove meet in the origin.", [("section", femur)], keys=[BONE])
    m.part("patella", "The facets meet in the origin.", [("section", patella)], keys=[BONE, placed(-8, 8, 15)])
    m.mounted("femur", [-20 - 40j, 20 - 40j], 1e6, 1000, text="The femur is held.")
    m.spring("patella", (10j, -30j), 500, 20, 30,
             text="The tendon pulls the patella, displaced to the side, back into the groove, where it comes to rest.")
    return m.picture({})
