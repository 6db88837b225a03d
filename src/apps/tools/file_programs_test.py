#!/usr/bin/env python3
"""Tests of files with one program after comments, or with several programs, for every verb.

usage: file_programs_test.py ARBITER FAKE_LAYER SOURCE_ROOT [unittest arguments]
"""
import json
import pathlib
import re

from command_draw_test import read_png
from command_session import BAD, GOOD, Temporary, arbiter, main

VERTEX = '''!!ARBvp1.0
#@ local[1] = 0.2 0 0 1
MOV result.position, vertex.position;
MOV result.color, program.local[1]; # no END yet
END
'''
FRAGMENT = '''!!ARBfp1.0
#@ local[1] = 0 0.4 0 0
TEMP t;
MOV t, fragment.color;
ADD t, t, program.local[1];
MOV result.color, t;
END
'''
PAIR = '# A material.\n#@ size 8 4\n\n' + VERTEX + '\n# Its other half.\n' + FRAGMENT
GLSL = '#version 120\n// !!ARBfp1.0\nvoid main()\n{\n  gl_FragColor = gl_Color;\n}\n'
CG = 'float4 main(float2 at : TEXCOORD0) : COLOR\n{\n  return at.xyxy;\n}\n'


class Verbs(Temporary):
    def test_check_names_each_half(self):
        path = self.path('bump.vfp', PAIR)
        seen = arbiter('check', path)
        self.assertEqual((seen.returncode, seen.stderr), (0, ''))
        for title in ('ARBvp1.0 of line 4', 'ARBfp1.0 of line 11'):
            self.assertIn(f'{path}, {title}: valid, within the native limits of r300\n', seen.stdout)
        self.assertNotIn(' under r300', seen.stdout)
        seen = arbiter('check', '--language', 'arbvp', path).stdout
        self.assertIn('ARBvp1.0 of line 4: valid', seen)
        self.assertNotIn('ARBfp1.0 of', seen)

    def test_diagnostics_have_the_lines_of_the_file(self):
        path = self.path('bump.vfp', PAIR.replace('MOV result.color, t', 'MOV result.color, q'))
        seen = arbiter('check', path)
        self.assertEqual(seen.returncode, 2)
        self.assertIn(f"{path}:16:19: error: 'q' is not declared [undeclared_name]\n"
                      '  MOV result.color, q;\n', seen.stdout)
        files = json.loads(arbiter('check', '--json', path).stdout)['files']
        self.assertEqual([(file['language'], file['line'], file['status']) for file in files],
                         [('ARBvp1.0', 4, 'valid'), ('ARBfp1.0', 11, 'invalid')])
        self.assertEqual(files[1]['diagnostics'][0]['line'], 16)
        # The position counts from the start of this half, as GL does when it is given the half alone.
        self.assertEqual(files[1]['error_position'], FRAGMENT.index('color, t') + 7)
        alone = json.loads(arbiter('check', '--json', '-', text=VERTEX.rstrip()).stdout)['files'][0]
        self.assertEqual(files[0]['hash'], alone['hash'])

    def test_wrong_lines_of_either_half_s_panel(self):
        path = self.path('bump.vfp', PAIR.replace('local[1] = 0.2 0 0 1', 'local[1] = z')
                         .replace('size 8 4', 'size 8 x'))
        seen = arbiter('check', path)
        self.assertRegex(seen.stdout, r'bump\.vfp:2:\d+: error')
        self.assertRegex(seen.stdout, r'bump\.vfp:5:15: warning')

    def test_one_program_behind_comments(self):
        path = self.path('late.fp', '# why\n\n' + GOOD)
        seen = arbiter('check', path)
        self.assertEqual(seen.returncode, 0)
        self.assertIn(f'{path}:3:1: warning: the header is there, but not at the first byte '
                      '[header_behind]\n', seen.stdout)
        self.assertIn(f'{path}: valid, within', seen.stdout)

    def test_a_folder_has_what_its_texts_are(self):
        texts = {'a.vfp': PAIR, 'b.material': '// one\n' + GOOD, 'c.cg': '/* two */\n' + GOOD,
                 'd.fp': BAD, 'e.fp': 'MOV result.color, fragment.color;\nEND\n',
                 'f.fp': GLSL, 'g.vp': CG, 'h.md': 'Text\n\n' + GOOD,
                 'i.c': f'const char *text = "{GOOD}";\n'}
        for name, text in texts.items():
            self.path(name, text)
        seen = arbiter('check', '--json', self.folder.name)
        names = [pathlib.Path(file['file']).name for file in json.loads(seen.stdout)['files']]
        self.assertEqual(names, ['a.vfp', 'a.vfp', 'b.material', 'c.cg', 'd.fp', 'e.fp'])
        seen = arbiter('check', self.folder.name)
        self.assertIn('6 programs in 5 files under r300: 4 valid, 2 invalid\n', seen.stdout)

    def test_cards_and_compare(self):
        path = self.path('bump.vfp', PAIR)
        seen = arbiter('check', '--profile', 'all', path).stdout
        self.assertRegex(seen, r'(?m)^\S*bump\.vfp, ARBvp1\.0 of line 4 +fits')
        self.assertRegex(seen, r'(?m)^\S*bump\.vfp, ARBfp1\.0 of line 11 +fits')
        twice = ('--compare', '--profile', 'r300', '--profile', 'nv30', path)
        self.assertIn('--language', arbiter('check', *twice).stderr)
        self.assertEqual(arbiter('check', '--language', 'arbfp', *twice).returncode, 0)

    def test_fixes_stay_in_their_half(self):
        wasteful = PAIR.replace('MOV result.color, t;',
                                'MAX t, t, 0;\nMIN t, t, 1;\nMOV result.color, t;')
        path = self.path('bump.vfp', wasteful)
        seen = arbiter('check', '--advise', '--fix', path)
        self.assertIn('ARBfp1.0 of line 11: ', seen.stdout)
        fixed = path.read_text()
        self.assertNotEqual(fixed, wasteful)
        self.assertNotIn('MAX', fixed)
        at = wasteful.index('# Its other')
        self.assertEqual(fixed[:at], wasteful[:at])
        self.assertTrue(fixed.endswith('END\n'))
        self.assertEqual(arbiter('check', path).returncode, 0)

    def test_compile(self):
        path = self.path('bump.vfp', PAIR)
        glsl = arbiter('compile', '--emit', 'glsl', path).stdout
        self.assertEqual(re.findall(r'(?m)^// (.*)$', glsl),
                         [f'{path}, ARBvp1.0 of line 4', f'{path}, ARBfp1.0 of line 11'])
        self.assertIn('gl_Position', glsl)
        self.assertIn('gl_FragColor', glsl)
        one = arbiter('compile', '--language', 'arbfp', '--emit', 'glsl', path).stdout
        self.assertEqual(one, arbiter('compile', '--emit', 'glsl', '-', text=FRAGMENT).stdout)
        assembly = self.path('again.vfp', arbiter('compile', '--emit', 'assembly', path).stdout)
        self.assertEqual(arbiter('check', assembly).returncode, 0)
        tokens = arbiter('compile', '--emit', 'tokens', path).stdout
        self.assertRegex(tokens, r'(?m)^11:1 +Header +!!ARBfp1\.0$')
        wrong = self.path('wrong.vfp', PAIR.replace('TEMP t', 'TEMP u'))
        seen = arbiter('compile', '--emit', 'ir', wrong)
        self.assertEqual((seen.returncode, seen.stdout), (2, ''))
        self.assertIn(f"{wrong}:14:5: error: 't' is not declared", seen.stderr)

    def test_report(self):
        path = self.path('bump.vfp', PAIR)
        page = self.path('page.html')
        seen = arbiter('report', '-o', page, '--json', path)
        self.assertIn('programs: 2, fit: 2,', seen.stderr)
        programs = json.loads(seen.stdout)['programs']
        self.assertEqual([program['name'] for program in programs],
                         [f'{path}, ARBvp1.0 of line 4', f'{path}, ARBfp1.0 of line 11'])
        self.assertEqual([line['line'] for line in programs[1]['lines']], [14, 15, 16])
        self.assertIn('ARBvp1.0 of line 4', page.read_text())


