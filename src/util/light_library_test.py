#!/usr/bin/env python3
"""Fails if the preloaded library brings iostreams or locales into every process.

They cost 700 KiB and a run of initialisers before main. One #include in any room is enough to bring them.

usage: light_library_test.py LIBRARY
"""
import re
import subprocess
import sys

HEAVY = re.compile(r' [tTwWVvuBbDd] (std::(?:__cxx11::)?(?:basic_(?:[io]|io|)stream|basic_filebuf|'
                   r'locale::_Impl|ios_base::Init)\b.*)$')


def main():
    listing = subprocess.run(['nm', '-C', '--defined-only', sys.argv[1]], check=True,
                             capture_output=True, text=True).stdout.splitlines()
    if not any('arbiter::' in line for line in listing):
        print('no symbols to look at: the library is stripped')
        return 77
    heavy = [match.group(1) for match in map(HEAVY.search, listing) if match]
    for symbol in heavy[:10]:
        print('brought in:', symbol)
    return 1 if heavy else 0


if __name__ == '__main__':
    sys.exit(main())
