#!/usr/bin/env python3
"""Checks a proof that there is no path, with nothing but Python's own fractions.

    python3 check.py PROOF.json

All numbers of the file are rational, and are taken as they are. Square roots and sines are bounded by rational numbers. The steps are
those of the crate `cspace-check`; the arithmetic is another.
"""

import json
import math
import sys
from fractions import Fraction as F

# Bounds are rounded to so many bits: fractions stay short.
BITS = 160

# π lies between these.
PI = (F("3.1415926535897932384626433832795028841971"), F("3.1415926535897932384626433832795028841972"))


def down(x):
    return F(math.floor(x * 2**BITS), 2**BITS)


def up(x):
    return F(math.ceil(x * 2**BITS), 2**BITS)


def root_up(x):
    """A number that is not less than the square root."""
    return F(math.isqrt(math.ceil(x * 4**BITS)) + 1, 2**BITS)


def root_down(x):
    return F(math.isqrt(math.floor(max(x, 0) * 4**BITS)), 2**BITS)


def sine_cosine(x):
    """Rational numbers near sine and cosine, and how far they may be off."""
    halvings = max(0, math.ceil(math.log2(max(abs(float(x)), 1e-9) * 8)))
    small = down(F(x) / 2**halvings)
    sine = cosine = F(0)
    term = F(1)
    for k in range(24):
        signed = term if k % 4 < 2 else -term
        if k % 2:
            sine += signed
        else:
            cosine += signed
        term = down(term * small / (k + 1))
    # The angle and 24 terms are rounded by one bit each, and no term's error grows in the next ones.
    error = abs(term) + F(64, 2**BITS)
    sine, cosine = down(sine), down(cosine)
    for _ in range(halvings):
        sine, cosine = down(2 * sine * cosine), down(1 - 2 * sine * sine)
        # |d(2sc)| and |d(2s²)| are at most 4 times the error and 2 of its square; rounding is one bit.
        error = 4 * error + 2 * error * error + F(1, 2**BITS)
    return sine, cosine, up(error)


def distance_down(p, a, b):
    """A number that the distance from p to the edge from a to b is not less than."""
    (px, py), (ax, ay, bulge), (bx, by, _) = p, a, b
    cx, cy, tx, ty = bx - ax, by - ay, px - ax, py - ay
    length2 = cx * cx + cy * cy
    along = cx * tx + cy * ty
    ends2 = min(tx * tx + ty * ty, (px - bx) ** 2 + (py - by) ** 2)
    if 0 <= along <= length2:
        line = root_down((cx * ty - cy * tx) ** 2 / length2)
    else:
        line = root_down(ends2)
    if bulge == 0:
        return line
    # An arc is nowhere farther from its chord than in its middle, and it lies on its circle.
    beside = line - abs(bulge) * root_up(length2) / 2
    lift = (1 - bulge * bulge) / (4 * bulge)
    mx, my = (ax + bx) / 2 - cy * lift, (ay + by) / 2 + cx * lift
    radius2 = length2 * ((1 + bulge * bulge) / (4 * bulge)) ** 2
    fx, fy = px - mx, py - my
    reach2 = fx * fx + fy * fy
    # The circle's point nearest to p is m + f r/|f|; on the arc if cross(chord, it − a) and the bulge differ in sign.
    offset, slope = cx * (my - ay) - cy * (mx - ax), cx * fy - cy * fx
    scale = (root_down(radius2 / reach2), root_up(radius2 / reach2)) if reach2 else (F(0), F(0))
    sides = [(offset + slope * s) * bulge for s in scale]
    circle = max(root_down(reach2) - root_up(radius2), root_down(radius2) - root_up(reach2))
    if min(sides) > 0:
        circle = root_down(ends2)
    return max(beside, circle)


def is_inside(p, loops, near):
    """Odd-even count, with arcs as chords nearer to them than `near`."""

    def crossings(a, b):
        (ax, ay, bulge), (bx, by, _) = a, b
        rise = abs(bulge) * (abs(bx - ax) + abs(by - ay))
        if bulge and abs(bulge) <= 1 and (max(ay, by) + rise < p[1] or min(ay, by) - rise > p[1] or max(ax, bx) + rise < p[0]):
            # All of the arc is below the half line, above it, or behind: no chord crosses it.
            return 0
        if rise > near and abs(bulge) * root_up((bx - ax) ** 2 + (by - ay) ** 2) > near:
            half = F(float(bulge) / (1 + math.sqrt(1 + float(bulge) ** 2)))
            middle = (down((ax + bx) / 2 + bulge * (by - ay) / 2), down((ay + by) / 2 - bulge * (bx - ax) / 2), half)
            return crossings((ax, ay, half), middle) + crossings(middle, b)
        if (ay > p[1]) == (by > p[1]):
            return 0
        cross = (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax)
        return int((cross > 0) == (by > ay))

    return sum(crossings(a, b) for vertices in loops for a, b in zip(vertices, vertices[1:] + vertices[:1])) % 2 == 1


