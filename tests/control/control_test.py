#!/usr/bin/env python3
"""Tests that programs of unmodified clients can be inspected and changed while they run, through `arbiter ctl` and
through the socket itself.

usage: control_test.py ARBITER TICKER PAINTER [unittest arguments]
"""
import json
import shutil
import subprocess
import time
import unittest
import zlib

import controlled
from controlled import ARBITER, PATIENCE, RED, TICKER, WRONG, Controlled, Painting, Raw, pixels, plain


class Edits(Controlled):
    """TICKER draws green with local parameters that it sets around each draw, and complains if its queries return
    anything
    but its own program."""

    def test_a_text_is_drawn_with_until_it_is_let_go(self):
        text = self.folder / 'mine.fp'
        text.write_text(RED)
        with self.running(TICKER) as output:
            self.assertTrue(output.waits_for('0 255 0'))
            program = self.effective()
            self.assertRegex(program, r'^[0-9a-f]{32}\.fp$')
            self.assertIn('program.local[0].yyyy', self.ctl('get', program).stdout)
            line, = (row for row in self.ctl('programs').stdout.splitlines() if row.startswith(program))
            self.assertGreater(int(line.split()[4]), 0, 'it draws all the time')
            with self.holding('set', program, text):
                self.assertTrue(output.waits_for('255 0 0'), 'the text is not drawn with')
                self.assertEqual([row['edited'] for row in self.programs() if row['id'] == program],
                                 [True])
                text.write_text(RED.replace('{1, 0, 0, 1}', '{0, 0, 1, 1}'))
                self.assertTrue(output.waits_for('0 0 255'), 'the changed file is not drawn with')
                text.write_text(WRONG)
                self.assertFalse(output.waits_for('0 255 0', 1), 'a wrong text changes something')
                second = self.ctl('set', program, text, code=1).stderr
                self.assertRegex(second, r'process \d+ changes things here already')
            self.assertTrue(output.waits_for('0 255 0'), 'the own text is not back')
            self.assertNotIn('unlike what was loaded', output.seen)

    def test_a_wrong_text_is_diagnosed(self):
        text = self.folder / 'mine.fp'
        text.write_text(WRONG)
        with self.running(TICKER) as output:
            self.assertTrue(output.waits_for('0 255 0'))
            error = self.ctl('set', self.effective(), text, code=2).stderr
            self.assertIn(f'{text}:2:19: error: ', error)
            text.write_text('# A material.\n!!ARBvp1.0\nEND\n\n' + WRONG)
            error = self.ctl('set', self.effective(), text, code=2).stderr
            self.assertIn(f'{text}:6:19: error: ', error)
            self.assertFalse(output.waits_for('', 0.3))

    def test_parameters_are_held(self):
        with self.running(TICKER) as output:
            self.assertTrue(output.waits_for('0 255 0'))
            program = self.effective()
            with self.holding('param', program, 'program.local[0]=0,1,0,0'):
                self.assertTrue(output.waits_for('255 255 255'), 'the value is not drawn with')
                rows = json.loads(self.ctl('--json', 'params', program).stdout)['parameters']
                row = next(row for row in rows if row['name'] == 'program.local[0]')
                self.assertEqual((row['held'], row['value']), (True, [0, 1, 0, 0]))
            self.assertTrue(output.waits_for('0 255 0'), 'the own value is not back')
            for wrong in ('program.local[9999]=1', 'state.fog.color=1', 'program.local[0]=x'):
                self.ctl('param', program, wrong, code=1)

    def test_the_other_languages(self):
        texts = {'vertex': '!!ARBvp1.0\nMOV result.position, vertex.position;\n'
                           'MOV result.color, {1, 0, 0, 1};\nEND\n',
                 'ati': '!!ATIfs1.0\nStartConstants; CONSTANT c0 = {1.0, 0.0, 0.0, 1.0}; '
                        'EndConstants;\nStartOutputPass; MOV r0, c0; EndPass;\n'}
        for kind, red in texts.items():
            with self.subTest(kind=kind), self.running(TICKER, kind) as output:
                self.assertTrue(output.waits_for('0 255 0'))
                text = self.folder / 'mine'
                text.write_text(red)
                with self.holding('set', self.effective(), text):
                    self.assertTrue(output.waits_for('255 0 0'))
                self.assertTrue(output.waits_for('0 255 0'))

    def test_a_client_that_is_killed_leaves_nothing(self):
        text = self.folder / 'mine.fp'
        text.write_text(RED)
        with self.running(TICKER) as output:
            self.assertTrue(output.waits_for('0 255 0'))
            with self.holding('set', self.effective(), text) as client:
                self.assertTrue(output.waits_for('255 0 0'))
                client.kill()
                self.assertTrue(output.waits_for('0 255 0'))

    def test_programs_that_change_before_each_draw(self):
        text = self.folder / 'mine.fp'
        text.write_text(RED)
        for backend in ('host', 'swrast'):  # a change takes the need to watch back
            changing = [ARBITER, 'draw', '--bare', '--frames', '1000000', '-o', self.folder / 'a.png', text]
            with self.subTest(backend=backend), \
                    self.running(*changing, options=('--control', '--backend', backend)) as output:
                self.socket_of(output)
                self.assertEqual(len(self.programs()), 1)

    def test_a_folder_of_replacements_is_exported(self):
        patches = self.folder / 'patches'
        with self.running(TICKER) as output:
            self.assertTrue(output.waits_for('0 255 0'))
            program = self.effective()
            text = self.folder / 'mine.fp'
            text.write_text(RED)
            with self.holding('set', program, text):
                self.assertTrue(output.waits_for('255 0 0'))
                self.ctl('export', patches)
        self.assertEqual((patches / program).read_text(), RED)
        result = subprocess.run([ARBITER, 'run', '--replace', patches, '--', TICKER, 'fragment', '1'],
                                env=self.environment, capture_output=True, timeout=PATIENCE)
        self.assertEqual(result.stdout, b'255 0 0\n')
        with self.running(TICKER) as output:  # bytes that are not UTF-8 arrive unchanged
            self.assertTrue(output.waits_for('0 255 0'))
            self.ctl('export', self.folder / 'own')
        self.assertIn(b'caf\xe9', (self.folder / 'own' / program).read_bytes())


