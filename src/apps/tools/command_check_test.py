#!/usr/bin/env python3
"""Tests of `arbiter check` from outside: exit codes, lines, JSON.

usage: command_check_test.py ARBITER FAKE_LAYER SOURCE_ROOT [unittest arguments]
"""
import json
import pathlib
import re

import command_session
from command_session import ARBITER, BAD, GOOD, PROGRAMS, ROOT, VERTEX, Temporary, alu, arbiter


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

    def test_languages_of_nvidia(self):
        vertex = '!!VP1.1\nDP4 o[HPOS].x, v[OPOS], c[4];\nABS o[COL0], v[COL0];\nEND\n'
        fragment = '!!FP1.0\nDECLARE tint = {1, 0.5};\nMUL o[COLR], f[COL0], tint;\nEND\n'
        files = self.path('a.vp', vertex), self.path('a.fp', fragment)
        result = arbiter('check', '--json', '--profile', 'nv30', *files)
        self.assertEqual(result.returncode, 0, result.stdout)
        read = json.loads(result.stdout)['files']
        self.assertEqual([file['language'] for file in read], ['VP1.1', 'FP1.0'])
        self.assertEqual([file['counts']['instructions']['used'] for file in read], [2, 1])
        self.assertEqual(arbiter('check', '--profile', 'r300', *files).returncode, 2)
        refused = arbiter('check', '--brief', '--profile', 'nv40', '-', text='!!FP2.0\nEND\n')
        self.assertEqual(refused.stdout, "<stdin>:1:5: error: there is no language '!!FP2.0' "
                                         '[native_header]\n')

    def test_a_language_may_be_demanded(self):
        self.assertEqual(arbiter('check', '--language', 'arbvp', '-', text=VERTEX).returncode, 0)
        result = arbiter('check', '--brief', '--language', 'arbfp', '-', text=VERTEX)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stdout, '<stdin>:1:6: error: the header !!ARBfp1.0 is missing '
                                        '[header_missing]\n')
        self.assertEqual(arbiter('check', '--language', 'cg', '-', text=VERTEX).returncode, 1)

    def test_another_language_is_told_what_it_is(self):
        glsl = 'uniform sampler2D image;\nvoid main() { gl_FragColor = texture2D(image, vec2(0.5)); }\n'
        hlsl = 'cbuffer c { float4 tint; };\nfloat4 main() : SV_Target { return tint; }\n'
        cg = 'fixed4 main(half2 uv : TEXCOORD0, uniform sampler2D i) : COLOR { return tex2D(i, uv); }\n'
        elf = pathlib.Path(ARBITER).read_bytes()[:4096]
        picture = (ROOT / 'docs' / 'pictures').glob('*.png').__next__().read_bytes()[:4096]
        for text, kind in ((glsl, 'GLSL'), (hlsl, 'HLSL'), (cg, 'Cg'), (elf, 'an ELF file'),
                           (picture, 'a PNG picture')):
            path = self.path('text.fp')
            path.write_bytes(text if isinstance(text, bytes) else text.encode())
            said = f'{path}:1:1: error: this is {kind}, which Arbiter does not read [header_missing]\n'
            result = arbiter('check', '--brief', path)
            self.assertEqual((result.returncode, result.stdout), (2, said))
            self.assertTrue(arbiter('compile', path).stderr.startswith(said))
        # A program with a wrong header still counts as a program.
        for text in (GOOD.replace('!!', '!'), GOOD.replace('fp1.0', 'fp2.0'), GOOD[GOOD.index('MOV'):]):
            self.assertIn('the header !!ARBfp1.0 is missing', arbiter('check', '--brief', '-', text=text).stdout)

    def test_error_line_is_what_editors_read(self):
        path = self.path('bad.fp', BAD)
        result = arbiter('check', '--brief', path)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stdout,
                         f"{path}:3:19: error: 'q' is not declared [undeclared_name]\n")

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
        self.assertEqual(result.stderr, f'arbiter check: {none}: No such file or directory\n')
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
        self.assertRegex(result.stdout, r'error: .* \[limit_alu_instructions\]\n')
        # The compiler merges both moves away, so that a program above the API limit fits the chip.
        result = arbiter('check', '--limits', 'report', '-', text=alu(65))
        self.assertEqual(result.returncode, 0)
        self.assertEqual(arbiter('check', '--limits', 'report', '-', text=alu(67)).returncode, 3)
        self.assertRegex(result.stdout, r'warning: .* \[limit_alu_instructions\]\n')
        self.assertIn('over the API limit', result.stdout)
        self.assertEqual(arbiter('check', '--profile', 'host', '-', text=alu(65)).returncode, 0)

    def test_the_panel_names_the_profile(self):
        """The order is that of `arbiter draw`: the option, the panel, the environment."""
        long_one = alu(70).replace('\n', '\n#@ profile nv30\n', 1)
        path = self.path('long.fp', long_one)
        short = self.path('short.fp', GOOD)
        result = arbiter('check', path)
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn('within the native limits of nv30', result.stdout)
        self.assertEqual(arbiter('check', '-', text=long_one).returncode, 0)
        self.assertEqual(arbiter('check', '--profile', 'r300', path).returncode, 2)
        self.assertEqual(arbiter('check', path, ARBITER_PROFILE='r300').returncode, 0)
        both = arbiter('check', path, short)
        self.assertIn('2 files under nv30, r300: 2 valid', both.stdout)
        report = json.loads(arbiter('check', '--json', path, short).stdout)
        self.assertEqual(report['profile']['name'], 'r300')
        self.assertEqual([file.get('profile') for file in report['files']], ['nv30', None])
        emitted = arbiter('compile', '--emit', 'ir', path)
        self.assertEqual(emitted.returncode, 0, emitted.stderr)
        self.path('mine.toml', 'inherits = "nv30"\n')
        beside = self.path('beside.fp', long_one.replace('nv30', 'mine.toml'))
        self.assertEqual(arbiter('check', beside).returncode, 0)
        broken = arbiter('check', '--brief', self.path('b.fp', long_one.replace('nv30', 'no.toml')))
        self.assertEqual(broken.returncode, 2)
        self.assertRegex(broken.stdout, r'b\.fp:2:12: error: .*no\.toml.*\[panel_file\]')

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
        self.assertEqual(diagnostic['id'], 'undeclared_name')
        self.assertEqual({name: value for name, value in diagnostic.items() if isinstance(value, int)},
                         {'begin': offset, 'end': offset + 1, 'line': 3,
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
        self.assertIn('[text_too_long]', result.stdout)

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


if __name__ == '__main__':
    command_session.main()
