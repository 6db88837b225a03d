#!/usr/bin/env python3
"""Tests the defaults of single programs in processes: each shipped entry's effect, and what overrides it.

A client that prints the extension string into a buffer of fixed size runs under the name of each
title, with a buffer as large as the title's. Without the defaults it overflows and ends; with them it
does not. Under the names of other titles it loads a program as long as theirs.
"""
import argparse
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'clients'))
from plain_environment import plain  # noqa: E402

# The name of each title's executable, and the bytes of its smallest buffer. If the source is not public, the buffer is
# that of the title's engine; all of them print into 4096 bytes.
TITLES = {
    'GLQuake (Linux)': ('glquake.glx', 1024),
    'GLQuake (Windows)': ('GLQUAKE.EXE', 4096),
    'QuakeWorld, GL client (Linux)': ('glqwcl.glx', 2048),
    'QuakeWorld, GL client (Windows)': ('glqwcl.exe', 4096),
    'Quake II (Linux)': ('quake2', 4096),
    'Quake II (Windows)': ('quake2.exe', 4096),
    'Hexen II (Windows)': ('glh2.exe', 4096),
    'Return to Castle Wolfenstein, single player (Linux)': ('wolfsp.x86', 4096),
    'Return to Castle Wolfenstein, single player (Windows)': ('WolfSP.exe', 4096),
    'Medal of Honor: Allied Assault': ('MOHAA.exe', 4096),
    'Soldier of Fortune': ('SoF.exe', 4096),
    'Soldier of Fortune II: Double Helix': ('SoF2MP.exe', 4096),
    'Call of Duty (2003)': ('CoDSP.exe', 4096),
    'Star Wars Jedi Knight II: Jedi Outcast': ('jk2sp.exe', 4096),
    'Star Wars Jedi Knight: Jedi Academy': ('jamp.exe', 4096),
    'Savage: The Battle for Newerth (Linux)': ('silverback.bin', 4096),
    'Stubbs the Zombie': ('Stubbs.exe', 4096),
    'Wolfenstein: Enemy Territory (Linux)': ('et.x86', 4096),
    'Wolfenstein: Enemy Territory (Windows)': ('ET.exe', 4096),
    'ET: Legacy (Linux)': ('etl.x86_64', 8192),
    'ET: Legacy (Windows)': ('etl.exe', 8192),
    'OpenArena (Linux)': ('openarena.x86_64', 8192),
    'OpenArena (Windows)': ('openarena.exe', 8192),
}
# The executables of titles whose programs exceed the default profile's card, and their instruction counts.
LONG_PROGRAMS = {'Compiz': ('compiz', 97)}
REFUSED = 3
OVERFLOWN = -signal.SIGSEGV
# Wine 8 appends this to the string.
WINES_OWN = len(' WGL_EXT_extensions_string WGL_EXT_swap_control')


class Failure(Exception):
    """A check failed; says what was seen and what was expected."""


def expect(holds, text):
    if not holds:
        raise Failure(text)


