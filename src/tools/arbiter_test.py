#!/usr/bin/env python3
"""Tests of the `arbiter` command from outside: exit codes, lines, JSON, pictures.

usage: arbiter_test.py ARBITER FAKE_LAYER SOURCE_ROOT [unittest arguments]
FAKE_LAYER is a shared library that can be preloaded and does nothing.
"""
import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / 'tests' / 'clients'))
from plain_environment import plain  # noqa: E402

ARBITER, FAKE, ROOT = sys.argv[1], os.path.abspath(sys.argv[2]), pathlib.Path(sys.argv[3])
PROGRAMS = ROOT / 'demos' / 'programs'
GOOD = '!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n'
VERTEX = ('!!ARBvp1.0\nPARAM c[2] = { program.env[0..1] };\nADDRESS A;\n'
          'ARL A.x, vertex.attrib[7].x;\nMOV result.position, c[A.x];\nEND\n')
BAD = '!!ARBfp1.0\n# a comment\nMOV result.color, q;\nEND\n'


def arbiter(*words, text=None, **environment):
    return subprocess.run([ARBITER, *map(str, words)], input=text, capture_output=True,
                          env=plain(**environment), timeout=60,
                          text=not isinstance(text, bytes))


def alu(count):
    return ('!!ARBfp1.0\nTEMP a;\nMOV a, fragment.color;\n' + 'ADD a, a, a;\n' * (count - 2) +
            'MOV result.color, a;\nEND\n')


