#!/usr/bin/env python3
"""Tests the inspection of frames, with a client that does one thing at a time: which draws a frame consists of,
contexts
that are destroyed, threads that continue, and signals that come meanwhile.

usage: step_test.py ARBITER TICKER STEPPER [unittest arguments]
"""
import base64
import contextlib
import json
import struct
import subprocess
import time

import controlled
from controlled import ARBITER, PAINTER, PATIENCE, Controlled, Output, Raw, XServer

STEPPER = PAINTER
WIDTH, HEIGHT = 200, 120  # of STEPPER's windows
SHOWN = '!!ARBfp1.0\nMOV result.color, fragment.position;\nEND\n'


class Steps:
    """Runs STEPPER and gives it commands."""

    def __init__(self, test, process, path):
        self.test, self.output, self.process, self.path = test, Output(process), process, path

    def send(self, *words, worker=0):
        self.process.stdin.write((' '.join((str(worker), *words)) + '\n').encode())
        self.process.stdin.flush()

    def waits_for(self, text, worker=0):
        self.test.assertTrue(self.output.waits_for(f'{worker} {text}'), f'{worker} {text}: {self.output.seen[-5:]}')

    def do(self, *words, worker=0):
        self.send(*words, worker=worker)
        self.waits_for('done', worker)

    def frames(self, scene='quad', count=2, worker=0):
        for _ in range(count):
            self.do('frame', scene, worker=worker)

    def until(self, process, scene):
        """Requests frames until a process has ended; returns its output."""
        end = time.monotonic() + 2 * PATIENCE
        while process.poll() is None and time.monotonic() < end:
            self.do('frame', scene)
        out, err = process.communicate(timeout=1)
        return process.returncode, out.decode(), err.decode()

    def unchanged(self):
        self.test.assertEqual([line for line in self.output.seen if line[2:].startswith(('state', 'error'))], [])


class Asking(Raw):
    """Sends requests whose answers come later."""

    def post(self, method, **params):
        """Sends a request that waits in the application; returns its number."""
        self.last += 1
        number = self.last
        self.send(json.dumps({'jsonrpc': '2.0', 'id': number, 'method': method, 'params': params}).encode() + b'\n')
        assert 'result' in self.call('ping')  # answered in order
        return number

    def answer(self, number):
        while True:
            line = self.line()
            if line is None or line.get('id') == number:
                return line

    def values(self, **params):
        """Returns the rows of four of pixel.draw."""
        answer = self.call('pixel.draw', **params)
        data = base64.b64decode(answer['result']['values'])
        floats = struct.unpack(f'{len(data) // 4}f', data)
        return [floats[i:i + 4] for i in range(0, len(floats), 4)]


class Stepping(Controlled):
    @classmethod
    def setUpClass(cls):
        server = XServer()
        cls.display = server.__enter__()
        cls.addClassCleanup(server.__exit__)

    @contextlib.contextmanager
    def stepping(self, *options, workers=1):
        process = subprocess.Popen(
            [ARBITER, 'run', '--control', *options, '--', STEPPER], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            env={**self.environment, 'DISPLAY': self.display})
        try:
            steps = Steps(self, process, self.folder / 'arbiter' / f'{process.pid}.sock')
            for worker in range(workers):
                steps.frames(worker=worker)
            yield steps
            steps.unchanged()
        finally:
            process.kill()
            process.wait()
            process.stdin.close()
            process.stdout.close()

    def picked(self, steps, raw, scene, x=100, y=60, **more):
        number = raw.post('pixel.pick', x=x, y=y, **more)
        steps.frames(scene)
        answer = raw.answer(number)
        self.assertIn('result', answer)
        return answer['result']

    def held(self, steps, raw, x=100, y=60, draw=1, scene='quad', **more):
        """Returns the answer; the application waits before that draw."""
        number = raw.post('pixel.hold', x=x, y=y, draw=draw, **more)
        steps.do('frame', scene)
        steps.send('frame', scene)
        answer = raw.answer(number)
        self.assertIn('result', answer)
        return answer['result']

    def released(self, steps, raw):
        self.assertEqual(raw.call('pixel.release')['result'], {})
        steps.waits_for('done')


