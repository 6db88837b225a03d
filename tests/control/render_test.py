#!/usr/bin/env python3
"""Tests `arbiter render`: documents sent through a socket, frames returned through shared memory.

usage: render_test.py ARBITER [unittest arguments]
"""
import array
import json
import mmap
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'clients'))
from plain_environment import plain  # noqa: E402

ARBITER = os.path.abspath(sys.argv[1])
PATIENCE = 60
TINT = '''!!ARBfp1.0
#@ size 32 16
#@ local[0] "tint" = 1 0 0 1
MOV result.color, program.local[0];
END
'''
MOVING = '''!!ARBfp1.0
#@ size 8 8
#@ local[0].x "level" = 0 in 0..1 animate saw 1s
MOV result.color, program.local[0].x;
END
'''
COUNTING = '''!!ARBfp1.0
#@ size 8 8
#@ texture 0 = feedback of constant r 0 g 0 b 0, nearest, edge
TEMP t;
TEX t, fragment.texcoord[0], texture[0], 2D;
ADD result.color, t, {0.0039215687, 0, 0, 1};
END
'''
WRONG = TINT.replace('program.local[0]', 'nothing')


class Renderer:
    """A renderer's process, with the protocol of the C++ client."""

    def __init__(self, folder, *options):
        ours, theirs = socket.socketpair()
        self.process = subprocess.Popen(
            [ARBITER, 'render', '--fd', str(theirs.fileno()), '--folder', str(folder), *options],
            pass_fds=[theirs.fileno()], env=plain(ARBITER_CACHE='0'))
        theirs.close()
        ours.settimeout(PATIENCE)
        self.socket, self.rest, self.descriptors, self.last = ours, b'', [], 0
        self.events, self.answers, self.memory, self.buffer = [], {}, None, None

    def close(self):
        self.socket.close()
        return self.process.wait(PATIENCE)

    def receive(self):
        """Returns one message, of either kind."""
        while b'\n' not in self.rest:
            data, extra, _, _ = self.socket.recvmsg(1 << 16, socket.CMSG_SPACE(64))
            if not data:
                raise EOFError
            for _, kind, bytes_ in extra:
                if kind == socket.SCM_RIGHTS:
                    self.descriptors += array.array('i', bytes_)
            self.rest += data
        line, _, self.rest = self.rest.partition(b'\n')
        message = json.loads(line)
        if 'method' not in message:
            self.answers[message['id']] = message
        elif message['method'] == 'frame.buffer':
            self.buffer = message['params']
            fd = self.descriptors.pop(0)
            self.memory = mmap.mmap(fd, self.buffer['slot_bytes'] * self.buffer['slots'],
                                    prot=mmap.PROT_READ)
            os.close(fd)
        else:
            self.events.append(message)

    def send(self, method, **params):
        self.last += 1
        self.socket.sendall(json.dumps({'jsonrpc': '2.0', 'id': self.last, 'method': method,
                                        'params': params}).encode() + b'\n')
        return self.last

    def wait(self, number):
        while number not in self.answers:
            self.receive()
        answer = self.answers.pop(number)
        return answer.get('result', answer.get('error'))

    def call(self, method, **params):
        return self.wait(self.send(method, **params))

    def frame(self):
        """Returns the parameters of the next frame, and its first and last pixel."""
        while True:
            for at, event in enumerate(self.events):
                if event['method'] == 'frame':
                    params = self.events.pop(at)['params']
                    return params, self.pixels(params)
            self.receive()

    def pixels(self, params):
        begin = params['slot'] * self.buffer['slot_bytes']
        size = params['width'] * params['height'] * 4
        picture = self.memory[begin:begin + size]
        self.call('frame.release', slot=params['slot'], serial=params['serial'])
        return picture[:4], picture[-4:]

    def shows(self, revision, colour):
        """Waits until a frame of the revision has the color everywhere; returns False if one has another."""
        while True:
            params, pixels = self.frame()
            if params['revision'] == revision and pixels == (bytes(colour),) * 2:
                return True
            if params['revision'] > revision:
                return False