def read_png(path):
    """Width, height and RGBA rows from the top, of what libpng writes (8-bit RGBA)."""
    data = pathlib.Path(path).read_bytes()
    assert data[:8] == b'\x89PNG\r\n\x1a\n'
    at, packed, size = 8, b'', None
    while at < len(data):
        length, kind = struct.unpack('>I4s', data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b'IHDR':
            size = struct.unpack('>II', body[:8])
            assert body[8:10] == b'\x08\x06', 'not 8-bit RGBA'
        elif kind == b'IDAT':
            packed += body
        at += 12 + length
    raw, rows, above = zlib.decompress(packed), [], bytearray(4 * size[0])
    stride = 4 * size[0]
    for y in range(size[1]):
        start = y * (stride + 1)
        method, row = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        for x in range(stride):
            left = row[x - 4] if x >= 4 else 0
            up, corner = above[x], above[x - 4] if x >= 4 else 0
            guess = left + up - corner
            paeth = min((left, up, corner), key=lambda value: abs(guess - value))
            row[x] = (row[x] + (0, left, up, (left + up) // 2, paeth)[method]) & 255
        rows.append(bytes(row))
        above = row
    return size[0], size[1], rows


def write_png(path, width, height, rows):
    def chunk(kind, body):
        return struct.pack('>I', len(body)) + kind + body + struct.pack('>I', zlib.crc32(kind + body))
    packed = zlib.compress(b''.join(b'\0' + row for row in rows))
    pathlib.Path(path).write_bytes(
        b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 8, 6, 0, 0, 0)) +
        chunk(b'IDAT', packed) + chunk(b'IEND', b''))


class Temporary(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix='arbiter-tools-')
        self.addCleanup(self.folder.cleanup)

    def path(self, name, text=None):
        path = pathlib.Path(self.folder.name) / name
        if text is not None:
            path.write_text(text)
        return path


class Check(Temporary):
    def test_valid(self):
        result = arbiter('check', self.path('good.fp', GOOD))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('good.fp: valid, within the native limits of r300', result.stdout)
        self.assertRegex(result.stdout, r'(?m)^  instructions +1 +96 +1 +96  \[#\.{9}\] \[#\.{9}\]$')

    def test_the_header_names_the_language(self):
        result = arbiter('check', self.path('good.vp', VERTEX))
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertRegex(result.stdout, r'(?m)^  instructions +2 +256 +2 +256 ')
        self.assertRegex(result.stdout, r'(?m)^  address registers +1 +1 +1 +1 ')
        self.assertNotIn('ALU', result.stdout)
        result = arbiter('check', '--json', '--profile', 'nv30', self.path('good.vp', VERTEX),
                         self.path('good.fp', GOOD))
        vertex, fragment = json.loads(result.stdout)['files']
        self.assertEqual((vertex['language'], fragment['language']), ('ARBvp1.0', 'ARBfp1.0'))
        self.assertEqual(list(vertex['counts']), ['instructions', 'temporaries', 'parameters',
                                                  'attribs', 'address_registers'])
        self.assertEqual(vertex['counts']['address_registers'],
                         {'used': 1, 'limit': 2, 'native_used': 1, 'native_limit': 2})

    def test_a_language_may_be_demanded(self):
        self.assertEqual(arbiter('check', '--language', 'arbvp', '-', text=VERTEX).returncode, 0)
        result = arbiter('check', '--brief', '--language', 'arbfp', '-', text=VERTEX)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stdout, '<stdin>:1:6: error: the header !!ARBfp1.0 is missing '
                                        '[header-missing]\n')
        self.assertEqual(arbiter('check', '--language', 'cg', '-', text=VERTEX).returncode, 1)

    def test_error_line_is_what_editors_read(self):
        path = self.path('bad.fp', BAD)
        result = arbiter('check', '--brief', path)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stdout,
                         f"{path}:3:19: error: 'q' is not declared [undeclared-name]\n")

    def test_caret_under_the_first_wrong_byte(self):
        lines = arbiter('check', '-', text=BAD).stdout.splitlines()
        self.assertTrue(lines[0].startswith('<stdin>:3:19: error: '), lines[0])
        self.assertEqual(lines[2].index('^') - lines[1].index('MOV'), 18)
        self.assertEqual(lines[-1], '<stdin>: invalid')

    def test_the_worst_file_decides(self):
        good, bad = self.path('good.fp', GOOD), self.path('bad.fp', BAD)
        none, wide = self.path('none.fp'), self.path('wide.fp', alu(70))
        catalyst = ('check', '--profile', 'r300-catalyst-2004')
        self.assertEqual(arbiter(*catalyst, good, wide).returncode, 3)
        self.assertEqual(arbiter(*catalyst, good, wide, bad).returncode, 2)
        result = arbiter(*catalyst, wide, bad, none, good)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr, f'arbiter: {none}: No such file or directory\n')
        self.assertIn('good.fp: valid', result.stdout)

    def test_over_native_says_so(self):
        result = arbiter('check', '--profile', 'r300-catalyst-2004', '-', text=alu(70))
        self.assertEqual(result.returncode, 3)
        self.assertIn('valid, but over the native limits of r300-catalyst-2004', result.stdout)
        self.assertRegex(result.stdout,
                         r'(?m)^  ALU instructions +70 +128 +68 +64  \[#####\.{5}\] \[#{9}>\]  over the native limit$')

    def test_api_limits_are_enforced_or_reported(self):
        self.assertEqual(arbiter('check', '-', text=alu(64)).returncode, 0)
        result = arbiter('check', '--brief', '-', text=alu(65))
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stdout, r'error: .* \[limit-alu-instructions\]\n')
        # The chip reads both moves through, so that what the API refuses fits it.
        result = arbiter('check', '--limits', 'report', '-', text=alu(65))
        self.assertEqual(result.returncode, 0)
        self.assertEqual(arbiter('check', '--limits', 'report', '-', text=alu(67)).returncode, 3)
        self.assertRegex(result.stdout, r'warning: .* \[limit-alu-instructions\]\n')
        self.assertIn('over the API limit', result.stdout)
        self.assertEqual(arbiter('check', '--profile', 'host', '-', text=alu(65)).returncode, 0)

    def test_profile_from_environment_and_file(self):
        self.assertIn('limits of i915', arbiter('check', '-', text=GOOD,
                                                ARBITER_PROFILE='i915').stdout)
        profile = self.path('tiny.toml', 'inherits = "r300"\n[api]\nalu_instructions = 1\n')
        result = arbiter('check', '--profile', profile, '-', text=alu(2))
        self.assertEqual(result.returncode, 2, result.stdout)
        result = arbiter('check', '--profile', 'r30', '-', text=GOOD)
        self.assertEqual(result.returncode, 1)
        self.assertIn('did you mean "r300"?', result.stderr)
        profile = self.path('broken.toml', 'inherits = "r300"\n[api]\ntemps = 1\n')
        result = arbiter('check', '--profile', profile, '-', text=GOOD)
        self.assertEqual(result.returncode, 1)
        self.assertIn('broken.toml:3:1: unknown row "api.temps"', result.stderr)

    def test_json(self):
        result = arbiter('check', '--json', self.path('good.fp', GOOD), self.path('bad.fp', BAD),
                         self.path('none.fp'))
        self.assertEqual(result.returncode, 1)
        document = json.loads(result.stdout)
        header = (ROOT / 'include' / 'GL' / 'arbiter.h').read_text()
        schema = int(re.search(r'ARBITER_CHECK_SCHEMA (\d+)', header).group(1))
        self.assertEqual(document['schema'], schema)
        self.assertEqual(document['profile']['name'], 'r300')
        good, bad, none = document['files']
        self.assertEqual([file['status'] for file in (good, bad, none)],
                         ['valid', 'invalid', 'unreadable'])
        self.assertEqual(good['bytes'], len(GOOD))
        self.assertEqual(good['error_position'], -1)
        self.assertTrue(good['under_native_limits'])
        self.assertEqual(good['counts']['alu_instructions'],
                         {'used': 1, 'limit': 64, 'native_used': 1, 'native_limit': 64})
        self.assertEqual(list(good['counts']), [
            'instructions', 'alu_instructions', 'tex_instructions', 'tex_indirections',
            'temporaries', 'parameters', 'attribs'])
        diagnostic = bad['diagnostics'][0]
        offset = BAD.index('q;')
        self.assertEqual(bad['error_position'], offset)
        self.assertEqual(diagnostic['id'], 'undeclared-name')
        self.assertEqual(diagnostic['offset'], offset)
        self.assertEqual(diagnostic['range'], {'begin': offset, 'end': offset + 1, 'line': 3,
                                               'column': 19, 'end_line': 3, 'end_column': 20})
        self.assertNotIn('counts', bad)
        self.assertIn('No such file', none['fault'])

    def test_hostile_bytes_give_clean_json(self):
        text = b'!!ARBfp1.0\nMOV \xff\x00\x1b[2J, \xc3\x28;\nEND'
        result = arbiter('check', '--json', '-', text=text)
        self.assertEqual(result.returncode, 2)
        document = json.loads(result.stdout)
        self.assertEqual(document['files'][0]['error_position'], text.index(b'\xff'))
        self.assertNotIn(b'\x1b', result.stdout)
        self.assertNotIn(b'\x1b', arbiter('check', '-', text=text).stdout)

    def test_large_inputs(self):
        result = arbiter('check', '--brief', '-', text='!!ARBfp1.0\n#' + 'x' * (2 << 20) + '\nEND')
        self.assertEqual(result.returncode, 2)
        self.assertIn('[text-too-long]', result.stdout)

    def test_life_programs_cost_what_they_should(self):
        result = arbiter('check', '--json', PROGRAMS / 'life_naive.fp', PROGRAMS / 'life_packed.fp')
        self.assertEqual(result.returncode, 0, result.stdout)
        naive, packed = ({name: row['used'] for name, row in file['counts'].items()}
                         for file in json.loads(result.stdout)['files'])
        self.assertEqual((naive['instructions'], naive['tex_instructions']), (36, 9))
        self.assertLessEqual(packed['alu_instructions'], 9)
        self.assertEqual(packed['tex_instructions'], 4)
        self.assertLessEqual(packed['temporaries'], 5)
        self.assertEqual(packed['tex_indirections'], 2)  # one dependent read


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

    def test_assembly_is_a_program_again(self):
        text = ('!!ARBvp1.0\nPARAM r[] = {program.env[0..1]}; ADDRESS i;\n'
                'ARL i.x, vertex.attrib[3].w;\nMOV result.position, r[i.x + 1].yxzw;\nEND\n')
        result = arbiter('compile', '--emit', 'assembly', '-', text=text)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout,
                         '!!ARBvp1.0\nADDRESS a0;\n'
                         'PARAM c0[2] = { program.env[0], program.env[1] };\n'
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
                         ['r300', 'r300-catalyst-2004', 'r350', 'r360', 'r420', 'nv30', 'nv35',
                          'i915', 'host'])

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


