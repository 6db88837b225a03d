#!/usr/bin/env python3
"""Debian's piglit on the bare host and under the layer, compared test by test.

Both sides run now, on this machine: nothing but the expected differences is stored, in
expectations/PROFILE.txt, each with its reason. A difference that no line explains is run again on
both sides; if it does not stay, it is a flake and is reported as one. Ends with
"N passed, N failed, N skipped": passed is the same result as on the bare host or an explained
one, skipped is skipped by both.
"""

import argparse
import collections
import json
import os
import pathlib
import subprocess
import sys
import time

import expectations
import profiles
import run as piglit
import table


def layer_is_active(layer, library, folder):
    """Whether a test under the layer leaves statistics with a program that it compiled."""
    stats = folder / "probe.json"
    stats.unlink(missing_ok=True)
    env = piglit.environment(layer, "host", {"ARBITER_STATS": str(stats),
                                             "PIGLIT_PLATFORM": "glx"})
    subprocess.run([str(library / "bin/fp-kil"), "-auto", "-fbo"], env=env, cwd=library,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=120)
    try:
        return bool(json.loads(stats.read_text())["programs"])
    except (OSError, ValueError, KeyError):
        return False


def run_again(unexpected, tests, sides, attempts):
    """Splits unexpected differences in (steady, flakes): what changes from run to run is a flake.

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
    """Runs under the layer with `profile`; returns the report as a dictionary."""
    label = args.results / ("layer-" + profile.replace(":", "-"))

    def run_layer(some, suffix=""):
        return piglit.run(some, str(label) + suffix, piglit.environment(args.layer, profile),
                          args.jobs, args.platform)

    start = time.monotonic()
    layer = run_layer(tests)
    rows = expectations.load(profile)
    explained, unexpected = expectations.judge(expectations.differences(bare, layer), rows)
    unexpected, flakes = run_again(
        unexpected, tests, (run_bare, lambda some: run_layer(some, "-again")), args.attempts)
    unused = [] if args.tests else expectations.unused_rows(rows, set(bare) | set(layer))
    skipped = sum(1 for test, status in layer.items()
                  if status == "skip" and bare.get(test) == "skip")
    return {
        "profile": profile, "seconds": round(time.monotonic() - start, 1),
        "bare": collections.Counter(bare.values()), "layer": collections.Counter(layer.values()),
        "explained": {k: {"bare": bare.get(k, "missing"), "layer": layer.get(k, "missing"),
                          "reason": reason} for k, reason in explained.items()},
        "unexpected": {k: {"bare": b, "layer": l} for k, (b, l) in unexpected.items()},
        "flakes": {k: {"bare": b, "layer": l} for k, (b, l) in flakes.items()},
        "stale": {row.where: row.pattern for row in unused},
        "passed": len(set(bare) | set(layer)) - len(unexpected) - skipped,
        "failed": len(unexpected) + len(unused), "skipped": skipped,
    }


def show(report):
    print("\nprofile %s (%.0f s)" % (report["profile"], report["seconds"]))
    for side in ("bare", "layer"):
        print("  %-6s %s" % (side, "  ".join("%s %d" % pair
                                             for pair in sorted(report[side].items()))))
    for kind, test, bare, layer, reason in table.rows(report):
        results = ": %s on the bare host, %s under the layer" % (bare, layer) if bare else ""
        print("  %-11s %s%s (%s)" % (kind, test, results, reason))
    sys.stdout.flush()


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--results", type=pathlib.Path, required=True)
    parser.add_argument("--set", choices=("quick", "named", "full"), default="named")
    parser.add_argument("--profiles", default="host,r300,r300:report,nv40,swrast",
                        help="names, each with :report for ARBITER_LIMITS=report; swrast and auto "
                             "are the profile host with that ARBITER_BACKEND, swrast-fixed and "
                             "auto-fixed also with ARBITER_FIXED_FUNCTION=always")
    parser.add_argument("--platform", default="glx",
                        choices=("glx", "x11_egl", "surfaceless_egl", "mixed_glx_egl"))
    parser.add_argument("--jobs", type=int, default=min(2, os.cpu_count() or 1))
    parser.add_argument("--attempts", type=int, default=2, help="of an unexpected difference")
    parser.add_argument("--counts", type=pathlib.Path, help="file for the counts, as JSON")
    parser.add_argument("--bare-only", action="store_true", help="show the bare host's results")
    parser.add_argument("tests", nargs="*", help="only tests whose name contains one of these")
    args = parser.parse_args()
    args.layer = (args.build / "src/interposer/libGLX_arbiter.so.0").resolve()
    args.results = args.results.resolve()
    return args


def main():
    args = arguments()
    tests = profiles.select(args.set)
    if args.tests:
        tests = {n: p for n, p in tests.items() if any(part in n for part in args.tests)}
    if not tests:
        print("no such tests", file=sys.stderr)
        return 2
    args.results.mkdir(parents=True, exist_ok=True)

    def run_bare(some, name="bare-again"):
        return piglit.run(some, args.results / name, piglit.environment(), args.jobs,
                          args.platform)

    print("%d tests (%s) with %d jobs" % (len(tests), args.set, args.jobs), flush=True)
    start = time.monotonic()
    bare = run_bare(tests, "bare")
    print("bare host: %s (%.0f s)" % (dict(collections.Counter(bare.values())),
                                      time.monotonic() - start), flush=True)
    if args.bare_only:
        return 0
    if not layer_is_active(args.layer, profiles.library_of_piglit(), args.results):
        print("the layer is not active in a test: %s" % args.layer, file=sys.stderr)
        return 1

    reports = []
    for profile in args.profiles.split(","):
        reports.append(compare(profile, bare, tests, args, run_bare))
        show(reports[-1])
    document = {"schema": 2, "set": args.set, "reports": reports}
    (args.results / "report.json").write_text(json.dumps(document, indent=1) + "\n")
    (args.results / "report.md").write_text(table.markdown(document))
    sums = {k: sum(r[k] for r in reports) for k in ("passed", "failed", "skipped")}
    if args.counts:
        args.counts.write_text(json.dumps({"name": "piglit", **sums}) + "\n")
    print("\n%(passed)d passed, %(failed)d failed, %(skipped)d skipped" % sums)
    return 1 if sums["failed"] else 0


if __name__ == "__main__":
    sys.exit(main())
