"""What the sources in Rust keep to: English, one place for double-double, constants that are explained, imports one way."""

import os
import re
from pathlib import Path

from .circles import circles
from .rust import crate_sources, crates, imports

# What a check found: how many things it looked at, and a message for each that is wrong.
Found = tuple[int, list[str]]

# Words with which no line of documentation begins: "The same of arcs" is "As above, for arcs".
REFUSED = re.compile(r"(?:The same|What|Of|That|Those|None of)(?![^\W_])")
DOCUMENTATION = re.compile(r"\s*//[/!] (.*)")

KERNEL = "crates/cspace/src"
# Modules of the kernel that name double-double: those of formulas. The others name the numbers in which they decide, not their kind.
OF_FORMULAS = ("number", "feature", "contact")
# The kernel has no more constants of type `f64`: a new one takes the place of an old one.
MOST_CONSTANTS = 253


def rust_files(root: Path) -> list[Path]:
    """All files in Rust, without those that builds leave."""
    found = []
    for group in ("crates", "dev"):
        for folder, folders, files in os.walk(root / group):
            folders[:] = sorted(f for f in folders if f not in ("target", "node_modules"))
            found += [Path(folder, f) for f in sorted(files) if f.endswith(".rs")]
    return found


def documentation_names_its_subject(root: Path) -> Found:
    count, wrong = 0, []
    for path in rust_files(root):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if text := DOCUMENTATION.match(line):
                count += 1
                if REFUSED.match(text[1]):
                    wrong.append(f"{path.relative_to(root)}:{number}: begin with a noun or a verb: {text[1]}")
    return count, wrong


def rust_imports_go_one_way(root: Path) -> Found:
    of_crates = [imports(root, folder) for folder in crates(root)]
    return sum(map(len, of_crates)), [message for of in of_crates for message in circles(of)]


def double_double_is_named_by_formulas_only(root: Path) -> Found:
    count, wrong = 0, []
    for module, source in crate_sources(root, KERNEL).items():
        places = [use.place for use in source.named + source.handed_on if "Dd" in use.path]
        if module[:1] and module[0] in OF_FORMULAS:
            count += bool(places)
        elif places:
            wrong.append(f"{places[0]}: `Dd` is named outside of {', '.join(OF_FORMULAS)}")
    return count, wrong


def constants_are_explained_and_few(root: Path) -> Found:
    constants = [c for source in crate_sources(root, KERNEL).values() for c in source.constants]
    wrong = [f"{c.place}: {c.name} has no comment of documentation" for c in constants if not c.explained]
    if len(constants) > MOST_CONSTANTS:
        wrong.append(f"{KERNEL}: {len(constants)} constants of type f64, and {MOST_CONSTANTS} are allowed: use an existing one")
    return len(constants), wrong
