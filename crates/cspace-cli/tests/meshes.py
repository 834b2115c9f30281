"""Opens the meshes that are given in the programs that people use: trimesh, meshio, pygltflib.

Usage: meshes.py NAME.ply ASCII.ply NAME.obj NAME.stl NAME.glb. Prints the number of triangles that each finds in each file, which are to be
the same. Leaves with 77 where a program is not installed.
"""

import sys

try:
    import meshio
    import pygltflib
    import trimesh
except ImportError as missing:
    print(missing)
    sys.exit(77)


def triangles(path):
    """The numbers of triangles, one for each program that reads the format."""
    if path.endswith(".glb"):
        file = pygltflib.GLTF2().load(path)
        primitive = file.meshes[0].primitives[0]
        assert primitive.attributes.NORMAL is not None and file.materials
        yield "pygltflib", file.accessors[primitive.indices].count // 3
    elif not (path.endswith(".ply") and b"binary" in open(path, "rb").read(40)):
        # Of binary PLY meshio reads faces with one property alone, and these have their patch.
        yield "meshio", len(meshio.read(path).cells_dict["triangle"])
    mesh = trimesh.load(path, force="mesh", process=False)
    assert mesh.extents.min() > 0
    yield "trimesh", len(mesh.faces)


found = {(path.rsplit("/")[-1], program, n) for path in sys.argv[1:] for program, n in triangles(path)}
for line in sorted(found):
    print(*line)
counts = [n for _, _, n in found]
# In single precision, which is all that GLB has, some triangles have no area and are left out.
sys.exit(max(counts) - min(counts) > max(counts) / 1000)
