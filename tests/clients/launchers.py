#!/usr/bin/env python3
"""Tests the ways in which launchers start a program (docs/use/launchers.md), with the layer in each.

The launchers themselves are not needed, only their methods: a command line with the game's path in it, read by a
shell; a prefix of words; one wrapper file; an environment; an overlay that is preloaded beside the layer. The program
is this script with a context of its own, in a folder with a space, and with options that `arbiter run` knows too.
"""
import ctypes
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

import self_client
from plain_environment import PYTHON, plain
from self_client import egl_context, expect

OPTIONS = ['--hud', '--profile', 'nv30']  # the program's own
OVERLAY = 'libm.so.6'  # any library may be preloaded beside the layer


def client(_):
    find = egl_context(False)
    if find is None:
        return self_client.SKIPPED
    get_integer = ctypes.CFUNCTYPE(None, ctypes.c_uint, ctypes.c_void_p)(find(b'glGetIntegerv'))
    units = ctypes.c_int(-1)
    get_integer(0x8872, ctypes.byref(units))  # MAX_TEXTURE_IMAGE_UNITS
    print(json.dumps({'units': units.value, 'preloaded': os.environ.get('LD_PRELOAD', '')}))
    return 0


def launched(command, **variables):
    """Returns what the program prints if a launcher starts it so; None if it cannot run here."""
    result = subprocess.run(command, env=plain(EGL_PLATFORM='surfaceless', **variables), capture_output=True, text=True,
                            timeout=120, check=False)
    if result.returncode == self_client.SKIPPED:
        return None
    expect(result.returncode == 0, f'{command}: exit {result.returncode}\n{result.stderr}')
    return json.loads(result.stdout)


def forms(run, game, folder):
    """Yields (name, command, variables) of each way."""
    wrapper = folder / 'wrapper'
    wrapper.write_text('#!/bin/sh\nexec ' + shlex.join(run) + ' "$@"\n')
    wrapper.chmod(0o755)
    yield 'terminal', [*run, *game], {}
    # Steam's launch options: %command% becomes the game's path and words, quoted, and a shell reads the line.
    line = (shlex.join(run) + ' %command%').replace('%command%', shlex.join(game))
    yield 'Steam', ['sh', '-c', line], {}
    yield 'overlay', ['sh', '-c', line], {'LD_PRELOAD': OVERLAY}
    # Lutris' command prefix is split into words; Heroic's wrapper is one file and its arguments.
    yield 'prefix', [*shlex.split(shlex.join(run)), *game], {}
    yield 'wrapper file', [str(wrapper), *game], {}
    # A script of the game starts the program as its child.
    yield 'script', [*run, 'sh', '-c', shlex.join(game) + '; exit $?'], {}
    printed = subprocess.run([run[0], 'run', '--print-environment', *run[2:-1]], capture_output=True, text=True,
                             check=True)
    yield 'environment', ['sh', '-c', printed.stdout + 'exec ' + shlex.join(game)], {}


def check(options):
    with tempfile.TemporaryDirectory(prefix='arbiter-launchers-') as folder:
        folder = pathlib.Path(folder)
        place = folder / 'an old game'
        place.mkdir()
        game_file = place / 'game'
        script = pathlib.Path(__file__).resolve()
        game_file.write_text(f'#!/bin/sh\n[ "$*" = "{" ".join(OPTIONS)}" ] || exit 3\n'
                             f'exec {PYTHON} {shlex.quote(str(script))} --client egl\n')
        game_file.chmod(0o755)
        game = [str(game_file), *OPTIONS]
        bare = launched(game)
        if bare is None:
            return False
        # A GeForce 4 has four units, fewer than any of today's hosts.
        run = [options.arbiter, 'run', '--profile', 'nv25', '--library', options.library, '--']
        for name, command, variables in forms(run, game, folder):
            told = launched(command, **variables)
            expect(told['units'] != bare['units'], f'{name}: the layer is not there, {told}')
            expect(pathlib.Path(options.library).name in told['preloaded'], f'{name}: {told}')
            expect(variables.get('LD_PRELOAD', '') in told['preloaded'], f'{name}: {told}')
    return True


if __name__ == '__main__':
    sys.exit(self_client.main('launchers', client, check))
