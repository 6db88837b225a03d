#!/usr/bin/env python3
"""Tests of `arbiter check --advise` and `--fix`.

usage: command_test.py ARBITER SOURCE_ROOT [UNITTEST ARGUMENTS...]
"""
import json
import os
import pathlib
import stat
import subprocess
import sys
import tempfile
import unittest

ARBITER = os.path.abspath(sys.argv.pop(1))
ROOT = pathlib.Path(sys.argv.pop(1))
NAIVE = ('!!ARBfp1.0\nTEMP t;\nMUL t, fragment.color, 3.0;\nMAX t, t, 0.0;\n'
         'MIN result.color, t, 1.0;\nEND\n')


class Advise(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix='arbiter-advise-')
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = self.folder / 'a.fp'
        self.file.write_text(NAIVE)

    def check(self, *words, status=0, text=None):
        done = subprocess.run([ARBITER, 'check', '--profile', 'r300', *map(str, words)],
                              capture_output=True, text=True, cwd=self.folder, input=text)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stdout if status == 0 else done.stderr

    def test_text(self):
        out = self.check('--advise', 'a.fp')
        for piece in ('a.fp:4:1: note: MAX and MIN', '[clamp_by_sat]', '  ^~~~', 'ALU 3 -> 1',
                      '  - MAX t, t, 0.0;', '  + MUL_SAT t, fragment.color, 3.0;'):
            self.assertIn(piece, out)
        self.assertNotIn('note:', self.check('a.fp'))
        self.assertEqual(self.file.read_text(), NAIVE)
        brief = self.check('--advise', '--brief', 'a.fp')
        self.assertEqual(len(brief.splitlines()), 1, brief)
        self.assertIn('ALU 3 -> 1', brief)

    def test_nothing_to_say(self):
        self.file.write_text('!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n')
        self.assertIn('a.fp: no advice', self.check('--advise', 'a.fp'))

    def test_a_program_over_a_limit_is_told_so(self):
        """Without advice the limit is named; with advice it is given although the program does not load."""
        long = '!!ARBfp1.0\nTEMP a;\nMOV a, fragment.color;\n' + 'ADD a, a, a;\n' * 68 + 'MOV result.color, a;\nEND\n'
        self.file.write_text(long)
        for brief in ((), ('--brief',)):
            done = subprocess.run([ARBITER, 'check', '--profile', 'r300', '--advise', *brief, 'a.fp'],
                                  capture_output=True, text=True, cwd=self.folder)
            self.assertEqual(done.returncode, 2)
            self.assertTrue(done.stdout.endswith('a.fp: over the API limit of ALU instructions; no rewriting is known '
                                                 'that takes less\n'), done.stdout)
        done = subprocess.run([ARBITER, 'check', '--profile', 'r300-catalyst-2004', '--advise', 'a.fp'],
                              capture_output=True, text=True, cwd=self.folder)
        self.assertEqual(done.returncode, 3)
        self.assertTrue(done.stdout.endswith("a.fp: over the card's own limits: ALU instructions 68 of 64; no "
                                             'rewriting is known that takes less\n'), done.stdout)
        naive = long.replace('ADD a, a, a;\n', '', 7).replace('MOV result.color, a;', NAIVE.split('t;\n', 1)[1][:-5])
        self.file.write_text(naive.replace('TEMP a;', 'TEMP a, t;').replace('fragment.color, 3', 'a, 3'))
        done = subprocess.run([ARBITER, 'check', '--profile', 'r300', '--advise', 'a.fp'],
                              capture_output=True, text=True, cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn('MAX and MIN', done.stdout)
        self.assertNotIn('no rewriting', done.stdout)
        self.assertIn('1 fix made', self.check('--advise', '--fix', 'a.fp'))
        self.assertIn('MUL_SAT', self.file.read_text())

    def test_standard_input(self):
        self.assertIn('<stdin>:4:1: note', self.check('--advise', '-', text=NAIVE))
        self.assertIn('standard input', self.check('--advise', '--fix', '-', text=NAIVE, status=1))

    def test_json(self):
        found = json.loads(self.check('--advise', '--json', 'a.fp'))['files'][0]['advice']
        clamp = next(each for each in found if each['rule'] == 'clamp_by_sat')
        self.assertEqual((clamp['before']['alu'], clamp['after']['alu']), (3, 1))
        self.assertEqual((clamp['line'], clamp['column']), (4, 1))
        text = NAIVE
        for edit in reversed(clamp['edits']):
            text = text[:edit['begin']] + edit['text'] + text[edit['end']:]
        self.file.write_text(text)
        self.assertNotIn('clamp_by_sat', self.check('--advise', 'a.fp'))
        self.assertIn('alu', self.check('--json', 'a.fp'))
        self.assertNotIn('advice', json.loads(self.check('--json', 'a.fp'))['files'][0])

    def test_fix(self):
        self.file.chmod(0o640)
        link = self.folder / 'link.fp'
        link.symlink_to('a.fp')
        out = self.check('--advise', '--fix', 'link.fp')
        self.assertIn('link.fp: 1 fix made: ALU 3 -> 1', out)
        self.assertIn('MUL_SAT', self.file.read_text())
        self.assertTrue(link.is_symlink())
        self.assertEqual(stat.S_IMODE(self.file.stat().st_mode), 0o640)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ['a.fp', 'link.fp'])
        again = self.file.stat().st_mtime_ns
        self.assertIn('0 fixes made', self.check('--advise', '--fix', 'a.fp'))
        self.assertEqual(self.file.stat().st_mtime_ns, again)

    def test_fix_where_it_cannot_be_written(self):
        if os.geteuid() == 0:
            pipe = self.folder / 'gone' / 'a.fp'
            self.assertIn('No such file', self.check('--advise', '--fix', pipe, status=1))
            return
        self.folder.chmod(0o500)
        self.addCleanup(self.folder.chmod, 0o700)
        self.assertIn('Permission denied', self.check('--advise', '--fix', 'a.fp', status=1))
        self.assertEqual(self.file.read_text(), NAIVE)

    def test_wrong_programs_stay(self):
        for text in (NAIVE.replace('END\n', ''), 'not a program', ''):
            self.file.write_text(text)
            self.check('--advise', '--fix', 'a.fp', status=2)
            self.assertEqual(self.file.read_text(), text)

    def test_options_that_do_not_go_together(self):
        self.check('--fix', 'a.fp', status=1)
        self.check('--advise', '--compare', 'a.fp', 'a.fp', status=1)
        done = subprocess.run([ARBITER, 'check', '--profile', 'all', '--advise', str(self.file)],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn('--advise', done.stderr)

    def test_the_naive_life(self):
        self.file.write_bytes((ROOT / 'demos/programs/life_naive.fp').read_bytes())
        found = json.loads(self.check('--advise', '--json', 'a.fp'))['files'][0]['advice']
        self.assertGreaterEqual(sum(each['fix'] for each in found), 3)
        fixed = json.loads(self.check('--advise', '--fix', '--json', 'a.fp'))['files'][0]
        self.assertEqual(fixed['fixed']['before']['alu'], 24)
        self.assertLessEqual(fixed['fixed']['after']['alu'], 20)
        self.assertEqual(fixed['counts']['alu_instructions']['native_used'],
                         fixed['fixed']['after']['alu'])


if __name__ == '__main__':
    unittest.main()
