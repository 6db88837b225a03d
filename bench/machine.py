"""Describes the machine of the figures: a table without it says nothing."""

import os
import pathlib
import platform


def describe():
    """Returns the processor, the number of processors for this process, vector extensions and caches."""
    fields, flags = {}, set()
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        key, _, value = line.partition(":")
        fields.setdefault(key.strip(), value.strip())
    flags = set(fields.get("flags", fields.get("Features", "")).split())
    known = ("sse4_1", "avx", "avx2", "avx512f", "avx512bw", "avx512vl", "avx512vbmi", "asimd",
             "amx_tile")
    caches = {}
    for index in sorted(pathlib.Path("/sys/devices/system/cpu/cpu0/cache").glob("index*")):
        level, kind, size = ((index / name).read_text().strip() for name in ("level", "type", "size"))
        caches[f"L{level} {kind.lower()}"] = size
    return {"model": fields.get("model name", platform.machine()), "machine": platform.machine(),
            "processors": len(os.sched_getaffinity(0)), "vectors": [f for f in known if f in flags],
            "caches": caches, "load": os.getloadavg()[0]}


def heading(machine):
    """Returns the line above a table."""
    return f"{machine['model']}, {machine['processors']} processors, {lanes(machine)}"


def lanes(machine):
    """Returns the number of 32-bit lanes of the widest vectors, in words."""
    for flag, text in (("avx512f", "16 lanes (AVX-512)"), ("avx2", "8 lanes (AVX2)"),
                       ("sse4_1", "4 lanes (SSE4.1)"), ("asimd", "4 lanes (NEON)")):
        if flag in machine["vectors"]:
            return text
    return "no vectors that are known here"
