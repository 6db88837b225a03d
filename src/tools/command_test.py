#!/usr/bin/env python3
"""Tests of the rest of the `arbiter` command from outside, and of the command as a whole.

usage: command_test.py ARBITER FAKE_LAYER SOURCE_ROOT [unittest arguments]
"""
import os
import pathlib
import re
import unittest

import command_session
from command_session import BAD, GOOD, ROOT, Temporary, arbiter


class Compile(Temporary):
    def test_tokens(self):
        result = arbiter('compile', '--emit', 'tokens', '-', text='!!ARBfp1.0\nMOV a, .5;\n')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual([line.split() for line in result.stdout.splitlines()],
                         [['1:1', 'Header', '!!ARBfp1.0'], ['2:1', 'Identifier', 'MOV'],
                          ['2:5', 'Identifier', 'a'], ['2:6', 'Comma', ','],
                          ['2:8', 'Float', '.5'], ['2:10', 'Semicolon', ';']])

    def test_ir_before_and_after_the_passes(self):
        text = ('!!ARBfp1.0\nTEMP unused;\nMOV unused, fragment.color;\n'
                'MOV result.color, fragment.color;\nEND\n')
        plain = arbiter('compile', '--emit', 'ir', '-', text=text)
        passed = arbiter('compile', '--emit', 'ir', '-O', '-', text=text)
        self.assertEqual((plain.returncode, passed.returncode), (0, 0), plain.stderr)
        self.assertEqual(plain.stdout.count('MOV'), 2)
        self.assertEqual(passed.stdout.count('MOV'), 1)

    def test_assembly_of_what_nvidias_languages_share_with_the_arbs(self):
        text = ('!!ARBvp1.0\nOPTION NV_vertex_program2;\nTEMP r, k;\nMOV result.position, vertex.position;\n'
                'MOV k.x, 2.0;\nagain:\nADD r, r, program.env[1];\nADDC k.x, k.x, -1.0;\n'
                'BRA again (GT.x);\nMOV result.color, r;\nEND\n')
        words = ('compile', '--profile', 'nv40', '--emit', 'assembly', '-')
        result = arbiter(*words, text=text)
        self.assertEqual((result.returncode, result.stdout), (1, ''))
        self.assertIn('with -O there may be one', result.stderr)
        result = arbiter(*words, '-O', text=text)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout.count('program.env[1]'), 1)
        self.assertNotIn('OPTION', result.stdout)
        again = arbiter('check', '-', text=result.stdout)
        self.assertEqual(again.returncode, 0, again.stdout)
        result = arbiter(*words, '-O', text=text.replace('ADDC', 'SEQ r, r, k;\nADDC'))
        self.assertIn('no assembly text of the ARB says what this program does\n', result.stderr)

    def test_assembly_is_a_program_again(self):
        text = ('!!ARBvp1.0\nPARAM r[] = {program.env[0..1]}; ADDRESS i;\n'
                'ARL i.x, vertex.attrib[3].w;\nMOV result.position, r[i.x + 1].yxzw;\nEND\n')
        result = arbiter('compile', '--emit', 'assembly', '-', text=text)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout,
                         '!!ARBvp1.0\nADDRESS a0;\n'
                         'PARAM c0[2] = { program.env[0..1] };\n'
                         'ARL a0.x, vertex.attrib[3].w;\n'
                         'MOV result.position, c0[a0.x+1].yxzw;\nEND\n')
        again = arbiter('compile', '--emit', 'assembly', '-', text=result.stdout)
        self.assertEqual(again.stdout, result.stdout)

    def test_native_wants_a_model(self):
        result = arbiter('compile', '--emit', 'native', '--profile', 'host', '-', text=GOOD)
        self.assertEqual((result.returncode, result.stdout), (1, ''))
        self.assertEqual(result.stderr, 'arbiter: -: the profile host has no model that runs '
                                        'ARBfp1.0 programs: its limits are documented numbers\n')
        self.assertEqual(arbiter('compile', '--emit', 'native', '-', text=BAD).returncode, 2)

    def test_machine_code(self):
        ir = arbiter('compile', '--emit', 'llvm', '-', text=GOOD)
        if 'libarbiter_jit' in ir.stderr:
            self.skipTest('built without the JIT back end')
        self.assertEqual((ir.returncode, ir.stderr), (0, ''))
        self.assertIn('define void @arbiter_entry(', ir.stdout)
        code = arbiter('compile', '--emit', 'machine', '--numerics', 'legacy', '-', text=GOOD)
        self.assertEqual((code.returncode, code.stderr), (0, ''))
        self.assertIn('arbiter_entry:', code.stdout)
        refused = arbiter('compile', '--emit', 'machine', '--numerics', 'fp24', '-', text=GOOD)
        self.assertEqual((refused.returncode, refused.stdout), (1, ''))
        missing = arbiter('compile', '--emit', 'machine', '-', text=GOOD,
                          ARBITER_JIT_LIBRARY='/nowhere/jit.so')
        self.assertEqual((missing.returncode, missing.stdout), (1, ''))
        self.assertIn('/nowhere/jit.so', missing.stderr)

    def test_combiners_of_nine_bits(self):
        text = '!!RC1.0\n{ rgb { spare0 = col0 * tex0; } }\nout.rgb = spare0;\n'
        plain = arbiter('compile', '--emit', 'glsl', '--profile', 'nv20', '-', text=text)
        self.assertEqual((plain.returncode, plain.stderr), (0, ''))
        self.assertNotIn('floor(', plain.stdout)
        for word, *emit in (('floor(', 'glsl'), ('FLR ', 'ir', '-O'), ('FLR ', 'assembly', '-O'),
                            ('FLR ', 'ir'), ('FLR ', 'assembly')):
            rounded = arbiter('compile', '--emit', *emit, '--profile', 'nv20', '--numerics', 'fx9', '-', text=text)
            self.assertEqual((rounded.returncode, rounded.stderr), (0, ''))
            self.assertIn(word, rounded.stdout)
        for numerics, given in (('legacy', text), ('fp24', text), ('fx9', GOOD)):  # nothing but the passes asks
            refused = arbiter('compile', '--emit', 'ir', '--profile', 'nv20', '--numerics', numerics, '-', text=given)
            self.assertEqual((refused.returncode, refused.stdout), (1, ''))
            self.assertIn('--numerics has no effect with --emit ir but beside --optimise', refused.stderr)

    def test_glsl_into_a_file(self):
        output = self.path('out.glsl')
        result = arbiter('compile', '-o', output, '-', text=GOOD)
        self.assertEqual((result.returncode, result.stdout), (0, ''), result.stderr)
        self.assertTrue(output.read_text().startswith('#version 120\n'))

    def test_errors(self):
        result = arbiter('compile', '-', text=BAD)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stdout, '')
        self.assertIn('<stdin>:3:19: error: ', result.stderr)
        self.assertEqual(arbiter('compile', self.path('none.fp')).returncode, 1)
        self.assertEqual(arbiter('compile', '--emit', 'spirv', '-', text=GOOD).returncode, 1)
        self.assertEqual(arbiter('compile', '-o', '/nowhere/x', '-', text=GOOD).returncode, 1)


