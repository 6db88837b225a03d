"""The rows of feedback.py: each part yields dictionaries, whose `figure` is judged."""

import json
import math
import pathlib
import statistics
import sys
from dataclasses import dataclass

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests" / "clients"))
from paced import Client, environment, interval, ratios, take_turns  # noqa: E402
from x_server import XServer  # noqa: E402


@dataclass
class Workload:
    name: str
    demo: str
    options: list
    least: float  # times faster than the bare host
    image_bytes: int  # a pixel, of the application's images of that size: color, depth, textures


WORKLOADS = [
    Workload("life naive", "life", ["--form", "naive"], 10, 12),
    Workload("life packed", "life", ["--form", "packed"], 8, 16),
    Workload("pass-through 1:1", "pass-through", [], 8, 12),
    Workload("brightness/contrast", "brightness-contrast", [], 4, 12),
    Workload("twirl", "twirl", [], 2.5, 12),
    Workload("per-pixel lighting", "lighting", [], 4, 16),
    Workload("cartoon", "cartoon", [], 3, 8),
]
MEAN_LEAST = {"": 6.0, "avx512": 6.0, "avx2": 6.0, "sse4.1": 5.0}  # by --cpu
SCENE_LEAST = 1.5
# These variables restrict the bare host's machine code to an older processor as well.
HOST_HELD_TO = {"sse4.1": {"GALLIUM_OVERRIDE_CPU_CAPS": "sse4.1", "LP_NATIVE_VECTOR_WIDTH": "128"}}
SHOWN = 0.6  # of each ratio, if the frame is shown in a window
SIZES = (256, 512, 1024, 2048, 4096)
# The sizes of linear passes: powers of two, sizes of films and windows, and odd ones.
PASS_SIZES = ("256x256", "640x480", "1023x767", "1024x1024", "1280x1280", "1366x768", "1536x1536",
              "1920x1080", "2048x2048", "2047x1535", "2560x1440", "3840x2160", "4096x4096")


def chosen(args):
    return [w for w in WORKLOADS if not args.workload or any(t in w.name for t in args.workload)]


def settings(args, **more):
    extra = {"ARBITER_BACKEND": args.backend}
    if args.threads:
        extra["ARBITER_THREADS"] = str(args.threads)
    if args.cpu:
        extra["ARBITER_CPU"] = args.cpu
    extra.update(more)
    return extra


def command_of(args, workload, size, headless=True):
    return [args.build / "demos" / workload.demo, *(["--headless"] if headless else []), "--paced",
            "--size", f"{size}x{size}", *workload.options]


def drawn_note(stats):
    """Returns a note from the layer's statistics: if the rasterizer drew nothing, the figures are the host's."""
    try:
        document = json.loads(stats.read_text())
    except (OSError, ValueError):
        return "no statistics"
    software = document.get("software")
    if not software:
        return "the rasterizer is not in this layer"
    return "" if software.get("drawn") else "drawn by the host"


def pair_row(args, name, command, least, more=None):
    """Measures both sides of one command, in turns."""
    stats = args.scratch / "stats.json"
    stats.unlink(missing_ok=True)
    extra = settings(args, ARBITER_STATS=str(stats))
    held = HOST_HELD_TO.get(args.cpu, {})
    clients = [Client(command, environment(None, {**held, **(more or {})})),
               Client(command, environment(args.layer, {**held, **extra, **(more or {})}))]
    for client in clients:
        client.reach_pace()
    rounds = take_turns(clients, args.turns)
    for client in clients:
        client.close()
    low, figure, high = interval(ratios(rounds))
    return {"name": name, "bare": statistics.median(t[0] for t in rounds),
            "layered": statistics.median(t[1] for t in rounds), "unit": "ms", "figure": figure,
            "low": low, "high": high, "bound": least, "bound_is": "least",
            "note": drawn_note(stats), "rounds": rounds}


def with_mean(rows, least):
    mean = math.exp(statistics.fmean(math.log(row["figure"]) for row in rows))
    return {"name": "geometric mean", "unit": "x", "figure": mean,
            "bound": least if len(rows) == len(WORKLOADS) else None, "bound_is": "least"}


