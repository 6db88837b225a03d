#!/usr/bin/env python3
"""Draws scenes with pairwise combinations of GL's state on the bare host and under the layer.

  run_states.py --build build                      the quick set: the first rows of the array
  run_states.py --build build --count 0            every possible pair of values
  run_states.py --build build --seed 7 --count 200
  run_states.py --build build --only 17            that row of the array; prints what it sets
  run_states.py --build build --out FOLDER         keeps the pictures that differ

With an assembly program the bare host ignores ShadeModel, and sometimes takes a depth texture of mode ALPHA for one of
INTENSITY: such scenes are compared with the host's picture of the layer's GLSL (ARBITER_BACKEND=host).

The rows are a covering array (covering.py) of the states in factors.py, followed by scenes that pairs alone do not make
(AFTER_THE_ROWS). Colors may differ by 1 of 255, depths by the resolution of 16 bits; where judge() says so, a bounded
number of pixels may differ by more. Ends with "N passed, N failed, N skipped".
"""

import array
import concurrent.futures
import pathlib
import sys
import tempfile

import covering
import sides
from factors import FACTORS, line, make_valid

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "real_programs_vs_host"))
from picture import of_rgba, write_png  # noqa: E402

AFTER_THE_ROWS = [
    # These test a quad's provoking vertex, and the corner from which it is split and outlined.
    "program=color shade=flat primitive=quads provoking=first",
    "program=color shade=smooth primitive=quads provoking=first",
    "program=color shade=flat primitive=quad_strip provoking=first",
    "program=color primitive=quad_strip provoking=first stipple=line mode_front=line mode_back=line",
    "program=color shade=flat primitive=quads provoking=first stipple=line mode_front=line "
    "mode_back=line vertices=clipped",
    # Several polygons share corners here, each with its own offset.
    "program=constant primitive=triangle_strip depths=perspective mode_back=point offset=on "
    "point_size=4 viewport=small depth_test=gequal logic_op=op10",
]
EDGE = 48
BATCH = 20  # scenes for each process
DEPTH = 1 << 16  # of 2^32: the interpolation of a depth in single precision


def run_batch(client, scenes, env, spell=line):
    """Returns [records of a scene or a text that says how the client died]."""
    try:
        found = sides.run([client], env, "".join(spell(s) + "\n" for s in scenes).encode())
        # A record's name begins with the number of its scene in the batch.
        named = [(what.split(" ", 1)[1], data) for what, data in found]
        return [{what.split(" ")[0]: (what, data) for what, data in named[5 * i:5 * i + 5]}
                for i in range(len(scenes))]
    except sides.Died as death:
        if len(scenes) == 1:
            return [str(death)]
        return [result for scene in scenes for result in run_batch(client, [scene], env, spell)]


def far_depths(a, b):
    if a == b:
        return 0
    return sum(abs(x - y) > DEPTH for x, y in zip(array.array("I", a), array.array("I", b)))


def allowance(scene):
    """Returns (levels that a channel may differ by, the fraction of pixels that may differ by more).

    The exceptions are these. A blend reads what an earlier primitive may have drawn a level apart, and scales the
    source's
    level. A test against a threshold, of alpha, by the program or of a texture's depth, may go either way in the pixels
    next
    to where the value crosses it. So may the choice between the filters of an image that is both magnified and
    minified.
    The ends of wide and stippled lines are free. Unfilled polygons draw their common sides and corners once each, so
    that
    the last bit of a sloped depth decides whether the second passes."""
    levels, part = (2 if scene["blend"] == "on" else 1), 0.0
    unfilled = (scene["mode_front"], scene["mode_back"]) != ("fill", "fill")
    if scene["alpha_test"] != "off" or scene["program"] == "kill":
        part += 0.01
    if scene["compare"] != "off":
        part += 0.02
    if scene["mag_filter"] != scene["min_filter"]:
        part += 0.005
    if ((scene["width"] != "1" or scene["stipple"] == "line")
            and ("line" in scene["primitive"] or unfilled)):
        part += 0.03
    if scene["depths"] != "level" and scene["depth_test"] != "off" and unfilled:
        part += 0.06
    return levels, part


