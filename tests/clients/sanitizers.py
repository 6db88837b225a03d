"""The environment of clients from a tree with a sanitizer (./dev asan, ./dev tsan); elsewhere it
means nothing."""

from pathlib import Path

SUPPRESSIONS = Path(__file__).resolve().parent.parent.parent / "scripts/tsan.supp"
# Preloading puts the layer before the sanitizer's runtime, and the host and its threads are not
# instrumented. The driver keeps memory for the life of the process.
OPTIONS = {"ASAN_OPTIONS": "verify_asan_link_order=0:detect_leaks=0",
           "UBSAN_OPTIONS": "print_stacktrace=1:halt_on_error=1",
           "TSAN_OPTIONS": "ignore_noninstrumented_modules=1:halt_on_error=1"
                           f":suppressions={SUPPRESSIONS}"}
