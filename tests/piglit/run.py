"""Runs piglit over a list of tests, and returns its results as a plain table."""

import bz2
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

from profiles import PROFILES

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))

import hosts

# These prefixes are removed from a test's environment, so that the two sides differ only by the layer.
FOREIGN = ("ARBITER_", "__GLX_", "__EGL_", "MESA_", "GALLIUM_", "LIBGL_", "VK_", "LD_PRELOAD", "PIGLIT_")


# The back end (ARBITER_BACKEND) of each configuration. With the profile `host` it is the host, or Arbiter's rasterizer
# wherever possible; all other profiles use the default back end.
BACKENDS = {"host": "host", "swrast": "swrast", "swrast-programs": "swrast"}
# Configurations by back end, with the profile `host`; -programs: with ARBITER_FIXED_FUNCTION=programs.
BY_BACKEND = ("swrast", "auto", "swrast-programs", "auto-programs")


def environment(layer=None, profile=None, extra=None):
    """Returns a test's environment.

    profile: a name of ARBITER_PROFILE, with `:report` or `:enforce` for ARBITER_LIMITS, or one of BY_BACKEND: the
    profile `host` with that ARBITER_BACKEND."""
    env = {k: v for k, v in os.environ.items() if not k.startswith(FOREIGN)}
    env.update(hosts.environment())
    env["PIGLIT_NO_FAST_SKIP"] = "1"  # a skip is the test's own answer, not the framework's guess
    if layer:
        env["LD_PRELOAD"] = str(layer)
        name, _, limits = profile.partition(":")
        env["ARBITER_PROFILE"] = "host" if name in BY_BACKEND else name
        env["ARBITER_BACKEND"] = BACKENDS.get(name, "auto")
        if name.endswith("-programs"):
            env["ARBITER_FIXED_FUNCTION"] = "programs"
        if limits:
            env["ARBITER_LIMITS"] = limits
    env.update(extra or {})
    return env


def run(tests, folder, env, jobs, platform, timeout=60):
    """Runs {test: profile}; returns {test: status} with subtests as `test/subtest`."""
    folder = pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    table = {}
    for profile in PROFILES:  # piglit takes a list of tests for one profile at a time
        names = [name for name, home in tests.items() if home == profile]
        if not names:
            continue
        listing = folder / (profile + ".txt")
        listing.write_text("\n".join(names) + "\n")
        results = folder / profile
        command = ["piglit", "run", "--jobs", str(jobs), "--platform", platform,
                   "--timeout", str(timeout), "--test-list", str(listing),
                   "--log-level", "quiet", profile, str(results)]
        log = folder / (profile + ".log")
        with open(log, "w") as stream:
            done = subprocess.run(command, env=env, stdout=stream, stderr=subprocess.STDOUT,
                                  stdin=subprocess.DEVNULL)
        if done.returncode:
            raise RuntimeError("piglit ended with %d; see %s" % (done.returncode, log))
        table.update(flatten(load(results)))
    return table


def load(results):
    for path in sorted(results.glob("results.json*")):
        if path.suffix == ".bz2":
            return json.loads(bz2.decompress(path.read_bytes()))
        return json.loads(path.read_text())
    raise RuntimeError("no results in %s" % results)


def reasons(folder):
    """Returns {test: reason} of the tests, and subtests as `test/subtest`, that skipped in a run's folder."""
    found = {}
    for results in sorted(pathlib.Path(folder).glob("*/results.json*")):
        document = load(results.parent)
        for key, status in flatten(document).items():
            if status == "skip":
                test = document["tests"].get(key)
                found[key] = reason_of(key, test.get("out") or "") if test else "piglit's test leaves out a part"
    return found


def reason_of(name, output):
    """Returns why a test skipped: by the last words that it prints, without a colon and without this host's figures. A
    test without words is named by its group, such as arb_vertex_program."""
    lines = [line.strip(" .") for line in output.replace(":", ",").splitlines() if line.strip()]
    if not lines:
        return f"piglit's test of {name.split('@')[1] if '@' in name else name} does not say"
    requires = re.match(r"Test requires (?:extension )?(GL\w*|\w*)$", lines[-1])
    if requires:
        return f"piglit's test requires {requires.group(1)}"
    return "piglit's test says, " + re.sub(r"\b\d+\b", "N", lines[-1])


def flatten(document):
    table = {}
    for name, test in document["tests"].items():
        table[name] = test["result"]
        for subtest, status in (test.get("subtests") or {}).items():
            if subtest != "__type__":  # the framework's JSON marks the type of the table with it
                table["%s/%s" % (name, subtest)] = status
    return table


def test_of(key, names):
    """Returns the test that a key of the table belongs to: subtests run with their test."""
    return key if key in names else key.rsplit("/", 1)[0]
