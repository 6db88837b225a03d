#!/usr/bin/env python3
"""Tests nvparse's languages, !!RC1.0 and !!TS1.0, in the command. Programs are checked against cards, compiled, drawn,
debugged, and served to editors.

usage: nvparse_test.py ARBITER SOURCE_ROOT [unittest arguments]
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ARBITER, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path[:0] = [str(ROOT / 'src/apps/tools/lsp'), str(ROOT / 'src/apps/tools'), str(ROOT / 'tests/clients')]
sys.argv[1:3] = [ARBITER, '', str(ROOT)]  # the arguments that command_session reads
from command_draw_test import read_png  # noqa: E402
from lsp_client import Client  # noqa: E402
from plain_environment import plain  # noqa: E402

STAGE = '{ rgb { spare0 = col0 * const0; } }\n'
TWO = '!!RC1.0\n' + STAGE * 2 + 'out.rgb = spare0;\nout.a = col0;\n'
THREE = '!!RC1.0\n' + STAGE * 3 + 'out.rgb = spare0;\nout.a = col0;\n'
REFLECTS = ('!!TS1.0\ntexture_2d();\n' + ''.join(
    f'dot_product_reflect_cube_map_eye_from_qs_{i}of3(expand(tex0));\n' for i in (1, 2, 3)))
LINE = '!!TS1.0\ntexture_2d();\ndot_product_1d(tex0);\n'  # NV_texture_shader3
PANEL = '#@ size 16 8, mesh quad, camera none\n#@ texture 0 = clouds 64 64, linear, repeat\n'
# One computation in both languages.
COMBINES = ('!!RC1.0\n' + PANEL + '#@ env[0] = 0.5 0.25 0.75 1\nconst1 = (0.25, 0.5, 0.125, 0.5);\n'
            '{\n  rgb {\n    discard = tex0 * const0;\n    discard = col0 * unsigned_invert(const1);\n'
            '    spare0 = sum();\n  }\n  alpha {\n    spare0 = expand(tex0.b);\n    scale_by_one_half();\n  }\n}\n'
            'out.rgb = lerp(const1.a, spare0, col0);\nout.a = unsigned_invert(spare0);\n')
ARB = ('!!ARBfp1.0\n' + PANEL + '#@ env[0] = 0.5 0.25 0.75 1\nPARAM b = {0.25, 0.5, 0.125, 0.5};\n'
       'TEMP t, s, c;\nTEX t, fragment.texcoord[0], texture[0], 2D;\nMOV_SAT c, fragment.color;\n'
       'SUB s, 1, b;\nMUL s.rgb, c, s;\nMAD s.rgb, t, program.env[0], s;\nMIN s.rgb, s, 1;\n'
       'MAD s.a, t.b, 2, -1;\nMUL s.a, s.a, 0.5;\nMAX s.a, s.a, -1;\n'
       'LRP result.color.rgb, b.a, s, c;\nMAX s.a, s.a, 0;\nSUB result.color.a, 1, s.a;\nEND\n')


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix='arbiter-nvparse-')
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def run_command(self, *words, text=None, code=0):
        result = subprocess.run([ARBITER, *map(str, words)], input=text, capture_output=True, text=True,
                                timeout=120, check=False, env=plain())
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result


class Check(Folder):
    def answer(self, text, profile, code=0):
        result = self.run_command('check', '--profile', profile, '--json', '-', text=text, code=code)
        entry, = json.loads(result.stdout)['files']
        return entry

    def test_stages_are_counted_against_the_card(self):
        counts = self.answer(TWO, 'nv10')['counts']
        self.assertEqual((counts['alu_instructions']['used'], counts['alu_instructions']['limit']), (2, 2))
        entry = self.answer(THREE, 'nv10', code=2)
        finding, = entry['diagnostics']
        self.assertEqual((finding['id'], finding['line'], finding['column']), ('limit_general_combiners', 4, 1))
        counts = self.answer(THREE, 'nv20')['counts']
        self.assertEqual((counts['alu_instructions']['used'], counts['alu_instructions']['limit']), (3, 8))
        self.answer('!!RC1.0\n' + STAGE * 8 + 'out.rgb = spare0;\n', 'nv25')
        self.answer('!!RC1.0\n' + STAGE * 9 + 'out.rgb = spare0;\n', 'nv25', code=2)

    def test_what_a_card_does_not_have(self):
        for text, profile, name in (
                (TWO, 'r300', 'not_offered'), (REFLECTS, 'nv10', 'not_offered'),
                (LINE, 'nv20', 'limit_texture_shaders'), ('!!RC1.0\nout.rgb = tex2;\n', 'nv10', 'image_unit'),
                ('!!RC1.0\n{ const0 = (0, 0, 0, 0); rgb { spare0 = const0; } }\nout.rgb = spare0;\n', 'nv10',
                 'limit_stage_constants')):
            entry = self.answer(text, profile, code=2)
            self.assertEqual([each['id'] for each in entry['diagnostics']], [name])
        for text, profile in ((REFLECTS, 'nv20'), (LINE, 'nv25'), (LINE, 'host')):
            self.assertEqual(self.answer(text, profile)['status'], 'valid')

    def test_every_card_in_one_run(self):
        result = self.run_command('check', '--profile', 'all', '--json', self.write('three.nvrc', THREE))
        row, = json.loads(result.stdout)['files']
        self.assertEqual({card['profile'] for card in row['cards'] if card['status'] == 'valid'},
                         {'nv20', 'nv25', 'nv30', 'nv35', 'nv40'})

    def test_a_folder_has_their_files(self):
        self.write('two.nvrc', TWO)
        self.write('line.nvts', LINE)
        result = self.run_command('check', '--profile', 'nv25', '--json', self.folder)
        self.assertEqual(len(json.loads(result.stdout)['files']), 2)

    def test_compiled_to_every_form(self):
        for text in (TWO, REFLECTS + TWO):
            for form, piece in (('ir', 'MUL'), ('glsl', '#version 120'), ('assembly', '!!ARBfp1.0'),
                                ('tokens', 'OpenParen' if text != TWO else 'Times')):
                profile = () if form == 'tokens' else ('--profile', 'nv25')
                result = self.run_command('compile', *profile, '--emit', form, '-', text=text)
                self.assertIn(piece, result.stdout)

    def test_an_editor_is_served(self):
        client = Client([ARBITER, 'lsp', '--profile', 'nv20'])
        client.request('initialize', {'processId': None, 'rootUri': None, 'capabilities': {}})
        client.notify('initialized', {})
        uri = 'file:///t.nvrc'
        self.assertEqual([each['code'] for each in client.open(uri, THREE.replace('col0 *', 'cool0 *', 1))],
                         ['syntax'])
        client.change(uri, 2, {'text': THREE})
        self.assertEqual(client.diagnostics(uri)['diagnostics'], [])
        at = {'textDocument': {'uri': uri}, 'position': {'line': 1, 'character': 10}}
        self.assertIn('not initialised', client.request('textDocument/hover', at)['contents']['value'])
        items = client.request('textDocument/completion', {**at, 'position': {'line': 4, 'character': 10}})
        labels = {item['label'] for item in (items if isinstance(items, list) else items['items'])}
        self.assertLessEqual({'spare1', 'lerp', 'final_product', 'tex3', 'unsigned_invert'}, labels)
        client.request('shutdown', None)
        client.notify('exit', None)
        client.process.wait(20)


class Draw(Folder):
    def picture(self, name, text, profile):
        path = self.write(name, text)
        self.run_command('draw', '--profile', profile, path, '-o', self.folder / 'out.png')
        return read_png(self.folder / 'out.png')

    def test_as_the_same_meaning_in_arb(self):
        expected = self.picture('same.fp', ARB, 'host')
        for name, text in (('own.nvrc', COMBINES), ('own.nvts', COMBINES.replace(
                '!!RC1.0\n' + PANEL, '!!TS1.0\n' + PANEL + 'texture_2d();\n!!RC1.0\n'))):
            drawn = self.picture(name, text, 'nv25')
            self.assertEqual(drawn[:2], expected[:2])
            worst = max(abs(a - b) for row, other in zip(drawn[2], expected[2]) for a, b in zip(row, other))
            self.assertLessEqual(worst, 1, name)
        self.assertGreater(len({row[i:i + 4] for row in expected[2] for i in range(0, len(row), 4)}), 20)

    def test_stages_alone_are_modulated(self):
        drawn = self.picture('stages.nvts', '!!TS1.0\n' + PANEL + 'texture_2d();\n', 'nv20')
        expected = self.picture('same.fp', '!!ARBfp1.0\n' + PANEL + 'TEMP t;\n'
                                'TEX t, fragment.texcoord[0], texture[0], 2D;\n'
                                'MUL result.color, t, fragment.color;\nEND\n', 'host')
        worst = max(abs(a - b) for row, other in zip(drawn[2], expected[2]) for a, b in zip(row, other))
        self.assertLessEqual(worst, 1)

    def test_errors_name_the_place(self):
        path = self.write('three.nvrc', THREE)
        result = self.run_command('draw', '--profile', 'nv10', path, '-o', self.folder / 'out.png', code=2)
        self.assertIn('three.nvrc:4:1: error: more than 2 general stages', result.stderr)

    def test_debugged(self):
        path = self.write('own.nvrc', COMBINES)
        result = self.run_command('debug', path, '--profile', 'host', '--pixel', '5,3', '--json')
        trace = json.loads(result.stdout)
        self.assertTrue(trace['verdict']['equal'])
        self.assertEqual(trace['parameters'][0]['value'], [0.5, 0.25, 0.75, 1])


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
