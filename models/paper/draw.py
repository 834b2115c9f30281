#!/usr/bin/env python3
"""Draws the pairs of Figure 5 of the paper, and their pictures in docs/paper.

    python3 models/paper/draw.py            write every model file and picture
    python3 models/paper/draw.py NAME ...   write these only (cam, geneva, ...)
    python3 models/paper/draw.py --check    write nothing; fail if a file differs from its drawing

How outlines are made is told in ../drawing.py: lengths in mm, angles in degrees, points are complex numbers.
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

from cams import cam, crank_slider, film_advance  # noqa: E402
from drawing import write_or_check  # noqa: E402
from holding import blocks, fastener, fixture  # noqa: E402
from knee import patella_femur, tibia_femur  # noqa: E402
from wheels import chain_gear, geneva, ratchet_pawl  # noqa: E402

# In the order of Figure 5.
MODELS = [cam, fixture, fastener, ratchet_pawl, geneva, film_advance, crank_slider, blocks, chain_gear, tibia_femur, patella_femur]

if __name__ == "__main__":
    sys.exit(write_or_check(MODELS, HERE, sys.argv[1:]))
