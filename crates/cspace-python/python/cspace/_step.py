"""The command on STEP files, where build123d or CadQuery is installed: each is read into a model, and the command is run on that."""

import importlib.util
import json
import os
import subprocess
import sys
import tempfile
import threading
from typing import IO, Any

from . import _assembly, _wires
from ._errors import Error
from ._optional import optional


def is_step(argument: str) -> bool:
    """Whether an argument is the name of a STEP file."""
    return argument.lower().endswith((".step", ".stp"))


def _read(path: str) -> Any:
    """The assembly in a STEP file."""
    if not os.path.isfile(path):
        raise Error(f"{path}: there is no such file\nhelp: check the path")
    if importlib.util.find_spec("build123d"):
        return optional("build123d").import_step(path)
    if importlib.util.find_spec("cadquery"):
        cad = optional("cadquery")
        solids = cad.importers.importStep(path).solids().vals()
        try:
            assembly = cad.Assembly.importStep(path)
        except ValueError:
            # It has parts alone.
            return solids
        # CadQuery leaves out a shape that stands beside parts in an assembly: all solids, without names, are better.
        return assembly if sum(len(shape.Solids()) for shape, *_ in assembly) == len(solids) else solids
    raise Error(f"{path}: STEP files are read by build123d or CadQuery, and neither is installed\nhelp: pip install build123d")


def _model(path: str) -> str:
    """The model of a STEP file: its parts where they stand, without joints, which STEP has none of."""
    try:
        assembly = _read(path)
        made, note = _assembly.model(assembly, 1e-3, None, None, None, _wires.JOIN)
    except Error as error:
        raise Error(str(error) if str(error).startswith(path) else f"{path}: {error}") from None
    except Exception as error:
        raise Error(f"{path}: it cannot be read: {error}\nhelp: export it again from the program that made it") from error
    if note is not None:
        print(f"note: {path}: {note}", file=sys.stderr)
    return json.dumps(made)


def run(arguments: list[str]) -> int:
    """Runs the command with models in the place of STEP files, and gives its exit code; what it prints has the files' own names."""
    with tempfile.TemporaryDirectory(prefix="cspace-") as folder:
        names = {}
        try:
            for i, path in enumerate(filter(is_step, dict.fromkeys(arguments))):
                names[path] = os.path.join(folder, f"{i}.json")
                with open(names[path], "w", encoding="utf-8") as file:
                    file.write(_model(path))
        except Error as error:
            return _failed(str(error), "--json" in arguments)
        child = subprocess.Popen(
            [sys.executable, "-m", "cspace", *(names.get(a, a) for a in arguments)],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        own = {os.fsencode(made): os.fsencode(path) for path, made in names.items()}
        streams = [(child.stdout, sys.stdout.buffer), (child.stderr, sys.stderr.buffer)]
        threads = [threading.Thread(target=_copy, args=(source, to, own)) for source, to in streams]
        for thread in threads:
            thread.start()
        try:
            child.wait()
        except KeyboardInterrupt:
            # The command is told, too, and prints what it knows.
            child.wait()
        for thread in threads:
            thread.join()
        return child.returncode


def _copy(source: IO[bytes], to: IO[bytes], names: dict[bytes, bytes]) -> None:
    for line in source:
        for made, path in names.items():
            line = line.replace(made, path)
        to.write(line)
        to.flush()


def _failed(message: str, as_json: bool) -> int:
    what, _, help = message.partition("\nhelp: ")
    if as_json:
        print(json.dumps({"error": {"message": what, "help": help or None, "file": None, "line": None, "column": None}}))
    else:
        print(f"error: {what}" + (f"\n  help: {help}" if help else ""), file=sys.stderr)
    return 2