class Run(Temporary):
    def run_env(self, *options, **environment):
        """The environment that a command sees under `arbiter run`."""
        result = arbiter('run', '--library', FAKE, *options, '--', 'env', '-0', **environment)
        self.assertEqual(result.returncode, 0, result.stderr)
        return dict(entry.split('=', 1) for entry in result.stdout.split('\0') if entry)

    def test_sets_what_the_options_say(self):
        seen = self.run_env('--profile', 'nv30', '--limits', 'report', '--log', 'debug',
                            '--debug', 'glsl', '--host-vendor', 'mesa', '--replace', '/tmp')
        self.assertEqual(seen['LD_PRELOAD'], FAKE)
        self.assertEqual({name: value for name, value in seen.items()
                          if name.startswith('ARBITER_')},
                         {'ARBITER_PROFILE': 'nv30', 'ARBITER_LIMITS': 'report',
                          'ARBITER_LOG': 'debug', 'ARBITER_DEBUG': 'glsl', 'ARBITER_REPLACE': '/tmp',
                          'ARBITER_HOST_VENDOR': 'mesa'})

    def test_paths_become_absolute(self):
        profile = self.path('mine.toml', 'inherits = "r300"\n')
        relative = os.path.relpath(profile)
        seen = self.run_env('--stats', 's-%p.json', '--log', 'warn:l.txt', '--profile', relative)
        self.assertEqual(seen['ARBITER_STATS'], os.path.join(os.getcwd(), 's-%p.json'))
        self.assertEqual(seen['ARBITER_LOG'], 'warn:' + os.path.join(os.getcwd(), 'l.txt'))
        self.assertTrue(os.path.isabs(seen['ARBITER_PROFILE']))
        self.assertTrue(os.path.samefile(seen['ARBITER_PROFILE'], profile))

    def test_keeps_what_is_there(self):
        other = self.path('libother.so')
        other.write_bytes(pathlib.Path(FAKE).read_bytes())
        seen = self.run_env(LD_PRELOAD=str(other), LD_LIBRARY_PATH='/opt/x', ARBITER_LIMITS='report')
        self.assertEqual(seen['LD_PRELOAD'], f'{FAKE}:{other}')
        self.assertTrue(seen['LD_LIBRARY_PATH'].endswith('/opt/x'))
        self.assertEqual(seen['ARBITER_LIMITS'], 'report')

    def test_the_front_of_osmesa_comes_first(self):
        library = self.path('libGLX_arbiter.so.0')
        library.write_bytes(pathlib.Path(FAKE).read_bytes())
        front = self.path('osmesa')
        front.mkdir()
        (front / 'libOSMesa.so.8').write_bytes(b'')
        result = arbiter('run', '--library', library, '--', 'env', LD_LIBRARY_PATH='/opt/x')
        self.assertIn(f'\nLD_LIBRARY_PATH={front}:/opt/x\n', '\n' + result.stdout)

    def test_egl_gets_the_vendor_file_that_fits(self):
        library = self.path('libGLX_arbiter.so.0')
        library.write_bytes(pathlib.Path(FAKE).read_bytes())
        folder = self.path('arbiter')
        folder.mkdir()
        by_path, by_name = folder / '10_arbiter.json', folder / '11_arbiter.json'

        def chosen(variable='__EGL_VENDOR_LIBRARY_FILENAMES', **environment):
            shell = f'printf "%s" "${variable}"'
            return arbiter('run', '--library', library, '--', 'sh', '-c', shell,
                           **environment).stdout
        self.assertEqual(chosen(), '')
        by_name.write_text('{"library_path": "libGLX_arbiter.so.0"}')
        self.assertEqual(chosen(), str(by_name))
        by_path.write_text('{"library_path": "/elsewhere/libGLX_arbiter.so.0"}')  # it was moved
        self.assertEqual(chosen(), str(by_name))
        by_path.write_text(f'{{"library_path": "{library}"}}')
        self.assertEqual(chosen(), str(by_path))
        # What was selected before is the layer's host.
        theirs = {'__EGL_VENDOR_LIBRARY_FILENAMES': '/theirs'}
        self.assertEqual(chosen(**theirs), str(by_path))
        self.assertEqual(chosen('ARBITER_SAVED_EGL_VENDORS', **theirs), '/theirs')

    def test_the_command_is_passed_on_as_it_is(self):
        def run(*words):
            return arbiter('run', '--library', FAKE, *words)
        shell = 'printf "%s|" "$@"; exit 7'
        result = run('--', 'sh', '-c', shell, 'sh', '--profile', '-x', '--', 'a b')
        self.assertEqual((result.returncode, result.stdout), (7, '--profile|-x|--|a b|'))
        result = run('sh', '-c', shell, 'sh', '--json', 'c')  # without the mark
        self.assertEqual((result.returncode, result.stdout), (7, '--json|c|'))
        self.assertEqual(run('--', 'no-such-command').returncode, 127)
        self.assertEqual(run('--', self.path('not-executable', 'x')).returncode, 126)

    def test_usage_errors(self):
        for words in ((), ('--bogus', '--', 'true'), ('--limits', 'maybe', '--', 'true'),
                      ('--profile', 'r30', '--', 'true')):
            result = arbiter('run', '--library', FAKE, *words)
            self.assertEqual(result.returncode, 1, words)
            self.assertNotEqual(result.stderr, '', words)
        self.assertEqual(arbiter('run', '--library', '/none.so', '--', 'true').returncode, 1)
        spaced = self.path('a b.so')
        spaced.write_bytes(pathlib.Path(FAKE).read_bytes())
        self.assertIn('cannot hold', arbiter('run', '--library', spaced, '--', 'true').stderr)

    def test_print_environment_is_read_by_a_shell(self):
        result = arbiter('run', '--library', FAKE, '--print-environment', '--stats', "it's.json")
        shell = subprocess.run(['sh', '-c', result.stdout + 'printf %s "$ARBITER_STATS"'],
                               capture_output=True, text=True, env=plain())
        self.assertEqual(shell.stdout, os.path.join(os.getcwd(), "it's.json"))

    def test_identity_options_become_variables(self):
        result = arbiter('run', '--library', FAKE, '--print-environment', '--identity', 'profile',
                         '--extensions-max-year', '2003', '--extensions-max-length', '4095')
        for line in ("ARBITER_IDENTITY='profile'", "ARBITER_EXTENSIONS_MAX_YEAR='2003'",
                     "ARBITER_EXTENSIONS_MAX_LENGTH='4095'"):
            self.assertIn('export ' + line + '\n', result.stdout)
        for bad in (('--identity', 'r300'), ('--extensions-max-year', '-1'),
                    ('--extensions-max-year', '1991'), ('--extensions-max-length', '0'),
                    ('--extensions-max-length', '4k')):
            self.assertEqual(arbiter('run', '--library', FAKE, *bad, '--', 'true').returncode, 1)


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


