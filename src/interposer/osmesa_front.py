#!/usr/bin/env python3
"""Makes the front libOSMesa.so.8 for programs that dlopen it.

It is a library without symbols of its own that needs the layer and the real library, the latter by absolute path
because its name is taken.

  osmesa_front.py --find COMPILER...                 prints the real library's path, or nothing
  osmesa_front.py --core LIB --real PATH -o FRONT -- COMPILER...
                                                     makes the front; run again when either moves
"""
import argparse
import os
import subprocess
import sys
import tempfile

SONAME = "libOSMesa.so.8"


def find(compiler):
    answer = subprocess.run([*compiler, "-print-file-name=" + SONAME], check=True,
                            capture_output=True, text=True).stdout.strip()
    # A compiler that does not find the file prints its name.
    return os.path.normpath(answer) if os.path.isabs(answer) and os.path.exists(answer) else ""


def make(compiler, core, real, front):
    # The library has no code that a debugger could use.
    base = [*compiler, "-shared", "-Wl,-s", "-nostdlib", "-x", "c", os.devnull, "-x", "none"]
    with tempfile.TemporaryDirectory() as scratch:
        # The linker records the SONAME of the libraries it links. This stand-in's SONAME is the absolute path.
        stand_in = os.path.join(scratch, "real.so")
        subprocess.run([*base, "-Wl,-soname," + real, "-o", stand_in], check=True)
        subprocess.run([*base, "-Wl,-soname," + SONAME, "-Wl,--no-as-needed", core, stand_in,
                        "-Wl,-rpath,$ORIGIN/..:$ORIGIN/../..", "-o", front], check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--find", action="store_true")
    parser.add_argument("--core")
    parser.add_argument("--real")
    parser.add_argument("-o", dest="front")
    parser.add_argument("compiler", nargs="+")
    arguments = parser.parse_args()
    if arguments.find:
        print(find(arguments.compiler))
        return 0
    if not (arguments.core and arguments.real and arguments.front):
        parser.error("--core, --real and -o are needed")
    make(arguments.compiler, arguments.core, arguments.real, arguments.front)
    return 0


if __name__ == "__main__":
    sys.exit(main())
