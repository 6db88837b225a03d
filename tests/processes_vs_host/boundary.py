#!/usr/bin/env python3
"""Checks which symbols the layer's libraries import and export, by their dynamic symbols.

They must import nothing of C++, so that an application's operator new, its C++ library or its LLVM never meet the
layer's memory or objects.

usage: boundary.py LAYER JIT
"""
import re
import subprocess
import sys

# Matches mangled names, and C names of the C++ runtime (__cxa_*, __gxx_*, _Unwind_*). libc itself has those for the end
# of the process, of a thread and of a library.
CPLUSPLUS = re.compile(r"^(_Z|__cxa_|__gxx_|_Unwind_|__cxxabi)")
OF_LIBC = {"__cxa_atexit", "__cxa_finalize", "__cxa_thread_atexit_impl"}
# Weak symbols of the static C++ library: never called, or only to end the process.
HARMLESS = {"_ZGTtdlPv", "_ZGTtnaj", "_ZGTtnam", "__cxa_pure_virtual"}


def symbols(library, *arguments):
    listing = subprocess.run(["nm", "-D", *arguments, library], check=True, capture_output=True, text=True)
    rows = [line.split() for line in listing.stdout.splitlines()]
    return {row[-1].split("@")[0] for row in rows if row}


def needed(library):
    listing = subprocess.run(["readelf", "-d", library], check=True, capture_output=True, text=True)
    return set(re.findall(r"\(NEEDED\).*\[(.*)\]", listing.stdout))


def main():
    layer, jit = sys.argv[1:]
    problems = []
    for library in (layer, jit):
        asked = symbols(library, "--undefined-only")
        problems += [f"{library} asks the process for {name}" for name in sorted(asked)
                     if CPLUSPLUS.match(name) and name not in OF_LIBC | HARMLESS]
        problems += [f"{library} needs {name}" for name in sorted(needed(library))
                     if re.match(r"libstdc\+\+|libgcc_s|libLLVM", name)]
        problems += [f"{library} offers {name}" for name in sorted(symbols(library, "--defined-only"))
                     if CPLUSPLUS.match(name)]
    if "__cxa_atexit" in symbols(jit, "--undefined-only"):
        problems.append(f"{jit} has something done at exit(), where a thread may be in a compilation")
    offered = symbols(jit, "--defined-only")
    if offered != {"arbiter_jit_interface"}:
        problems.append(f"{jit} offers {sorted(offered)}")
    print("\n".join(problems) or "nothing of C++ crosses")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
