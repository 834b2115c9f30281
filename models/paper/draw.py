#!/usr/bin/env python3
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import importlib
import drawing
from drawing import write_or_check
ALL=[]
for mod in ("cams","holding","wheels","knee"):
    try: m=importlib.import_module(mod)
    except ModuleNotFoundError: continue
    ALL += [f for n,f in vars(m).items() if n in "cam fixture fastener ratchet_pawl geneva film_advance crank_slider blocks chain_gear tibia_femur patella_femur".split()]
sys.exit(write_or_check(ALL, HERE, sys.argv[1:]))
