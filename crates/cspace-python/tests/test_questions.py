"""Every question that the library answers about a pair has an answer in Python, or a reason why there is none.

A new public function of PairSpace, PairPatch or FeatureContact fails here until it has an entry in the table: the name in Python, such as
"ContactSpace.classify", or "none: " or "missing: " and a reason.
"""

import functools
import re

import pytest

import cspace as cs
from conftest import ROOT

ANSWERS = {
    # The space.
    "PairSpace.compute": "compute",
    "PairSpace.compute_with": "progress",
    "PairSpace.compute_each": "sweep",
    "PairSpace.class": "ContactSpace.pair_class",
    "PairSpace.fixed": "ContactSpace.fixed",
    "PairSpace.moving": "ContactSpace.moving",
    "PairSpace.features": "ContactSpace.features",
    "PairSpace.least_clearance": "ContactSpace.least_clearance",
    "PairSpace.resolution": "ContactSpace.resolution",
    "PairSpace.contact_distance": "ContactSpace.contact_distance",
    "PairSpace.patch_count": "ContactSpace.patches",
    "PairSpace.band_count": "ContactSpace.bands",
    "PairSpace.region_count": "ContactSpace.regions",
    "PairSpace.data": "ContactSpace.save",
    # What it consists of.
    "PairSpace.patches": "ContactSpace.patches",
    "PairSpace.patch": "ContactSpace.patches",
    "PairSpace.links": "ContactSpace.links",
    "PairSpace.neighbours": "ContactSpace.to_networkx",
    "PairSpace.bands": "ContactSpace.bands",
    "PairSpace.regions": "ContactSpace.regions",
    "PairPatch.id": "none: a patch's number is its place in ContactSpace.patches",
    "PairPatch.features": "Patch.fixed",
    "PairPatch.region": "Patch.region",
    "PairPatch.orientations": "Patch.orientations",
    "PairPatch.ends_at": "ContactSpace.patch_ends",
    "PairPatch.neighbours": "ContactSpace.to_networkx",
    # Configurations.
    "PairSpace.classify": "ContactSpace.classify",
    "PairSpace.locate": "ContactSpace.region",
    "PairSpace.connected": "ContactSpace.connected",
    "PairSpace.clearance": "ContactSpace.clearance",
    "PairSpace.contacts": "ContactSpace.contacts",
    "PairSpace.is_on": "ContactSpace.contacts",
    "PairSpace.near_features": "ContactSpace.features_within",
    "PairSpace.nearest_contact": "ContactSpace.nearest",
    "PairSpace.project": "ContactSpace.nearest",
    "PairSpace.nearest_patch": "ContactSpace.nearest",
    # Motions.
    "PairSpace.first_contact": "ContactSpace.move",
    "PairSpace.first_contact_about": "ContactSpace.move",
    "PairSpace.first_contact_along": "missing: the first contact along any curve that a function of Python gives, with bounds of its rates",
    "PairSpace.crossings": "ContactSpace.crossings",
    # Contact functions.
    "PairPatch.contact": "ContactSpace.contact_function",
    "PairSpace.contact_of": "ContactSpace.contact_function",
    "FeatureContact.value": "ContactSpace.contact_function",
    "FeatureContact.evaluate": "ContactSpace.contact_function",
    "FeatureContact.touching": "ContactSpace.contact_function",
    "FeatureContact.by_drawing": "missing: the derivatives of the contact function by the vertices and bulges of the drawing",
}

ASKED = ("PairSpace", "PairPatch", "FeatureContact")


def of_rust():
    """The public functions of the types in question, as Type.function."""
    found = set()
    for path in (ROOT / "crates/cspace/src/pair").glob("*.rs"):
        text = path.read_text(encoding="utf-8")
        for kind, body in re.findall(r"^impl(?:<[^>]*>)? (\w+)(?:<[^>]*>)? \{\n(.*?)^\}", text, re.MULTILINE | re.DOTALL):
            if kind in ASKED:
                found |= {f"{kind}.{name}" for name in re.findall(r"^    pub (?:const )?fn (\w+)", body, re.MULTILINE)}
    return found


def is_reason(answer):
    return answer.startswith(("none: ", "missing: "))


def test_the_sources_are_read():
    found = of_rust()
    assert {"PairSpace.classify", "PairPatch.ends_at", "FeatureContact.evaluate", "PairSpace.compute_each"} <= found
    assert not any(name.endswith((".neighbours_of", ".placed", ".names", ".new")) for name in found)


def test_every_question_has_an_entry():
    found = of_rust()
    assert sorted(found - ANSWERS.keys()) == [], "give these an entry in the table"
    assert sorted(ANSWERS.keys() - found) == [], "these are no more"


@pytest.mark.parametrize("answer", sorted({a for a in ANSWERS.values() if not is_reason(a)}))
def test_the_answer_is_there(answer):
    name, *rest = answer.split(".")
    assert name in cs.__all__
    found = getattr(cs, name)
    if rest and rest[0] in getattr(found, "__dataclass_fields__", {}):
        return
    assert functools.reduce(getattr, rest, found).__doc__


def test_reasons_are_words():
    assert all(len(answer.split()) > 3 for answer in ANSWERS.values() if is_reason(answer))
