#!/usr/bin/env python3
"""Writes program texts into a C++ table: embed.py OUT.cpp FILE.fp..."""
import pathlib
import sys


def main() -> None:
    out, files = pathlib.Path(sys.argv[1]), [pathlib.Path(name) for name in sys.argv[2:]]
    rows = []
    for file in files:
        text = file.read_text(encoding="ascii")
        if ')fp"' in text:
            sys.exit(f"{file}: the text holds the raw string's own terminator")
        rows.append(f'    {{"{file.name}", R"fp({text})fp"}},\n')
    out.write_text(
        '#include "common/program.h"\n\nnamespace demos {\n\n'
        "const ProgramText kProgramTexts[] = {\n" + "".join(rows) + "};\n"
        "const unsigned kProgramTextCount = sizeof kProgramTexts / sizeof *kProgramTexts;\n\n"
        "} // namespace demos\n",
        encoding="ascii",
    )


main()