def judge(scene, bare, layer):
    """Returns complaints, as lines."""
    if isinstance(layer, str):
        return [] if isinstance(bare, str) else [f"died under the layer: {layer}"]
    if isinstance(bare, str):
        return [f"died on the bare host: {bare}"]
    lines = []
    if bare["errors"][0] != layer["errors"][0]:
        lines.append(f"errors: '{bare['errors'][0]}', layer '{layer['errors'][0]}'")
    levels, part = allowance(scene)
    pixels = EDGE * EDGE
    counts = {"color": sides.distances(bare["color"][1], layer["color"][1], levels)[0],
              "depth": far_depths(bare["depth"][1], layer["depth"][1]),
              "stencil": sum(x != y for x, y in zip(bare["stencil"][1], layer["stencil"][1]))}
    for what, count in counts.items():
        if count > part * pixels:
            worst = max(abs(x - y) for x, y in zip(bare[what][1], layer[what][1]))
            lines.append(f"{what}: {count} pixels differ (by more than {levels} levels), by up to "
                         f"{worst}; allowed {int(part * pixels)}")
    return lines


BACKGROUND = {bytes(color) for color in ((64, 128, 191, 128), (200, 40, 90, 180), (30, 220, 130, 60))}


def lively(bare):
    """True if the scene's own draws are visible: otherwise it tests little."""
    if isinstance(bare, str):
        return False
    data = bare["color"][1]
    return any(data[i:i + 4] not in BACKGROUND for i in range(0, len(data), 4))


def keep(folder, number, scene, bare, layer):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{number}.txt").write_text("\n".join(f"{k}={v}" for k, v in scene.items()) + "\n")
    for side, records in (("bare", bare), ("layer", layer)):
        if isinstance(records, str):
            continue
        write_png(folder / f"{number}.{side}.png", of_rgba(records["color"][1], EDGE, EDGE))


def scene_of(words):
    """Returns the scene with the words' values, and the first value of all other factors."""
    return make_valid({**{name: next(iter(values)) for name, values in FACTORS.items()},
                       **dict(word.split("=") for word in words.split())})


def wants_glsl(scene):
    """True if the host is only right in GLSL."""
    return (scene["shade"] == "flat"
            or (scene["format"] == "depth24" and scene["depth_mode"] == "alpha"))


def reduce(scene, differs):
    """Resets as many factors as possible to their first value while the scene still differs."""
    for name in FACTORS:
        plain = next(iter(FACTORS[name]))
        if scene[name] != plain:
            candidate = make_valid({**scene, name: plain})
            if differs(candidate):
                scene = candidate
    return scene