class Draw(Temporary):
    """On the bare host; the same through the layer is Layered."""
    words = ('--bare',)

    def draw(self, text, *options, size='8x4'):
        self.output = self.path('out.png')
        return arbiter('draw', *self.words, '--size', size, *options, '-', '-o', self.output,
                       text=text)

    def pixels(self, text, *options, size='8x4'):
        result = self.draw(text, *options, size=size)
        self.assertEqual(result.returncode, 0, result.stderr)
        return read_png(self.output)

    def test_coordinates_run_up_and_right(self):
        width, height, rows = self.pixels('!!ARBfp1.0\nMOV result.color, fragment.texcoord[3];\nEND',
                                          size='4x2')
        self.assertEqual((width, height), (4, 2))
        # The top row has the larger t: (0.5 + 1) / 2 of 255.
        self.assertEqual([list(row[:2]) for row in rows], [[32, 191], [32, 64]])
        self.assertEqual(rows[0][12], 223)

    def test_parameters(self):
        _, _, rows = self.pixels(
            '!!ARBfp1.0\nADD result.color, program.local[2], program.env[1];\nEND',
            '--local', '2=0.2,0,0.4,0.5', '--env', '1=0.2,0.6')
        self.assertEqual(list(rows[0][:4]), [102, 153, 102, 128])

    def test_a_texture_is_upright(self):
        image = self.path('in.png')
        colours = [b'\xff\0\0\xff', b'\0\xff\0\xff', b'\0\0\xff\xff', b'\xff\xff\xff\xff']
        write_png(image, 2, 2, [colours[0] + colours[1], colours[2] + colours[3]])
        _, _, rows = self.pixels('!!ARBfp1.0\nTEX result.color, fragment.texcoord, texture[1], 2D;'
                                 '\nEND', '--texture', f'1={image}', size='2x2')
        self.assertEqual(rows, [colours[0] + colours[1], colours[2] + colours[3]])

    def test_feedback(self):
        # Each frame adds 10/255 to what the last one drew; it starts from black.
        text = ('!!ARBfp1.0\nTEMP a;\nTEX a, fragment.texcoord, texture[0], 2D;\n'
                'ADD result.color, a, {0.0392156862745, 0, 0, 1};\nEND')
        _, _, rows = self.pixels(text, '--feedback', '0', '--frames', '5')
        self.assertEqual(set(rows[0][0::4]), {50})

    def test_invalid_program(self):
        result = self.draw(BAD)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r'^<stdin>:\d+:\d+: error: ')
        self.assertIn('^', result.stderr)
        self.assertFalse(self.output.exists())

    def test_a_vertex_program_moves_a_mesh(self):
        vertex = self.path('half.vp', '!!ARBvp1.0\nMUL result.position, vertex.position, {0.5, 1, 1, 1};\n'
                                      'MOV result.color, program.local[3];\nEND\n')
        for words in ((vertex,), ('--mesh', 'grid', '-', vertex)):
            local = ('--local', ('vp:' if '-' in words else '') + '3=0,1,0,1')
            result = arbiter('draw', *self.words, '--size', '8x4', *local, *words, '-o',
                             self.path('out.png'), text=GOOD)
            self.assertEqual((result.returncode, result.stderr), (0, ''))
            _, _, rows = read_png(self.path('out.png'))
            row = [rows[1][4 * x:4 * x + 3] for x in range(8)]
            self.assertEqual(row, [b'\0\0\0'] * 2 + [b'\0\xff\0'] * 4 + [b'\0\0\0'] * 2)

    def test_attributes(self):
        vertex = self.path('a.vp', '!!ARBvp1.0\nMOV result.position, vertex.attrib[0];\n'
                                   'MAD result.color, vertex.attrib[8], {1, 1, 0, 0}, vertex.attrib[6];\nEND\n')
        result = arbiter('draw', *self.words, '--size', '4x2', '--attrib', '6=0,0,0.2,1', vertex, '-o',
                         self.path('out.png'))
        self.assertEqual((result.returncode, result.stderr), (0, ''))
        _, _, rows = read_png(self.path('out.png'))
        self.assertEqual(list(rows[0][:4]), [32, 191, 51, 255])

    def test_a_sphere_is_round(self):
        _, _, rows = self.pixels(GOOD, '--mesh', 'sphere', size='16x16')
        self.assertEqual(rows[0][:3], b'\0\0\0')
        middle = rows[8][4 * 8:4 * 8 + 3]
        self.assertTrue(abs(middle[0] - 128) < 12 and abs(middle[1] - 128) < 12, list(middle))

    def test_what_has_no_effect_is_an_error(self):
        sampling = '!!ARBfp1.0\nTEX result.color, fragment.texcoord, texture[0], {};\nEND\n'
        for text, options, said in (
                (GOOD, ('--texture', '3=checker'),
                 '--texture 3=checker has no effect: no program samples a texture'),
                (sampling.format('2D'), ('--texture', '1=noise'),
                 '--texture 1=noise has no effect: <stdin> samples texture[0] as 2D'),
                (sampling.format('CUBE'), ('--texture', '0=checker'),
                 '--texture 0=checker: <stdin> samples texture[0] as CUBE, and this is a 2D image'),
                (sampling.format('RECT'), ('--feedback', '0', '--frames', '2'),
                 '--feedback 0: <stdin> samples texture[0] as RECT, and this is a 2D image'),
                (sampling.format('2D'), ('--feedback', '0'), '--feedback 0 has no effect on one frame'),
                (GOOD, ('--local', '0=1'), '--local 0=1 has no effect: no program reads program.local[0]'),
                (GOOD, ('--env', 'vp:2=1'),
                 '--env vp:2=1 has no effect: no vertex program reads program.env[2]'),
                (GOOD, ('--attrib', '1=1'), 'no program reads vertex.attrib[1]'),
                (GOOD, ('--mesh', 'grid'), '--mesh grid has no effect without a vertex program'),
                (sampling.format('2D'), ('--texture', '0=noise', '--texture', '0=checker'),
                 '--texture 0 is given twice')):
            result = self.draw(text, *options)
            self.assertEqual(result.returncode, 1, (options, result.stderr))
            self.assertIn(said, result.stderr)
            self.assertFalse(self.output.exists())

    def test_a_sample_without_an_image_is_said(self):
        result = self.draw('!!ARBfp1.0\nTEX result.color, fragment.texcoord, texture[2], CUBE;\nEND\n')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, 'arbiter: <stdin>: texture[2] (CUBE) has no image, so its '
                                        'samples are black\n')

    def test_two_programs_of_one_stage(self):
        first, second = self.path('a.fp', GOOD), self.path('b.fp', GOOD)
        result = arbiter('draw', *self.words, first, second, '-o', self.path('out.png'))
        self.assertEqual(result.returncode, 1)
        self.assertIn('are both programs of fragments', result.stderr)
        result = arbiter('draw', *self.words, first, '-o', first)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(first.read_text(), GOOD)

    def test_usage_errors(self):
        for options in (('--texture', '0'), ('--texture', 'x=checker'), ('--texture', '0=/none.png'),
                        ('--local', '0=1,2,3,4,5'), ('--local', '0=a'), ('--env', '0:1'),
                        ('--frames', '0'), ('--texture', '99=checker'), ('--local', '99999=1'),
                        ('--feedback', '0', '--texture', '0=checker')):
            result = self.draw(GOOD, *options)
            self.assertEqual(result.returncode, 1, (options, result.stderr))
        for size in ('8', '0x8', '8x99999', '-1x2', 'axb'):
            self.assertEqual(self.draw(GOOD, size=size).returncode, 1, size)
        self.assertEqual(arbiter('draw', *self.words, '-o', '/nowhere/x.png', '-',
                                 text=GOOD).returncode, 1)


