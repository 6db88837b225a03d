#!/usr/bin/env python3
"""Writes the version of the interface between the layer and libarbiter_jit.so (jit_boundary.h).

The version is a hash of the interface's headers and of all headers that they include, so every change of
them changes it.

  jit_version.py --source src --output jit_version.h --depfile jit_version.h.d HEADER...

HEADERs are named as they are included.
"""

import argparse
import hashlib
import pathlib
import re

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
TEXT = """#pragma once
#include <cstdint>

namespace arbiter::fp::jit::boundary {{

/// Of the headers that the layer and libarbiter_jit.so were built with (jit_version.py). A library of
/// another version is not used.
inline constexpr std::uint64_t kVersion = 0x{version};

}} // namespace arbiter::fp::jit::boundary
"""


def closure(source, roots):
    """Returns {name: bytes} of the headers and of all headers of `source` that they include."""
    found, wanted = {}, list(roots)
    while wanted:
        name = wanted.pop()
        if name in found:
            continue
        found[name] = (source / name).read_bytes()
        wanted += INCLUDE.findall(found[name].decode())
    return found


def version(headers):
    """Returns 16 hexadecimal digits, which change with any header."""
    digest = hashlib.sha256()
    for name in sorted(headers):
        digest.update(f"{name} {len(headers[name])}\n".encode() + headers[name])
    return digest.hexdigest()[:16]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--output", type=pathlib.Path, required=True)
    parser.add_argument("--depfile", type=pathlib.Path, required=True)
    parser.add_argument("headers", nargs="+")
    args = parser.parse_args()
    headers = closure(args.source, args.headers)
    args.output.write_text(TEXT.format(version=version(headers)))
    names = " ".join(str(args.source / name).replace(" ", "\\ ") for name in sorted(headers))
    args.depfile.write_text(f"{args.output}: {names}\n")


if __name__ == "__main__":
    main()
