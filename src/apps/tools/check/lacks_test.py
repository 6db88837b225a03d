#!/usr/bin/env python3
"""`arbiter check` of a card that lacks programs of a language, and of limits that a card does not enforce.

usage: lacks_test.py ARBITER
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ARBITER = os.path.abspath(sys.argv[1])
GOOD = '!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n'
VERTEX = '!!ARBvp1.0\nMOV result.position, vertex.position;\nEND\n'
BAD = '!!ARBfp1.0\nMOV result.color, q;\nEND\n'
# Five reads, each of where the one before led to: one more than the R300 runs.
DEEP = ('!!ARBfp1.0\nTEMP a;\nTEX a, fragment.texcoord[0], texture[0], 2D;\n' +
        'TEX a, a, texture[0], 2D;\n' * 4 + 'MOV result.color, a;\nEND\n')


def check(*words, cwd=None):
    return subprocess.run([ARBITER, 'check', *map(str, words)], cwd=cwd, capture_output=True, text=True,
                          timeout=60, check=False)


class Temporary(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix='arbiter-lacks-')
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def path(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path


class Programless(Temporary):
    """Cards that have no programs of a language."""

    SAID = 'geforce.fp: nv25: the card has no fragment programs\n'

    def test_it_is_said_alone(self):
        for text in (GOOD, DEEP):
            path = self.path('geforce.fp', text)
            for options in ((), ('--brief',), ('--why',), ('--gauges=always',)):
                result = check('--profile', 'geforce4', *options, path.name, cwd=self.folder)
                self.assertEqual(result.stdout, self.SAID, options)
                self.assertEqual(result.stderr, '')

    def test_json_says_it_before_all_else(self):
        path = self.path('geforce.fp', GOOD)
        [file] = json.loads(check('--json', '--profile', 'geforce4', path).stdout)['files']
        self.assertEqual(list(file)[:3], ['file', 'status', 'why'])
        self.assertEqual(file['why'], 'the card has no fragment programs')
        [file] = json.loads(check('--json', path).stdout)['files']
        self.assertNotIn('why', file)

    def test_a_wrong_text_is_wrong_all_the_same(self):
        result = check('--profile', 'nv25', self.path('bad.fp', BAD))
        self.assertEqual(result.returncode, 2)
        first, second = result.stdout.splitlines()[:2]
        self.assertTrue(first.endswith('bad.fp: nv25: the card has no fragment programs'), first)
        self.assertIn("error: 'q' is not declared", second)

    def test_many_files_have_it_in_the_summary(self):
        for i in range(9):
            self.path(f'{i}.fp', GOOD)
        result = check('--profile', 'nv10', '.', cwd=self.folder)
        self.assertEqual(result.stdout.count('the card has no fragment programs\n'), 9)
        self.assertNotIn('the fullest', result.stdout)

    def test_a_comparison_has_its_side_without_native_counts(self):
        words = ('--compare', '--profile', 'r300', '--profile', 'nv25')
        result = check(*words, self.path('geforce.fp', GOOD))
        self.assertIn('geforce.fp: nv25: the card has no fragment programs\n', result.stdout)
        self.assertRegex(result.stdout, r'(?m)^  ALU instructions +1/64 +1/48 +0 +1/64 +-$')
        deep = check(*words, self.path('deep.fp', DEEP))
        self.assertTrue(deep.stdout.endswith('deep.fp: nv25: the card has no fragment programs\n'), deep.stdout)

    def test_vertex_programs_are_run_by_the_driver(self):
        result = check('--profile', 'i915', self.path('v.vp', VERTEX))
        self.assertIn('v.vp: valid; the card has no vertex programs of its own: its driver runs them on the '
                      'processor\n', result.stdout)
        self.assertNotIn('over the', result.stdout)


class Indirections(Temporary):
    """A card that announces a limit of indirections and loads what is over it."""

    def test_the_warning_and_the_table_agree(self):
        result = check(self.path('deep.fp', DEEP))
        self.assertEqual(result.returncode, 3)
        self.assertIn('warning: ATI Radeon 9700 (r300) runs 4 texture indirections, and this program needs 5: '
                      'it loads, but not natively [limit_tex_indirections]\n', result.stdout)
        self.assertIn('deep.fp: valid, but over the native limits of r300\n', result.stdout)
        self.assertRegex(result.stdout, r'(?m)^  TEX indirections +5 +4 +5 +4  .*\]'
                                        r'  over the native limit; the API limit is not enforced$')

    def test_a_driver_that_refuses_says_whose_limit_it_is(self):
        profile = self.path('strict.toml', 'name = "strict"\ninherits = "r300"\n[state]\nrefuse_indirections = 1\n')
        result = check('--profile', profile, self.path('deep.fp', DEEP))
        self.assertEqual(result.returncode, 2)
        self.assertIn('error: more than 4 texture indirections, the limit of ATI Radeon 9700 (strict) '
                      '[limit_tex_indirections]\n', result.stdout)


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0]])
