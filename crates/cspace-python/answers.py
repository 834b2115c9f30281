#!/usr/bin/env python3
"""Writes python/cspace/answers.py: a class for each object of an answer, from the schemas in docs/answers.

    python crates/cspace-python/answers.py

The text of the module is what `text` returns, with which a test compares the file.
"""

import json
import keyword
import pathlib
import textwrap

HERE = pathlib.Path(__file__).parent
PATH = HERE / "python/cspace/answers.py"
SCHEMAS = HERE.parent.parent / "docs/answers"

HEAD = '''"""Answers of the questions to a model. Written by answers.py from the schemas of the command's answers."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from ._record import Record, configuration, each_of, number_or_configuration
'''

# Objects that are arrays here.
ARRAYS = {"Coordinates", "Configuration"}
# Answers that no method gives.
LEFT_OUT = {"classify", "error", "import", "slice", "written", "zones"}
SIMPLE = {"string": "str", "integer": "int", "number": "float", "boolean": "bool", "null": "None"}


def camel(name):
    return "".join(word.capitalize() for word in name.split("-"))


class Module:
    """The classes of one answer."""

    def __init__(self, name, definitions, taken, written, reads):
        self.name, self.definitions = name, definitions
        # The definitions of all answers by name, the text of each class, and how it is read.
        self.taken, self.written, self.reads = taken, written, reads
        self.names = {}

    def class_name(self, definition):
        """The name of the class of a definition: with that of the answer before it where another answer has one of the name."""
        if definition not in self.names:
            same = self.taken.setdefault(definition, self.definitions[definition])
            self.names[definition] = definition if same == self.definitions[definition] else camel(self.name) + definition
        return self.names[definition]

    def kind(self, schema):
        """The type of a value, and how it is read: None where it stays as it is."""
        if "$ref" in schema:
            name = schema["$ref"].rsplit("/", 1)[1]
            if name in ARRAYS:
                return "NDArray[np.float64]", "configuration"
            definition = self.definitions[name]
            if "properties" in definition:
                return self.record(name), self.class_name(name)
            return self.kind(definition)
        if "const" in schema:
            return f"Literal[{schema['const']!r}]", None
        if "enum" in schema:
            return f"Literal[{', '.join(map(repr, schema['enum']))}]", None
        for key in ("anyOf", "oneOf"):
            if key in schema:
                found = [self.kind(one) for one in schema[key]]
                reads = {read for kind, read in found if kind != "None"}
                if reads == {None, "configuration"}:
                    reads = {"number_or_configuration"}
                return union([kind for kind, _ in found]), reads.pop() if len(reads) == 1 else None
        if isinstance(schema.get("type"), list):
            found = [self.kind({**schema, "type": one}) for one in schema["type"]]
            return union([kind for kind, _ in found]), next((read for _, read in found if read), None)
        if schema.get("type") == "array":
            kind, read = self.kind(schema["items"]) if isinstance(schema.get("items"), dict) else ("Any", None)
            return ("NDArray[np.float64]" if read == "configuration" else f"list[{kind}]"), read
        if schema.get("type") == "object":
            inner = schema.get("additionalProperties")
            if isinstance(inner, dict):
                kind, read = self.kind(inner)
                return f"dict[str, {kind}]", read and f"each_of({read})"
            return "dict[str, Any]", None
        return SIMPLE.get(schema.get("type"), "Any"), None

    def record(self, definition):
        """The class of a definition, which is written before what needs it."""
        name = self.class_name(definition)
        if name not in self.written:
            self.write(name, self.definitions[definition])
        return name

    def write(self, name, schema):
        """Writes the class of an object; one that contains itself is known by then."""
        self.written[name] = ""
        lines, reads = [], {}
        required = schema.get("required", [])
        for key, value in schema["properties"].items():
            kind, read = self.kind(value)
            if key not in required and "None" not in kind.split(" | "):
                kind += " | None"
            if read:
                reads[key] = read
            if key.isidentifier() and not keyword.iskeyword(key):
                lines.append(f"{key}: {kind}")
                if "description" in value:
                    lines.append(documented(value["description"]))
        head = [f"class {name}(Record):", textwrap.indent(documented(schema.get("description", "")), "    "), ""]
        body = lines
        if reads:
            self.reads.append(f"{name}._read = {{{', '.join(f'{key!r}: {read}' for key, read in reads.items())}}}")
        # It stands after those that it needs.
        del self.written[name]
        self.written[name] = "\n".join(head + [textwrap.indent("\n".join(body), "    ")])


def documented(text):
    return '"""' + text.replace("\\", "\\\\") + (" " if text.endswith('"') else "") + '"""'


def union(kinds):
    flat = dict.fromkeys(one for kind in kinds for one in kind.split(" | "))
    literals = [one[8:-1] for one in flat if one.startswith("Literal[")]
    others = [one for one in flat if not one.startswith("Literal[") and one != "None"]
    joined = ([f"Literal[{', '.join(literals)}]"] if literals else []) + others
    return " | ".join(joined + (["None"] if "None" in flat else []))


def text():
    """The whole file."""
    taken, written, reads = {}, {}, []
    for path in sorted(SCHEMAS.glob("*.schema.json")):
        name = path.name.removesuffix(".schema.json")
        if name in LEFT_OUT:
            continue
        schema = json.loads(path.read_text(encoding="utf-8"))
        module = Module(name, schema.get("$defs", {}), taken, written, reads)
        # Of answers about one file and about several, that about one.
        one = module.definitions["Answer"] if "anyOf" in schema else schema
        module.write(camel(name) + "Answer", {**one, "description": schema["title"]})
    return HEAD + "\n\n" + "\n\n\n".join(written.values()) + "\n\n\n" + "\n".join(reads) + "\n"


if __name__ == "__main__":
    PATH.write_text(text(), encoding="utf-8")
