#!/usr/bin/env python3
"""Tests how the layer finds the host's vendor.

It asks the X server for vendors on a connection of its own, before the application opens a display. A server that ends
with its last client must neither end in between, nor live on after the application has closed its display. If the
vendor that a user names does not load, the layer says so, and the application runs without it.

  host_vendor.py --build build
"""

import argparse
import ctypes
import pathlib
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "rasterizer_vs_host"))
import sides  # noqa: E402
from plain_environment import PYTHON  # noqa: E402

GRACE = 1  # seconds in which a server that has lost its last client ends
DEADLINE = 30  # seconds
GLX_RGBA, GLX_NONE = 4, 0


def client():
    """Runs in a process of its own, under the layer: asks for a GL function, then opens a display and draws nothing."""
    gl, x = ctypes.CDLL("libGL.so.1", ctypes.RTLD_GLOBAL), ctypes.CDLL("libX11.so.6", ctypes.RTLD_GLOBAL)
    for function, result, arguments in (
            (gl.glXGetProcAddressARB, ctypes.c_void_p, (ctypes.c_char_p,)),
            (x.XOpenDisplay, ctypes.c_void_p, (ctypes.c_char_p,)),
            (gl.glXChooseVisual, ctypes.c_void_p, (ctypes.c_void_p, ctypes.c_int, ctypes.c_void_p)),
            (gl.glXCreateContext, ctypes.c_void_p, (ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int)),
            (gl.glXDestroyContext, None, (ctypes.c_void_p, ctypes.c_void_p)),
            (x.XCloseDisplay, ctypes.c_int, (ctypes.c_void_p,))):
        function.restype, function.argtypes = result, arguments
    gl.glXGetProcAddressARB(b"glProgramStringARB")
    time.sleep(GRACE)
    display = x.XOpenDisplay(None)
    if not display:
        sys.exit("the server ended before the application opened its display")
    visual = gl.glXChooseVisual(display, 0, (ctypes.c_int * 2)(GLX_RGBA, GLX_NONE))
    context = visual and gl.glXCreateContext(display, visual, None, 1)
    if not context:
        sys.exit("no context")
    gl.glXDestroyContext(display, context)
    x.XCloseDisplay(display)
    print("closed", flush=True)
    sys.stdin.read()  # the process lives until the test has seen the server end


def wrong(build, layered):
    """Returns what is wrong, or ''."""
    server = sides.XServer(options=("-terminate",))
    with server as display:
        env = sides.environment(sides.layer_of(build) if layered else None, "auto", {"DISPLAY": display})
        with subprocess.Popen([PYTHON, __file__, "--client"], env=env, stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE, text=True) as process:
            closed = process.stdout.readline().strip() == "closed"
            try:
                server.process.wait(DEADLINE if closed else GRACE)
                ended = True
            except subprocess.TimeoutExpired:
                ended = False
            process.stdin.close()
    if not closed:
        return "the client did not come to its end"
    return "" if ended else "a connection stays open when the application has closed its display"


def wrong_of_another_vendor(build):
    """Returns what is wrong if a vendor is named that is not there, or ''."""
    with sides.XServer() as display:
        env = sides.environment(sides.layer_of(build), "auto", {"DISPLAY": display, "ARBITER_HOST_VENDOR": "nowhere"})
        done = subprocess.run([PYTHON, __file__, "--client"], env=env, capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, timeout=DEADLINE)
    said = "GLX: no driver loads, so that this program runs without the layer; tried libGLX_nowhere.so.0"
    if done.stdout.strip() != "closed":
        return f"the application does not run: {done.stderr[-300:]}"
    return "" if said in done.stderr else f"the log says {done.stderr[-300:]!r}"


def main():
    parser = sides.options(__doc__)
    parser.add_argument("--client", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.client:
        client()
        return 0
    problems = [f"{name}: {problem}" for name, layered in (("bare", False), ("under the layer", True))
                if (problem := wrong(options.build.resolve(), layered))]
    if problem := wrong_of_another_vendor(options.build.resolve()):
        problems.append(problem)
    print("\n".join(problems) or "the server ends with the application's display, and a missing vendor is named")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
