#!/usr/bin/env python3
"""Tests of the rest of the `arbiter` command from outside, and of the command as a whole.

usage: command_test.py ARBITER FAKE_LAYER SOURCE_ROOT [unittest arguments]
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import tomllib
import unittest

import command_session
from command_session import ARBITER, BAD, GOOD, ROOT, VERTEX, Temporary, arbiter, on_terminal


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
        self.assertEqual(result.stderr, 'arbiter compile: -: the profile host has no model that runs '
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
        for numerics, given in (('legacy', text), ('fp24', text), ('fx9', GOOD)):  # only the passes use numerics
            refused = arbiter('compile', '--emit', 'ir', '--profile', 'nv20', '--numerics', numerics, '-', text=given)
            self.assertEqual((refused.returncode, refused.stdout), (1, ''))
            self.assertIn('--numerics has no effect with --emit ir but beside --optimize', refused.stderr)

    def test_json(self):
        result = arbiter('compile', '--json', '-', text=GOOD)
        said = json.loads(result.stdout)
        self.assertEqual((result.returncode, result.stderr, said['emit'], said['profile']), (0, '', 'glsl', 'r300'))
        program, = said['programs']
        self.assertEqual((program['status'], program['diagnostics']), ('valid', []))
        self.assertEqual(program['text'], arbiter('compile', '-', text=GOOD).stdout)
        result = arbiter('compile', '--json', '-', text=BAD)
        program, = json.loads(result.stdout)['programs']
        self.assertEqual((result.returncode, result.stderr, program['status']), (2, '', 'invalid'))
        self.assertEqual([each['id'] for each in program['diagnostics']], ['undeclared_name'])
        both = json.loads(arbiter('compile', '--json', '-', text=GOOD + VERTEX).stdout)
        self.assertEqual([(each['language'], each['line']) for each in both['programs']],
                         [('ARBfp1.0', 1), ('ARBvp1.0', 4)])

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
        self.assertIn('also geforcefx,', result.stdout)
        self.assertEqual([line.split()[0] for line in result.stdout.splitlines() if line[0] != ' '],
                         ['r300', 'r300-catalyst-2004', 'r350', 'r360', 'r420', 'nv10', 'nv20',
                          'nv25', 'nv30', 'nv35', 'nv40', 'i915', 'host'])

    def test_a_printed_profile_is_a_profile(self):
        for name in ('r300', 'r360', 'host'):
            printed = arbiter('profiles', name)
            self.assertEqual(printed.returncode, 0)
            again = arbiter('profiles', self.path(name + '.toml', printed.stdout))
            self.assertEqual(again.stdout, printed.stdout)

    def test_json_has_what_the_text_has(self):
        listed = json.loads(arbiter('profiles', '--json').stdout)
        self.assertEqual(listed['default'], 'r300')
        names = [line.split()[0] for line in arbiter('profiles').stdout.splitlines() if line[0] != ' ']
        self.assertEqual([profile['name'] for profile in listed['profiles']], names)
        self.assertIn('radeon9700', listed['profiles'][0]['aliases'])
        for name in names:
            one = json.loads(arbiter('profiles', '--json', name).stdout)
            text = tomllib.loads(arbiter('profiles', name).stdout)
            for table, rows in text.items():
                if table == 'identity':
                    self.assertEqual({key: row['value'] for key, row in one[table].items()},
                                     {key: str(row['value']) for key, row in rows.items()})
                else:
                    self.assertEqual(one[table], rows, f'{name}: {table}')

    def test_a_card_by_what_people_call_it(self):
        for typed, name in (('radeon9700', 'r300'), ('9700', 'r300'), ('GeForce FX', 'nv30'), ('geforce4', 'nv25')):
            self.assertEqual(arbiter('profiles', typed).stdout, arbiter('profiles', name).stdout)
        self.assertIn('native limits of nv30\n',
                      arbiter('check', '--profile', 'geforcefx', '-', text=GOOD).stdout)

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

    def test_json(self):
        folder = self.path('arbiter/programs/2a')
        os.makedirs(folder)
        pathlib.Path(folder, '2a' * 16).write_bytes(b'x' * 100)
        home = {'XDG_CACHE_HOME': self.path('')}
        for clear, files in (((), 1), (('--clear',), 0)):
            seen = json.loads(arbiter('cache', '--json', *clear, **home, ARBITER_CACHE_MAX_MB='2').stdout)
            self.assertEqual(seen['enabled'], True)
            self.assertEqual(seen['kinds'][0], {
                'kind': 'programs', 'folder': str(self.path('arbiter/programs')), 'files': files,
                'bytes': 100 * files, 'limit_bytes': 2 << 20})

    def test_without_a_home_it_says_so(self):
        result = arbiter('cache', XDG_CACHE_HOME='relative', HOME='')
        self.assertEqual(result.returncode, 1)
        self.assertIn('neither XDG_CACHE_HOME nor HOME', result.stderr)


class Whole(unittest.TestCase):
    def test_usage(self):
        self.assertEqual(arbiter('check').returncode, 1)
        self.assertEqual(arbiter('check', '--bogus', '-').returncode, 1)
        for words in (('--help',), ('check', '--help'), ('run', '--help'), ('--version',)):
            self.assertEqual(arbiter(*words).returncode, 0, words)
        header = (ROOT / 'include' / 'GL' / 'arbiter.h').read_text()
        version = '.'.join(re.findall(r'ARBITER_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)', header))
        for word in ('--version', '-V'):
            self.assertEqual(arbiter(word).stdout, f'arbiter {version}\n')
        self.assertEqual(f'{version}\n', (ROOT / 'VERSION').read_text())

    def test_help(self):
        alone = arbiter()
        self.assertEqual((alone.returncode, alone.stderr), (1, ''))
        for words in (('--help',), ('help',)):
            shown = arbiter(*words)
            self.assertEqual((shown.returncode, shown.stdout), (0, alone.stdout))
        self.assertEqual(arbiter('help', 'check').stdout, arbiter('check', '--help').stdout)
        self.assertEqual(arbiter('help', 'chek').stderr,
                         'arbiter: no verb chek; did you mean check? (arbiter --help)\n')

    def test_help_is_in_own_words(self):
        """Help must not use CLI11's words for the kinds of values."""
        names = re.findall(r'^  ([a-z]+)  ', arbiter('--help').stdout.partition('Subcommands:')[2], re.M)
        for name in names:
            text = arbiter(name, '--help').stdout
            self.assertNotRegex(text, r'\b(TEXT|INT|FLOAT|REQUIRED)\b|Needs:|Excludes:', name)
        text = re.sub(r'\s+', ' ', arbiter('debug', '--help').stdout)
        for words in ('Usage: arbiter debug [OPTIONS] FILE ', ' FILE a document: ',
                      ' --pixel X,Y the pixel; ',
                      ' --pass N (1 to 16; by default 1) which ', ' --line N (1 or more) run to ',
                      ' --against {swrast,host,bare,fp24} or FILE (by default swrast) ',
                      ' --range LOW,HIGH (by default 0,1; needs --output) values that ', ' --json the whole'):
            self.assertIn(words, text)
        self.assertIn('Usage: arbiter draw [OPTIONS] FILE...\n', arbiter('draw', '--help').stdout)

    def test_advice_has_colours_on_a_terminal(self):
        text = ('!!ARBfp1.0\nTEMP t;\nMUL t, fragment.color, 3.0;\nMAX t, t, 0.0;\n'
                'MIN result.color, t, 1.0;\nEND\n')
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / 'a.fp'
            path.write_text(text)
            place = f'\x1b[1m{path}:4:1:\x1b[0m \x1b[1;36mnote:\x1b[0m MAX and MIN clamp'
            for options in ((), ('--brief',)):
                seen = on_terminal('check', '--profile', 'r300', '--advise', *options, path)
                self.assertIn(place, seen)
            self.assertIn('\x1b[1;36m  ^~~~', on_terminal('check', '--profile', 'r300', '--advise', path))

    def test_a_window_that_is_not_there(self):
        with tempfile.TemporaryDirectory() as folder:
            tree = pathlib.Path(folder)
            for place, said in (('bin', 'the window is not installed: it is in the package arbiter-builder'),
                                ('src/apps/tools', 'this build is without the window: install qt6-base-dev')):
                (tree / place).mkdir(parents=True)
                shutil.copy(ARBITER, tree / place / 'arbiter')
                result = subprocess.run([tree / place / 'arbiter', 'builder'], capture_output=True, text=True)
                self.assertEqual(result.returncode, 1)
                self.assertTrue(result.stderr.startswith('arbiter builder: ' + said), result.stderr)
                (tree / 'build.ninja').write_text('')

    def test_one_voice(self):
        """A complaint names the command, the fault, what was expected, and how to get help."""
        rows = {
            'chek a.fp': 'arbiter: no verb chek; did you mean check? (arbiter --help)',
            'che a.fp': 'arbiter: no verb che; did you mean check? (arbiter --help)',
            'c a.fp': 'arbiter: no verb c (arbiter --help)',
            'check --adv -': 'arbiter check: no option --adv; did you mean --advise? (arbiter check --help)',
            'debug --pixel 1,1 --line 0 -': 'arbiter debug: --line 0: expected a whole number, 1 or more '
                                            '(arbiter debug --help)',
            '--jsn check': 'arbiter: no option --jsn; did you mean --json? (arbiter --help)',
            'check': 'arbiter check: FILE is missing: expected program texts, each with one program or several '
                     '(arbiter check --help)',
            'check --jsn -': 'arbiter check: no option --jsn; did you mean --json? (arbiter check --help)',
            'check --jsn': 'arbiter check: no option --jsn; did you mean --json? (arbiter check --help)',
            'run --huhd -- true': 'arbiter run: no option --huhd; did you mean --hud? (arbiter run --help)',
            'check --fix -': 'arbiter check: --fix needs --advise (arbiter check --help)',
            'check --compare --brief - -': 'arbiter check: --brief cannot be given with --compare '
                                           '(arbiter check --help)',
            'check --why --json -': 'arbiter check: --why has no effect with --json (arbiter check --help)',
            'compile --emit asembly -': 'arbiter compile: --emit asembly: expected tokens, ir, assembly, glsl, native, '
                                        'llvm or machine; did you mean assembly? (arbiter compile --help)',
            'compile --emit': 'arbiter compile: --emit has no value: expected tokens, ir '
                              '(arbiter compile --help)',
            'compile - x': 'arbiter compile: unexpected x (arbiter compile --help)',
            'ctl --pid abc list': 'arbiter ctl: --pid abc: expected a whole number from 1 to 4194304 '
                                  '(arbiter ctl --help)',
            'ctl --timeout 0 list': 'arbiter ctl: --timeout 0: expected a number from 0.001 to 3600 '
                                    '(arbiter ctl --help)',
            'draw --mesh cub -': 'arbiter draw: --mesh cub: expected quad, grid, plane, cube, sphere, torus, cylinder, '
                                 'knot, billboards or a file; did you mean cube? (arbiter draw --help)',
            'debug --from-top -': 'arbiter debug: --from-top needs --pixel (arbiter debug --help)',
            'draw --mesh none.obj -': 'arbiter draw: --mesh none.obj: No such file or directory (arbiter draw --help)',
            'draw --mesh . -': 'arbiter draw: --mesh .: Is a directory (arbiter draw --help)',
            'draw a.fp b.fp c.fp': 'arbiter draw: FILE: at most 2 are taken (arbiter draw --help)',
            'render a.fp': 'arbiter render: unexpected a.fp (arbiter render --help)',
            'check gallery:twril': 'arbiter check: gallery:twril: the gallery has no such document; did you mean '
                                   'gallery:twirl? (arbiter check --help)',
            'check none.fp': 'arbiter check: none.fp: No such file or directory',
            'doctor': 'arbiter doctor: no command to run (arbiter doctor --help)',
        }
        for words, said in rows.items():
            result = arbiter(*words.split())
            code = 125 if words.startswith('run') else 1
            self.assertEqual((result.returncode, result.stderr), (code, said + '\n'), words)

    def test_the_manual_has_every_option(self):
        names = re.findall(r'^  ([a-z]+)  ', arbiter('--help').stdout.partition('Subcommands:')[2], re.M)
        self.assertIn('doctor', names)
        for name in sorted(set(names) - {'help', 'builder'}):
            manual = (ROOT / 'docs' / 'man' / f'arbiter-{name}.1').read_text().replace('\\-', '-')
            for option in re.findall(r'(?<![\w-])--[a-z-]+', arbiter(name, '--help').stdout):
                if option not in ('--help', '--help-all'):
                    self.assertIn(option, manual, name)

    def test_the_header_names_every_variable(self):
        header = (ROOT / 'include' / 'GL' / 'arbiter.h').read_text()
        table = (ROOT / 'src' / 'util' / 'flags.def').read_text()
        self.assertEqual(set(re.findall(r'"(ARBITER_\w+)"', header)),
                         set(re.findall(r'^ARBITER_ENV\(\w+, "(\w+)"', table, re.M)))


if __name__ == '__main__':
    command_session.main()
