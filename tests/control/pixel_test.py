#!/usr/bin/env python3
"""Tests the inspection of pixels of a running client's frame: which draw gives them their color, what its program
computes there, and what each program costs. Also tests requests that wait while GL is busy.

usage: pixel_test.py ARBITER TICKER PAINTER [unittest arguments]
"""
import json
import random
import time

import controlled
from controlled import Painting, Raw

WIDTH, HEIGHT = 200, 120  # of PAINTER's window


class Pixels(Painting):
    """PAINTER draws one quad a frame: white texels, times program.env[3], times program.local[0]."""
    CASES = ((), ('--backend', 'host'), ('--backend', 'swrast'))

    def trace(self, *words, code=0):
        return json.loads(self.ctl('--json', 'trace', *words, code=code).stdout)

    def test_a_pixel_is_traced_and_nothing_changes(self):
        for options in self.CASES:
            with self.subTest(options=options), self.painting(options=('--control', *options)) as output:
                self.assertTrue(output.waits_for('middle 255 255 0'))
                found = self.trace('100,60')
                self.assertEqual(found['file'], self.effective())
                self.assertEqual([row['opcode'] for row in found['rows']], ['TEX', 'MUL', 'MUL'])
                self.assertEqual(found['rows'][0]['value'], [1, 1, 1, 1])
                self.assertEqual(found['rows'][2]['value'], [1, 1, 0, 1])
                self.assertEqual(found['rows'][0]['texel']['unit'], 0)
                coordinate = found['rows'][0]['texel']['coordinate']
                self.assertAlmostEqual(coordinate[0], 100.5 / WIDTH, 5)
                self.assertAlmostEqual(coordinate[1], 60.5 / HEIGHT, 5)
                inputs = {each['name']: each['value'] for each in found['parameters']}
                self.assertEqual(inputs['program.local[0]'], [1, 1, 0, 1])
                self.assertTrue(found['verdict']['equal'], found['verdict']['line'])
                self.assertEqual(found['text'].split()[0], '!!ARBfp1.0')
                self.assertEqual([draw['draw'] for draw in found['draws']], [1])
                with self.holding('param', self.effective(), 'program.env[3]=0.5,1,1,1'):
                    self.assertTrue(output.waits_for('middle 128 255 0'))
                    self.assertEqual(self.trace('0,0')['rows'][1]['value'], [0.5, 1, 1, 1])
                self.assertTrue(output.waits_for('middle 255 255 0'))
                self.unchanged(output)

    def test_depth_and_scissor_say_which_draw_is_seen(self):
        for options in self.CASES:
            with self.subTest(options=options), \
                    self.painting('-1', 'depth', options=('--control', *options)) as output:
                self.assertTrue(output.waits_for('middle 255 255 0'))
                left = json.loads(self.ctl('--json', 'pick', '20,60').stdout)
                self.assertEqual([draw['draw'] for draw in left['draws']], [1, 2])
                self.assertEqual([draw['color'] for draw in left['draws']], [[1, 0, 0, 1], [1, 1, 0, 1]])
                self.assertEqual([draw['command'] for draw in left['draws']], ['glDrawArrays', 'glDrawElements'])
                self.assertEqual(left['count'], 3)
                found = self.trace('180,60')
                self.assertEqual([draw['draw'] for draw in found['draws']], [2])
                self.assertEqual(found['rows'][-1]['value'], [1, 1, 0, 1])
                hidden = self.trace('20,60', '1')
                self.assertEqual(hidden['rows'][-1]['value'], [1, 0, 0, 1])
                measured = json.loads(self.ctl('--json', 'measure').stdout)
                self.assertEqual([draw['pixels'] for draw in measured['draws']],
                                 [WIDTH // 2 * HEIGHT, WIDTH * HEIGHT, 0])
                self.unchanged(output)

    def test_an_edit_is_what_is_traced(self):
        text = self.folder / 'mine.fp'
        text.write_text('!!ARBfp1.0\nTEMP a;\nADD a, fragment.position, 0.25;\n'
                        'RCP a.w, program.env[3].x;\nMUL result.color, a, {0.001, 0.001, 0, 1};\nEND\n')
        with self.painting() as output:
            self.assertTrue(output.waits_for('middle 255 255 0'))
            with self.holding('set', self.effective(), text):
                self.assertFalse(output.waits_for('', 0.5))
                found = self.trace('199,119')
                self.assertEqual(found['rows'][0]['value'][:2], [199.75, 119.75])
                self.assertEqual(found['text'], text.read_text())
            self.assertTrue(output.waits_for('middle 255 255 0'))
            self.unchanged(output)

    def test_what_cannot_be_traced_is_said(self):
        with self.painting() as output:
            self.assertTrue(output.waits_for('middle 255 255 0'))
            self.assertIn('from 0 to 199', self.ctl('trace', '200,0', code=1).stderr)
            self.assertIn('draws with programs that write it: 1', self.ctl('trace', '5,5', '7', code=1).stderr)
            self.assertIn('X,Y', self.ctl('trace', '5', code=1).stderr)
            with self.holding('disable', self.effective()):
                self.assertTrue(output.waits_for('middle 0 0 255'))
                self.assertIn('by fixed function', self.ctl('trace', '5,5', code=1).stderr)
            with Raw(self.socket_of(output)) as raw:
                self.assertEqual(raw.call('pixel.draw', text='!!ARBfp1.0\nEND\n')['error']['code'], -32004)
                late = raw.call('pixel.hold', x=1, y=1, draw=9)['error']
                self.assertIn('the frame had 1 draws', late['message'])

    def test_a_held_draw_goes_on_without_its_client(self):
        with self.painting() as output:
            self.assertTrue(output.waits_for('middle 255 255 0'))
            path = self.socket_of(output)
            with Raw(path) as raw:
                held = raw.call('pixel.hold', x=3, y=4, draw=1)['result']
                self.assertEqual((held['width'], held['height']), (WIDTH, HEIGHT))
                frames = raw.call('ping')['result']['frames']
                wrong = raw.call('pixel.draw', text='!!ARBfp1.0\nMOV x, y;\nEND\n', x=3, y=4)['error']
                self.assertIn('is not declared', wrong['message'])
                values = raw.call('pixel.draw', x=3, y=4, width=2, height=2, targets=1,
                                  text='!!ARBfp1.0\nMOV result.color, fragment.position;\nEND\n')['result']
                self.assertEqual(len(values['values']), 88)  # base64 of 64 bytes
                self.assertEqual(raw.call('ping')['result']['frames'], frames, 'the draw is not held')
            self.goes_on(path)  # the client has disconnected
            with Raw(path) as raw:
                raw.call('pixel.hold', x=3, y=4, draw=1)
                self.goes_on(path)  # it requests nothing
                self.assertIn('no draw is held', raw.call('pixel.draw')['error']['message'])
            self.unchanged(output)

    def goes_on(self, path):
        with Raw(path) as raw:
            frames = raw.call('ping')['result']['frames']
            end = time.monotonic() + controlled.PATIENCE
            while raw.call('ping')['result']['frames'] < frames + 2:
                self.assertLess(time.monotonic(), end, 'the application stays where it was held')
                time.sleep(0.05)

    def test_a_frame_is_measured(self):
        for options in self.CASES:
            with self.subTest(options=options), self.painting(options=('--control', *options)) as output:
                self.assertTrue(output.waits_for('middle 255 255 0'))
                program = self.effective()
                measured = json.loads(self.ctl('--json', 'measure').stdout)
                cost = measured['programs'][program]
                self.assertEqual((cost['draws'], cost['pixels']), (1, WIDTH * HEIGHT))
                self.assertGreater(cost['milliseconds'], 0)
                self.assertEqual(measured['draws'][0]['fragment'], program)
                self.assertIn(program, self.ctl('measure').stdout)
                given = json.loads(self.ctl('stats').stdout)['software']['given_to_host']
                self.assertNotIn('query', given, 'no query of the application counts')
                if 'swrast' in options:
                    self.assertEqual(given, {'observed': 2})
                self.unchanged(output)


class Busy(Painting):
    @staticmethod
    def slow_text(turns):
        """Returns a program that takes the host's compiler longer the more turns it has.

        No other run has its text: the host stores compiled programs on disk, and would be done at once.
        """
        own = ', '.join(f'{0.5 + random.random():.6f}' for _ in range(4))
        lines = ''.join(f'POW a.{c}, a.{d}, a.{e};\nMAD a, a, a.{d}{e}{c}w, b.{c};\n'
                        for _ in range(turns) for c, d, e in ('xyz', 'yzx', 'zxy'))
        head = f'!!ARBfp1.0\nTEMP a, b;\nMUL a, fragment.position, {{{own}}};\nMOV b, a;\n'
        return f'{head}{lines}MOV result.color, a;\nEND\n'

    def lines_until_listed(self, raw):
        """Returns what comes until the answer to a list requested now, with a ping behind it; milliseconds."""
        started = time.monotonic()
        raw.send(b'{"jsonrpc":"2.0","id":"list","method":"program.list"}\n')
        raw.send(b'{"jsonrpc":"2.0","id":"ping","method":"ping"}\n')
        seen = []
        while not {'list', 'ping'} <= {line.get('id') for line in seen}:
            seen.append(raw.line())
        return seen, (time.monotonic() - started) * 1000

    def test_requests_that_wait_are_told_of(self):
        """While GL compiles for long, a client that waits for an answer is told so, and ping is answered."""
        options = ('--control', '--backend', 'host', '--profile', 'host')
        with self.painting(options=options) as output:
            self.assertTrue(output.waits_for('middle 255 255 0'))
            with Raw(self.socket_of(output)) as raw:
                program = next(row['id'] for row in raw.call('program.list')['result']['programs']
                               if row['effective'])
                for turns in (int(60 * 1.4 ** step) for step in range(12)):  # until it takes long enough here
                    answer = raw.call('program.set', id=program, text=self.slow_text(turns), revision=turns)
                    self.assertTrue(answer['result']['ok'], answer)
                    seen, waited = self.lines_until_listed(raw)
                    if waited > 150:
                        break
                busy = [line['params']['milliseconds'] for line in seen if line.get('method') == 'busy']
                self.assertGreater(waited, 150, 'the text is compiled too fast for this test')
                self.assertTrue(busy, f'nothing was said for {waited:.0f} ms')
                self.assertGreaterEqual(busy[0], 100)
                self.assertEqual(busy, sorted(busy))
                self.assertEqual(seen[0].get('id'), 'ping', 'ping waits for GL')
            self.assertTrue(output.waits_for('middle 255 255 0'), 'the own text is not back')


if __name__ == '__main__':
    controlled.main()
