"""Blocks, a fixture and a fastener: parts that hold or are held."""

from common import RECONSTRUCTION, rectangle
from drawing import Model, rounded_polygon
from forces import GRAVITY, STEEL, placed


def blocks():
    seat = rounded_polygon([
        (-15 - 15j, 0, "foot"), (45 - 15j, 0, "end"), (45 + 0j, 0, "bed"), (0j, 2.0, "fence"), (30j, 0, "top"), (-15 + 30j, 0, "back"),
    ])
    block = rounded_polygon([(0j, 3.0, "bears on the bed"), (25 + 0j, 0, "end"), (25 + 18j, 0, "top"), (18j, 0, "bears on the fence")])
    m = Model("blocks.toml", "blocks", f"""
A block in the corner of an angle block. 12 + 8 = 20 features.

{RECONSTRUCTION}

The angle block has a bed of 45 and a fence of 30 with a fillet R2 between them. The block, 25 x 18, has one corner rounded R3,
which clears the fillet: with this corner in the angle it seats on bed and fence, with any other it does not.

At (x, y, theta) = (0, 0, 0) the block is seated.
""")
    m.show("Does the angle hold the block?")
    m.world(gravity=(0, -GRAVITY), friction=0.15, restitution=0.3)
    m.part("angle", "The corner of the angle is the origin.", [("outline", seat)], keys=[STEEL])
    m.part("block", "The rounded corner is at the origin.", [("outline", block)], keys=[STEEL, placed(12, 6, -8)])
    m.mounted("angle", [-15 - 15j, 45 - 15j], 1e6, 1000, text="The angle stands on the bench.")
    m.force("block", (-150, 0), "The block is dropped, pushed to the fence, and comes to rest seated.")
    return m.picture({})


def fixture():
    pads = [("pad 1 of the long side", rectangle(10 - 12j, 22 + 0j)),
            ("pad 2 of the long side", rectangle(58 - 12j, 70 + 0j)),
            ("pad of the short side", rectangle(-12 + 19j, 0 + 31j))]
    work = rounded_polygon([
        (0j, 0, "long side, rests on two pads"), (80 + 0j, 0, "end"), (80 + 25j, 0, "step"), (50 + 25j, 3.0, "step"),
        (50 + 50j, 0, "top"), (50j, 0, "short side, rests on one pad"),
    ])
    m = Model("fixture.toml", "fixture", f"""
Three pads of a milling fixture and the workpiece they locate. 24 + 12 = 36 features.

{RECONSTRUCTION}

Two pads carry the long side of the workpiece and one its short side, the 3-2-1 rule in the plane: pressed against them it has one
place and one direction. The pads are ground square, 12 x 12; the workpiece is a sawn blank, 80 x 50, with a step and R3 in its corner.

At (x, y, theta) = (0, 0, 0) the workpiece lies on all three pads.
""")
    m.show("Does the fixture alone hold the workpiece?")
    m.world(friction=0.15, restitution=0.3)
    m.part("fixture", "Pads that stand apart; the plate that carries them is not in this plane.", pads, keys=["mass = 10", "inertia = 20000"])
    m.part("workpiece", "The located corner is the origin.", [("outline", work)], keys=[STEEL, placed(5, 8, 5)])
    m.mounted("fixture", [-10 - 10j, 70 - 10j], 2e6, 4000, text="The machine's table, on which the fixture is clamped.")
    m.spring("workpiece", (38 + 24j, -12 - 36j), 100, 0, 5,
             text="The clamp pulls the workpiece, laid in askew, against all three pads; it comes to rest located.")
    return m.picture({})


def fastener():
    depth, mouth, lip, wall = 14.0, 4.0, 8.0, 6.0
    shank, barb, tip, gap = 3.8, 5.2, 2.2, 0.15
    socket = rounded_polygon([(p, 0, note) for p, note in (
        (complex(-wall, 0), "face"), (0j, "mouth"), (complex(0, -depth - gap), "floor"), (complex(8, -depth - gap), "pocket"),
        (complex(8, -lip), "lip, holds the barb"), (complex(mouth, -lip), "mouth"), (complex(mouth, 0), "face"),
        (14 + 0j, "side"), (14 - 20j, "foot"), (complex(-wall, -20), "side"))])
    hook = rounded_polygon([(p, 0, note) for p, note in (
        (complex(mouth - shank, 12), "back"), (complex(mouth - shank, -depth), "tip"), (complex(tip, -depth), "lead-in"),
        (complex(barb, -lip - gap), "barb"), (complex(shank, -lip - gap), "tongue"), (complex(shank, 12), "end"))])
    m = Model("fastener.toml", "snap fastener", f"""
Snap fastener cut from sheet: a barbed tongue and the socket it snaps into. 20 + 12 = 32 features.

{RECONSTRUCTION}

The socket's mouth is {mouth:g} wide and {lip:g} deep; behind it the pocket is undercut by {8 - mouth:g}. The tongue, {shank - 0.2:g} wide, has a barb that
stands out by {barb - shank:.1f} and a lead-in that bends it aside as it is pushed in. Snapped in, it has {gap:g} of play between the lip and the
floor, and parts that do not bend cannot come apart. The sheet is cut with sharp corners.

At (x, y, theta) = (0, 0, 0) the tongue is snapped in, {gap:g} below the lip and as much above the floor.
""")
    m.show("Can the tongue leave the socket without bending?")
    m.part("socket", "The mouth's edge is the origin.", [("outline", socket)], keys=[STEEL])
    m.part("tongue", "Drawn snapped in.", [("outline", hook)], keys=["mass = 0.3 # with what it carries", "inertia = 60"])
    m.mounted("socket", [-6 - 20j, 14 - 20j], 1e6, 3000, text="The sheet of the socket, held at its foot.")
    m.spring("tongue", (2 + 12j, 12 + 32j), 100, 0, 300, text="A pull askew: the tongue tilts in the mouth, its barb bears on the lip, and it holds.")
    return m.picture({})