def holds(loops, center, radius):
    edges = [e for vertices in loops for e in zip(vertices, vertices[1:] + vertices[:1])]
    room = min(distance_down(center, a, b) for a, b in edges)
    return 0 < radius <= room and is_inside(center, loops, room / 2)


def stack(part):
    """The layers of a part, each with its heights, None at every height, and its loops; or what is wrong."""
    loops = [[tuple(map(F, vertex)) for vertex in loop] for loop in part["loops"]]
    counted = part.get("layers") or [{"z": None, "loops": len(loops)}]
    if sum(layer["loops"] for layer in counted) != len(loops):
        return f"the layers of {part['name']} have not as many loops as it has"
    layers = []
    for layer in counted:
        layers.append((layer["z"] and tuple(map(F, layer["z"])), loops[: layer["loops"]]))
        loops = loops[layer["loops"] :]
    return layers


def meet(a, b):
    """Whether two intervals of heights overlap."""
    return a is None or b is None or max(a[0], b[0]) < min(a[1], b[1])


def check(proof):
    """None, or what is wrong."""
    rational = lambda rows: [tuple(map(F, row)) for row in rows]
    parts = {k: stack(proof[k]) for k in ("fixed", "moving")}
    for found in parts.values():
        if isinstance(found, str):
            return found
    witnesses, vertices = rational(proof["witnesses"]), rational(proof["vertices"])
    pivot, window = tuple(map(F, proof["pivot"])), proof["window"]
    triangles = proof["triangles"]
    if proof["version"] != 1:
        return "version 1 is what can be checked"
    for i, t in enumerate(triangles):
        if not (all(0 <= v < len(vertices) for v in t[:3]) and 0 <= t[6] < len(witnesses)):
            return f"triangle {i} names what there is not"
        if window and any(t[3:6]):
            return f"triangle {i} has turns in a window"
    for i, (qx, qy, r, cx, cy, s) in enumerate(witnesses):
        discs = (("moving", (qx, qy), r), ("fixed", (cx, cy), s))
        within = [[z for z, loops in parts[k] if holds(loops, center, radius)] for k, center, radius in discs]
        if not all(within):
            return f"witness {i}: a disc is not within its part"
        if not any(meet(a, b) for a in within[0] for b in within[1]):
            return f"witness {i}: its discs are at different heights"
    turned = [sine_cosine(v[2]) for v in vertices]
    for i, t in enumerate(triangles):
        qx, qy, r, cx, cy, s = witnesses[t[6]]
        qx, qy = qx - pivot[0], qy - pivot[1]
        arm = root_up(qx * qx + qy * qy)
        farthest, theta = F(0), []
        for k in range(3):
            x, y, angle = vertices[t[k]]
            sine, cosine, error = turned[t[k]]
            vx, vy = x + cosine * qx - sine * qy - cx, y + sine * qx + cosine * qy - cy
            farthest = max(farthest, root_up(vx * vx + vy * vy) + 2 * error * arm)
            theta += [angle + 2 * t[k + 3] * p for p in PI]
        span = max(theta) - min(theta)
        if span > 3 or farthest + arm * span * span / 8 >= r + s:
            return f"triangle {i}: its witness does not overlap in all of it"
    edges = {}
    for t in triangles:
        for j, k in ((0, 1), (1, 2), (2, 0)):
            a, b, turns = t[j], t[k], t[k + 3] - t[j + 3]
            key, way = ((a, b, turns), 1) if (a, 0) < (b, turns) else ((b, a, -turns), -1)
            edges[key] = edges.get(key, 0) + way
    for (a, b, _), count in edges.items():
        ends = [vertices[v][2] for v in (a, b)]
        if count and not (window and (max(ends) <= window[0] or min(ends) >= window[1])):
            return f"the edge from vertex {a} to {b} is open"
    around = []
    for name in ("start", "goal"):
        at = tuple(map(F, proof[name]))
        # Nearest to the middle of the orientations, which the whole turns do not change.
        middle = sum(map(F, window)) / 2 if window else F(0)
        turns = round(float(middle - at[2]) / math.tau)
        theta = sorted(at[2] + 2 * turns * p for p in PI)
        if window and (theta[1] < F(window[0]) or theta[0] > F(window[1])):
            return f"the {name} is not in the window"
        around.append(winding(proof, vertices, (at[0], at[1], theta[0]), pivot))
        if around[-1] is None:
            return f"the {name} is on the surface, or too near to it"
    if around[0] == around[1]:
        return f"the surface winds {around[0]} times around both start and goal"
    return None


