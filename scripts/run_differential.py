#!/usr/bin/env python3
"""The differential suite in several ways, each against the reference interpreter.

glsl: the compiler's GLSL given to the host; host: the host's own ARB path, in a process of its own;
printed: that path with the compiler's own text of each program; layer: the same calls with the
layer in front, whose statistics must show that it compiled them. vertex-...: likewise of vertex
programs. ati-glsl, ati-text, ati-api: ATI fragment shaders as GLSL, and the same shaders with the
layer in front through ATI_text_fragment_shader and through ATI_fragment_shader. legacy-..., fp24-...:
the same under those modes of arithmetic; wild: programs that multiply infinities by zeros;
unwritten: programs that read what nothing wrote and leave results, or a position, unwritten.
swrast-...: the layer's rasterizer draws, by machine code of each program; its statistics must show
that it drew every one of them and gave the host nothing. --shard and --engine spread the programs
over machines (docs/driver/shards.md).
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests/merge"))

import of_differential
import results
import sharding

SOURCES = ("include", "src", "tests/back_ends_vs_interpreter")  # what a result depends on
SUITE_GLSL = 16  # draws of the suite's own GLSL: one an attribute that programs read


def run(name, out, build, block, options, extra):
    """One way's row for the report, of a block (first, how many) of its programs."""
    report = out / (name + ".json")
    report.unlink(missing_ok=True)
    first, count = block
    with open(out / (name + ".txt"), "w") as log:
        done = subprocess.run(
            [str(build / "tests/back_ends_vs_interpreter/differential"), *options,
             "--seed", str(1 + first), "--count", str(count), "--json", str(report),
             "--failures", str(out / (name + "-failures"))],
            env={**os.environ, **extra}, stdin=subprocess.DEVNULL, stdout=log,
            stderr=subprocess.STDOUT)
    try:
        row = of_differential.row(name, json.loads(report.read_text()))
    except (OSError, ValueError, KeyError):
        return of_differential.fault(name, "no report, status %d" % done.returncode)
    if done.returncode not in (0, 1) or (done.returncode == 1) != bool(row["failures"]):
        row["faults"].append("status %d" % done.returncode)
    return row


def not_drawn(stats, programs):
    """Why the rasterizer did not draw every program of a way; empty if it did."""
    try:
        software = json.loads(stats.read_text())["software"]
    except (OSError, ValueError, KeyError):
        return "no statistics"
    # Under a mode of arithmetic the suite measures attributes with GLSL of its own.
    given = {reason: count for reason, count in software["given_to_host"].items()
             if reason != "no_fragment_program" or count > SUITE_GLSL}
    if software["drawn"] >= programs and not given:
        return ""
    return "drew %d of %d programs, gave the host %s" % (software["drawn"], programs, given)


def compiled_by_layer(stats):
    try:
        document = json.loads(stats.read_text())
        return len(document["programs"]) + document["programs_not_listed"]
    except (OSError, ValueError, KeyError):
        return 0


def statistics_of(name, out):
    """Returns the file of the layer's statistics of a way."""
    return out / (name + "-statistics.json")


