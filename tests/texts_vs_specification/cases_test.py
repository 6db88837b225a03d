#!/usr/bin/env python3
"""Tests of case_files.py: what is expanded, and what is refused."""

import pathlib
import tempfile
import unittest

from case_files import Malformed, expanded, read_cases


class Expansion(unittest.TestCase):
    def test_every_combination(self):
        self.assertEqual(list(expanded('a@{1;2}b@{x;}')),
                         [(' [1] [x]', 'a1bx'), (' [1] []', 'a1b'), (' [2] [x]', 'a2bx'),
                          (' [2] []', 'a2b')])
        self.assertEqual(list(expanded('plain; {2}')), [('', 'plain; {2}')])

    def test_braces_nest(self):
        self.assertEqual([text for _, text in expanded('@{{1;2};3}')], ['{1;2}', '3'])


class Files(unittest.TestCase):
    def read(self, text, name='fragment_x.cases'):
        with tempfile.TemporaryDirectory(prefix='arbiter-texts-') as folder:
            path = pathlib.Path(folder) / name
            path.write_text(text)
            return read_cases(path)

    def test_a_case(self):
        [case] = self.read('# c\n=== n | refuse | 3.1 | show fixed | bare accept: why\n!!ARBvp1.0\nEND\n')
        self.assertEqual((case.name, case.place, case.stage, case.accepted, case.reason, case.shown),
                         ('n', 'fragment_x.cases:2', 'fragment', False, '3.1', 'fixed'))
        self.assertEqual((case.bare_accepted, case.bare_reason), (True, 'why'))
        self.assertEqual(case.text, '!!ARBvp1.0\nEND\n')

    def test_a_host_that_varies(self):
        [case] = self.read('=== n | accept | r | bare draws: why\n!!ARBfp1.0\nEND\n')
        self.assertEqual((case.bare_varies, case.bare_accepted, case.bare_reason), (True, None, 'why'))

    def test_a_host_that_rounds(self):
        [case] = self.read('=== n | accept | r | exact | bare rounds from Mesa 23.1: why\n!!ARBfp1.0\nEND\n')
        self.assertEqual((case.exact, case.bare_rounds_from, case.bare_reason), (True, (23, 1), 'why'))

    def test_the_header_is_the_stage_elsewhere(self):
        [case] = self.read('=== n | accept | r\n!!ARBvp1.0\nEND\n', 'x.cases')
        self.assertEqual(case.stage, 'vertex')

    def test_malformed(self):
        for text in ('x\n', '=== n | maybe | r\n', '=== n | accept\n', '=== n | accept | r | what\n',
                     '=== n | accept | r\n@{\n', '=== n | accept | r | bare no: x\n',
                     '=== n | accept | r | bare rounds from Mesa 23: x\n'):
            with self.assertRaises(Malformed, msg=text):
                self.read(text)


if __name__ == '__main__':
    unittest.main()
