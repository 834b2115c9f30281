"""Circles of imports: ways from a file along its imports back to itself."""

from collections import deque

# For every file the files that it imports, each with a place where it does: "file:line".
Imports = dict[str, dict[str, str]]


def shortest_circle(imports: Imports, start: str) -> list[str]:
    """The files of the shortest circle through a file, which stands at both ends; nothing if there is none."""
    came_from: dict[str, str] = {}
    queue = deque([start])
    while queue:
        at = queue.popleft()
        for to in sorted(imports.get(at, ())):
            if to == start:
                way = [start, at]
                while way[-1] != start:
                    way.append(came_from[way[-1]])
                return way[::-1]
            if to not in came_from:
                came_from[to] = at
                queue.append(to)
    return []


def circles(imports: Imports) -> list[str]:
    """A message for every circle; of circles that share files not every one is told."""
    told: set[str] = set()
    messages = []
    for start in sorted(imports):
        way = shortest_circle(imports, start) if start not in told else []
        if way:
            told.update(way)
            steps = [(imports[a][b], b) for a, b in zip(way, way[1:])]
            messages.append(f"{steps[0][0]}: imports in a circle" + "".join(f"\n    {at} imports {of}" for at, of in steps))
    return messages
