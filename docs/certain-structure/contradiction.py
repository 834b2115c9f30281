"""Shows why a shell contradicts itself.

Reads what the patched kernel writes to stderr with CSPACE_DEBUG=2 for one pair with a conflict, and prints the shortest way
from a cell that its bounds call blocked to a free cell that lasts, link by link. One of these links is false, or the
order of branches at one of these cells is.

    CSPACE_DEBUG=2 cspace compute MODEL --general 2> dump.txt
    python3 contradiction.py dump.txt [least duration in radians]
"""

import collections
import re
import sys

CELL = re.compile(
    r"cell (\d+) sheet (\d+) .*? dur (\S+) \[.*\] blocked (\w+) free (\w+) shell (\d+)"
)


def read(path):
    cells, links = {}, collections.defaultdict(list)
    with open(path) as dump:
        for line in dump:
            line = line.strip()
            if found := CELL.match(line):
                cells[int(found[1])] = (line, float(found[3]), found[4] == "true", found[5] == "true")
            words = line.split()
            certain_vertical = line.startswith("vertical ") and words[-1] == "true"
            if certain_vertical or line.startswith("side "):
                a, b = int(words[1]), int(words[2])
                links[a].append((b, line))
                links[b].append((a, line))
    return cells, links


def shortest(cells, links, least):
    goals = {c for c, (_, lasts, blocked, free) in cells.items() if free and not blocked and lasts > least}
    best = None
    for start in (c for c, cell in cells.items() if cell[2] and links[c]):
        before, queue = {start: None}, collections.deque([start])
        while queue:
            at = queue.popleft()
            if at in goals:
                way = []
                while at is not None:
                    way.append((cells[at][0], before[at][1] if before[at] else ""))
                    at = before[at][0] if before[at] else None
                if best is None or len(way) < len(best):
                    best = way
                break
            for other, link in links[at]:
                if other not in before:
                    before[other] = (at, link)
                    queue.append(other)
    return best or []


if __name__ == "__main__":
    LEAST = float(sys.argv[2]) if len(sys.argv) > 2 else 1e-2
    for cell, link in shortest(*read(sys.argv[1]), LEAST):
        print(cell)
        if link:
            print("   ", link)
