"""A small drawing of parts, as SVG in the colours of the page around it."""

import math

Box = tuple[float, float, float, float]

# Drawn beside each other, parts are so far apart, as a share of their width.
GAP = 0.08
MARGIN = 0.03


def arc(a: dict, b: dict) -> tuple[float, float, float]:
    """The centre and the radius of the edge from `a` to `b`, which is no line."""
    k = a["bulge"]
    dx, dy = b["x"] - a["x"], b["y"] - a["y"]
    # From the middle of the chord to the left of it, as a share of the chord.
    off = (1 - k * k) / (4 * k)
    x, y = (a["x"] + b["x"]) / 2 - off * dy, (a["y"] + b["y"]) / 2 + off * dx
    return x, y, math.hypot(a["x"] - x, a["y"] - y)


def edges(loop: list[dict]) -> list[tuple[dict, dict]]:
    return list(zip(loop, loop[1:] + loop[:1]))


def box(loops: list[list[dict]]) -> Box:
    """The box of loops: of ends of edges, and of the four outermost points of circles, as far as arcs have them."""
    points = [(v["x"], v["y"]) for loop in loops for v in loop]
    for a, b in (edge for loop in loops for edge in edges(loop)):
        if a["bulge"]:
            x, y, r = arc(a, b)
            begin = math.atan2(a["y"] - y, a["x"] - x)
            sweep = 4 * math.atan(a["bulge"])
            for quarter in range(4):
                turn = (quarter * math.pi / 2 - begin) % math.tau
                if turn < sweep or turn - math.tau > sweep:
                    points.append((x + r * math.cos(quarter * math.pi / 2), y + r * math.sin(quarter * math.pi / 2)))
    xs, ys = zip(*points)
    return min(xs), min(ys), max(xs), max(ys)


def path(loop: list[dict], shift: float, number) -> str:
    """A loop as SVG has it, whose y goes down."""
    at = lambda v: f"{number(v['x'] + shift)} {number(-v['y'])}"
    text = f"M{at(loop[0])}"
    for a, b in edges(loop):
        k = a["bulge"]
        text += f"A{(r := number(arc(a, b)[2]))} {r} 0 {int(abs(k) > 1)} {int(k < 0)} {at(b)}" if k else f"L{at(b)}"
    return text + "Z"


def drawing(scene: dict, pair: dict, apart: bool) -> str:
    """The parts as they are drawn, the two of the pair coloured; these beside each other if they are to be `apart`."""
    parts = scene["parts"]
    order = [*(i for i in range(len(parts)) if i not in (pair["fixed"], pair["moving"])), pair["fixed"], pair["moving"]]
    boxes = {i: box(parts[i]["loops"]) for i in order}
    shift = dict.fromkeys(order, 0.0)
    if apart:
        fixed, moving = boxes[pair["fixed"]], boxes[pair["moving"]]
        shift[pair["moving"]] = fixed[2] - moving[0] + GAP * (fixed[2] - fixed[0] + moving[2] - moving[0])
    lo = min(b[0] + shift[i] for i, b in boxes.items()), min(b[1] for b in boxes.values())
    hi = max(b[2] + shift[i] for i, b in boxes.items()), max(b[3] for b in boxes.values())
    size = max(hi[0] - lo[0], hi[1] - lo[1])
    # A thousandth of the drawing is less than it shows.
    digits = max(0, 3 - math.floor(math.log10(size)))
    number = lambda x: f"{x:.{digits}f}".rstrip("0").rstrip(".") if digits else f"{x:.0f}"
    margin = MARGIN * size
    view = " ".join(number(x) for x in (lo[0] - margin, -hi[1] - margin, hi[0] - lo[0] + 2 * margin, hi[1] - lo[1] + 2 * margin))
    drawn = ""
    for i in order:
        part = parts[i]
        kind = {pair["fixed"]: "fixed", pair["moving"]: "moving"}.get(i, "other")
        for layer in part["layers"]:
            text = "".join(path(part["loops"][k], shift[i], number) for k in layer["loops"])
            drawn += f'<path class="{kind}" d="{text}"/>'
    return f'<svg viewBox="{view}" aria-hidden="true">{drawn}</svg>'