def workload_rows(args, _):
    rows = []
    for workload in chosen(args):
        rows.append(pair_row(args, workload.name, command_of(args, workload, args.size),
                             None if args.cpu else workload.least))
        yield rows[-1]
    yield with_mean(rows, MEAN_LEAST[args.cpu])


def window_rows(args, before):
    """Requires at least SHOWN of the ratio that is required without a window."""
    with XServer(f"{max(args.size, 64)}x{max(args.size, 64)}x24") as display:
        for workload in chosen(args):
            row = pair_row(args, workload.name + ", shown",
                           command_of(args, workload, args.size, headless=False),
                           SHOWN * workload.least, {"DISPLAY": display})
            headless = [r["figure"] for r in before
                        if r["part"] == "workloads" and r["name"] == workload.name]
            if headless:
                row["of_headless"] = row["figure"] / headless[0]
                row["note"] = (f"{row['of_headless']:.2f} of headless " + row["note"]).strip()
            yield row


def size_rows(args, _):
    """Measures nanoseconds a pixel at each size, the layer alone, in turns, and the ratio of the extremes to the
    middle."""
    sizes = (32, 64) if args.self_test else SIZES
    for workload in chosen(args):
        clients = [Client(command_of(args, workload, size), environment(args.layer, settings(args)))
                   for size in sizes]
        for client in clients:
            client.reach_pace()
        rounds = take_turns(clients, max(3, args.turns // 2))
        for client in clients:
            client.close()
        costs = {size: 1e6 * statistics.median(t[i] for t in rounds) / (size * size)
                 for i, size in enumerate(sizes)}
        middle = statistics.median(costs.values())
        note = "  ".join(f"{size}: {cost:.3f}" for size, cost in costs.items())
        # The figure is the furthest ratio from the middle.
        figure = max(max(cost / middle, middle / cost) for cost in costs.values())
        yield {"name": workload.name, "unit": "ns/px", "layered": costs[sizes[-1]],
               "figure": figure, "bound": 1.2, "bound_is": "most", "note": note, "costs": costs}


def pass_rows(args, _):
    """Measures nanoseconds a pixel of a linear filter at 1:1, and its ratio to a nearest filter, in turns.

    Both move the same memory, of which caches hold less as pictures grow."""
    workload = next(w for w in WORKLOADS if w.demo == "pass-through")
    for size in ("64x64", "100x60") if args.self_test else PASS_SIZES:
        width, height = (int(side) for side in size.split("x"))
        clients = [Client([*command_of(args, workload, width)[:-1], size, "--form", form],
                          environment(args.layer, settings(args)))
                   for form in ("linear", "nearest")]
        for client in clients:
            client.reach_pace()
        rounds = take_turns(clients, max(3, args.turns // 2))
        for client in clients:
            client.close()
        low, figure, high = interval(ratios(rounds))
        cost = 1e6 * statistics.median(t[0] for t in rounds) / (width * height)
        yield {"name": f"linear 1:1, {size}", "unit": "ns/px", "layered": cost, "figure": figure,
               "low": low, "high": high, "bound": 1.3, "bound_is": "most",
               "note": "times a nearest filter's"}


def thread_rows(args, _):
    """Measures one thread against two, both with the layer."""
    for workload in chosen(args):
        command = command_of(args, workload, args.size)
        clients = [Client(command, environment(args.layer, settings(args, ARBITER_THREADS=count)))
                   for count in ("1", "2")]
        for client in clients:
            client.reach_pace()
        rounds = take_turns(clients, args.turns)
        for client in clients:
            client.close()
        low, figure, high = interval(ratios(rounds))
        yield {"name": workload.name + ", 2 threads", "unit": "ms",
               "bare": statistics.median(t[0] for t in rounds),
               "layered": statistics.median(t[1] for t in rounds), "figure": figure, "low": low,
               "high": high, "bound": 1.8, "bound_is": "least", "note": "(left: one thread)"}


def scene_rows(args, _):
    for form, label in (("fixed", "fixed-function vertices"), ("program", "vertex program")):
        command = [args.build / "bench/bench-scene", "--size", args.size, "--form", form]
        row = pair_row(args, f"scene, {label}", command, None if args.cpu else SCENE_LEAST)
        row["pixels_differ"] = pictures_differ(args, command)
        row["note"] = (f"{100 * row['pixels_differ']:.2f} % of the pixels differ by more than 2 "
                       + row["note"]).strip()
        yield row


def pictures_differ(args, command):
    """Returns the fraction of the third frame's pixels that differ by more than 2 of 255."""
    pictures = []
    for layer, extra in ((None, {}), (args.layer, settings(args, ARBITER_BACKEND="swrast"))):
        client = Client(command, environment(layer, extra))
        path = args.scratch / "picture.rgba"
        client.ask(2)
        client.ask(f"picture {path}")
        client.close()
        pictures.append(path.read_bytes())
    bare, layered = pictures
    pixels = len(bare) // 4
    if bare == layered:
        return 0.0
    far = sum(max(abs(a - b) for a, b in zip(bare[i:i + 3], layered[i:i + 3])) > 2
              for i in range(0, len(bare), 4))
    return far / pixels


def first_draw_rows(args, _):
    """Measures 100 programs that no one has seen, one after the other, without disk caches."""
    count = 5 if args.self_test else 100
    command = [args.build / "bench/bench-client"]
    extra = settings(args, ARBITER_CACHE="0")
    clients = [Client(command, environment(None)), Client(command, environment(args.layer, extra))]
    pairs = []
    for client in clients:
        client.ask("sample 3 900000 load/generated programs")
    for seed in range(count):
        times = [0.0, 0.0]
        for side in (seed % 2, 1 - seed % 2):
            times[side] = clients[side].ask(f"sample 1 {seed + 1} load/generated programs")[0] / 1e6
        pairs.append(times)
    for client in clients:
        client.close()
    low, figure, high = interval([layered / bare for bare, layered in pairs])
    yield {"name": f"{count} generated programs", "unit": "ms",
           "bare": statistics.median(p[0] for p in pairs),
           "layered": statistics.median(p[1] for p in pairs), "figure": figure, "low": low,
           "high": high, "bound": 1.0, "bound_is": "most", "note": "(layered / bare)"}


def memory_rows(args, _):
    """Measures memory at 4096x4096, where images are most of a process."""
    size = 256 if args.self_test else 4096
    for workload in chosen(args):
        peaks = []
        for layer, extra in ((None, {}), (args.layer, settings(args))):
            client = Client(command_of(args, workload, size), environment(layer, extra))
            client.reach_pace()
            client.turn()
            peaks.append(client.peak_bytes())
            client.close()
        images = workload.image_bytes * size * size
        yield {"name": f"{workload.name}, {size}x{size}", "unit": "MiB", "bare": peaks[0] / 2**20,
               "layered": peaks[1] / 2**20, "figure": (peaks[1] - peaks[0]) / images, "bound": 2.0,
               "bound_is": "most", "note": f"times the images, {images / 2**20:.0f} MiB"}


def small_rows(args, _):
    """Measures bench-client's draws and large quads; the figure is layered / bare."""
    command = [args.build / "bench/bench-client"]
    clients = [Client(command, environment(None)),
               Client(command, environment(args.layer, settings(args)))]
    for name in clients[0].ask("rows"):
        if not name.startswith(("draws/", "fill/")):
            continue
        pairs = []
        for turn in range(max(3, args.turns // 2) + 2):
            times = [0.0, 0.0]
            for side in (turn % 2, 1 - turn % 2):
                times[side] = clients[side].ask(f"sample 1 {turn + 1} {name}")[0] / 1e6
            if turn >= 2:  # one-time work is left out
                pairs.append(times)
        low, figure, high = interval([layered / bare for bare, layered in pairs])
        yield {"name": name, "unit": "ms", "bare": statistics.median(p[0] for p in pairs),
               "layered": statistics.median(p[1] for p in pairs), "figure": figure, "low": low,
               "high": high, "bound": 1.05, "bound_is": "most"}
    for client in clients:
        client.close()