def self_test():
    count = covering.self_test()
    scene = scene_of("")
    same = {"color": ("", bytes(EDGE * EDGE * 4)), "depth": ("", bytes(EDGE * EDGE * 4)),
            "stencil": ("", bytes(EDGE * EDGE)), "errors": ("0 errors", b"")}
    assert judge(scene, same, same) == []

    def changed(what, value):
        data = same[what][1]
        return {**same, what: ("", bytes([value]) * (len(data) // 3) + data[len(data) // 3:])}

    assert judge(scene, same, changed("color", 1)) == []
    assert judge(scene, same, changed("color", 120)) and judge(scene, same, changed("stencil", 1))
    assert judge(scene, same, changed("depth", 9)) and judge(scene, same, "status -11")
    assert judge(scene, same, {**same, "errors": ("0 errors 0x0502", b"")})
    wanted = {"blend": "on", "format": "l8"}
    start = make_valid({name: list(values)[-1] for name, values in FACTORS.items()} | wanted
                       | {"logic_op": "off"})
    found = reduce(start, lambda s: all(s[k] == v for k, v in wanted.items()))
    assert [k for k in FACTORS if found[k] != next(iter(FACTORS[k]))] == ["blend", "format"]
    print(f"{count + 7} passed, 0 failed, 0 skipped")


def parse():
    parser = sides.options(__doc__)
    parser.add_argument("--backend", default="swrast", choices=("swrast", "auto", "host"))
    parser.add_argument("--cpu", choices=sides.CPU_FLAGS, help="the rasterizer as on this family")
    parser.add_argument("--count", type=int, default=100, help="rows; 0: all")
    parser.add_argument("--seed", type=int, default=1, help="of the array")
    parser.add_argument("--only", type=int, action="append", help="a row; may be repeated")
    parser.add_argument("--drawn", action="store_true", help="fail if the rasterizer drew nothing")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--reduce", type=int, default=3, help="how many failures are reduced")
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--self-test", action="store_true")
    return parser.parse_args()


def main():
    args = parse()
    if args.self_test:
        return self_test()
    client = args.build.resolve() / "tests/rasterizer_vs_host/rasterizer-states"
    rows, part = covering.rows(FACTORS, make_valid, args.count, args.seed)
    rows = rows + [scene_of(words) for words in AFTER_THE_ROWS]
    numbers = args.only or range(len(rows))
    chosen = [(n, rows[n]) for n in numbers]
    batches = [chosen[i:i + BATCH] for i in range(0, len(chosen), BATCH)]
    failed, alive = 0, 0
    with tempfile.TemporaryDirectory(prefix="arbiter-states-") as scratch, \
            sides.Displays() as displays, concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        stats = pathlib.Path(scratch) / "stats-%p.json"
        bare_env = sides.environment()
        layer_env = sides.environment(sides.layer_of(args.build.resolve()), args.backend,
                                      {"XDG_CACHE_HOME": scratch, "ARBITER_STATS": str(stats),
                                       **sides.cpu_setting(args.cpu)})

        glsl_env = sides.environment(sides.layer_of(args.build.resolve()), "host",
                                     {"XDG_CACHE_HOME": scratch})

        def draw(scenes, env):
            return run_batch(client, scenes, {**env, "DISPLAY": displays.name()}) if scenes else []

        def both(scenes):
            glsl = iter(draw([s for s in scenes if wants_glsl(s)], glsl_env))
            other = iter(draw([s for s in scenes if not wants_glsl(s)], bare_env))
            return ([next(glsl if wants_glsl(s) else other) for s in scenes],
                    draw(scenes, layer_env))

        def differs(scene):
            (bare,), (layer,) = both([scene])
            return bool(judge(scene, bare, layer))

        results = pool.map(lambda batch: both([scene for _, scene in batch]), batches)
        for batch, (bares, layers) in zip(batches, results):
            for (number, scene), bare, layer in zip(batch, bares, layers):
                alive += lively(bare)
                lines = judge(scene, bare, layer)
                if args.only:
                    print("\n".join(f"    {k}={v}" for k, v in scene.items()))
                if not lines:
                    continue
                failed += 1
                print(f"FAIL row {number} of seed {args.seed}:")
                print("\n".join(f"    {text}" for text in lines), flush=True)
                if args.out:
                    keep(args.out, number, scene, bare, layer)
                if failed <= args.reduce:
                    small = reduce(scene, differs)
                    print("    reduced: " + " ".join(
                        f"{k}={v}" for k, v in small.items() if v != next(iter(FACTORS[k]))),
                        flush=True)
        total, given = sides.software_totals(scratch)
    print(f"{len(chosen)} scenes hold {100 * part:.1f} % of all pairs; in {alive} something is seen; "
          f"the rasterizer drew {total}, and the host {given or 'nothing'}")
    failed += args.drawn and not total
    print(f"{len(chosen) - failed} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
