#!/usr/bin/env python3
"""Compares Debian's piglit on the bare host and under the layer, test by test.

Both sides run now, on this machine: only the expected differences are stored, in expectations/PROFILE.txt, each with
its reason. A difference that no line explains is run again on both sides; if it does not persist, it is reported as a
flake. Ends with "N passed, N failed, N skipped". Passed means that the result equals the bare host's or is explained;
skipped means that both sides skipped. --shard and --engine spread the tests over machines (docs/driver/shards.md).
"""

import argparse
import collections
import json
import os
import pathlib
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "merge"))

import expectations
import of_piglit
import profiles
import results
import run as piglit
import sharding

NEED_DISPLAY = ("glx", "x11_egl", "mixed_glx_egl")
SOURCES = ("include", "src", "tests/piglit")  # what a result depends on


def lacking(platform, layer, environment):
    """Says what a run lacks, or returns None.

    layer: the layer's library; None for the bare host alone"""
    if layer and not layer.is_file():
        return "%s is not there: ./dev build makes it, --build names its folder" % layer
    if platform in NEED_DISPLAY and not environment.get("DISPLAY"):
        return "DISPLAY is not set: xvfb-run starts a display, --platform surfaceless_egl needs none"
    return None


def layer_is_active(layer, library, folder, platform):
    """True if a test under the layer leaves statistics with a program that it compiled."""
    stats = folder / "probe.json"
    stats.unlink(missing_ok=True)
    env = piglit.environment(layer, "host", {"ARBITER_STATS": str(stats),
                                             "PIGLIT_PLATFORM": platform})
    subprocess.run([str(library / "bin/fp-kil"), "-auto", "-fbo"], env=env, cwd=library,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=120)
    try:
        return bool(json.loads(stats.read_text())["programs"])
    except (OSError, ValueError, KeyError):
        return False


def run_again(unexpected, tests, sides, attempts):
    """Splits unexpected differences into (steady, flakes): a flake changes from run to run.

    sides: functions that run {test: profile} on the bare host and under the layer."""
    flakes = {}
    for _ in range(attempts):
        again = {name: tests[name] for name in tests
                 if any(piglit.test_of(key, tests) == name for key in unexpected)}
        if not again:
            break
        bare, layer = [side(again) for side in sides]
        for key in list(unexpected):
            now = (bare.get(key, "missing"), layer.get(key, "missing"))
            if now[0] == now[1]:
                flakes[key] = unexpected.pop(key)
    return unexpected, flakes


def compare(profile, bare, tests, args, run_bare):
    """Runs under the layer with `profile`; returns ({"layer": table, "flakes": …, "skips": reasons}, seconds)."""
    label = args.work / ("layer-" + profile.replace(":", "-"))

    def run_layer(some, suffix=""):
        return piglit.run(some, str(label) + suffix, piglit.environment(args.layer, profile),
                          args.jobs, args.platform)

    start = time.monotonic()
    layer = run_layer(tests)
    skips = piglit.reasons(label)
    _, unexpected = expectations.judge(expectations.differences(bare, layer),
                                       expectations.load(profile))
    _, flakes = run_again(
        unexpected, tests, (run_bare, lambda some: run_layer(some, "-again")), args.attempts)
    return {"layer": layer, "flakes": flakes, "skips": skips}, time.monotonic() - start


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--results", type=pathlib.Path, required=True)
    parser.add_argument("--set", choices=("quick", "named", "full"), default="named")
    parser.add_argument("--profiles", default="host,r300,r300:report,nv40,swrast",
                        help="names, each with :report for ARBITER_LIMITS=report; swrast and auto "
                             "are the profile host with that ARBITER_BACKEND, swrast-programs and "
                             "auto-programs also with ARBITER_FIXED_FUNCTION=programs")
    parser.add_argument("--platform", default="glx",
                        choices=("glx", "x11_egl", "surfaceless_egl", "mixed_glx_egl"))
    parser.add_argument("--jobs", type=int, default=min(2, os.cpu_count() or 1))
    parser.add_argument("--attempts", type=int, default=2, help="of an unexpected difference")
    parser.add_argument("--counts", type=pathlib.Path, help="file for the counts, as JSON")
    parser.add_argument("--bare-only", action="store_true", help="show the bare host's results")
    parser.add_argument("tests", nargs="*", help="only tests whose name contains one of these")
    sharding.add_options(parser)
    args = parser.parse_intermixed_args()
    sharding.check(parser, args)
    args.layer = (args.build / "src/interposer/libGLX_arbiter.so.0").resolve()
    args.results = args.results.resolve()
    args.work = sharding.pieces_folder(args.results, args)
    return args


def description(args, tests):
    """Returns the description that all shards of a run share."""
    return {"kind": of_piglit.KIND, "set": args.set, "filter": args.tests,
            "profiles": args.profiles.split(","), "platform": args.platform,
            "tests": results.digest(sorted(tests.items())),
            "sources": results.sources_digest(sharding.ROOT, SOURCES)}


def command(args):
    """Returns the command line of the same run for a shard."""
    return [str(sharding.ROOT / "dev"), "piglit", "--set", args.set, "--profiles", args.profiles,
            "--platform", args.platform, "--jobs", str(args.jobs), "--attempts", str(args.attempts),
            *args.tests]


def run_shard(args, tests, shard):
    """Returns (content, seconds) of the shard's part of the tests; None if the layer is missing."""
    lack = lacking(args.platform, args.layer, os.environ)
    if lack:
        print(lack, file=sys.stderr)
        return None
    tests = {name: profile for name, profile in tests.items() if shard.has(name)}

    def run_bare(some, name="bare-again"):
        return piglit.run(some, args.work / name, piglit.environment(), args.jobs, args.platform)

    print("%d tests (%s) with %d jobs" % (len(tests), args.set, args.jobs), flush=True)
    start = time.monotonic()
    bare = run_bare(tests, "bare")
    seconds = {"bare": time.monotonic() - start}
    print("bare host: %s (%.0f s)" % (dict(collections.Counter(bare.values())), seconds["bare"]),
          flush=True)
    if not layer_is_active(args.layer, profiles.library_of_piglit(), args.work, args.platform):
        print("the layer is not active in a test: %s" % args.layer, file=sys.stderr)
        return None
    content = {"bare": bare, "profiles": {}}
    for profile in args.profiles.split(","):
        content["profiles"][profile], seconds[profile] = compare(profile, bare, tests, args, run_bare)
        print("profile %s: %s (%.0f s)" % (
            profile, dict(collections.Counter(content["profiles"][profile]["layer"].values())),
            seconds[profile]), flush=True)
    return content, seconds


def main():
    args = arguments()
    try:
        tests = profiles.select(args.set)
    except FileNotFoundError as error:
        print(error, file=sys.stderr)
        return 2
    if args.tests:
        tests = {n: p for n, p in tests.items() if any(part in n for part in args.tests)}
    if not tests:
        print("no such tests", file=sys.stderr)
        return 2
    args.work.mkdir(parents=True, exist_ok=True)
    if args.bare_only:
        lack = lacking(args.platform, None, os.environ)
        if lack:
            print(lack, file=sys.stderr)
            return 2
        bare = piglit.run(tests, args.work / "bare", piglit.environment(), args.jobs, args.platform)
        print("bare host: %s" % dict(collections.Counter(bare.values())))
        return 0
    return sharding.main(args, description(args, tests), lambda shard: run_shard(args, tests, shard),
                         command(args), args.results)


if __name__ == "__main__":
    sys.exit(main())