class Place:
    """A folder for the test, and the programs that it runs."""

    def __init__(self, options, folder):
        self.options = options
        self.folder = pathlib.Path(folder)
        self.stats = self.folder / 'stats.json'

    def run(self, name, size, **environment):
        """Runs the client under the name of a Linux program, or as a program that Wine runs. It sets LD_PRELOAD
        itself: the layer follows the defaults, not the command that starts it."""
        windows = name.lower().endswith('.exe')
        program = self.folder / ('wine64-preloader' if windows else name)
        if not program.exists():
            shutil.copy(self.options.client, program)
        if windows:
            (self.folder / name).touch()
        words = ['Z:' + str(self.folder / name).replace('/', '\\'), '-window'] if windows else [name]
        self.stats.unlink(missing_ok=True)
        return subprocess.run(
            words, executable=program, capture_output=True, text=True, timeout=60, check=False,
            env=plain(**{'EGL_PLATFORM': 'surfaceless', 'FIXED_BUFFER_BYTES': str(size),
                         'LD_PRELOAD': self.options.library, 'ARBITER_STATS': str(self.stats),
                         'XDG_CONFIG_HOME': str(self.folder / 'config'), 'HOME': str(self.folder),
                         **environment}))

    def defaults(self):
        return json.loads(self.stats.read_text())['defaults']

    def put(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path


def entry(name, settings, title='mine'):
    return f"[[program]]\ntitle = '{title}'\nmatch.name = '{name}'\n[program.set]\n{settings}\n"


def shipped(place):
    listed = subprocess.run([place.options.arbiter, 'defaults', '--json'], capture_output=True, text=True,
                            env=plain(HOME=str(place.folder)), check=True)
    return json.loads(listed.stdout)


def check_titles(place):
    """Checks each shipped entry: what happens without it, and with it."""
    listed = shipped(place)
    expect(not listed['errors'], listed['errors'])
    titles = {each['title']: each for each in listed['entries']}
    tried = {*TITLES, *LONG_PROGRAMS}
    expect(set(titles) == tried, f'what is tried and the files differ in {set(titles) ^ tried}')
    for title, (name, size) in TITLES.items():
        expect(titles[title]['source'], f'{title}: no source')
        size -= WINES_OWN if name.lower().endswith('.exe') else 0
        bare = place.run(name, size, ARBITER_DEFAULTS='0')
        if bare.returncode == 77:
            return False
        # The strings of some of today's hosts fit into the larger buffers.
        fits = bare.returncode == 0 and size > 8000
        expect(fits or bare.returncode == OVERFLOWN, f'{title} without defaults: {bare}')
        held = place.run(name, size)
        expect(held.returncode == 0, f'{title}: {held}')
        report = place.defaults()
        expect([each['title'] for each in report['entries']] == [title], f'{title}: {report}')
        expect(all(row['used'] and row['title'] == title and row['line'] > 0
                   for row in report['settings'].values()) and report['settings'], f'{title}: {report}')
    return True


def check_long_programs(place):
    """Checks each such entry: the program is refused without it, and loads with it."""
    for title, (name, instructions) in LONG_PROGRAMS.items():
        asked = {'PROGRAM_INSTRUCTIONS': str(instructions)}
        bare = place.run(name, 100000, ARBITER_DEFAULTS='0', **asked)
        expect(bare.returncode == REFUSED, f'{title} without defaults: {bare}')
        held = place.run(name, 100000, **asked)
        expect(held.returncode == 0, f'{title}: {held}')
        report = place.defaults()
        expect([each['title'] for each in report['entries']] == [title], f'{title}: {report}')


def check_precedence(place):
    """Checks that the user's file overrides the shipped one, and the environment overrides both."""
    name, size = TITLES['Quake II (Linux)']
    mine = place.put('config/arbiter/defaults.d/50.toml', entry(name, 'extensions_max_length = 100'))
    seen = place.run(name, size)
    expect(seen.returncode == 0 and int(seen.stdout) < 120, f'the user\'s file: {seen}')
    expect(place.defaults()['settings']['extensions_max_length']['file'] == str(mine), place.defaults())
    seen = place.run(name, size, ARBITER_EXTENSIONS_MAX_LENGTH='200')
    expect(100 < int(seen.stdout) < 220, f'the environment: {seen}')
    expect(place.defaults()['settings']['extensions_max_length']['used'] is False, place.defaults())
    seen = place.run(name, size, ARBITER_EXTENSIONS_MAX_LENGTH='')
    expect(seen.returncode == OVERFLOWN, f'a variable set to nothing: {seen}')
    mine.write_text(entry(name, 'extensions_max_length = "default"'))
    expect(place.run(name, size).returncode == OVERFLOWN, 'default does not undo the shipped entry')
    mine.unlink()


def check_every_setting(place):
    """Checks that each key has the effect of its variable."""
    place.put('config/arbiter/defaults.d/all.toml',
              entry('client', "profile = 'nv30'\nidentity = 'profile'\nnumerics = 'legacy'\n"
                              "backend = 'host'\nlimits = 'report'\nfixed_function = 'always'\n"
                              "threads = 2\nextensions_max_year = 2001\n"
                              "extensions = 'GL_EXT_abgr=off'"))
    seen = place.run('client', 100000, ARBITER_LOG='info')
    expect(seen.returncode == 0, seen)
    report = json.loads(place.stats.read_text())
    expect((report['profile'], report['identity'], report['numerics']) == ('nv30', 'profile', 'legacy'),
           {key: report[key] for key in ('profile', 'identity', 'numerics')})
    expect(len(report['defaults']['settings']) == 9, report['defaults'])
    for name in ('PROFILE', 'BACKEND', 'LIMITS', 'THREADS', 'FIXED_FUNCTION', 'EXTENSIONS_MAX_YEAR',
                 'EXTENSIONS'):
        expect(f'ARBITER_{name}=' in seen.stderr, f'{name} is not in the log: {seen.stderr}')


def check_bad_files(place):
    """Checks that a bad file is reported with its line while the others apply, and a bad value while the rest of its
    entry applies."""
    folder = place.put('bad/10.toml', '[[program]\n').parent
    place.put('bad/20.toml', entry('client', "numerics = 'fp25'\nextensions_max_length = 100"))
    os.mkfifo(folder / '30.toml')
    place.put('bad/40.toml', entry('client', "profile = 'r3000'"))
    seen = place.run('client', 200, ARBITER_DEFAULTS=str(folder))
    expect(seen.returncode == 0 and int(seen.stdout) < 120, f'the rest does not hold: {seen}')
    for text in (f'{folder}/10.toml:1:', f'{folder}/20.toml:5:12: numerics: expected host, legacy, fp24 or fx9',
                 f'{folder}/30.toml: not a regular file', f'{folder}/40.toml:5: no profile'):
        expect(text in seen.stderr, f'{text!r} is not in the log: {seen.stderr}')
    expect(len(place.defaults()['errors']) == 3, place.defaults())
    # A process that does not use GL reads no defaults. It is the client, which has the layer's word size.
    idle = subprocess.run([place.options.client], capture_output=True, text=True, check=False,
                          env=plain(LD_PRELOAD=place.options.library, ARBITER_DEFAULTS=str(folder),
                                    ARBITER_LOG='debug'))
    expect((idle.returncode, idle.stderr) == (0, ''), idle)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--arbiter', required=True)
    parser.add_argument('--library', required=True)
    parser.add_argument('--client', required=True)
    options = parser.parse_args()
    options.library = os.path.abspath(options.library)
    options.client = os.path.abspath(options.client)
    options.arbiter = os.path.abspath(options.arbiter)
    with tempfile.TemporaryDirectory(prefix='arbiter-defaults-') as folder:
        place = Place(options, folder)
        try:
            if not check_titles(place):
                print('skipped: no context without a window')
                return 77
            for check in (check_long_programs, check_precedence, check_every_setting, check_bad_files):
                check(place)
        except Failure as failure:
            print(f'defaults: {failure}', file=sys.stderr)
            return 1
    print(f'{len(TITLES) + len(LONG_PROGRAMS)} titles fail without their defaults, and none with them')
    return 0


if __name__ == '__main__':
    sys.exit(main())
