#!/usr/bin/env python3
"""Draws models of this folder once more, with masses, friction and restitution: what drives and loads them is the same, or the comment of the file gives the difference.

    python3 models/weighed.py            write every model file
    python3 models/weighed.py NAME ...   write these only (geneva_dynamic, ...)
    python3 models/weighed.py --check    write nothing; fail if a file differs from its drawing
"""

import sys
from pathlib import Path

from draw import cam_tappet, geneva, ratchet_mechanism
from drawing import write_or_check
from forces import PLASTIC, STEEL
from mechanisms import cam_roller, film_advance, snap_in

STEEL_ON_STEEL = ["friction = 0.15 # steel on steel, dry", "restitution = 0.3"]


def geneva_dynamic():
    return geneva().weighed("geneva_dynamic.toml", """
With masses, to be seen beside the motion of geneva.toml: the pin strikes the slots, and at dwell the wheel rattles in its play until it rests.
""", STEEL_ON_STEEL, {"wheel": [STEEL], "driver": [STEEL]})


def cam_tappet_dynamic():
    return cam_tappet().weighed("cam_tappet_dynamic.toml", """
With masses, to be seen beside the motion of cam_tappet.toml: the tappet comes down on the dwell with a bounce and then stays on the cam.
""", STEEL_ON_STEEL, {"cam": [STEEL], "tappet": [STEEL]})


def cam_roller_dynamic():
    return cam_roller().weighed("cam_roller_dynamic.toml", """
With masses, to be seen beside the motion of cam_roller.toml: friction turns the roller, so that it rolls on the cam.
""", STEEL_ON_STEEL, {"cam": [STEEL], "roller": [STEEL], "stem": [STEEL]})


def film_advance_dynamic():
    m = film_advance().weighed("film_advance_dynamic.toml", """
With masses, to be seen beside the motion of film_advance.toml: the film runs on a little when the claw has brought it to its speed, and is
caught by the gate, whose friction is a damper here.
""", STEEL_ON_STEEL, {
        "film": ["mass = 0.002 # with what moves along with it"], "crank": ["density = 2.4e-5 # steel, 3 thick"],
        "claw": ["density = 2.4e-5"], "rocker": ["density = 2.4e-5"]})
    return m.spring("film", (-14 + 0j, -14 - 1000j), 0, 1000, 2, "The gate.")


def ratchet_mechanism_dynamic():
    return ratchet_mechanism("3e4", "1e5").weighed("ratchet_mechanism_dynamic.toml", """
With masses, to be seen beside the motion of ratchet_mechanism.toml: the pawl falls behind a tooth with a bounce; the wheel, braked less, runs on
a little when the link turns back.
""", STEEL_ON_STEEL, {part: [STEEL] for part in ("driver", "link", "pawl", "ratchet")})


def snap_in_dynamic():
    return snap_in(50).weighed("snap_in_dynamic.toml", """
With masses, to be seen beside the motion of snap_in.toml: the hook springs back behind the lip and rings for a while. With this friction the
retention face, 10 deg from square, lets the hook out again.
""", STEEL_ON_STEEL, {"cover": [PLASTIC], "hook": [PLASTIC]})


MODELS = [geneva_dynamic, cam_tappet_dynamic, cam_roller_dynamic, film_advance_dynamic, ratchet_mechanism_dynamic, snap_in_dynamic]


if __name__ == "__main__":
    sys.exit(write_or_check(MODELS, Path(__file__).resolve().parent, sys.argv[1:]))
