"""Reads what clothlab has written, as a user of Blender would, and holds every vertex against the CSV of the frame.

blender -b --factory-startup --python-exit-code 1 --python read_back.py -- FOLDER, which tests/blender/run fills.
"""

import csv
import importlib.util
import os
import sys
from pathlib import Path

import bpy

FOLDER = Path(sys.argv[sys.argv.index("--") + 1])
FRAMES = [0, 7, 20]
RATE = 90  # frames a second, of the scene
TOLERANCE = 1e-5  # m


def expected(frame):
    """Positions in Blender's world, which is z up."""
    with open(FOLDER / f"expected_{frame:04d}.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    places = [[float(row["position_" + axis]) for axis in "xyz"] for row in rows]
    return [(x, -z, y) for x, y, z in places]


def fresh():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.fps = RATE


def imported(operator, path, **options):
    operator(filepath=str(FOLDER / path), **options)
    meshes = [o for o in bpy.context.scene.objects if o.type == "MESH"]
    assert len(meshes) == 1, f"{path}: {len(meshes)} meshes"
    return meshes[0]


def compare(thing, frame, scale=1):
    bpy.context.scene.frame_set(frame)
    graph = bpy.context.evaluated_depsgraph_get()
    evaluated = thing.evaluated_get(graph)
    vertices = [evaluated.matrix_world @ v.co for v in evaluated.to_mesh().vertices]
    wanted = expected(frame)
    assert len(vertices) == len(wanted), f"{len(vertices)} vertices and not {len(wanted)}"
    worst = max(abs(a / scale - b) for v, w in zip(vertices, wanted) for a, b in zip(v, w))
    assert worst <= TOLERANCE, f"frame {frame}: {worst} m off"
    return worst


def compare_texture(thing):
    """Texture coordinates of every corner, which run from 0 to 1 over the grid in every format."""
    with open(FOLDER / "expected_0000.csv", newline="") as file:
        places = [(int(row["x"]), int(row["y"])) for row in csv.DictReader(file)]
    width, height = (max(place) for place in zip(*places))
    coordinates = thing.data.uv_layers[0].data
    for loop in thing.data.loops:
        x, y = places[loop.vertex_index]
        u, v = coordinates[loop.index].uv
        assert abs(u - x / width) + abs(v - y / height) < 1e-5, f"point ({x}, {y}) has the texture at {u}, {v}"


def obj():
    for frame in FRAMES:
        fresh()
        thing = imported(bpy.ops.wm.obj_import, f"a_{frame:04d}.obj")
        compare_texture(thing)
        yield compare(thing, frame)


def obj_with_z_up_in_centimetres():
    fresh()
    thing = imported(bpy.ops.wm.obj_import, "z.obj", forward_axis="Y", up_axis="Z")
    yield compare(thing, FRAMES[-1], scale=100)


def ply_with_z_up():
    for frame in FRAMES:
        fresh()
        thing = imported(bpy.ops.import_mesh.ply, f"z_{frame:04d}.ply")
        compare_texture(thing)
        yield compare(thing, frame)


def cache(ending):
    fresh()
    thing = imported(bpy.ops.wm.obj_import, "a.obj")
    modifier = thing.modifiers.new("cloth", "MESH_CACHE")
    modifier.cache_format = ending.upper()
    modifier.filepath = str(FOLDER / f"a.{ending}")
    for frame in FRAMES:
        yield compare(thing, frame)


def pc2():
    yield from cache("pc2")


def mdd():
    yield from cache("mdd")


def glb():
    import numpy

    if "bool" not in vars(numpy):
        numpy.bool = bool  # Debian 12: its Blender 3.4 asks for a name that its numpy 1.24 has no more
    fresh()
    thing = imported(bpy.ops.import_scene.gltf, "a.glb")
    compare_texture(thing)
    for frame in FRAMES:
        yield compare(thing, frame)


def can_read_glb():
    return importlib.util.find_spec("numpy") or os.environ.get("CLOTHLAB_REQUIRE_BLENDER") == "1"


def main():
    moved = max(abs(a - b) for v, w in zip(expected(FRAMES[0]), expected(FRAMES[-1])) for a, b in zip(v, w))
    assert moved > 0.01, "the sheet hardly moves, so that a wrong frame would not show"
    status = 0
    checks = [obj, obj_with_z_up_in_centimetres, ply_with_z_up, pc2, mdd, glb]
    if not can_read_glb():
        print("SKIP glb: Blender reads it with numpy, which is not here; on Debian and Ubuntu: python3-numpy")
        checks.remove(glb)
        status = 77
    for check in checks:
        try:
            print(f"PASS {check.__name__}: at most {max(check()):.2g} m off")
        except Exception as problem:  # of one, so that the others are seen, too
            status = 1
            print(f"FAIL {check.__name__}: {problem}")
    sys.exit(status)


main()
