"""The environment that runners give to clients: nothing that the tests were started with for
the layer, for the loader of libraries or for Mesa reaches them; nor an ignored signal."""

import os
import signal
import sys
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parent.parent.parent / "scripts"
# For clients of a tree with a sanitizer (./dev asan, ./dev tsan); elsewhere they mean nothing.
# Preloading puts the layer before the sanitizer's runtime, and the host and its threads are not
# instrumented. The driver keeps memory for the life of the process.
SANITIZERS = {"ASAN_OPTIONS": "verify_asan_link_order=0:detect_leaks=0",
              "UBSAN_OPTIONS": "print_stacktrace=1:halt_on_error=1",
              "TSAN_OPTIONS": "ignore_noninstrumented_modules=1:halt_on_error=1"
                              f":suppressions={SCRIPTS}/tsan.supp"}
# Without the layer what the sanitizer finds inside the host's driver is the driver's own: it reads past
# its buffers, and takes the length of program strings, which need not end. Under the layer the same
# report may be of memory that the layer gave it.
HOST_ALONE = f":intercept_strlen=0:suppressions={SCRIPTS}/asan_host.supp"

FOREIGN = ("ARBITER_", "__GLX_", "__EGL_", "MESA_", "GALLIUM_", "LIBGL_", "LD_")
# Where the drivers lie is no wish of how they draw: a tree of another width has its own.
KEPT = ("LIBGL_DRIVERS_PATH",)
# That runs clients in Python: of the width that the layer has.
PYTHON = os.environ.get("CLIENT_PYTHON", sys.executable)


def plain(**more):
    """The caller's environment without FOREIGN names, on a GL of software; `more` is set in it."""
    kept = {name: value for name, value in os.environ.items() if name in KEPT or not name.startswith(FOREIGN)}
    return {**kept, "LIBGL_ALWAYS_SOFTWARE": "1", **more}


def sanitized(layered=True, **more):
    """The same for clients that may be instrumented, under the layer or on the host alone."""
    env = plain(**SANITIZERS, **more)
    if not layered:
        env["ASAN_OPTIONS"] += HOST_ALONE
    return env


def heed_signals():
    """A shell ignores SIGINT for what it runs in the background, nohup SIGHUP, and children inherit it:
    no process of a test would end by them."""
    for number in (signal.SIGINT, signal.SIGHUP, signal.SIGQUIT, signal.SIGTERM):
        if signal.getsignal(number) == signal.SIG_IGN:
            is_interrupt = number == signal.SIGINT
            signal.signal(number, signal.default_int_handler if is_interrupt else signal.SIG_DFL)