def all_ways(args, out):
    """(name, programs, options, environment) of each; statistics go to `out`."""
    layer = (args.build / "src/interposer/libGLX_arbiter.so.0").resolve()
    in_front = {"LD_PRELOAD": str(layer), "ARBITER_PROFILE": "host"}
    ati = ["--language", "ati", "--mode"]
    vertex = ["--language", "vertex", "--mode"]
    plain = ["--plain", "1"]  # Mesa reads some constants of SWZ wrong
    ways = [("glsl", args.count, ["--mode", "glsl"], {}),
            ("host", args.count, ["--mode", "arb", *plain], {}),
            ("printed", args.count, ["--mode", "assembly"], {}),
            ("layer", args.count, ["--mode", "arb"],
             {**in_front, "ARBITER_STATS": str(statistics_of("layer", out))}),
            ("vertex-glsl", args.vertex_count, [*vertex, "glsl"], {}),
            ("vertex-host", args.vertex_count, [*vertex, "arb", *plain], {}),
            ("vertex-printed", args.vertex_count, [*vertex, "assembly"], {}),
            ("vertex-layer", args.vertex_count, [*vertex, "arb"], in_front),
            ("ati-glsl", args.count, [*ati, "glsl"], {}),
            ("ati-text", args.count, [*ati, "arb"], in_front),
            ("ati-api", args.count, [*ati, "api"], in_front)]
    nv, nv_vertex = ["--language", "nv", "--mode"], ["--language", "nv-vertex", "--mode"]
    nv_card = {**in_front, "ARBITER_PROFILE": "nv40"}
    # The interpreter takes its time with their loops.
    ways += [("nv-glsl", args.count // 3, [*nv, "glsl"], {}),
             ("nv-layer", args.mode_count, [*nv, "arb"], nv_card),
             ("nv-v-glsl", args.vertex_count // 3, [*nv_vertex, "glsl"], {}),
             ("nv-v-layer", args.mode_count, [*nv_vertex, "arb"], nv_card),
             ("nv-v-both", args.mode_count, [*nv_vertex, "arb"],
              {**nv_card, "ARBITER_BACKEND": "swrast"})]
    count = args.mode_count
    for mode in ("legacy", "fp24"):
        of_mode = ["--numerics", mode, "--mode"]
        in_mode = {**in_front, "ARBITER_NUMERICS": mode}
        ways += [(mode + "-glsl", count, [*of_mode, "glsl"], {}),
                 (mode + "-wild", count, [*of_mode, "glsl", "--wild", "1"], {}),
                 (mode + "-layer", count, [*of_mode, "arb"], in_mode),
                 (mode + "-ati", count, ["--language", "ati", *of_mode, "glsl"], {}),
                 (mode + "-ati-text", count, ["--language", "ati", *of_mode, "arb"], in_mode)]
    ways += [("legacy-vertex", count, ["--numerics", "legacy", *vertex, "glsl"], {}),
             ("legacy-v-layer", count, ["--numerics", "legacy", *vertex, "arb"],
              {**in_front, "ARBITER_NUMERICS": "legacy"})]
    software = {**in_front, "ARBITER_BACKEND": "swrast"}
    legacy = {**software, "ARBITER_NUMERICS": "legacy"}
    of_legacy = ["--numerics", "legacy", "--mode"]
    unwritten = ["--unwritten", "1"]
    ways += [("unwritten", count, [*unwritten, "--mode", "arb"], in_front),
             ("v-unwritten", count, [*unwritten, *vertex, "arb"], in_front)]
    drawn = [("", ["--mode", "arb"], software),
             ("unwritten", [*unwritten, "--mode", "arb"], software),
             ("v-unwritten", [*unwritten, *vertex, "arb"], software),
             ("wild", ["--mode", "arb", "--wild", "1"], software),
             ("edges", ["--mode", "arb", "--suite", "edges"], software),
             ("ati-text", [*ati, "arb"], software),
             ("ati-api", [*ati, "api"], software),
             ("vertex", [*vertex, "arb"], software),
             ("nv", [*nv, "arb"], {**software, "ARBITER_PROFILE": "nv40"}),
             ("v-edges", ["--suite", "edges", *vertex, "arb"], software),
             ("legacy", [*of_legacy, "arb"], legacy),
             ("l-wild", [*of_legacy, "arb", "--wild", "1"], legacy),
             ("l-edges", [*of_legacy, "arb", "--suite", "edges"], legacy),
             ("l-ati", ["--language", "ati", *of_legacy, "arb"], legacy),
             ("l-vertex", ["--numerics", "legacy", *vertex, "arb"], legacy)]
    for name, options, extra in drawn:
        name = ("swrast-" + name).rstrip("-")
        ways.append((name, count, options, {**extra, "ARBITER_STATS": str(statistics_of(name, out))}))
    return [way for way in ways if way[1] > 0 and (not args.ways or way[0] in args.ways)]


def statistics_fault(name, row, stats):
    """What statistics of the layer lack of a way; empty if nothing."""
    if name.startswith("swrast"):
        lacking = not_drawn(stats, row["programs"])
        return "the rasterizer " + lacking if lacking else ""
    if name == "layer" and compiled_by_layer(stats) < row["programs"]:
        return "it compiled fewer programs than were drawn"
    return ""


def run_way(way, out, build, block):
    """Returns a way's row, with what its statistics lack."""
    name, _, options, extra = way
    stats = statistics_of(name, out)
    stats.unlink(missing_ok=True)
    row = run(name, out, build, block, options, extra)
    lacking = statistics_fault(name, row, stats)
    if lacking:
        row["faults"].append(lacking)
    return row


def run_shard(args, shard):
    """(content, seconds) of the shard's block of each way's programs. Ways run side by side, as most of a way's time is
    one thread's; where shards do, each runs its ways in turn."""
    out = sharding.pieces_folder(args.out, args)
    out.mkdir(parents=True, exist_ok=True)
    rows, start = {}, time.monotonic()
    # Edges have no numbers: they are one test.
    blocks = [(way, shard.block(way[1]) if "edges" not in way[2] else (0, int(shard.has(way[0])) * way[1]))
              for way in all_ways(args, out)]
    with concurrent.futures.ThreadPoolExecutor(1 if args.shard else len(os.sched_getaffinity(0))) as pool:
        running = [(way[0], pool.submit(run_way, way, out, args.build, block)) for way, block in blocks if block[1]]
        for name, made in running:
            row = rows[name] = made.result()
            print("%-15s %4d programs, %d failed" % (name, row["programs"], len(row["failures"])), flush=True)
    return {"ways": rows}, {"all": time.monotonic() - start}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--count", type=int, default=500, help="fragment programs")
    parser.add_argument("--vertex-count", type=int, default=300, help="vertex programs")
    parser.add_argument("--mode-count", type=int, default=60,
                        help="programs of each kind in each mode of arithmetic")
    parser.add_argument("--ways", type=lambda text: text.split(","), help="only these, by name")
    parser.add_argument("--counts", type=pathlib.Path, help="file for the counts, as JSON")
    sharding.add_options(parser)
    args = parser.parse_args()
    sharding.check(parser, args)
    known = [way[0] for way in all_ways(argparse.Namespace(**{**vars(args), "ways": None}), args.out)]
    if args.ways and not set(args.ways) <= set(known):
        parser.error("--ways: there are " + " ".join(known))
    return args


def main():
    args = arguments()
    run = {"kind": of_differential.KIND, "count": args.count, "vertex_count": args.vertex_count,
           "mode_count": args.mode_count, "ways": [way[0] for way in all_ways(args, args.out)],
           "sources": results.sources_digest(sharding.ROOT, SOURCES)}
    command = [str(sharding.ROOT / "dev"), "differential", "--count", str(args.count),
               "--vertex-count", str(args.vertex_count), "--mode-count", str(args.mode_count),
               *(["--ways", ",".join(args.ways)] if args.ways else [])]
    return sharding.main(args, run, lambda shard: run_shard(args, shard), command, args.out)


if __name__ == "__main__":
    sys.exit(main())
