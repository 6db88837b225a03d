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
that it drew every one of them and gave the host nothing.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys

SUITE_GLSL = 16  # draws of the suite's own GLSL: one an attribute that programs read


def run(name, args, count, options, extra):
    """(failed, programs) of one way; failed is None if it could not run at all."""
    report = args.out / (name + ".json")
    report.unlink(missing_ok=True)
    print("%-15s" % name, end=" ", flush=True)
    done = subprocess.run(
        [str(args.build / "tests/back_ends_vs_interpreter/differential"), *options,
         "--count", str(count), "--json", str(report),
         "--failures", str(args.out / (name + "-failures"))],
        env={**os.environ, **extra}, stdin=subprocess.DEVNULL)
    try:
        document = json.loads(report.read_text())
    except (OSError, ValueError):
        print("%-15s no report, status %d" % (name, done.returncode), flush=True)
        return None
    failed = len(document["failures"])
    if done.returncode not in (0, 1) or (done.returncode == 1) != (failed > 0):
        return None
    return failed, document["programs"]


def not_drawn(stats, programs):
    """Why the rasterizer did not draw every program of a way; empty if it did."""
    try:
        software = json.loads(stats.read_text())["software"]
    except (OSError, ValueError, KeyError):
        return "no statistics"
    # Under a mode of arithmetic the suite measures attributes with GLSL of its own.
    given = {reason: count for reason, count in software["given_to_host"].items()
             if reason != "no-fragment-program" or count > SUITE_GLSL}
    if software["drawn"] >= programs and not given:
        return ""
    return "drew %d of %d programs, gave the host %s" % (software["drawn"], programs, given)


def compiled_by_layer(stats):
    try:
        document = json.loads(stats.read_text())
        return len(document["programs"]) + document["programs_not_listed"]
    except (OSError, ValueError, KeyError):
        return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--count", type=int, default=500, help="fragment programs")
    parser.add_argument("--vertex-count", type=int, default=300, help="vertex programs")
    parser.add_argument("--mode-count", type=int, default=60,
                        help="programs of each kind in each mode of arithmetic")
    parser.add_argument("--counts", type=pathlib.Path, help="file for the counts, as JSON")
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    layer = (args.build / "src/interposer/libGLX_arbiter.so.0").resolve()
    stats = args.out / "stats.json"
    stats.unlink(missing_ok=True)
    in_front = {"LD_PRELOAD": str(layer), "ARBITER_PROFILE": "host"}
    ati = ["--language", "ati", "--mode"]
    vertex = ["--language", "vertex", "--mode"]
    ways = [("glsl", args.count, ["--mode", "glsl"], {}),
            ("host", args.count, ["--mode", "arb"], {}),
            ("printed", args.count, ["--mode", "assembly"], {}),
            ("layer", args.count, ["--mode", "arb"], {**in_front, "ARBITER_STATS": str(stats)}),
            ("vertex-glsl", args.vertex_count, [*vertex, "glsl"], {}),
            ("vertex-host", args.vertex_count, [*vertex, "arb"], {}),
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
             # Those that sample textures are the host's.
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
    (args.out / "drawn.json").unlink(missing_ok=True)
    ways += [(("swrast-" + name).rstrip("-"), count, options,
              {**extra, "ARBITER_STATS": str(args.out / "drawn.json")})
             for name, options, extra in drawn]
    passed = failed = 0
    for name, count, options, extra in ways:
        result = run(name, args, count, options, extra)
        if result is None:
            failed += 1
            continue
        failed += result[0]
        passed += result[1] - result[0]
        if name.startswith("swrast"):
            fault = not_drawn(args.out / "drawn.json", result[1])
            (args.out / "drawn.json").unlink(missing_ok=True)
            if fault:
                print("%s: the rasterizer %s" % (name, fault))
                failed += 1
    if compiled_by_layer(stats) < args.count:
        print("layer: it compiled fewer programs than were drawn")
        failed += 1
    if args.counts:
        args.counts.write_text(json.dumps({"name": "differential", "passed": passed,
                                           "failed": failed, "skipped": 0}) + "\n")
    print("%d passed, %d failed, 0 skipped" % (passed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
