"""Runs a client that draws random states and judges them itself, under the layer: on the host and by its rasterizer.
Shared by the tests of state that the layer turns into programs."""

import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "rasterizer_vs_host"))
import sides  # noqa: E402

SKIPPED = 77


def draw(args, client, backend, scratch):
    """Returns (the client's result, its last line as JSON, the rasterizer's statistics)."""
    build = args.build.resolve()
    stats = pathlib.Path(scratch) / f"stats-{backend}.json"
    env = sides.environment(sides.layer_of(build), backend, {
        "XDG_CACHE_HOME": str(scratch), "ARBITER_STATS": str(stats), "ARBITER_PROFILE": args.profile})
    command = [build / client, "--first", str(args.first), "--count", str(args.count)]
    if args.fx9:
        env["ARBITER_NUMERICS"] = "fx9"
        command.append("--fx9")
    result = subprocess.run(command, env=env, capture_output=True, text=True, timeout=args.count * 5 + 60)
    lines = result.stdout.splitlines()
    try:
        report = json.loads(lines[-1])
    except (IndexError, ValueError):
        report = {}
    return result, report, sides.software_statistics(stats)


def judge(backend, result, report, part, most_unjudged, least_drawn):
    """Returns what is wrong, a line each."""
    wrong = []
    if result.returncode not in (0, 1) or not report:
        return [f"status {result.returncode}: {result.stderr[-600:]}"]
    if report["different"]:
        wrong += result.stdout.splitlines()[:10]
        wrong.append(f"{report['different']} of {report['states']} states differ")
    if report["unjudged"] > most_unjudged * report["cells"]:
        wrong.append(f"{report['unjudged']} of {report['cells']} cells were not judged")
    drawn, given = part.get("drawn", 0), sum(part.get("given_to_host", {}).values())
    if backend == "swrast" and (drawn == 0 or drawn < least_drawn * (drawn + given)):
        wrong.append(f"the rasterizer drew {drawn}, the host {part.get('given_to_host')}")
    return wrong


def main(description, client, most_unjudged, least_drawn, has_fx9=False):
    """Runs the client on the chosen back ends.

    has_fx9: the client supports the integers of the numerics fx9
    client: its path in the build folder
    most_unjudged: the fraction of cells that may stay undecided
    least_drawn: the fraction of draws that the rasterizer must draw when it is selected
    """
    parser = sides.options(description)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--backend", default="both", choices=("host", "swrast", "both"))
    parser.add_argument("--profile", default="host")
    parser.add_argument("--json", type=pathlib.Path)
    if has_fx9:
        parser.add_argument("--fx9", action="store_true")
    else:
        parser.set_defaults(fx9=False)
    args = parser.parse_args()
    tally, reports = sides.Tally(), {}
    backends = ("host", "swrast") if args.backend == "both" else (args.backend,)
    with tempfile.TemporaryDirectory(prefix="arbiter-states-") as scratch:
        for backend in backends:
            result, report, part = draw(args, client, backend, scratch)
            if result.returncode == SKIPPED:
                print(f"skipped: {result.stderr.strip()}")
                return SKIPPED
            wrong = judge(backend, result, report, part, most_unjudged, least_drawn)
            reports[backend] = {**report, "rasterizer_drew": part.get("drawn", 0),
                                "given_to_host": part.get("given_to_host", {}), "wrong": wrong}
            tally.row(f"{backend}: {json.dumps(report)}, the rasterizer drew {part.get('drawn', 0)}", wrong, 12)
    if args.json:
        args.json.write_text(json.dumps(reports, indent=2) + "\n")
    return tally.end()
