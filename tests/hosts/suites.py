"""What runs on the bare host and under the layer: the API's cases, the demonstrations, generated programs."""

import argparse
import dataclasses
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "scripts")]

import run_demos  # noqa: E402
import run_differential  # noqa: E402
import tally_log  # noqa: E402

BARE = "bare"
BACK_ENDS = ("host", "auto", "swrast")
LAYER = "src/interposer/libGLX_arbiter.so.0"
# What was compiled before decides which frames `auto` gives to the host. A run is that of a machine without a cache.
COLD = {"ARBITER_CACHE": "0"}
TIMEOUT = 300
DEATHS = 20  # of one program's cases, after which the rest is not asked
# {way: (settings of the layer, cases)}: the default profile, NVIDIA's languages, and what only the host's profile has.
API = {
    **{back_end: ({"ARBITER_BACKEND": back_end}, "*") for back_end in BACK_ENDS},
    "nv40-host": ({"ARBITER_PROFILE": "nv40", "ARBITER_BACKEND": "host"},
                  "Nv*:DepthModes.*:Era*:Imaging*:-EraVertexShaders.*:EraBumpMaps.*"),
    "era-host": ({"ARBITER_PROFILE": "host", "ARBITER_BACKEND": "host"}, "Era*:Imaging*"),
}
# Ways of scripts/run_differential.py: {under the layer: on the bare host, where the same seed is the same program}. The
# ways of results that nothing writes are not among them: they are undefined, and of llvmpipe.
DIFFERENTIAL = {
    "layer": ("glsl", "host"), "vertex-layer": ("vertex-glsl", "vertex-host"), "ati-text": ("ati-glsl",),
    "ati-api": ("ati-glsl",), "nv-layer": ("nv-glsl",), "nv-v-layer": ("nv-v-glsl",),
    "legacy-layer": ("legacy-glsl",), "legacy-ati-text": ("legacy-ati",), "legacy-v-layer": ("legacy-vertex",),
    "fp24-layer": ("fp24-glsl",), "fp24-ati-text": ("fp24-ati",),
}


@dataclasses.dataclass
class Outcome:
    kind: str  # passed, failed or skipped
    why: str = ""
    alike: tuple = ()  # names of the bare host's cases that are the same, if they have other names


def layered(build, settings):
    """Returns the variables that put the layer in front."""
    return {"LD_PRELOAD": str(build / LAYER), "API_TEST_LAYERED": "1", **COLD, **settings}


def output_of(command, more):
    """Runs a program. Returns (status, what it printed); the status of one that hangs is -9."""
    try:
        done = subprocess.run([str(word) for word in command], env={**os.environ, **more}, capture_output=True,
                              text=True, errors="replace", stdin=subprocess.DEVNULL, timeout=TIMEOUT)
    except subprocess.TimeoutExpired as late:
        return -9, (late.stdout or b"").decode(errors="replace")
    return done.returncode, f"{done.stdout}\n{done.stderr}"


def of_gtest(output, status):
    """Returns {case: Outcome} of a GoogleTest program's output."""
    reasons = dict(tally_log.gtest_reasons(output))
    cases = {}
    for name, how in tally_log.gtest_cases(output).items():
        if how == "run":
            cases[name] = Outcome("failed", tally_log.ended(status))
        else:
            cases[name] = Outcome(how, reasons.get(name, tally_log.NO_REASON) if how == "skipped" else "")
    return cases


def gtest(program, cases, more, log):
    """Returns {case: Outcome} of all cases that the pattern names: where a case ends the program, the rest runs in
    another one. What they print is left in the file `log`."""
    found = {}
    log.write_text("")
    for _ in range(DEATHS):
        chosen, _, left_out = cases.partition("-")
        without = ":".join(filter(None, [left_out, *found]))
        status, output = output_of([program, f"--gtest_filter={chosen}" + (f"-{without}" if without else "")], more)
        with log.open("a") as file:
            file.write(output)
        new = of_gtest(output, status)
        found.update(new)
        if not any(outcome.why == tally_log.ended(status) for outcome in new.values()):
            break
    return found or {"api_test": Outcome("failed", f"{tally_log.ended(status)}: {tally_log.last_line(output)}"[:160])}


def api(args):
    """Returns {way: {case: Outcome}} of the tests of the program API, whose output is WAY.log in the folder."""
    program = args.build / "tests/layer_vs_specification/api_test"
    return {BARE: gtest(program, "*", {}, args.out / "bare.log"),
            **{way: gtest(program, cases, layered(args.build, settings), args.out / f"{way}.log")
               for way, (settings, cases) in API.items()}}


def demonstrations(args):
    """Returns {way: {case: Outcome}} of the demonstrations, which compare their picture with what they compute."""
    results = {}
    for way in (BARE, *BACK_ENDS):
        more = {} if way == BARE else layered(args.build, {"ARBITER_BACKEND": way})
        results[way] = {}
        for name, path, options in run_demos.runs_of(run_demos.demos_of(args.build)):
            status, output = output_of([path, *options, "--verify", "--headless", "--size", "128x128"], more)
            how = {0: "passed", tally_log.SKIPPED: "skipped"}.get(status, "failed")
            results[way][name] = Outcome(how, "" if how == "passed" else tally_log.last_line(output))
    return results


def differential(args):
    """Returns {way: {case: Outcome}} of generated programs against the interpreter."""
    # Programs of NVIDIA's languages are a third as many on the bare host, where run_differential.py counts them.
    bare = programs(args, {way for ways in DIFFERENTIAL.values() for way in ways}, {}, 3 * args.count)
    return {BARE: bare, **{way: programs(args, set(DIFFERENTIAL), {"ARBITER_BACKEND": way, **COLD}, args.count)
                           for way in ("host", "auto")}}


def programs(args, ways, more, most):
    """Returns {case: Outcome} of the named ways. most: programs of those of which a third is drawn."""
    out = args.out / more.get("ARBITER_BACKEND", BARE)
    out.mkdir(parents=True, exist_ok=True)
    settings = argparse.Namespace(build=args.build, count=most, vertex_count=most, mode_count=args.count, ways=ways)
    cases = {}
    for way, count, options, extra in run_differential.all_ways(settings, out):
        row = run_differential.run(way, out, args.build, (0, min(count, args.count)), options, {**extra, **more})
        wrong = {failure["seed"]: failure["reason"] for failure in row["failures"]}
        for seed in range(1, row["programs"] + 1):
            name, alike = f"{way} {seed}", tuple(f"{other} {seed}" for other in DIFFERENTIAL.get(way, ()))
            cases[name] = Outcome("failed" if seed in wrong else "passed", wrong.get(seed, ""), alike)
        for text in row["faults"]:
            cases[way] = Outcome("failed", text)
        print(f"{out.name:6} {way:15} {row['programs']:4} programs, {len(wrong)} failed", flush=True)
    return cases


SUITES = {"api": api, "demonstrations": demonstrations, "differential": differential}
