"""What the space of the pair that a model shows first comes to, in a few words."""

import math


def order(disassembled: dict) -> str | None:
    """The order in which all comes apart, if it does."""
    if disassembled["verdict"] != "apart":
        return None
    left = [" with ".join(step["moving"]) for step in disassembled["steps"] if step["kind"] == "leaves"]
    return f"Comes apart: {', then '.join(left)}."


def is_assembly(scene: dict) -> bool:
    """Whether a model is more than two parts that nothing joins, and of which some are free."""
    kinds = [part["motion"]["type"] for part in scene["parts"]]
    return len(kinds) > 2 and not scene["joints"] and "planar" in kinds and set(kinds) <= {"planar", "fixed"}


def verdict(scene: dict, pair: dict, region: int | None) -> str:
    """Where the moving part can go from the region that it is in; without one, from a pocket, and from the first region without that."""
    fixed, moving = (scene["parts"][pair[key]] for key in ("fixed", "moving"))
    if pair["class"] == "lower":
        return f"{moving['name']} is joined to {fixed['name']}."
    if not pair["regions"]:
        return f"{moving['name']} has no room at {fixed['name']}."
    pockets = [r for r in pair["regions"] if not r["unbounded"]]
    of = pair["regions"][region] if region is not None else (pockets or pair["regions"])[0]
    if pair["class"] != "fixed-axes":
        aside = ", the other parts left aside" if len(scene["parts"]) > 2 else ""
        return f"{moving['name']} can leave{aside}." if of["unbounded"] else f"{moving['name']} is caged by {fixed['name']}."
    if all(r["around"] for r in of["ranges"]):
        return f"{fixed['name']} and {moving['name']} turn together for ever."
    said = [goes(part, reach, scene["unit"]) for part, reach in zip((fixed, moving), of["ranges"]) if part["motion"]["type"] != "fixed"]
    return ", ".join(said) + "."


def goes(part: dict, reach: dict, unit: str | None) -> str:
    """How far a part goes on its axis."""
    turns = part["motion"]["type"] == "revolute"
    does = f"{part['name']} {'turns' if turns else 'slides'}"
    if reach["around"]:
        return f"{does} for ever"
    if any(reach["open"]):
        return f"{does} without limit" + ("" if all(reach["open"]) else " one way")
    wide = reach["hi"] - reach["lo"]
    return f"{does} by {math.degrees(wide):.3g}°" if turns else f"{does} by {wide:.3g} {unit or ''}".rstrip()