class Capture(Temporary):
    def capture(self, *words):
        library = () if '--index-only' in words else ('--library', FAKE)
        return subprocess.run([os.path.abspath(ARBITER), 'capture', *library, *map(str, words)],
                              capture_output=True, text=True, timeout=60, env=plain(),
                              cwd=self.folder.name)

    def test_the_command_sees_a_folder_that_is_private(self):
        result = self.capture('-o', 'kept', '--', 'sh', '-c',
                              'stat -c %a "$ARBITER_CAPTURE"; touch "$ARBITER_CAPTURE/x"; exit 5')
        self.assertEqual((result.returncode, result.stdout), (5, '700\n'), result.stderr)
        self.assertEqual(json.loads(self.path('kept/index.json').read_text())['programs'], [])

    def test_the_folder_is_named_for_the_command(self):
        seen = self.capture('--', 'sh', '-c', 'basename "$ARBITER_CAPTURE"')
        self.assertEqual(seen.stdout, 'sh.capture\n')
        self.assertFalse(self.path('sh.capture').exists(), 'nothing was captured')
        self.path('sh.capture').mkdir()
        seen = self.capture('--', 'sh', '-c', 'basename "$ARBITER_CAPTURE"')
        self.assertEqual(seen.stdout, 'sh.capture-2\n')

    def test_signals(self):
        result = self.capture('--', 'sh', '-c', 'kill -SEGV $$')
        self.assertEqual(result.returncode, 128 + 11)
        for _ in range(20):  # the command's first act races with our own after the fork
            result = self.capture('--', 'sh', '-c', 'kill -TERM $PPID; exec sleep 30')
            self.assertEqual(result.returncode, 128 + 15, 'TERM was not passed on')

    def test_errors(self):
        self.path('file').write_text('')
        self.path('kept').mkdir()
        (self.path('kept') / ('0' * 32 + '.fp')).write_text('edited')
        self.path('old').mkdir()
        (self.path('old') / 'process-1-2.json').write_text('{}')
        for words, text in ((('-o', 'file', '--', 'true'), 'file'),
                            (('-o', 'no/such', '--', 'true'), 'no/such'),
                            (('-o', 'kept', '--', 'true'), 'is edited'),
                            (('-o', 'old', '--', 'true'), 'holds a capture'),
                            ((), 'no command to run'),
                            (('--index-only',), '--index-only takes a folder'),
                            (('--index-only', '-o', 'none'), 'none: no such folder'),
                            (('--index-only', '-o', 'kept', '--', 'true'), 'no command'),
                            (('--replace', 'none', '--', 'true'), 'none: no such folder')):
            result = self.capture(*words)
            self.assertEqual(result.returncode, 1, words)
            self.assertIn(text, result.stderr, words)
        self.assertEqual(self.capture('--', './nothing').returncode, 127)
        self.assertEqual((self.path('kept') / ('0' * 32 + '.fp')).read_text(), 'edited')