class Render(unittest.TestCase):
    OPTIONS = ()

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix='arbiter-render-')
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.renderer = Renderer(self.folder, *self.OPTIONS)
        self.addCleanup(self.end)

    def end(self):
        if self.renderer.process.poll() is None:
            self.renderer.process.kill()
        self.renderer.close()

    def test_a_text_becomes_a_frame(self):
        r = self.renderer
        self.assertEqual(r.call('hello')['server'], 'renderer')
        self.assertEqual(r.call('frame.want'), {})
        answer = r.call('scene.set', text=TINT, revision=1)
        self.assertTrue(answer['ok'], answer)
        self.assertEqual((answer['size'], answer['animated'], answer['diagnostics']),
                         ([32, 16], False, []))
        self.assertEqual(answer['programs'][0]['counts']['instructions'], 1)
        self.assertTrue(r.shows(1, (255, 0, 0, 255)))
        self.assertEqual(r.call('scene.param', stage='fragment', kind='local', index=0,
                                value=[None, 1, None, None]), {})
        self.assertTrue(r.shows(1, (255, 255, 0, 255)))
        self.assertEqual(r.call('scene.size', width=64, height=64), {})
        params, _ = r.frame()
        self.assertEqual((params['width'], params['height']), (64, 64))
        self.assertEqual(r.close(), 0)

    def test_a_wrong_text_leaves_the_last_good_one(self):
        r = self.renderer
        r.call('frame.want')
        self.assertTrue(r.call('scene.set', text=TINT, revision=1)['ok'])
        self.assertTrue(r.shows(1, (255, 0, 0, 255)))
        answer = r.call('scene.set', text=WRONG, revision=2)
        self.assertFalse(answer['ok'])
        found = answer['diagnostics'][0]
        self.assertEqual((found['line'], found['column'], found['severity']), (4, 19, 'error'))
        wrong_line = r.call('scene.set', text=TINT.replace('size 32 16', 'size 0 16'), revision=3)
        self.assertFalse(wrong_line['ok'])
        self.assertEqual(wrong_line['diagnostics'][0]['line'], 2)
        self.assertGreaterEqual(r.call('scene.frame')['milliseconds'], 0)
        self.assertTrue(r.shows(1, (255, 0, 0, 255)))

    def test_the_newest_text_wins(self):
        r = self.renderer
        r.call('frame.want')
        numbers = [r.send('scene.set', text=TINT.replace('1 0 0 1', f'0 0 {i % 2} 1'), revision=i)
                   for i in range(1, 41)]
        answers = [r.wait(number) for number in numbers]
        self.assertTrue(answers[-1]['ok'])
        for answer in answers[:-1]:
            self.assertTrue(answer['ok'] or answer['superseded'])
        self.assertTrue(any(answer['superseded'] for answer in answers))
        self.assertTrue(r.shows(40, (0, 0, 0, 255)))

    def test_files_of_the_editor_stand_in_for_those_beside_it(self):
        r = self.renderer
        (self.folder / 'shape.vp').write_text('!!ARBvp1.0\nwrong\n')
        text = TINT.replace('#@ size', '#@ vertex shape.vp\n#@ size') \
            .replace('program.local[0];', 'fragment.color;')
        r.call('frame.want')
        broken = r.call('scene.set', text=text, revision=1, name='main.fp')
        self.assertFalse(broken['ok'])
        self.assertEqual(broken['diagnostics'][0]['file'], 'shape.vp')
        vertex = ('!!ARBvp1.0\nMOV result.position, vertex.position;\n'
                  'MOV result.color, {0, 1, 0, 1};\nEND\n')
        answer = r.call('scene.set', text=text, revision=2, name='main.fp',
                        files={'shape.vp': vertex})
        self.assertTrue(answer['ok'], answer)
        self.assertTrue(r.shows(2, (0, 255, 0, 255)))

    def test_time_goes_on_and_stands(self):
        r = self.renderer
        r.call('frame.want')
        answer = r.call('scene.set', text=MOVING, revision=1)
        self.assertTrue(answer['animated'])
        times = [r.frame()[0]['time'] for _ in range(5)]
        self.assertEqual(times, sorted(set(times)))
        self.assertEqual(r.call('scene.pause', paused=True), {'paused': True})
        r.call('scene.time', seconds=0.5)
        while True:
            params, pixels = r.frame()
            if params['time'] == 0.5:
                break
        self.assertAlmostEqual(pixels[0][0], 128, delta=2)
        time.sleep(0.2)
        self.assertAlmostEqual(r.call('scene.step', seconds=0.25)['time'], 0.75, delta=0.02)
        bench = r.call('scene.bench', frames=5)
        self.assertEqual(bench['frames'], 5)

    def test_feedback_is_taken_to_a_step(self):
        r = self.renderer
        r.call('frame.want')
        r.call('scene.pause', paused=True)
        r.call('scene.set', text=COUNTING, revision=1)
        params, pixels = r.frame()
        self.assertEqual((params['steps'], pixels[0][0]), (1, 1))
        for steps in 40, 41, 7, 7:
            self.assertEqual(r.call('scene.steps', steps=steps)['steps'], steps)
            params, pixels = r.frame()
            self.assertEqual((params['steps'], pixels[0][0], pixels[1][0]), (steps,) * 3)
        r.call('scene.step')
        self.assertEqual(r.frame()[0]['steps'], 8)
        self.assertEqual(r.call('scene.steps', steps=0)['code'], -32602)
        far = r.call('scene.steps', steps=1_000_000_000)['steps']
        self.assertLess(far, 1_000_000_000)
        self.assertGreater(far, 8)
        r.call('scene.set', text=TINT, revision=2)
        self.assertEqual(r.call('scene.steps', steps=2)['code'], -32004)

    def test_hostile_messages(self):
        r = self.renderer
        r.call('frame.want')
        self.assertTrue(r.call('scene.set', text=TINT, revision=1)['ok'])
        for method, params in (
                ('scene.set', {'text': 7}), ('scene.set', {'text': '', 'revision': 2}),
                ('scene.set', {'text': TINT, 'revision': 3, 'name': '../x.fp'}),
                ('scene.set', {'text': TINT, 'revision': 3, 'files': {'a': 1}}),
                ('scene.set', {'text': '#@ size 8192 8192\n' * 1000, 'revision': 4}),
                ('scene.param', {}), ('scene.size', {'width': 1 << 30, 'height': 1}),
                ('scene.param', {'stage': 'vertex', 'kind': 'local', 'index': 0,
                                 'value': [0, 0, 0, 0]}),
                ('scene.step', {'seconds': -1}), ('scene.bench', {'frames': 0}),
                ('scene.camera', {'yaw': 'x'}), ('frame.release', {'slot': 9}),
                ('program.list', {}), ('none', {})):
            with self.subTest(method=method, params=str(params)[:60]):
                answer = r.call(method, **params)
                self.assertTrue(answer.get('code', 0) < 0 or answer.get('ok') is False, answer)
        self.assertTrue(r.call('scene.frame'))

    def test_it_is_killed_and_another_one_goes_on(self):
        for _ in range(3):
            r = Renderer(self.folder, *self.OPTIONS)
            r.call('frame.want')
            self.assertTrue(r.call('scene.set', text=TINT, revision=1)['ok'])
            r.process.send_signal(signal.SIGKILL)
            with self.assertRaises((EOFError, OSError)):
                while True:
                    r.call('ping')
            r.close()

    def test_what_is_no_socket_is_said(self):
        result = subprocess.run([ARBITER, 'render', '--fd', '1', *self.OPTIONS],
                                env=plain(), capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(result.returncode, 1)
        self.assertIn('--fd 1: is no connected socket', result.stderr)

    def test_it_listens_where_it_prints(self):
        process = subprocess.Popen([ARBITER, 'render', *self.OPTIONS], text=True,
                                   env=plain(XDG_RUNTIME_DIR=str(self.folder)),
                                   stdout=subprocess.PIPE)
        path = process.stdout.readline().strip()
        self.assertEqual(path, f'{self.folder}/arbiter/{process.pid}.render.sock')
        with socket.socket(socket.AF_UNIX) as client:
            client.settimeout(PATIENCE)
            client.connect(path)
            client.sendall(b'{"jsonrpc": "2.0", "id": 1, "method": "ping"}\n')
            self.assertIn(b'"busy"', client.recv(4096))
        process.terminate()
        process.wait(PATIENCE)
        process.stdout.close()


class Bare(Render):
    """Uses the host's own implementation, as picture B of a comparison does."""
    OPTIONS = ('--bare',)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