class Traced(Stepping):
    """Tests what counts as a draw."""
    CASES = ((), ('--backend', 'host'), ('--backend', 'swrast'))

    def each(self, scene, look, cases=CASES):
        for options in cases:
            with self.subTest(options=options, scene=scene), self.stepping(*options) as steps, \
                    Asking(steps.path) as raw:
                steps.frames(scene, 4)
                look(steps, raw)

    def test_lists_of_vertices_are_draws(self):
        def look(steps, raw):
            found = self.picked(steps, raw, scene)
            self.assertEqual([(draw['draw'], draw['command'], draw['color']) for draw in found['draws']],
                             [(1, 'glCallList', [1, 1, 0, 1])], found)
            self.assertEqual((found['count'], found['lists']), (1, 0))
            self.assertRegex(found['draws'][0]['fragment'], r'^[0-9a-f]+\.fp$')
            self.held(steps, raw, scene=scene)
            self.assertEqual(raw.values(text=SHOWN, x=100, y=60)[0][:2], (100.5, 60.5))
            self.released(steps, raw)
            self.assertEqual(steps.output.seen[-2:], ['0 middle 255 255 0', '0 done'])
        for scene in ('list', 'early', 'executed'):
            self.each(scene, look, ((), ('--backend', 'swrast')))

    def test_lists_of_anything_are_counted(self):
        def look(steps, raw):
            found = self.picked(steps, raw, scene)
            self.assertEqual((found['draws'], found['count']), ([], 0))
            self.assertGreater(found['lists'], 0)
            code, _, said = steps.until(self.client('trace', '5,5'), scene)
            self.assertEqual(code, 1)
            self.assertRegex(said, r'what [1-9]\d* calls of display lists draw is not known')
        for scene in ('list', 'early', 'executed'):  # without the rasterizer none of them is recorded
            self.each(scene, look, (('--backend', 'host'),))

    def test_lists_of_state_are_no_draws(self):
        def look(steps, raw):
            found = self.picked(steps, raw, 'state')
            self.assertEqual((found['count'], found['lists']), (1, 0))
        self.each('state', look, ((), ('--backend', 'swrast')))

    def client(self, *words):
        """Runs `arbiter ctl` while the test requests frames."""
        return subprocess.Popen([ARBITER, 'ctl', '--timeout', str(PATIENCE), *words], env=self.environment,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def test_framebuffer_objects_are_looked_into(self):
        def look(steps, raw):
            name = next(int(line.split()[2]) for line in steps.output.seen if line.startswith('0 framebuffer'))
            window = self.picked(steps, raw, 'object')
            self.assertEqual([draw['draw'] for draw in window['draws']], [3])
            self.assertEqual(window['framebuffers'],
                             [{'framebuffer': 0, 'draws': 1}, {'framebuffer': name, 'draws': 2}])
            found = self.picked(steps, raw, 'object', 40, 30, framebuffer=name)
            self.assertEqual([(draw['draw'], draw['color']) for draw in found['draws']], [(1, [0, 1, 0, 1])],
                             'depth hides the second')
            outside = self.picked(steps, raw, 'object', 100, 60, framebuffer=name)
            self.assertEqual((outside['draws'], outside['trouble']), ([], 'the framebuffer is 48x32'))
            held = self.held(steps, raw, 40, 30, 2, 'object', framebuffer=name)
            self.assertEqual((held['framebuffer'], held['width'], held['height']), (name, 48, 32))
            self.assertEqual(raw.values(text=SHOWN, x=40, y=30, clear=[9, 9, 9, 9])[0], (9, 9, 9, 9))
            self.released(steps, raw)
            code, out, said = steps.until(self.client('--json', 'trace', f'40,30@{name}'), 'object')
            self.assertEqual(code, 0, said)
            self.assertEqual(json.loads(out)['rows'][-1]['value'], [0, 1, 0, 1])
        self.each('object', look)

    def test_equal_depths_are_met(self):
        """The rows of a window and of a framebuffer object are in opposite order, and their depths differ in the
        last bits."""
        places = [(x, y) for x in range(9, 120, 27) for y in (31, 77)]

        def look(steps, raw):
            self.assertIn('0 middle 255 255 0', steps.output.seen)
            found = {place: [draw['draw'] for draw in self.picked(steps, raw, 'equal', *place)['draws']]
                     for place in places}
            self.assertEqual([each for each in found.items() if each[1] != [1, 2]], [], f'of {len(places)} pixels')
            self.held(steps, raw, 100, 60, 2, 'equal')
            shown = raw.values(text=SHOWN, x=100, y=60, width=2, height=2, clear=[9, 9, 9, 9])
            self.assertEqual([value[:2] for value in shown],
                             [(100.5, 60.5), (101.5, 60.5), (100.5, 61.5), (101.5, 61.5)])
            self.released(steps, raw)
        self.each('equal', look)


class Moved(Stepping):
    """Tests events between a request and its frame."""

    def test_an_observed_context_is_destroyed(self):
        with self.stepping() as steps, Asking(steps.path) as raw:
            for _ in range(3):
                number = raw.post('pixel.pick', x=100, y=60)
                steps.frames(count=1)
                steps.do('destroy')
                time.sleep(0.6)
                steps.frames(count=3)
                found = raw.answer(number)['result']
                self.assertEqual([draw['draw'] for draw in found['draws']], [1])
                self.assertEqual(found['count'], 1, 'of one frame')
            self.assertEqual(len(self.picked(steps, raw, 'list')['draws']), 1)
            number = raw.post('frame.measure')
            steps.frames(count=1)
            steps.do('destroy')
            time.sleep(0.6)
            steps.frames(count=3)
            self.assertEqual(raw.answer(number)['result']['draws'][0]['pixels'], WIDTH * HEIGHT)

    def test_a_draw_that_was_to_be_held_is_of_the_next_context(self):
        with self.stepping() as steps, Asking(steps.path) as raw:
            number = raw.post('pixel.hold', x=100, y=60, draw=1)
            steps.frames(count=1)
            steps.do('context', '1')
            time.sleep(0.6)
            steps.frames(count=1)
            steps.send('frame', 'quad')
            self.assertEqual(raw.answer(number)['result']['draw'], 1)
            self.assertEqual(raw.values(text=SHOWN, x=100, y=60)[0][:2], (100.5, 60.5))
            self.released(steps, raw)

    def test_the_application_moves_to_another_context(self):
        with self.stepping() as steps, Asking(steps.path) as raw:
            steps.do('context', '1')
            steps.frames()
            steps.do('context', '0')
            number = raw.post('pixel.pick', x=100, y=60)
            steps.frames(count=1)
            steps.do('context', '1')
            steps.frames(count=2)  # at once, as the first may come back
            steps.do('context', '0')
            steps.frames(count=1)
            self.assertEqual(len(raw.answer(number)['result']['draws']), 1)
            number = raw.post('pixel.pick', x=100, y=60)
            steps.frames(count=1)
            steps.do('context', '1')
            time.sleep(0.6)
            steps.frames(count=2)
            self.assertEqual(len(raw.answer(number)['result']['draws']), 1, 'it moves with the application')
            steps.do('context', '0')  # its draws went to the observer that was given up
            steps.frames('list', 3)
            for scene in ('quad', 'list'):
                self.assertEqual(len(self.picked(steps, raw, scene)['draws']), 1)
            self.assertEqual(steps.output.seen[-2:], ['0 middle 255 255 0', '0 done'])

    def test_another_thread_goes_on_while_a_draw_is_held(self):
        with self.stepping(workers=2) as steps, Asking(steps.path) as raw, Asking(steps.path) as other:
            for _ in range(3):
                self.held(steps, raw)
                steps.frames(count=3, worker=1)
                self.assertEqual(raw.values(text=SHOWN, x=100, y=60)[0][:2], (100.5, 60.5))
                number = other.post('program.list')
                steps.frames(count=1, worker=1)
                self.assertTrue(other.answer(number)['result']['programs'])
                number = other.post('pixel.pick', x=1, y=1)
                steps.frames(count=1, worker=1)
                self.assertEqual(other.answer(number)['error']['code'], -32005)
                steps.do('destroy', worker=1)
                steps.frames('list', worker=1)
                self.assertNotIn('0 done', steps.output.lines, 'the draw is not held')
                self.assertEqual(raw.values(text=SHOWN, x=7, y=9)[0][:2], (7.5, 9.5))
                self.released(steps, raw)
            number = other.post('pixel.pick', x=1, y=1)
            steps.frames(worker=1)
            self.assertEqual(len(other.answer(number)['result']['draws']), 1)

    def test_signals_are_handled_during_a_hold(self):
        with self.stepping() as steps, Asking(steps.path) as raw:
            self.held(steps, raw)
            steps.send('signal')
            steps.waits_for('handled')
            self.assertEqual(raw.values(text=SHOWN, x=100, y=60)[0][:2], (100.5, 60.5))
            steps.send('pester')
            for _ in range(20):
                self.assertEqual(raw.values(text=SHOWN, x=100, y=60)[0][:2], (100.5, 60.5))
                time.sleep(0.02)
            end = time.monotonic() + PATIENCE
            while not any(line.startswith('0 pestered') for line in steps.output.seen):
                steps.output.waits_for('', 0.1)
                self.assertLess(time.monotonic(), end)
                raw.call('pixel.texture', unit=0, target='2D')
            self.assertGreater(int(next(line for line in steps.output.seen if 'pestered' in line).split()[2]), 50)
            self.assertNotIn('0 done', steps.output.lines, 'the draw is not held any more')
            self.released(steps, raw)
            self.held(steps, raw)
            since = time.monotonic()
            steps.send('pester')  # a wait interrupted by a signal must neither restart its patience nor end
            steps.waits_for('done')
            self.assertGreater(time.monotonic() - since, 1.5)

    def test_a_handler_ends_the_process_during_a_hold(self):
        with self.stepping() as steps, Asking(steps.path) as raw:
            self.held(steps, raw)
            steps.send('exit')
            self.assertEqual(steps.process.wait(PATIENCE), 7)
            self.assertIsNone(raw.line())
            self.assertFalse(steps.path.exists(), 'the socket stays')


if __name__ == '__main__':
    controlled.main()
