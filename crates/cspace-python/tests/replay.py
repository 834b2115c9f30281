"""Objects of other packages that are recorded while they are read, and what stands for them afterwards.

A tape has a node for each object: what its attributes were, and what its methods gave for which arguments. A replayed object knows
nothing else, so that what a reader asks for beyond it is an error.
"""

import copy
import enum
import inspect
import json


def _key(value):
    """An argument as a text: numbers alike whatever their type, and however sums were rounded."""
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(map(_key, value))}]"
    if isinstance(value, _Stand):
        return f"#{value._node_}"
    return repr(round(float(value), 9) + 0.0 if isinstance(value, float) else value)


def _call(name, given, named):
    return f"{name}({', '.join([*map(_key, given), *(f'{k}={_key(v)}' for k, v in sorted(named.items()))])})"


class _Stand:
    """What stands for an object; a class is made of it for each type, so that the type's name is right."""

    def __new__(cls, *given):
        return cls._tape_.constructed(cls.__name__, cls._real_, given)

    def __getattr__(self, name):
        if name.startswith("__") and name != "__array__":
            raise AttributeError(name)
        return self._tape_.attribute(self, name)

    def __call__(self, *given, **named):
        return self._tape_.called(self, "", given, named)

    def __iter__(self):
        return iter(self._tape_.called(self, "__iter__", (), {}))

    def __copy__(self):
        return self._tape_.called(self, "__copy__", (), {})


class _Tape:
    def __init__(self, nodes=()):
        self.nodes, self.stands = list(nodes), {}

    def stand(self, node, type_name, real=None):
        if node not in self.stands:
            kind = type(type_name, (_Stand,), {"_tape_": self, "_real_": type(real)})
            stand = object.__new__(kind)
            stand._node_, stand._object_ = node, real
            self.stands[node] = stand
        return self.stands[node]


class Recorder(_Tape):
    """A tape that is being written."""

    def __init__(self):
        super().__init__()
        self.known = {}

    def wrap(self, value):
        """The object that stands for a real one."""
        return self._decoded(self._encoded(value))

    def save(self, path, roots):
        """Writes the tape, with what is not of it: a dictionary whose objects are those that were wrapped."""
        encoded = {name: self._encoded(value) for name, value in roots.items()}
        nodes = [{k: v for k, v in node.items() if v} for node in self.nodes]
        path.write_text(json.dumps({"roots": encoded, "nodes": nodes}, separators=(",", ":")), encoding="utf-8")

    def _encoded(self, value):
        if isinstance(value, _Stand):
            return {"node": value._node_}
        if value is None or isinstance(value, (bool, int, float, str)) and not isinstance(value, enum.Enum):
            return float(value) if isinstance(value, float) else value
        if isinstance(value, (list, tuple)):
            return {"list": [self._encoded(v) for v in value]}
        if isinstance(value, dict):
            return {"dict": {k: self._encoded(v) for k, v in value.items()}}
        if inspect.isroutine(value):
            return {"routine": True}
        if id(value) not in self.known:
            # The object is kept, so that no other gets its number.
            self.known[id(value)] = len(self.nodes), value
            name = value.__name__ if inspect.isclass(value) else type(value).__name__
            self.nodes.append({"type": name, "has": {}, "calls": {}})
        return {"node": self.known[id(value)][0]}

    def _decoded(self, encoded):
        if isinstance(encoded, dict) and "node" in encoded:
            node = encoded["node"]
            real = next(value for number, value in self.known.values() if number == node)
            return self.stand(node, self.nodes[node]["type"], real)
        return _decoded(self, encoded)

    def attribute(self, stand, name):
        value = getattr(stand._object_, name)
        self.nodes[stand._node_]["has"][name] = encoded = self._encoded(value)
        if encoded == {"routine": True}:
            return lambda *given, **named: self.called(stand, name, given, named)
        return self._decoded(encoded)

    def called(self, stand, name, given, named):
        of, known = stand._object_, self.nodes[stand._node_]["calls"].get(_call(name, given, named))
        if known is not None:
            return self._decoded(known)
        real = [self._real(v) for v in given], {k: self._real(v) for k, v in named.items()}
        special = {"": of, "__iter__": lambda: list(of), "__copy__": lambda: copy.copy(of)}
        value = (special[name] if name in special else getattr(of, name))(*real[0], **real[1])
        node = self.nodes[stand._node_]
        node["calls"][_call(name, given, named)] = encoded = self._encoded(value)
        # That it is a routine goes without saying.
        node["has"].pop(name, None)
        return self._decoded(encoded)

    def constructed(self, name, kind, given):
        call = _call(name, given, {})
        known = next((i for i, node in enumerate(self.nodes) if node.get("made") == call), None)
        if known is not None:
            return self._decoded({"node": known})
        made = self.wrap(kind(*given))
        self.nodes[made._node_]["made"] = call
        return made

    def _real(self, value):
        if isinstance(value, (list, tuple)):
            return type(value)(map(self._real, value))
        return value._object_ if isinstance(value, _Stand) else value


def _decoded(tape, encoded):
    if not isinstance(encoded, dict):
        return encoded
    if "list" in encoded:
        return [tape._decoded(v) for v in encoded["list"]]
    return {k: tape._decoded(v) for k, v in encoded["dict"].items()}


class Replay(_Tape):
    """A tape that was written; `roots` are what was saved with it."""

    def __init__(self, path):
        saved = json.loads(path.read_text(encoding="utf-8"))
        super().__init__({"has": {}, "calls": {}, **node} for node in saved["nodes"])
        self.roots = {name: self._decoded(value) for name, value in saved["roots"].items()}

    def _decoded(self, encoded):
        if isinstance(encoded, dict) and "node" in encoded:
            return self.stand(encoded["node"], self.nodes[encoded["node"]]["type"])
        return _decoded(self, encoded)

    def attribute(self, stand, name):
        node = self.nodes[stand._node_]
        called = any(call.startswith(f"{name}(") for call in node["calls"])
        if not called and name not in node["has"]:
            raise AttributeError(f"{type(stand).__name__} has no {name} on the tape")
        if called or node["has"][name] == {"routine": True}:
            return lambda *given, **named: self.called(stand, name, given, named)
        return self._decoded(node["has"][name])

    def called(self, stand, name, given, named):
        return self._decoded(self.nodes[stand._node_]["calls"][_call(name, given, named)])

    def constructed(self, name, kind, given):
        call = _call(name, given, {})
        return self._decoded({"node": next(i for i, node in enumerate(self.nodes) if node.get("made") == call)})
