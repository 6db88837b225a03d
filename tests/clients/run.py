#!/usr/bin/env python3
"""Runs every kind of GL client on the bare host and under the layer, on an X server of its own.

  tests/clients/run.py --build build                all
  tests/clients/run.py --build build --only EGL     those whose name has "EGL" in it
  tests/clients/run.py --list
  tests/clients/run.py --build build --headless libEGL_nvidia.so.0
                                                    EGL's device platform, no X, that host vendor
  tests/clients/run.py --build build --pack FOLDER  packs what --headless needs, for a machine that
                                                    has no build: python3 FOLDER/run.py --headless …

Prints a table, and with --json writes it. Exit status 1 if a case fails.
"""
import argparse
import concurrent.futures
import contextlib
import json
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import cases
from setting import Failure, Setting, Skip
from x_server import XServer


def pack(build, folder):
    """Makes a build tree of only the layer and the clients that need no X, with these scripts."""
    programs = ["egl_direct", "egl_dynamic", "count", "spawn", "early", "reuse", "threads"]
    libraries = ["libclient_early_library.so", "libclient_counting_vendor.so"]
    files = ["src/interposer/libGLX_arbiter.so.0", "src/interposer/libarbiter_first.so",
             "src/interposer/osmesa/libOSMesa.so.8", "src/interposer/arbiter/11_arbiter.json"]
    files += [f"tests/clients/client_{name}" for name in programs]
    files += [f"tests/clients/{name}" for name in libraries]
    for name in files:
        target = folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(build / name, target)
        if not name.endswith(".json"):
            subprocess.run(["strip", target], check=True)
    for script in ("run.py", "cases.py", "extra_cases.py", "setting.py", "plain_environment.py", "x_server.py"):
        shutil.copy(Path(__file__).resolve().parent / script, folder)


def run_case(name, case, build, display, vendor):
    begin = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="arbiter-client-") as scratch:
        setting = Setting(build, Path(__file__).resolve().parent, Path(scratch), display, vendor)
        try:
            result, note = "pass", case(setting) or ""
        except Skip as skip:
            result, note = "skip", str(skip)
        except Failure as failure:
            result, note = "FAIL", str(failure)
        except Exception as error:  # an invalid report is a failure of the case
            result, note = "FAIL", f"{type(error).__name__}: {error}"
    return {"name": name, "result": result, "note": note,
            "seconds": round(time.monotonic() - begin, 2)}


def default_build():
    """Returns the folder of these scripts if they were packed with a build, else ./build."""
    here = Path(__file__).resolve().parent
    return here if (here / "src/interposer").is_dir() else Path("build")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--build", type=Path, default=default_build())
    parser.add_argument("--only", action="append", help="part of a case's name; may be repeated")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--json", type=Path)
    parser.add_argument("--headless", metavar="EGL_VENDOR_LIBRARY")
    parser.add_argument("--pack", type=Path, metavar="FOLDER")
    parser.add_argument("--sanitized", action="store_true", help="the build has a sanitizer")
    parser.add_argument("--list", action="store_true")
    arguments = parser.parse_args()
    kinds, extras = cases.all_cases()
    chosen = {**kinds, **extras}
    if arguments.headless:
        chosen = cases.headless_cases()
    elif arguments.sanitized:
        chosen = cases.sanitized_cases()
    if arguments.only:
        chosen = {n: c for n, c in chosen.items() if any(o.lower() in n.lower() for o in arguments.only)}
        if not chosen:
            sys.exit(f"clients: no case has {' or '.join(arguments.only)} in its name")
    if arguments.list:
        print("\n".join(chosen))
        return 0
    build = arguments.build.resolve()
    if arguments.pack:
        pack(build, arguments.pack)
        return 0
    rows = []
    server = contextlib.nullcontext() if arguments.headless else XServer()
    with server as display, concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        futures = [pool.submit(run_case, n, c, build, display, arguments.headless) for n, c in chosen.items()]
        for future in futures:
            row = future.result()
            rows.append(row)
            kind = "kind " if row["name"] in kinds else "extra"
            if row["result"] == "skip":
                print(f"skip  {kind} {row['name']}: {row['note']}", flush=True)
                continue
            print(f"{row['result']:5} {kind} {row['name']:28} {row['seconds']:6.2f} s  {row['note']}",
                  flush=True)
    tally = {r: sum(row["result"] == r for row in rows) for r in ("pass", "FAIL", "skip")}
    of_kinds = sum(row["result"] == "pass" for row in rows if row["name"] in kinds)
    print(f"clients: {of_kinds}/{sum(n in kinds for n in chosen)} kinds")
    print(f"{tally['pass']} passed, {tally['FAIL']} failed, {tally['skip']} skipped")
    if arguments.json:
        arguments.json.write_text(json.dumps({"kinds_passed": of_kinds, **tally, "cases": rows}, indent=2))
    return 1 if tally["FAIL"] else 0


if __name__ == "__main__":
    sys.exit(main())