class Layered(Draw):
    words = ()

    def test_invalid_program_names_the_byte(self):
        self.assertTrue(self.draw(BAD).stderr.startswith('<stdin>:3:19: error: '))

    def test_limits_are_the_profiles(self):
        self.assertEqual(self.draw(alu(65)).returncode, 2)
        self.assertEqual(self.draw(alu(65), '--limits', 'report').returncode, 0)
        self.assertEqual(self.draw(GOOD, '--texture', '16=checker').returncode, 1)

    def test_the_statistics_agree_with_check(self):
        stats = self.path('stats.json')
        for program in ('life_naive.fp', 'life_packed.fp', 'lighting.fp'):
            text = (PROGRAMS / program).read_text()
            self.assertEqual(self.draw(text, '--stats', stats).returncode, 0)
            seen = json.loads(stats.read_text())
            header = (ROOT / 'include' / 'GL' / 'arbiter.h').read_text()
            self.assertIn(f'ARBITER_STATS_SCHEMA {seen["schema"]}\n', header)
            self.assertEqual(seen['draws']['host_glsl'] + seen['draws']['rasterizer'], 1)
            checked = json.loads(arbiter('check', '--json', '-', text=text).stdout)['files'][0]
            loaded = seen['programs'][0]
            self.assertEqual(loaded['hash'], checked['hash'])
            counts = dict(loaded['counts'])
            # The statistics' row is every language's; a fragment program has no such register.
            self.assertEqual(counts.pop('address_registers'), 0)
            self.assertEqual(list(counts.values()),
                             [row['used'] for row in checked['counts'].values()], program)

    def test_an_ati_shader(self):
        image = self.path('in.png')
        write_png(image, 1, 1, [b'\x10\x20\x30\xff'])
        text = '!!ATIfs1.0\nStartOutputPass;\nSampleMap r0, t0.str;\nMOV r0, r0;\nEndPass;\n'
        _, _, rows = self.pixels(text, '--texture', f'0={image}', size='2x2')
        self.assertEqual(rows[0][:4], b'\x10\x20\x30\xff')

    def test_a_refused_vertex_program_is_named(self):
        vertex = self.path('bad.vp', '!!ARBvp1.0\nMOV result.position, q;\nEND\n')
        result = arbiter('draw', *self.words, '-', vertex, '-o', self.path('out.png'), text=GOOD)
        self.assertEqual(result.returncode, 2)
        self.assertTrue(result.stderr.startswith(f'{vertex}:2:22: error: '), result.stderr)

    def test_never_the_bare_hosts_picture(self):
        result = arbiter('draw', '--in-layer', '-', '-o', self.path('x.png'), text=GOOD)
        self.assertEqual(result.returncode, 4)
        self.assertIn('not loaded', result.stderr)


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
        for command in ('check', 'compile', 'draw', 'run', 'profiles', 'cache', 'lsp'):
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
    unittest.main(argv=[sys.argv[0]] + sys.argv[4:])
