"""Edges of loops: a start, an end, and the bulge of the arc between them. Points are complex numbers, x + iy.

The bulge is tan of a quarter of the angle by which the edge turns, positive to the left, 0 of a line. An arc is reckoned from its
chord, never from its centre, which of a flat arc is far away.
"""

import cmath
import math
from collections.abc import Iterator

# The most that a Bézier turns: it is then within 5e-6 of the radius from its arc.
_BEZIER = math.pi / 4

# An arc has no more chords.
_MOST_CHORDS = 1_000_000

# Up to this bulge the area beside a chord is summed as a series, whose terms fall by its square; above it, the closed form has little
# cancellation.
_FLAT = 0.1
_TERMS = 8


def turn(bulge: float) -> float:
    """The angle by which an edge turns."""
    return 4 * math.atan(bulge)


def radius(start: complex, end: complex, bulge: float) -> float:
    """The radius of an arc."""
    return abs(end - start) * (1 + bulge * bulge) / (4 * abs(bulge))


def length(start: complex, end: complex, bulge: float) -> float:
    """The length of an edge."""
    chord = abs(end - start)
    return chord * (1 + bulge * bulge) * math.atan(bulge) / bulge if bulge else chord


def area_beside(start: complex, end: complex, bulge: float) -> float:
    """The area between a chord and its arc, positive where the arc is on the right of the chord."""
    b, square = bulge, abs(end - start) ** 2
    if abs(b) > _FLAT:
        return square * ((1 + b * b) ** 2 * math.atan(b) - b * (1 - b * b)) / (8 * b * b)
    terms = ((-b * b) ** k / ((1 - 2 * k) * (1 + 2 * k) * (3 + 2 * k)) for k in range(_TERMS))
    return square * b * math.fsum(terms)


def at(start: complex, end: complex, bulge: float, share: float) -> complex:
    """The point of an edge at a share of its length."""
    if bulge == 0:
        return start + share * (end - start)
    angle = turn(bulge)
    chord = math.sin(share * angle / 2) / math.sin(angle / 2)
    return start + chord * (end - start) * cmath.rect(1, (share - 1) * angle / 2)


def seen(start: complex, end: complex, bulge: float, eye: complex) -> float:
    """The angle by which an observer, who is not on the edge, turns when a point goes along it."""
    angle = cmath.phase((end - eye) / (start - eye))
    # From between a chord and its arc the chord looks larger than from the arc, and the arc is on the other side.
    on_arc = math.pi - abs(turn(bulge)) / 2
    if bulge > 0 and angle < -on_arc:
        return angle + 2 * math.pi
    if bulge < 0 and angle > on_arc:
        return angle - 2 * math.pi
    return angle


def distance(start: complex, end: complex, bulge: float, eye: complex) -> float:
    """The distance of a point from an edge."""
    ends = min(abs(start - eye), abs(end - eye))
    chord = end - start
    if chord == 0:
        return ends
    if bulge == 0:
        share = ((eye - start) * chord.conjugate()).real / abs(chord) ** 2
        return abs(eye - start - share * chord) if 0 < share < 1 else ends
    # The centre is beside the middle of the chord; the foot of the point is on the arc where it is seen from there between the ends.
    center = (start + end) / 2 + 1j * chord * (1 - bulge * bulge) / (4 * bulge)
    arm = eye - center
    if arm == 0:
        return radius(start, end, bulge)
    along = cmath.phase(arm / (start - center)) * math.copysign(1, bulge)
    if along % (2 * math.pi) > abs(turn(bulge)):
        return ends
    # |arm|² − r², without their difference: of a flat arc both are large.
    power = ((eye - start) * (eye - start).conjugate() + 2 * (eye - start) * (start - center).conjugate()).real
    return abs(power) / (abs(arm) + radius(start, end, bulge))


def chords(start: complex, end: complex, bulge: float, tolerance: float) -> Iterator[complex]:
    """Points of an edge from its start, without its end, whose chords are no farther than `tolerance` from it."""
    pieces = 1
    if bulge and start != end:
        # A chord of the angle a is 2 r sin² a/4 from its arc, and no chord turns by more than a quarter.
        off = min(tolerance / (2 * radius(start, end, bulge)), 1.0)
        most = min(4 * math.asin(math.sqrt(off)), math.pi / 2)
        pieces = math.ceil(min(abs(turn(bulge)) / most, _MOST_CHORDS)) if most else _MOST_CHORDS
    for k in range(pieces):
        yield at(start, end, bulge, k / pieces)


def axis_points(start: complex, end: complex, bulge: float) -> Iterator[complex]:
    """The points inside an arc at which it runs along an axis: where it is extreme in x or y."""
    angle = turn(bulge)
    if angle == 0 or start == end:
        return
    first = cmath.phase(end - start) - angle / 2
    lo, hi = sorted((first, first + angle))
    quarter = math.pi / 2
    for k in range(math.ceil(lo / quarter), math.floor(hi / quarter) + 1):
        yield at(start, end, bulge, (k * quarter - first) / angle)


def beziers(start: complex, end: complex, bulge: float) -> Iterator[tuple[complex, complex, complex]]:
    """An arc as cubic Béziers: of each the two inner points and the end."""
    angle = turn(bulge)
    pieces = math.ceil(abs(angle) / _BEZIER)
    # From an end of a Bézier to the inner point, along the chord; turned into the direction of travel there.
    reach = (end - start) * (1 + bulge * bulge) / (3 * bulge) * math.tan(angle / pieces / 4)
    here = start
    for k in range(pieces):
        leaves, comes = (reach * cmath.rect(1, angle * (i / pieces - 0.5)) for i in (k, k + 1))
        there = end if k + 1 == pieces else at(start, end, bulge, (k + 1) / pieces)
        yield here + leaves, there - comes, there
        here = there
