#!/usr/bin/env python3
"""Tests that the programs' resource counts agree: the demonstrations' promises, `arbiter check`, and
glGetProgramivARB.

counts_test.py --check ARBITER PROGRAMS_DIR [--layer LIBRARY DEMO...]
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys

# The two forms of Life demonstrate these counts: exactly, or at most.
EXACT = {"life_naive.fp": {"instructions": 36, "tex_instructions": 9}}
AT_MOST = {"life_packed.fp": {"alu_instructions": 9, "tex_instructions": 4, "temporaries": 5,
                              # The first level is not a dependent read.
                              "tex_indirections": 2}}
# The limits of a Radeon 9700, which the profile r300 has.
RADEON = {"alu_instructions": 64, "tex_instructions": 32, "tex_indirections": 4, "temporaries": 32,
          "parameters": 32, "attribs": 10}
APPLICATION_KEYS = {"instructions": "instructions", "alu": "alu_instructions",
                    "tex": "tex_instructions", "indirections": "tex_indirections",
                    "temporaries": "temporaries", "parameters": "parameters", "attribs": "attribs"}


def checked(arbiter, programs):
    """Returns {file name: counts} by `arbiter check`."""
    files = sorted(programs.glob("*.fp"))
    if not files:
        raise SystemExit(f"{programs}: no programs")
    run = subprocess.run([arbiter, "check", "--profile", "r300", "--json", *map(str, files)],
                         capture_output=True, text=True)
    if run.returncode:
        raise SystemExit(f"arbiter check: status {run.returncode}\n{run.stdout}{run.stderr}")
    return {pathlib.Path(row["file"]).name:
            {key: count["used"] for key, count in row["counts"].items()}
            for row in json.loads(run.stdout)["files"]}


def heard(demo, form, layer):
    """Returns {program name: counts} by glGetProgramivARB, under the layer."""
    environment = dict(os.environ, LD_PRELOAD=layer, ARBITER_PROFILE="r300")
    run = subprocess.run([demo, "--headless", "--size", "64x64", "--info", *form], text=True,
                         capture_output=True, env=environment)
    if run.returncode:
        print(run.stdout, run.stderr)
        sys.exit(run.returncode)
    return {program["name"]: {name: program[key] for key, name in APPLICATION_KEYS.items()}
            for program in json.loads(run.stdout)["programs"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", required=True)
    parser.add_argument("--layer")
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("demos", nargs="*")
    args = parser.parse_args()
    wrong = []
    counts = checked(args.check, args.programs)
    for name, counted in counts.items():
        for key, limit in {**RADEON, **AT_MOST.get(name, {})}.items():
            if counted[key] > limit:
                wrong.append(f"{name}: {key} {counted[key]}, more than {limit}")
        for key, value in EXACT.get(name, {}).items():
            if counted[key] != value:
                wrong.append(f"{name}: {key} {counted[key]}, not {value}")
    seen = set()
    for demo in args.demos:
        forms = [[]] if pathlib.Path(demo).name != "life" else [["--form", "naive"],
                                                                ["--form", "packed"]]
        for form in forms:
            for name, said in heard(demo, form, args.layer).items():
                seen.add(name)
                for key, value in said.items():
                    if value != counts[name][key]:
                        wrong.append(f"{name}: glGetProgramivARB says {key} {value}, "
                                     f"arbiter check {counts[name][key]}")
    if args.demos and seen != set(counts):
        wrong.append(f"not drawn by any demonstration: {sorted(set(counts) - seen)}")
    print("\n".join(wrong) or f"{len(counts)} programs counted, {len(seen)} of them asked for")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
