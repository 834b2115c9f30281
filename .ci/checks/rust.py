"""Rust, as far as the checks read it: the names that a file defines, hands on and uses, and its constants.

What is compiled only for tests is left out: items under `#[cfg(test)]`, and files named `tests.rs`.
"""

import functools
import re
from dataclasses import dataclass, field
from pathlib import Path

from .circles import Imports

TOKEN = re.compile(
    r"""
    (?P<comment>//[^\n]*|/\*)
  | (?P<text>[bc]?r(?P<hashes>\#*)".*?"(?P=hashes)
           | [bc]?"(?:\\.|[^"\\])*"
           | b?'(?:\\(?:u\{[^}]*\}|x..|.)|[^\\'])')
  | '\w+
  | (?P<token>(?:r\#)?\w+|::|\S)
    """,
    re.X | re.S,
)
COMMENT_END = re.compile(r"/\*|\*/")
# Documentation, as an attribute of what follows it.
DOC = "///"
TEXT = '""'

# Words with which the definition of a name begins.
DEFINING = {"fn", "const", "static", "struct", "enum", "trait", "type", "union"}
# `const` before one of these is not a constant.
BEFORE_FN = {"fn", "unsafe", "async", "extern"}
# Items that end with a semicolon, whatever braces they have.
TO_SEMICOLON = {"use", "const", "static", "type", "let"}
# Words with which a path begins that is seen from the crate, the module, or the one around it.
ROOTS = ("crate", "self", "super")
CLOSING = {"(": ")", "[": "]", "{": "}"}

Token = tuple[str, int]
Module = tuple[str, ...]


@dataclass
class Use:
    """A path of names, and where it stands; `name` is what a `use` makes of it, `*` for all of a module."""

    path: tuple[str, ...]
    place: str
    name: str = ""


@dataclass
class Constant:
    """A constant of type `f64`, and whether it has documentation."""

    name: str
    explained: bool
    place: str


@dataclass
class Source:
    file: str
    defined: set[str] = field(default_factory=set)
    handed_on: list[Use] = field(default_factory=list)
    named: list[Use] = field(default_factory=list)
    constants: list[Constant] = field(default_factory=list)


def tokens(text: str) -> list[Token]:
    """Words and marks with their lines; of comments and of what is in quotes only that they are there."""
    found: list[Token] = []
    at, line = 0, 1
    while match := TOKEN.search(text, at):
        start, end = match.span()
        line += text.count("\n", at, start)
        if match["comment"] == "/*":
            depth = 1
            while depth and (mark := COMMENT_END.search(text, end)):
                depth += 1 if mark[0] == "/*" else -1
                end = mark.end()
        if match["comment"]:
            if re.match(r"///(?!/)|/\*\*(?![*/])", text[start:end]):
                found.append((DOC, line))
        elif match["text"]:
            found.append((TEXT, line))
        elif match["token"]:
            found.append((match["token"], line))
        line += text.count("\n", start, end)
        at = end
    return found


def after_brackets(words: list[Token], at: int) -> int:
    """The index behind the bracket that closes the one at an index."""
    depth = 0
    while at < len(words):
        depth += (words[at][0] in CLOSING) - (words[at][0] in CLOSING.values())
        at += 1
        if depth == 0:
            break
    return at


def after_item(words: list[Token], at: int) -> int:
    """The index behind an item, statement, field or variant that begins at an index."""
    first = ""
    while at < len(words):
        word = words[at][0]
        if word == "#" and not first:
            at = after_brackets(words, at + 1)
            continue
        if word in CLOSING.values():
            return at
        if word in CLOSING:
            at = after_brackets(words, at)
            if word == "{" and first not in TO_SEMICOLON:
                return at
            continue
        at += 1
        if word == ";" or (word == "," and first not in DEFINING | {"impl"}):
            return at
        # `const fn` and `extern "C" fn` are functions.
        if word not in (DOC, "pub", "unsafe", "async") and (not first or word == "fn"):
            first = word
    return at


def is_for_tests(attribute: list[str]) -> bool:
    return attribute[:1] == ["cfg"] and "test" in attribute


def use_tree(words: list[Token], at: int, before: tuple[str, ...], file: str, out: list[Use]) -> int:
    """Reads the paths of a `use` from an index on; the index behind them."""
    path = before
    while True:
        word, line = words[at]
        place = f"{file}:{line}"
        if word == "{":
            at += 1
            while words[at][0] != "}":
                at = use_tree(words, at, path, file, out)
                at += words[at][0] == ","
            return at + 1
        if word == "*":
            out.append(Use(path, place, "*"))
            return at + 1
        at += 1
        if word == "::":
            continue
        # `self` within braces is the module itself.
        if word != "self" or not path:
            path = (*path, word)
        if words[at][0] == "::":
            continue
        if words[at][0] == "as":
            out.append(Use(path, place, words[at + 1][0]))
            return at + 2
        out.append(Use(path, place, path[-1]))
        return at


@dataclass
class Item:
    """What is known so far of an item: its first keyword, whether it implements a trait, has documentation, and is public."""

    kind: str = ""
    of_trait: bool = False
    explained: bool = False
    public: bool = False


