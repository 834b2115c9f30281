"""Pictures of parts: SVG in which arcs are arcs."""

import cmath
import math

FILLS = [("#b8cde0", "#24476b"), ("#f2c48d", "#8a4b08")]  # of the parts, in order: fill and line
EDGE = 480  # pixels on a picture's longer side


def extent(edges):
    """The corners of the box about some edges."""
    points = []
    for e in edges:
        points += [e.start, e.end]
        if e.turn:
            sweep = 4 * math.atan(e.bulge())
            for k in range(4):
                away = (cmath.phase(1j**k / (e.start - e.centre)) * e.turn) % (2 * math.pi)
                if away < abs(sweep):
                    points.append(e.centre + 1j**k * e.radius())
    return (complex(min(p.real for p in points), min(p.imag for p in points)),
            complex(max(p.real for p in points), max(p.imag for p in points)))


def svg(title, parts, ghosts):
    """Parts, each (name, loops), filled by the even-odd rule as material is; arcs stay arcs."""
    low, high = extent([e for _, loops in parts for edges in loops for e in edges] + [e for g in ghosts for e in g])
    scale = EDGE / max(high.real - low.real, high.imag - low.imag)
    margin, head = 12, 30
    width = (high.real - low.real) * scale + 2 * margin
    height = (high.imag - low.imag) * scale + margin + head + 22

    def at(p):
        return f"{(p.real - low.real) * scale + margin:.2f} {(high.imag - p.imag) * scale + head:.2f}"

    def path(edges):
        out = f"M{at(edges[0].start)}"
        for e in edges:
            if e.turn:
                r, wide = e.radius() * scale, abs(e.bulge()) > 1
                out += f"A{r:.2f} {r:.2f} 0 {int(wide)} {int(e.turn < 0)} {at(e.end)}"
            else:
                out += f"L{at(e.end)}"
        return out + "Z"

    out = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}" '
           f'height="{height:.0f}" font-family="sans-serif">\n<title>{title}</title>\n<rect width="100%" height="100%" fill="white"/>\n'
           f'<text x="{margin}" y="20" font-size="15" fill="#222">{title}</text>\n')
    for ghost in ghosts:
        out += f'<path d="{path(ghost)}" fill="#eee" stroke="#aaa"/>\n'
    x = margin
    for (name, loops), (fill, line) in zip(parts, FILLS):
        out += f'<path d="{"".join(path(edges) for edges in loops)}" fill="{fill}" stroke="{line}" fill-rule="evenodd"/>\n'
        out += f'<text x="{x}" y="{height - 7:.0f}" font-size="12" fill="{line}">{name}</text>\n'
        x += 8 * len(name) + 14
    return out + "</svg>\n"