class Profiles(Temporary):
    def test_list(self):
        result = arbiter('profiles')
        self.assertEqual(result.returncode, 0)
        self.assertEqual([line.split()[0] for line in result.stdout.splitlines()],
                         ['r300', 'r300-catalyst-2004', 'r350', 'r360', 'r420', 'nv10', 'nv20',
                          'nv25', 'nv30', 'nv35', 'nv40', 'i915', 'host'])

    def test_a_printed_profile_is_a_profile(self):
        for name in ('r300', 'r360', 'host'):
            printed = arbiter('profiles', name)
            self.assertEqual(printed.returncode, 0)
            again = arbiter('profiles', self.path(name + '.toml', printed.stdout))
            self.assertEqual(again.stdout, printed.stdout)

    def test_unknown(self):
        result = arbiter('profiles', 'voodoo')
        self.assertEqual(result.returncode, 1)
        self.assertIn('built in: r300,', result.stderr)


class Cache(Temporary):
    def test_shows_and_clears_what_is_there(self):
        folder = self.path('arbiter/programs/2a')
        code = self.path('arbiter/code/2a')
        for kind in (folder, code):
            os.makedirs(kind)
            for name in ('2a' * 16, 'ea' * 16):
                pathlib.Path(kind, name).write_bytes(b'x' * 100)
        mine = pathlib.Path(folder, 'notes.txt')
        mine.write_text('mine')
        home = {'XDG_CACHE_HOME': self.path('')}
        shown = arbiter('cache', **home, ARBITER_CACHE_MAX_MB='2')
        self.assertEqual(shown.returncode, 0)
        self.assertIn('arbiter/programs: 3 files, 204 of 2097152 bytes\n', shown.stdout)
        self.assertIn('arbiter/code: 2 files, 200 of 2097152 bytes\n', shown.stdout)
        self.assertIn('off', arbiter('cache', **home, ARBITER_CACHE='0').stdout)
        arbiter('cache', '--clear', **home)
        self.assertEqual(os.listdir(folder), ['notes.txt'])
        self.assertFalse(os.path.exists(code) and os.listdir(code))

    def test_without_a_home_it_says_so(self):
        result = arbiter('cache', XDG_CACHE_HOME='relative', HOME='')
        self.assertEqual(result.returncode, 1)
        self.assertIn('neither XDG_CACHE_HOME nor HOME', result.stderr)


class Whole(unittest.TestCase):
    def test_usage(self):
        self.assertEqual(arbiter().returncode, 1)
        self.assertEqual(arbiter('check').returncode, 1)
        self.assertEqual(arbiter('check', '--bogus', '-').returncode, 1)
        self.assertIn('did you mean check', arbiter('chek').stderr)
        for words in (('--help',), ('check', '--help'), ('run', '--help'), ('--version',)):
            self.assertEqual(arbiter(*words).returncode, 0, words)
        header = (ROOT / 'include' / 'GL' / 'arbiter.h').read_text()
        version = '.'.join(re.findall(r'ARBITER_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)', header))
        self.assertEqual(arbiter('--version').stdout, f'arbiter {version}\n')
        self.assertIn(f"version: '{version}'", (ROOT / 'meson.build').read_text())

    def test_the_manual_has_every_option(self):
        manual = (ROOT / 'docs' / 'man' / 'arbiter.1').read_text().replace('\\-', '-')
        for command in ('check', 'compile', 'draw', 'run', 'profiles', 'cache', 'lsp', 'builder', 'defaults', 'doctor'):
            self.assertIn(f'arbiter {command}', manual)
            for option in re.findall(r'(?<![\w-])--[a-z-]+', arbiter(command, '--help').stdout):
                if option not in ('--help', '--help-all'):
                    self.assertIn(option, manual, command)

    def test_the_header_names_every_variable(self):
        header = (ROOT / 'include' / 'GL' / 'arbiter.h').read_text()
        table = (ROOT / 'src' / 'util' / 'flags.def').read_text()
        self.assertEqual(set(re.findall(r'"(ARBITER_\w+)"', header)),
                         set(re.findall(r'^ARBITER_ENV\(\w+, "(\w+)"', table, re.M)))


if __name__ == '__main__':
    command_session.main()