def winding(proof, vertices, at, pivot):
    """Signed crossings of a segment from a configuration to far away, with bounds on π in all that is turned."""
    sine, cosine, _ = sine_cosine(at[2])
    # Rounded: what is tested is a configuration beside it, nearer than any surface in blocked space can be.
    start = (at[0] + cosine * pivot[0] - sine * pivot[1], at[1] + sine * pivot[0] + cosine * pivot[1], at[2])
    reach = max([abs(v[0]) + abs(v[1]) for v in vertices] + [abs(start[0]) + abs(start[1]), F(1)])
    for ray in range(64):
        end = float(start[2]) + 0.2 * math.sin(1.7 * ray + 1)
        if proof["window"]:
            end = min(max(end, proof["window"][0]), proof["window"][1])
        far = (4 * reach * F(math.cos(2.4 * ray + 0.3)), 4 * reach * F(math.sin(2.4 * ray + 0.3)), F(end))
        found = crossings(proof, vertices, start, far)
        if found is not None:
            return found
    return None


def volume(a, b, c, d):
    u, v, w = (tuple(p[k] - d[k] for k in range(3)) for p in (a, b, c))
    return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0])


def crossings(proof, vertices, start, far):
    # A turn is 2π within 1e-39 and the start is as near to its place: signs of volumes less certain than `least` are not taken.
    turn = 2 * PI[0]
    low, high = min(start[2], far[2]), max(start[2], far[2])
    total = 0
    for t in proof["triangles"]:
        base = [vertices[t[k]][2] + t[k + 3] * turn for k in range(3)]
        nearest = round(float(low - base[0]) / math.tau)
        for more in range(0, 1) if proof["window"] else range(nearest - 1, nearest + 2):
            p = [(*vertices[t[k]][:2], base[k] + more * turn) for k in range(3)]
            if max(c[2] for c in p) < low - 1 / F(10**9) or min(c[2] for c in p) > high + 1 / F(10**9):
                continue
            least = F(1, 10**30) * max(abs(c) for q in (*p, far) for c in q) ** 2
            sides = [volume(start, far, p[j], p[k]) for j, k in ((0, 1), (1, 2), (2, 0))]
            ends = [volume(*p, end) for end in (start, far)]
            sure = lambda x: abs(x) > least
            if any(s > least for s in sides) and any(s < -least for s in sides):
                continue
            if sure(ends[0]) and sure(ends[1]) and (ends[0] > 0) == (ends[1] > 0):
                continue
            if not all(map(sure, sides + ends)):
                return None
            total += 1 if ends[0] > 0 else -1
    return total


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: check.py PROOF.json")
    with open(sys.argv[1], encoding="utf-8") as file:
        answer = json.load(file)
    if not isinstance(answer, dict):
        sys.exit("error: this is no proof: an object is expected")
    if isinstance(answer.get("pairs"), list) and answer["pairs"]:
        answer = answer["pairs"][0]
    proof = answer.get("proof", answer)
    if proof is answer and "verdict" in answer:
        why = f" ({answer['unproved']})" if answer.get("unproved") else ""
        sys.exit(f"error: this answer holds no proof: its verdict is {answer['verdict']}{why}")
    try:
        wrong = check(proof)
    except (ArithmeticError, KeyError, IndexError, TypeError, ValueError) as e:
        wrong = f"this is no proof that can be read: {type(e).__name__}: {e}"
    if wrong:
        sys.exit(f"error: not proved: {wrong}")
    names = (proof[k]["name"] for k in ("moving", "fixed"))
    print("proved: no motion of {} from {} to {} past {}".format(next(names), proof["start"], proof["goal"], next(names)))


if __name__ == "__main__":
    main()
