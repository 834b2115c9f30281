"""The knee: femur and tibia in the plane of flexion, and the patella in the groove of the femur."""

import math

from cams import RECONSTRUCTION
from drawing import Edge, Model, Outline, meet_line_circle, moved, nearest, polar, rounded_polygon


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


def tibia_femur():
    fore, _ = chain(0j, 0, FORE)
    hind, _ = chain(0j, 180, HIND)
    lean = polar(1, 92)
    back_foot, front_foot = -17 + 62j, 16 + 62j
    last = fore[-1]
    front = max(meet_line_circle(front_foot, lean, last.centre, last.radius()), key=lambda p: p.imag)
    fore[-1] = Edge(last.start, front, last.note, last.centre, last.turn)
    last = hind[-1]
    back = nearest(meet_line_circle(back_foot, lean, last.centre, last.radius()), -20 + 52j)
    hind[-1] = Edge(last.start, back, last.note, last.centre, last.turn)
    head = back_foot + lean * 40
    pen = Outline(head).round(3.0).line(back, "shaft, back").round(12.0)
    follow(pen, backwards(hind))
    follow(pen, fore).round(25.0)
    pen.line(front_foot + lean * 40, "shaft, front").round(3.0).line(head, "cut")
    femur = pen.closed()

    to_back, _ = chain(0j, 180, DISH_BACK)
    to_front, _ = chain(0j, 0, DISH_FRONT)
    return femur, to_back, to_front
