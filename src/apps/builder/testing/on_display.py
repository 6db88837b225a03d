#!/usr/bin/env python3
"""Runs a Qt program on an X display of its own, as for a user, not off screen.

usage: on_display.py PROGRAM [ARGUMENT...]
"""
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[4] / 'tests' / 'clients'))
import x_server  # noqa: E402


def main():
    with x_server.XServer("1400x900x24") as display:
        environment = dict(os.environ, DISPLAY=display, QT_QPA_PLATFORM='xcb')
        return subprocess.run(sys.argv[1:], env=environment).returncode


if __name__ == '__main__':
    sys.exit(main())
