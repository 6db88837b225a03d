#!/usr/bin/env python3
"""Writes the pages' style and script as C++ strings: embed.py OUT.cpp PAGE.css PAGE.js"""
import base64
import hashlib
import pathlib
import sys


def literal(text: str) -> str:
    # Split the text, because compilers may reject literals of more than 64 KiB.
    lines = ['    "' + line.replace('\\', '\\\\').replace('"', '\\"') + '\\n"'
             for line in text.split('\n')[:-1]]
    return '\n'.join(lines)


def main() -> None:
    out, style, script = (pathlib.Path(name) for name in sys.argv[1:4])
    css, js = (path.read_text(encoding='ascii') for path in (style, script))
    for path, text, end in ((style, css, '</style'), (script, js, '</script')):
        if end in text.lower() or not text.endswith('\n'):
            sys.exit(f'{path}: holds {end}, or does not end in a newline')
    digest = base64.b64encode(hashlib.sha256(js.encode()).digest()).decode()
    out.write_text(f'#include "apps/tools/page/parts.h"\n\nnamespace arbiter::tools {{\n\n'
                   f'const std::string_view kPageStyle =\n{literal(css)};\n\n'
                   f'const std::string_view kPageScript =\n{literal(js)};\n\n'
                   f'const std::string_view kPageScriptHash = "sha256-{digest}";\n\n'
                   '} // namespace arbiter::tools\n', encoding='ascii')


main()
