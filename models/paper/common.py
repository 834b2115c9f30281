"""What the drawings of the paper's pairs share."""

from drawing import Outline, rounded_polygon, unit

RECONSTRUCTION = "A reconstruction: the drawings behind Figure 5 of the paper are not public."


def stadium(a, b, radius, note):
    """A slot or a bar with round ends about a and b."""
    side = 1j * unit(b - a) * radius
    pen = Outline(a - side)
    pen.line(b - side, note).arc(b, b + side, 1, f"end R{radius:g}").line(a + side, note)
    return pen.arc(a, pen.start, 1, f"end R{radius:g}").closed()


def rectangle(low, high):
    """The upright rectangle between two opposite corners."""
    return rounded_polygon([(c, 0, "") for c in (low, complex(high.real, low.imag), high, complex(low.real, high.imag))])