class Draw(Temporary):
    """Draws a pair as one pass; each half uses the lines of its own panel."""
    words = ('--bare',)

    def draw(self, text, *options):
        self.output = self.path('out.png')
        return arbiter('draw', *self.words, self.path('bump.vfp', text), '-o', self.output, *options)

    def test_a_pair_is_drawn(self):
        for text in (PAIR, FRAGMENT.replace('#@', '#@ size 8 4,', 1) + VERTEX):
            seen = self.draw(text)
            self.assertEqual((seen.returncode, seen.stderr), (0, ''))
            width, height, rows = read_png(self.output)
            self.assertEqual((width, height), (8, 4))
            self.assertEqual(list(rows[0][:4]), [51, 102, 0, 255])

    def test_options_are_of_the_half_that_they_name(self):
        self.draw(PAIR, '--local', 'vp:1=0.4,0,0,1')
        self.assertEqual(list(read_png(self.output)[2][0][:4]), [102, 102, 0, 255])

    def test_a_vertex_program_of_a_pair(self):
        self.path('pair.vfp', PAIR)
        seen = self.draw(FRAGMENT.replace('#@', '#@ size 8 4, vertex pair.vfp,', 1))
        self.assertEqual((seen.returncode, seen.stderr), (0, ''))
        self.assertEqual(list(read_png(self.output)[2][0][:4]), [51, 102, 0, 255])

    def test_what_is_refused_has_its_line_in_the_file(self):
        seen = self.draw(PAIR.replace('MOV result.color, t', 'MOV result.color, q'))
        self.assertEqual(seen.returncode, 2)
        self.assertIn('bump.vfp:16:', seen.stderr)


class Layered(Draw):
    words = ()

    def test_a_pixel_of_a_pair(self):
        seen = arbiter('debug', self.path('bump.vfp', PAIR), '--pixel', '1,1', '--json')
        rows = json.loads(seen.stdout)['rows']
        self.assertEqual([row['line'] for row in rows], [14, 15, 16])
        seen = arbiter('debug', self.path('bump.vfp'), '--pixel', '1,1', '--stage', 'vertex')
        self.assertIn('MOV result.color, program.local[1]', seen.stdout)


if __name__ == '__main__':
    main()
