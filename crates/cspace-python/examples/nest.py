"""Nests the parts of a DXF drawing into a sheet, bottom-left, at any orientation and at quarter turns, and writes the better nest as DXF.

    python nest.py                                  # twenty parts of nest.dxf into a sheet 200 wide
    python nest.py --parts 8 --width 120 -o out.dxf
    python nest.py --spacing 2                      # that far apart

Arcs stay arcs on the way from the one drawing to the other. Parts are placed one after the other, the largest first, each where its centroid
is lowest, and of these places the leftmost. It prints how high the parts reach, and how much of the sheet up to there they fill.
"""

import argparse
import math
import pathlib
import time

import cspace as cs

DRAWING = pathlib.Path(__file__).with_name("nest.dxf")
# Layers of the drawing, and how many of each part are cut.
COUNTS = {"gusset": 5, "bracket": 4, "sector": 3, "wedge": 3, "link": 3, "hook": 2}
QUARTERS = [0.0, math.pi / 2, math.pi, -math.pi / 2]


def parts(path: pathlib.Path, most: int) -> list[cs.Part]:
    """So many parts of the drawing, the largest first."""
    drawn = [cs.Part.from_dxf(path, name=layer, layer=layer) for layer in COUNTS]
    # One of each, then the second of each that has one, and so on.
    rounds = [part for i in range(max(COUNTS.values())) for part in drawn if i < COUNTS[part.name]]
    return sorted(rounds[:most], key=lambda part: -part.area)


def nest(sheet: cs.Part, queue: list[cs.Part], spacing: float, orientations: list[float] | None) -> list[cs.Part]:
    """The parts where they are placed."""
    placed: list[cs.Part] = []
    for part in queue:
        place = cs.fit(sheet, placed, part, spacing=spacing, orientations=orientations).lowest()
        if place is None:
            raise SystemExit(f"{part.name} does not fit into the sheet")
        placed.append(place.part)
    return placed


def main(arguments: list[str] | None = None) -> dict[str, float]:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("drawing", nargs="?", type=pathlib.Path, default=DRAWING)
    parser.add_argument("--parts", type=int, default=sum(COUNTS.values()), help="how many are placed")
    parser.add_argument("--width", type=float, default=200.0, help="of the sheet")
    parser.add_argument("--spacing", type=float, default=0.0, help="least distance of the parts")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="DXF of the nest with the lower top")
    options = parser.parse_args(arguments)
    queue = parts(options.drawing, options.parts)
    # High enough for all of them one above the other.
    high = sum(max(p.bounds[2] - p.bounds[0], p.bounds[3] - p.bounds[1]) + 2 * options.spacing for p in queue)
    sheet = cs.Part.rectangle(options.width, high, center=(options.width / 2, high / 2), name="sheet")
    area = sum(part.area for part in queue)
    print(f"{len(queue)} parts of {area:.0f} mm² on a sheet {options.width:g} mm wide\n")
    print("orientations   height    filled   seconds")
    nests, heights = {}, {}
    for name, orientations in [("any", None), ("quarter turns", QUARTERS)]:
        start = time.perf_counter()
        nests[name] = nest(sheet, queue, options.spacing, orientations)
        heights[name] = max(part.bounds[3] for part in nests[name])
        filled = area / (options.width * heights[name])
        print(f"{name:13} {heights[name]:7.2f}   {filled:6.1%}   {time.perf_counter() - start:7.1f}")
    if options.output is not None:
        cs.write_dxf(options.output, nests[min(heights, key=heights.__getitem__)], unit="mm")
        print(f"\n{options.output}")
    return heights


if __name__ == "__main__":
    main()