def read(text: str, file: str) -> Source:
    """What a file names, whose path messages begin with."""
    source = Source(file)
    words = tokens(text)
    # Brackets around what is read, each with the item that it belongs to; and the item that is read.
    blocks: list[tuple[str, Item]] = []
    item = Item()
    at = 0

    def seen(use: Use) -> Use:
        """A path seen from the file: `super` of a module within the file is the file."""
        inner, path = sum(around.kind == "mod" for _, around in blocks), use.path
        while inner and path[0] == "super":
            inner, path = inner - 1, path[1:] if path[1:2] == ("super",) else ("self", *path[1:])
        return Use(path, use.place, use.name)

    while at < len(words):
        word, line = words[at]
        following = words[at + 1][0] if at + 1 < len(words) else ""
        if word == "#" and following in ("[", "!"):
            end = after_brackets(words, at + 1 + (following == "!"))
            attribute = [w for w, _ in words[at + 2 : end]]
            item.explained |= attribute[0] == "doc"
            at = end
            if is_for_tests(attribute):
                at = after_item(words, end)
                item = Item()
            continue
        if word == "use" and not item.kind and following != "<":
            found: list[Use] = []
            at = use_tree(words, at + 1, (), file, found)
            (source.handed_on if item.public and not blocks else source.named).extend(map(seen, found))
            continue
        if word == DOC:
            item.explained = True
        elif word in CLOSING:
            blocks.append((word, item))
            item = Item() if word == "{" else item
        elif word in CLOSING.values() and blocks:
            _, item = blocks.pop()
            item = Item() if word == "}" else item
        elif word == ";" or (word == "," and not item.kind):
            # Within other brackets than braces they separate pieces of the same item.
            item = item if blocks and blocks[-1][0] != "{" else Item()
        elif word == "pub":
            item.public = True
        elif word == "for" and item.kind == "impl" and following != "<":
            item.of_trait = True
        elif word in ("impl", "mod") and not item.kind:
            item.kind = word
        elif word in DEFINING and not item.kind and not (word == "const" and following in BEFORE_FN):
            item.kind = word
            name = words[at + 2][0] if following == "mut" else following
            if not blocks:
                source.defined.add(name)
            around = blocks[-1][1] if blocks else Item()
            # A trait's own are not counted; those of its implementations have their documentation there.
            is_number = [w for w, _ in words[at + 2 : at + 4]] == [":", "f64"] and words[at + 4][0] in "=;"
            if word == "const" and is_number and around.kind != "trait":
                source.constants.append(Constant(name, item.explained or around.of_trait, f"{file}:{line}"))
        elif word in ROOTS and following == "::":
            path = [word]
            while words[at + 1][0] == "::" and re.match(r"\w", words[at + 2][0]):
                path.append(words[at + 2][0])
                at += 2
            source.named.append(seen(Use(tuple(path), f"{file}:{line}")))
        at += 1
    return source


@functools.lru_cache(maxsize=None)
def crate_sources(root: Path, folder: str) -> dict[Module, Source]:
    """The sources of a crate by their modules, without programs of `bin`; `main.rs` and `lib.rs` are one."""
    sources: dict[Module, Source] = {}
    base = root / folder
    for path in sorted(base.rglob("*.rs")):
        *module, stem = path.relative_to(base).with_suffix("").parts
        if stem == "tests" or "bin" in module:
            continue
        at = (*module,) if stem in ("mod", "lib", "main") else (*module, stem)
        new = read(path.read_text(encoding="utf-8"), path.relative_to(root).as_posix())
        if old := sources.get(at):
            old.defined |= new.defined
            old.handed_on += new.handed_on
            old.named += new.named
            old.constants += new.constants
        else:
            sources[at] = new
    return sources


def crates(root: Path) -> list[str]:
    return sorted(p.relative_to(root).as_posix() for group in ("crates", "dev") for p in root.glob(f"{group}/*/src"))


def resolved(sources: dict[Module, Source], start: Module, path: tuple[str, ...], depth: int = 0) -> Module | None:
    """The module whose file defines what a path names, seen from a module; none if it is of another crate."""
    at, rest = start, path
    while rest and rest[0] in ROOTS:
        at = {"crate": (), "self": at, "super": at[:-1]}[rest[0]]
        rest = rest[1:]
    if rest == path and (*start, path[0]) not in sources:
        return None
    while rest:
        name, child = rest[0], (*at, rest[0])
        if child in sources:
            at, rest = child, rest[1:]
            continue
        source = sources.get(at)
        if source is None:
            return None
        if name in source.defined or depth > 8:
            return at
        for use in source.handed_on:
            if use.name == name:
                return resolved(sources, at, use.path, depth + 1)
        for use in source.handed_on:
            module = resolved(sources, at, use.path, depth + 1) if use.name == "*" else None
            if module in sources and name in sources[module].defined:
                return module
        return at
    return at


def imports(root: Path, folder: str) -> Imports:
    """For every file of a crate the files that it imports."""
    sources = crate_sources(root, folder)
    found: Imports = {}
    for module, source in sources.items():
        of = found.setdefault(source.file, {})
        for use in source.named:
            to = resolved(sources, module, use.path)
            if to in sources and to != module:
                of.setdefault(sources[to].file, use.place)
    return found
