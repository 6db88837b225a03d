#!/usr/bin/env python3
"""Tests of `arbiter defaults` from outside. tests/defaults covers how the layer applies them.

usage: command_defaults_test.py ARBITER FAKE_LAYER SOURCE_ROOT [unittest arguments]
"""
import json
import pathlib
import subprocess

import command_session
from command_session import ARBITER, ROOT, Temporary, arbiter

GOOD = """[[program]]
title = "A game"
match.name = "game"
source = "https://a.example/"
[program.set]
numerics = "legacy"
extensions_max_year = 2001
"""
SHIPPED = ROOT / 'src/interposer/arbiter/defaults.d'


class Defaults(Temporary):
    def program(self, name, text='#!/bin/sh\n'):
        path = self.path(name, text)
        path.chmod(0o755)
        return path

    def folder_of(self, **files):
        for name, text in files.items():
            (pathlib.Path(self.folder.name) / 'd').mkdir(exist_ok=True)
            self.path(f'd/{name}.toml', text)
        return str(self.path('d'))

    def test_lists_what_is_shipped(self):
        result = arbiter('defaults', ARBITER_DEFAULTS=str(SHIPPED))
        self.assertEqual((result.returncode, result.stderr), (0, ''))
        self.assertIn('GLQuake (Linux)\n', result.stdout)
        self.assertIn('extensions_max_length = 1007', result.stdout)
        listed = json.loads(arbiter('defaults', '--json', ARBITER_DEFAULTS=str(SHIPPED)).stdout)
        self.assertEqual(listed['schema'], 1)
        self.assertGreaterEqual(len(listed['entries']), 12)
        for entry in listed['entries']:
            self.assertTrue(entry['source'] and all(each.startswith('https://') for each in entry['source']),
                            entry['title'])
            self.assertTrue(entry['note'], entry['title'])

    def test_the_build_tree_has_them_where_the_layer_looks(self):
        listed = json.loads(arbiter('defaults', '--json', XDG_CONFIG_HOME=self.folder.name).stdout)
        self.assertIn('GLQuake (Linux)', [entry['title'] for entry in listed['entries']])

    def test_says_which_apply_and_why(self):
        game = self.program('game')
        game.write_bytes(pathlib.Path('/bin/true').read_bytes())
        folder = self.folder_of(a=GOOD, b=GOOD.replace('legacy', 'fp24').replace('A game', 'Later'))
        result = arbiter('defaults', '--', game, ARBITER_DEFAULTS=folder, ARBITER_EXTENSIONS_MAX_YEAR='1999')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('entry    A game, by name game', result.stdout)
        self.assertIn(f'sets     numerics = fp24 ({folder}/b.toml:6)', result.stdout)
        self.assertIn('not      extensions_max_year = 2001 (ARBITER_EXTENSIONS_MAX_YEAR is set',
                      result.stdout)
        twin = json.loads(arbiter('defaults', '--json', '--', game, ARBITER_DEFAULTS=folder,
                                  ARBITER_EXTENSIONS_MAX_YEAR='1999').stdout)
        self.assertEqual([each['title'] for each in twin['choice']['entries']], ['A game', 'Later'])
        self.assertTrue(twin['choice']['settings']['numerics']['used'])
        self.assertFalse(twin['choice']['settings']['extensions_max_year']['used'])

    def test_the_hash_that_it_prints_matches(self):
        game = self.program('game')
        game.write_bytes(pathlib.Path('/bin/true').read_bytes())
        printed = arbiter('defaults', '--', game, ARBITER_DEFAULTS='0').stdout
        self.assertIn('no entry is for it', printed)
        value = next(line.split()[1] for line in printed.splitlines() if line.startswith('xxh128'))
        text = GOOD.replace('match.name = "game"', f'match.xxh128 = "{value}"')
        result = arbiter('defaults', '--', game, ARBITER_DEFAULTS=self.folder_of(a=text))
        self.assertIn(f'by xxh128 {value}', result.stdout)
        game.write_bytes(game.read_bytes() + b'\0')
        result = arbiter('defaults', '--', game, ARBITER_DEFAULTS=self.folder_of(a=text))
        self.assertIn('no entry is for it', result.stdout)

    def test_windows_programs_behind_wine(self):
        wine, game = self.program('wine'), self.path('Game.EXE', 'MZ')
        text = GOOD.replace('match.name = "game"', 'match.windows = "game.exe"')
        result = arbiter('defaults', '--', wine, game, '-x', ARBITER_DEFAULTS=self.folder_of(a=text))
        self.assertIn('entry    A game, by windows Game.EXE', result.stdout)

    def test_windows_programs_where_wine_is_not_installed(self):
        text = GOOD.replace('match.name = "game"', 'match.windows = "game.exe"')
        folder = self.folder_of(a=text)
        seen = arbiter('defaults', '--', 'wine', 'Game.EXE', ARBITER_DEFAULTS=folder, PATH='/none')
        self.assertEqual((seen.returncode, seen.stderr), (0, 'arbiter defaults: wine: not found in PATH\n'))
        self.assertIn('entry    A game, by windows Game.EXE', seen.stdout)
        seen = arbiter('defaults', '--', 'wine', 'game', ARBITER_DEFAULTS=folder, PATH='/none')
        self.assertEqual((seen.returncode, seen.stdout), (1, ''))

    def test_tests_a_file(self):
        good = self.path('good.toml', GOOD)
        result = arbiter('defaults', '--check', good)
        self.assertEqual((result.returncode, result.stderr), (0, ''))
        bad = self.path('bad.toml', GOOD.replace('legacy', 'fp25') +
                        '[[program]]\ntitle = "B"\nmatch.name = "b"\nset.profile = "r3000"\n')
        result = arbiter('defaults', '--check', bad)
        self.assertEqual(result.returncode, 2)
        self.assertIn(f'{bad}:6:12: numerics: expected host, legacy, fp24 or fx9, not "fp25"', result.stderr)
        self.assertIn(f'{bad}:11: no profile', result.stderr)
        self.assertIn('"B" has no source', result.stderr)
        self.assertIn('extensions_max_year = 2001', result.stdout, 'the rest is not shown')
        twin = arbiter('defaults', '--json', '--check', bad)
        self.assertEqual((twin.returncode, len(json.loads(twin.stdout)['errors'])), (2, 2))
        self.assertEqual(arbiter('defaults', '--check', self.path('none.toml')).returncode, 2)

    def test_a_file_is_tried_on_a_command(self):
        game = self.program('game')
        game.write_bytes(pathlib.Path('/bin/true').read_bytes())
        result = arbiter('defaults', '--check', self.path('good.toml', GOOD), '--', game)
        self.assertIn('sets     numerics = legacy', result.stdout)

    def test_the_template_is_good_and_shows_every_key(self):
        template = ROOT / 'docs/use/defaults_template.toml'
        result = arbiter('defaults', '--json', '--check', template)
        self.assertEqual(result.returncode, 0, result.stdout)
        entry, = json.loads(result.stdout)['entries']
        self.assertEqual(set(entry['match']), {'name', 'path', 'windows', 'xxh128'})
        self.assertEqual(len(entry['set']), 11, 'a key that the template does not show')

    def test_what_cannot_be_found(self):
        result = arbiter('defaults', '--', './none')
        self.assertEqual((result.returncode, result.stderr), (1, 'arbiter defaults: ./none: no such file\n'))

    def test_the_command_itself_follows_none(self):
        text = GOOD.replace('"game"', '"arbiter"').replace('numerics = "legacy"', 'profile = "nv30"')
        checked = subprocess.run([ARBITER, 'check', '-'], input=command_session.GOOD, text=True,
                                 capture_output=True, check=True,
                                 env=command_session.plain(ARBITER_DEFAULTS=self.folder_of(a=text)))
        self.assertIn('r300', checked.stdout)


if __name__ == '__main__':
    command_session.main()
