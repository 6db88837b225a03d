"""The environment that runners give to clients: settings for the layer, for the library loader or for Mesa from outside
of the tests do not reach them, nor do ignored signals."""

import os
import signal
import sys
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parent.parent.parent / "scripts"
# Options for clients built with a sanitizer (./dev asan, ./dev tsan); others ignore them. Preloading puts the layer
# before the sanitizer's runtime, and the host and its threads are not instrumented. Leaks are looked for where the
# caller's options say how: the driver keeps memory for the life of the process.
SANITIZERS = {"ASAN_OPTIONS": ":".join(filter(None, ("verify_asan_link_order=0:detect_leaks=0",
                                                     os.environ.get("ASAN_OPTIONS")))),
              "UBSAN_OPTIONS": "print_stacktrace=1:halt_on_error=1",
              "TSAN_OPTIONS": "ignore_noninstrumented_modules=1:halt_on_error=1"
                              f":suppressions={SCRIPTS}/tsan.supp"}
# Without the layer, the sanitizer's findings inside the host's driver are the driver's own. It reads past its buffers,
# and takes the length of program strings, which need not be terminated. Under the layer the same report may concern the
# layer's memory.
HOST_ALONE = f":intercept_strlen=0:suppressions={SCRIPTS}/asan_host.supp"

FOREIGN = ("ARBITER_", "__GLX_", "__EGL_", "MESA_", "GALLIUM_", "LIBGL_", "LD_")
# The drivers' folder is kept, as it does not affect drawing: a tree of another word size has its own.
KEPT = ("LIBGL_DRIVERS_PATH",)
# A Python of the layer's word size, for clients in Python.
PYTHON = os.environ.get("CLIENT_PYTHON", sys.executable)


def plain(**more):
    """Returns the caller's environment without FOREIGN names, with software GL; `more` is set in it."""
    kept = {name: value for name, value in os.environ.items() if name in KEPT or not name.startswith(FOREIGN)}
    return {**kept, "LIBGL_ALWAYS_SOFTWARE": "1", **more}


def sanitized(layered=True, **more):
    """Returns the environment for clients that may be instrumented, under the layer or on the host alone."""
    env = plain(**SANITIZERS, **more)
    if not layered:
        env["ASAN_OPTIONS"] += HOST_ALONE
    return env


def heed_signals():
    """Stops ignoring signals: a shell ignores SIGINT for background jobs, nohup SIGHUP, and children inherit that, so
    that
    no process of a test would end by them."""
    for number in (signal.SIGINT, signal.SIGHUP, signal.SIGQUIT, signal.SIGTERM):
        if signal.getsignal(number) == signal.SIG_IGN:
            is_interrupt = number == signal.SIGINT
            signal.signal(number, signal.default_int_handler if is_interrupt else signal.SIG_DFL)
