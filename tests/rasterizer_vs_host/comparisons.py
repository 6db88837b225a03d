#!/usr/bin/env python3
"""The table of comparisons with the bare host: a row for each client, the ways in which it is run and how it is judged.

  comparisons.py ROW --build build [--first SEED] [--count N] [--backend swrast|auto|host] [NAME...]
"""

import math
import os
import sys

import anisotropy
import bitmaps
import depth_planes
import exact
import judges
import list_arrays
import meets
from checks import (all_ours, alike, alike_but_for, counted, each, each_shows, has_drawn, mostly_ours,
                    shows_something)
from runner import Row, Way, main

# The allowed numbers of images moved from the host and to it. A scene's first frame takes up what the host cleared; a
# context that is released gives the host a frame's two images.
MOVED = {"cleared": (2, 48), "kept": (2, 48), "within-frames": (2, 96), "again": (2, 2), "shown-outside": (2, 48)}
# A context that the layer left has few refused draws, except in the last frames to the window with four samples; any
# other context has all. A busy machine returns to it more often, as frame times vary, and leaves it later, as frames
# count for nothing while machine code is made. Half of all draws separates the two. The last 300 frames contain draws
# for the rasterizer.
LEFT_FRAMES, LEFT_DRAWS = 1300, 4
REFUSED = counted("given_to_host.target", lambda run: (1, LEFT_DRAWS * LEFT_FRAMES // 2))
MIXED = counted("given_to_host.mixed_frame", lambda run: (0, LEFT_DRAWS * LEFT_FRAMES // 2))
# A start that finds its machine code: the rasterizer's frames may be over before a busy machine has loaded it.
SOME = counted("drawn", lambda run: (LEFT_DRAWS, math.inf))
# Late machine code arrives while frames pause, for 40 ms; the passes of a frame must meet nevertheless.
PAUSE = ("40",)
NO_SHM = ("-extension", "MIT-SHM")
# A scene of an extension that the bare host lacks and that the layer must offer.
CARD = "sampled-by-vertices"
CARD_ENV = {"ARBITER_PROFILE": "nv40", "SAFETY_NEEDS": "GL_NV_vertex_program3"}

ROWS = {
    # Filters of 2, 4, 8 and 16 to 1, on the two hosts of Mesa.
    "anisotropy": Row("rasterizer-anisotropy", (anisotropy.near, counted("drawn", anisotropy.drawn), all_ours),
                      words=(), drivers=anisotropy.HOSTS, tell=anisotropy.tell),
    "bitmaps": Row("rasterizer-bitmaps", (alike,), 60, words=(), ways=bitmaps.WAYS),
    # Blending in byte buffers: each pair of factors, each equation, with and without alpha, and a stack of faint
    # layers. llvmpipe rounds operands and each product to bytes, and so does the rasterizer.
    "blends": Row("rasterizer-blends", (alike_but_for(0), judges.blended,
                                        counted("drawn", lambda run: (judges.SQUARES, math.inf))), words=()),
    # Two starts of two fragment programs.
    "cache": Row("rasterizer-presenter", (judges.read_from_disk,), words=("feedback",), bare=None),
    # State changes between two draws, one piece at a time: before, after, and after undoing the change.
    "changes": Row("rasterizer-changes", (alike, judges.seen_changes), words=("{name}",), is_listed=True, jobs=2,
                   least_drawn=0.8),
    # Fixed function with depth comparison textures: each target, depth format, function, mode and filter.
    "compared": Row("rasterizer-compared", (judges.compared, all_ours)),
    # Texture 0 of each target among named textures. The host may draw with textures that another context deleted.
    # Mesa 22.3.6 reads freed memory when a context that shared textures ends, and hangs if it contains something else
    # by then, as Meson arranges for its tests.
    "default_textures": Row("rasterizer-default-textures", (alike, mostly_ours(50)), 40, env={"MALLOC_PERTURB_": "0"}),
    # Depth buffers without stencil, to which software hosts give 32 bits.
    "depths": Row("rasterizer-depths", (each(judges.depth_buffers), all_ours), 12),
    "depth_planes": Row("rasterizer-depth-planes", (depth_planes.alike, depth_planes.as_64_bits, all_ours), 12),
    "exact": Row("rasterizer-exact", (exact.alike, all_ours), 40),
    # Fixed function without any program, which the rasterizer draws only when it is told to.
    "fixed": Row("rasterizer-fixed", (judges.of_whole_lists, mostly_ours(20)), 10,
                 ways=(Way("always", env={"ARBITER_FIXED_FUNCTION": "always"}),
                       Way("programs", env={"ARBITER_FIXED_FUNCTION": "programs"}, count=lambda n: max(n // 5, 1),
                           checks=(judges.of_whole_lists, judges.unused)))),
    # Fixed-function draws with all state random. A coordinate may be between two faces of a cube within its last bit.
    "fixed_states": Row("rasterizer-fixed-states", (alike_but_for(1, 2), mostly_ours(20)), 20),
    # Windows in which the host makes every draw, because of several samples a pixel or of draws that only the host
    # supports. The layer stops inspecting the context. Later draws that the rasterizer supports are its own again.
    # Without machine code frames count for nothing, so that more frames of the first start are mixed.
    "left": Row("rasterizer-left", (alike,), words=(str(LEFT_FRAMES), "{name}"), names=("samples", "mixed"),
                ways=(Way("auto", "auto", only="samples".__eq__, checks=(alike, REFUSED)),
                      Way("auto", "auto", only="mixed".__eq__),
                      Way("swrast", "swrast"),
                      Way("auto again", "auto", only="samples".__eq__, checks=(alike, REFUSED, SOME)),
                      Way("auto again", "auto", only="mixed".__eq__, checks=(alike, MIXED, SOME)))),
    "levels": Row("rasterizer-levels", (judges.levels, all_ours), 12),
    "list_arrays": Row("rasterizer-list-arrays", (list_arrays.alike, counted("drawn", list_arrays.drawn)),
                       words=("{name}",), names=tuple(list_arrays.ORDERS), ways=list_arrays.WAYS),
    # Random materials between Begin and End. The host gets strips in which a command other than Material(f)(v) sets
    # materials, or a query is made. With late machine code it draws more of them.
    "materials": Row("rasterizer-materials", (judges.materials, judges.materials_outside, mostly_ours(5)), 20,
                     ways=(Way(), Way("auto", "auto", count=lambda n: max(n // 4, 1), checks=(judges.materials,)))),
    "meets": Row("rasterizer-meets", (meets.some_meet, meets.meet, has_drawn), 12, drivers=meets.HOSTS,
                 ways=meets.WAYS, cache="case"),
    # Frames that the rasterizer and the host draw together, in windows that change. The layer's fresh memory contains a
    # pattern, so that undefined pixels are visible.
    "mixed": Row("rasterizer-mixed", (judges.mixed, has_drawn), 25, read_bare=judges.defined, cache="run",
                 servers={"MIT-SHM": ((), ()), "no MIT-SHM": (NO_SHM, ())},
                 ways=(Way("auto", "auto", {"ARBITER_DEBUG": "steady"}, fresh=judges.POISON[2]),
                       Way("auto, late code", "auto", {"ARBITER_DEBUG": "late-code"}, own_words=PAUSE,
                           fresh=judges.POISON[2]),
                       *(Way(backend, backend, fresh=judges.POISON[2]) for backend in ("swrast", "host")))),
    # Filled polygons of any shape.
    "polygons": Row("rasterizer-polygons", (alike, each_shows, all_ours), 20),
    # Frames shown in windows: the server must show the same after each swap. Without MIT-SHM the host shows them.
    "presenter": Row("rasterizer-presenter", (alike, shows_something, has_drawn), words=("{name}",), is_listed=True,
                     servers={"": ((), ()), "no MIT-SHM": (NO_SHM, ("frames", "resized", "two-windows"))}),
    # A window whose context is released and made current again: its visible content and its buffers. If no one else
    # can have drawn to it, nothing may be read from the host again.
    "releases": Row("rasterizer-releases", (alike, shows_something, has_drawn, *(
        counted(figure, lambda run, place=place: run.name in MOVED and (0, MOVED[run.name][place]))
        for place, figure in enumerate(("downloads", "uploads")))), words=("{name}",), is_listed=True,
        servers={"": ((), ())}),
    # Scenes that no careful program draws, each in a process of its own: nothing may crash, except the bare host.
    "safety": Row("rasterizer-safety", (alike,), words=("{name}",), is_listed=True, jobs=2, bare_may_die=True,
                  least_drawn=0, ways=(Way(only=CARD.__ne__), Way(env=CARD_ENV, only=CARD.__eq__))),
    # Frames whose depths must meet, with a draw in the middle that the rasterizer lacks: under `auto` they settle on
    # one rasterizer instead of alternating.
    "steady": Row("rasterizer-steady", (alike, counted("drawn", judges.steady_draws), judges.draws_from_the_start), 200,
                  ("{name}", "{count}"), ("whole", "formats", "indices"), ways=(Way("auto", "auto"),), cache="case"),
    # Still pictures, each of one feature of the rasterizer, frame after frame, without machine code on disk and with
    # it: none may change, from the first frame on, whoever draws.
    "still": Row("rasterizer-still", (judges.still,), 2000, ("{name}", "{count}"), is_listed=True, bare=None,
                 cache="case", jobs=os.cpu_count(),
                 ways=(Way("first start", "auto"), Way("second start", "auto", count=lambda n: min(n, 100)),
                       Way("by turns", "auto", words=("two",), count=lambda n: min(n, 100),
                           only=judges.TWO.__contains__))),
    # Points, lines and unfilled polygons.
    "strokes": Row("rasterizer-strokes", (judges.strokes, each_shows, all_ours), 20),
    # Images that move between the rasterizer and the host in every frame: under `auto` the layer measures which of them
    # should draw, and keeps to that.
    "thrash": Row("rasterizer-thrash", (judges.back_off, has_drawn), 120, ("{name}", "{count}"), ("cheap", "dear"),
                  ways=(Way("auto", "auto"),), tell=judges.tell_times),
    # Textures in vertex programs, which a bare host lacks. The host waits for its draws to a texture before a vertex
    # program samples it: Mesa 22.3.6's llvmpipe does not, and gives other pixels from run to run.
    "vertex_textures": Row("rasterizer-vertex-textures", (alike, mostly_ours(50)), 40, env={"ARBITER_PROFILE": "nv40"},
                           bare=Way(backend="host", own_words=("finish",))),
}

if __name__ == "__main__":
    sys.exit(main(ROWS, "rasterizer_vs_host"))