class Windows(Painting):
    """PAINTER draws yellow: white texels times (1, 1, 0)."""
    # Options of the layer, and of PAINTER.
    CASES = (((), ()), (('--backend', 'host'), ('-1', 'fbo')))

    def test_frames_and_textures(self):
        for more, words in self.CASES:
            with self.subTest(options=more, words=words), \
                    self.painting(*words, options=('--control', *more)) as output:
                self.assertTrue(output.waits_for('middle 255 255 0'))
                self.look_and_paint(output)

    def look_and_paint(self, output):
        png, mine = self.folder / 'frame.png', self.folder / 'mine.png'
        self.ctl('frame', '-o', png)
        size, rows = pixels(png)
        self.assertEqual(size, (200, 120))
        self.assertEqual(rows[60][400:404], b'\xff\xff\0\xff')
        rows = json.loads(self.ctl('--json', 'textures').stdout)['textures']
        row = next(row for row in rows if row['name'] == 5)
        self.assertEqual((row['unit'], row['target'], row['width'], row['height'], row['format']),
                         (0, '2D', 16, 16, 'RGBA8'))
        self.ctl('texture', '5', '-o', mine)
        size, rows = pixels(mine)
        self.assertEqual((size, set(rows)), ((16, 16), {b'\xff' * 64}))
        self.ctl('frame', '-o', png)
        with self.holding('paint', '5', green_picture(self.folder / 'green.png')):
            self.assertTrue(output.waits_for('middle 0 255 0'), 'the picture is not drawn with')
        self.assertTrue(output.waits_for('middle 255 255 0'), "the texture's own is not back")
        with self.holding('param', self.effective(), 'program.env[3]=0,1,1,1'):
            self.assertTrue(output.waits_for('middle 0 255 0'))
        self.assertTrue(output.waits_for('middle 255 255 0'))
        with self.holding('disable', self.effective()):  # texturing is not enabled: blue
            self.assertTrue(output.waits_for('middle 0 0 255'))
        self.assertTrue(output.waits_for('middle 255 255 0'))
        stats = json.loads(self.ctl('stats').stdout)
        self.assertGreater(stats['frames'], 0)
        self.assertGreater(sum(stats['draws'].values()), 0)
        self.unchanged(output)

    def test_a_slot_is_lent_until_it_is_released(self):
        with self.painting() as output:
            self.assertTrue(output.waits_for('middle 255 255 0'))
            with Raw(self.socket_of(output)) as raw:
                for wrong in ({'serial': 1}, {'slot': 3}, {'slot': 0, 'serial': 'x'}):
                    self.assertEqual(raw.call('frame.release', **wrong)['error']['code'], -32602, wrong)
                raw.send(b'{"jsonrpc": "2.0", "method": "frame.want", "params": {"width": 20, "height": 12}}\n')
                lent = self.lent(raw, 3)
                self.assertEqual(sorted(lent), [0, 1, 2])
                release = {'jsonrpc': '2.0', 'method': 'frame.release', 'params': {'slot': lent[1]}}
                raw.send(json.dumps(release).encode() + b'\n')  # without a serial: of the newest buffer
                self.assertEqual(self.lent(raw, 1), [lent[1]])

    @staticmethod
    def lent(raw, count):
        """Returns the slots of the next frames."""
        slots = []
        while len(slots) < count:
            line = raw.line()
            if line.get('method') == 'frame':
                slots.append(line['params']['slot'])
        return slots

    def test_the_beginning_of_an_id_is_enough(self):
        with self.painting() as output:
            self.assertTrue(output.waits_for('middle 255 255 0'))
            ids = [row['id'] for row in json.loads(self.ctl('--json', 'programs').stdout)['programs']]
            whole = self.effective()
            text = self.ctl('get', whole).stdout
            short = next(whole[:n] for n in range(1, 32) if sum(id.startswith(whole[:n]) for id in ids) == 1)
            ending = whole[whole.index('.'):]
            for word in (short, whole[:32], short + ending):
                self.assertEqual(self.ctl('get', word).stdout, text, word)
            with self.holding('param', short, 'program.env[3]=0,1,1,1'):
                self.assertTrue(output.waits_for('middle 0 255 0'))
            for word in ('xyz', short + '.none', ending):
                self.assertIn(f'there is no program {word} (arbiter ctl programs)',
                              self.ctl('get', word, code=1).stderr)

    def test_textures_look_as_samplers_see_them(self):
        seen = {11: [64, 64, 64, 255], 12: [64, 64, 64, 8], 13: [64, 64, 64, 64], 14: [0, 0, 0, 8],
                15: [64, 32, 16, 255], 0: [64, 64, 64, 255]}
        png = self.folder / 'texture.png'
        for more, words in self.CASES:
            with self.subTest(options=more, words=words), \
                    self.painting(*words, options=('--control', *more)) as output:
                self.assertTrue(output.waits_for('middle 255 255 0'))
                rows = json.loads(self.ctl('--json', 'textures').stdout)['textures']
                # It is listed without a name, on every unit that has no other texture.
                self.assertEqual([(row['unit'], row['target'], row['width'], row['format'])
                                  for row in rows if row['name'] == 0], [(1, '2D', 2, 'LUMINANCE')])
                for name, colour in seen.items():
                    self.ctl('texture', str(name), '-o', png)
                    self.assertEqual(list(pixels(png)[1][0][:4]), colour, name)
                self.ctl('texture', '0:2D', '-o', png)
                self.ctl('texture', '0:3D', '-o', png, code=1)
                green = green_picture(self.folder / 'green.png', 2)
                lines = f'paint 0 {green}\ntexture 0 {png}\n'
                self.ctl('-', feed=lines)
                self.assertEqual(list(pixels(png)[1][0][:4]), [0, 0, 0, 255])
                self.ctl('texture', '0', '-o', png)
                self.assertEqual(list(pixels(png)[1][0][:4]), seen[0], 'the own image is not back')
                self.unchanged(output)

    def test_actions_by_lines(self):
        png = self.folder / 'frame.png'
        text = self.folder / 'mine.fp'
        text.write_text(RED)
        with self.painting() as output:
            self.assertTrue(output.waits_for('middle 255 255 0'))
            lines = f'# a script\nset {self.effective()} {text}\nwait 0.3\nframe -o {png}\n'
            self.ctl('-', feed=lines)
            self.assertEqual(pixels(png)[1][60][400:404], b'\xff\0\0\xff')

    def test_figures_are_in_the_frame(self):
        for more, words in self.CASES:
            with self.subTest(options=more, words=words), \
                    self.painting(*words, options=('--hud=version,host,fps,graph,draws', *more)) as output:
                self.assertTrue(output.waits_for('middle 255 255 0'))
                end, counts = time.monotonic() + PATIENCE, []
                while time.monotonic() < end and not (counts and counts[-1] > 1000):
                    output.waits_for('', 0.1)
                    counts = [int(line.split()[1]) for line in output.seen
                              if line.startswith('shown')]
                self.assertGreater(counts[-1], 1000, 'no figures')
                self.unchanged(output)
        with self.painting(options=()) as output:
            self.assertTrue(output.waits_for('shown 0'), 'without --hud there are none')

    def counts_reach(self, output, words, is_enough):
        """Waits until the client counts that many pixels behind these words."""
        end, last = time.monotonic() + PATIENCE, None
        while time.monotonic() < end:
            output.waits_for('', 0.1)
            counts = [int(line.split()[-1]) for line in output.seen if line.startswith(words)]
            last = counts[-1] if counts else None
            if last is not None and is_enough(last):
                return True
        return False

    def test_figures_leave_a_small_window_visible(self):
        for more, words in self.CASES:
            with self.subTest(options=more, words=words), \
                    self.painting(*words, options=('--hud=top-right', *more)) as output:
                self.assertTrue(self.counts_reach(output, 'upper right', lambda count: 500 < count < 2500))
                self.assertTrue(self.counts_reach(output, 'shown', lambda count: count == 0))

    def test_figures_stand_in_the_corner_that_is_asked_for(self):
        for more, words in self.CASES:
            with self.subTest(options=more, words=words), \
                    self.painting(*words, options=('--hud=draws,programs,top-right', *more)) as output:
                self.assertTrue(self.counts_reach(output, 'upper right', lambda count: count > 1000))
                self.assertTrue(self.counts_reach(output, 'shown', lambda count: count == 0))
                self.unchanged(output)

    @unittest.skipUnless(shutil.which('xdotool'), 'not installed: xdotool, which presses the key')
    def test_a_key_shows_and_hides_the_figures(self):
        with self.painting(options=('--hud=draws,programs,bottom-left,hidden,key=ctrl+F7',)) as output:
            self.assertTrue(self.counts_reach(output, 'shown', lambda count: count == 0))
            for is_enough in (lambda count: count > 1000, lambda count: count == 0):
                self.press('ctrl+F7')
                self.assertTrue(self.counts_reach(output, 'shown', is_enough))
            self.unchanged(output)

    def press(self, key):
        for action in ('keydown', 'keyup'):
            subprocess.run(['xdotool', action, key], check=True, env=plain(DISPLAY=self.display))
            time.sleep(0.2)

    @unittest.skipUnless(shutil.which('xdotool') and shutil.which('xkbcomp'),
                         'not installed: xdotool, which presses the key, or xkbcomp')
    def test_the_key_follows_another_layout(self):
        layout = subprocess.run(['xkbcomp', '-xkb', self.display, '-'], check=True, capture_output=True,
                                text=True).stdout
        other = layout.replace('key <FK07>', 'key <FK00>').replace('key <FK08>', 'key <FK07>')
        other = other.replace('key <FK00>', 'key <FK08>')
        self.assertNotEqual(other, layout)
        with self.painting(options=('--hud=draws,programs,bottom-left,hidden,key=F7',)) as output:
            self.assertTrue(self.counts_reach(output, 'shown', lambda count: count == 0))
            self.addCleanup(subprocess.run, ['xkbcomp', '-', self.display], input=layout, text=True,
                            capture_output=True)
            subprocess.run(['xkbcomp', '-', self.display], input=other, check=True, text=True,
                           capture_output=True)
            self.press('F7')
            self.assertTrue(self.counts_reach(output, 'shown', lambda count: count > 1000))

    def test_words_for_figures_are_checked(self):
        run = subprocess.run([ARBITER, 'run', '--hud=fsp', '--', 'true'], capture_output=True, text=True)
        self.assertEqual(run.returncode, 125)
        self.assertIn('did you mean fps?', run.stderr)


def green_picture(path, side=16):
    """Writes a square PNG whose every pixel is green."""
    def chunk(kind, data):
        return (len(data).to_bytes(4, 'big') + kind + data +
                zlib.crc32(kind + data).to_bytes(4, 'big'))
    head = side.to_bytes(4, 'big') * 2 + b'\x08\x06\0\0\0'
    rows = zlib.compress((b'\0' + b'\0\xff\0\xff' * side) * side)
    path.write_bytes(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head) + chunk(b'IDAT', rows) +
                     chunk(b'IEND', b''))
    return path


if __name__ == '__main__':
    controlled.main()
