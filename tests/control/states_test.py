#!/usr/bin/env python3
"""Tests state that the layer turns into programs, in running clients: register combiners, texture shaders, and shaders
made by ATI_fragment_shader's commands are listed, shown, replaced and disabled through `arbiter ctl`.

usage: states_test.py ARBITER STATE_TICKER PAINTER [unittest arguments]
STATE_TICKER draws green by its state, and complains if its queries return anything else
(tests/capture/state_ticker.cpp).
"""
import subprocess

import controlled
from controlled import ARBITER, PATIENCE, TICKER, Controlled

# For each kind: its card, how many objects hold it, the ending of its text's file, the beginning of its text, a red
# replacement, and the color without it: fixed function's white, or that of combiners behind a unit without a texture.
KINDS = {
    'combiners': ('nv25', 0, '.nvrc', '!!RC1.0\n{\n  rgb {\n    spare0 = const0;\n',
                  '!!RC1.0\nconst0 = (1, 0, 0, 1);\nout.rgb = const0;\n', '255 255 255'),
    'texture_shaders': ('nv25', 0, '.nvts', '!!TS1.0\npass_through();\n',
                        '!!TS1.0\npass_through();\n!!RC1.0\nconst0 = (1, 0, 0, 1);\n'
                        '{ rgb { spare0 = unsigned_invert(tex0); } }\nout.rgb = const0 * spare0;\n', '0 0 0'),
    'ati_fragment_api': ('r300', 1, '.atifs', '!!ATIfs1.0\nStartConstants;\n  CONSTANT c0 = program.env[0];\n',
                         '!!ATIfs1.0\nStartConstants; CONSTANT c0 = {1, 0, 0, 1}; EndConstants;\n'
                         'StartOutputPass;\nMOV r0, c0;\nEndPass;\n', '255 255 255'),
}


class States(Controlled):
    def each_kind(self):
        for kind, (card, objects, extension, begins, red, without) in KINDS.items():
            self.card, self.objects = ('--profile', card), objects
            with self.subTest(kind=kind), self.running(TICKER, kind, options=('--control', *self.card)) as output:
                self.assertTrue(output.waits_for('0 255 0'))
                row, = self.programs()
                self.assertTrue(row['id'].endswith(extension), row)
                self.assertEqual(row['target'], kind)
                yield row, output, begins, red, without
                self.assertNotIn('unlike what was set', output.seen)

    def test_they_are_listed_and_shown(self):
        for row, output, begins, _, _ in self.each_kind():
            self.assertEqual([row[name] for name in ('objects', 'bound', 'effective', 'edited', 'enabled')],
                             [self.objects, True, True, False, True])
            self.assertEqual(row['counts']['alu_instructions'], 1)
            self.assertGreater(row['draws'], 0, row)
            text = self.ctl('get', row['id']).stdout
            self.assertTrue(text.startswith(begins), text)
            (self.folder / row['id']).write_text(text)
            checked = subprocess.run([ARBITER, 'check', *self.card, self.folder / row['id']], env=self.environment,
                                     capture_output=True, timeout=PATIENCE)
            self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)
            self.assertIn(row['id'], self.ctl('programs').stdout)
            self.assertEqual(self.ctl('params', row['id']).stdout.count('program.'), 0)
            self.ctl('get', row['id'][1:], code=1)

    def test_a_text_is_drawn_with_until_it_is_let_go(self):
        for row, output, _, red, _ in self.each_kind():
            mine = self.folder / 'mine'
            mine.write_text(red)
            with self.holding('set', row['id'], mine):
                self.assertTrue(output.waits_for('255 0 0'), 'the text is not drawn with')
                now, = self.programs()
                self.assertEqual((now['id'], now['edited'], now['effective']), (row['id'], True, True))
                mine.write_text(red.replace('1, 0, 0, 1', '1, 0, 1, 1'))
                self.assertTrue(output.waits_for('255 0 255'), 'the changed file is not drawn with')
                self.assertGreater(self.programs()[0]['draws'], 0)
            self.assertTrue(output.waits_for('0 255 0'), 'the own state is not back')
            self.assertFalse(self.programs()[0]['edited'])

    def test_a_wrong_text_changes_nothing(self):
        for row, output, _, red, _ in self.each_kind():
            mine = self.folder / 'mine'
            mine.write_text(red + 'nothing();\n')
            self.assertIn(f'{mine}:', self.ctl('set', row['id'], mine, code=2).stderr)
            self.assertFalse(output.waits_for('', 0.3))
            self.assertFalse(self.programs()[0]['edited'])

    def test_they_are_switched_off(self):
        for row, output, _, _, without in self.each_kind():
            with self.holding('disable', row['id']):
                self.assertTrue(output.waits_for(without), 'it is drawn with')
                now = next(each for each in self.programs() if each['id'] == row['id'])
                self.assertEqual((now['enabled'], now['effective']), (False, False))
            self.assertTrue(output.waits_for('0 255 0'), 'it is not drawn with again')

    def test_a_folder_of_replacements_is_exported(self):
        for row, output, _, red, _ in self.each_kind():
            mine, patches = self.folder / 'mine', self.folder / row['target']
            mine.write_text(red)
            with self.holding('set', row['id'], mine):
                self.assertTrue(output.waits_for('255 0 0'))
                self.ctl('export', patches)
            self.assertEqual((patches / row['id']).read_text(), red)
            command = [ARBITER, 'run', *self.card, '--replace', patches, '--', TICKER, row['target'], '1']
            result = subprocess.run(command, env=self.environment, capture_output=True, timeout=PATIENCE)
            self.assertEqual(result.stdout, b'255 0 0\n')


if __name__ == '__main__':
    controlled.main()
