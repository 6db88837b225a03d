#!/usr/bin/env python3
"""Programs of unmodified clients looked at and changed while they run, through `arbiter ctl` and through
the socket itself.

usage: control_test.py ARBITER TICKER PAINTER [unittest arguments]
TICKER (tests/capture) ends no frames; PAINTER has a window, and complains of state that changed.
"""
import contextlib
import json
import os
import pathlib
import random
import re
import select
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'clients'))
from plain_environment import plain  # noqa: E402
from x_server import XServer  # noqa: E402

ARBITER, TICKER, PAINTER = (os.path.abspath(path) for path in sys.argv[1:4])
RED = '!!ARBfp1.0\nMOV result.color, {1, 0, 0, 1};\nEND\n'
WRONG = '!!ARBfp1.0\nMOV result.color, nothing;\nEND\n'
PATIENCE = 60  # seconds, on a machine that has other things to do


class Output:
    """The lines of a client, as they come."""

    def __init__(self, process):
        self.process, self.rest, self.lines = process, b'', []
        self.seen = []  # all of them

    def waits_for(self, text, seconds=PATIENCE):
        """Until the client says so, from now on."""
        end = time.monotonic() + seconds
        while True:
            while self.lines:
                if self.lines.pop(0) == text:
                    return True
            left = end - time.monotonic()
            if left <= 0 or not select.select([self.process.stdout], [], [], left)[0]:
                return False
            part = os.read(self.process.stdout.fileno(), 4096)
            if not part:
                return False
            *lines, self.rest = (self.rest + part).split(b'\n')
            self.lines += [line.decode() for line in lines]
            self.seen += [line.decode() for line in lines]


def pixels(path):
    """Size and rows of an RGBA PNG without interlacing, top row first."""
    data = path.read_bytes()
    assert data[:8] == b'\x89PNG\r\n\x1a\n'
    at, body, size = 8, b'', None
    while at < len(data):
        length = int.from_bytes(data[at:at + 4], 'big')
        kind, chunk = data[at + 4:at + 8], data[at + 8:at + 8 + length]
        if kind == b'IHDR':
            size = int.from_bytes(chunk[:4], 'big'), int.from_bytes(chunk[4:8], 'big')
            assert chunk[8:10] == b'\x08\x06', 'RGBA of 8 bits'
        elif kind == b'IDAT':
            body += chunk
        at += 12 + length
    raw, stride, rows = zlib.decompress(body), size[0] * 4, []
    before = bytearray(stride)
    for y in range(size[1]):
        line = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        unfilter(raw[y * (stride + 1)], line, before)
        rows.append(bytes(line))
        before = line
    return size, rows


def unfilter(kind, line, before):
    for i in range(len(line)):
        a, b, c = (line[i - 4] if i >= 4 else 0), before[i], (before[i - 4] if i >= 4 else 0)
        p = a + b - c
        nearest = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
        line[i] = (line[i] + [0, a, b, (a + b) // 2, nearest][kind]) & 255


class Raw:
    """The socket as it is."""

    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self.socket.settimeout(PATIENCE)
        self.socket.connect(str(path))
        self.rest, self.last = b'', 0

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()

    def send(self, data):
        self.socket.sendall(data)

    def line(self):
        """The next line; None where the connection ends."""
        while b'\n' not in self.rest:
            part = self.socket.recv(1 << 16)
            if not part:
                return None
            self.rest += part
        line, _, self.rest = self.rest.partition(b'\n')
        return json.loads(line)

    def call(self, method, **params):
        """The result, or the error, of a request; events on the way are passed over."""
        self.last += 1
        self.send(json.dumps({'jsonrpc': '2.0', 'id': self.last, 'method': method,
                              'params': params}).encode() + b'\n')
        while True:
            answer = self.line()
            if answer is None or answer.get('id') == self.last:
                return answer


class Controlled(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix='arbiter-control-')
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.environment = plain(XDG_RUNTIME_DIR=scratch.name, ARBITER_CACHE='0')

    def ctl(self, *words, code=0, feed=None):
        result = subprocess.run([ARBITER, 'ctl', '--timeout', str(PATIENCE), *map(str, words)],
                                env=self.environment, capture_output=True, text=True, input=feed,
                                timeout=2 * PATIENCE, errors='replace')
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    @contextlib.contextmanager
    def holding(self, *words):
        """`arbiter ctl` that stays, until it is interrupted."""
        process = subprocess.Popen([ARBITER, 'ctl', '--timeout', str(PATIENCE), *map(str, words)],
                                   env=self.environment, stderr=subprocess.PIPE)
        try:
            yield process
        finally:
            if process.poll() is None:
                process.send_signal(signal.SIGINT)
            process.wait(PATIENCE)
            process.stderr.close()

    @contextlib.contextmanager
    def running(self, *command, options=('--control',), **more):
        process = subprocess.Popen([ARBITER, 'run', *options, '--', *command],
                                   env={**self.environment, **more}, stdout=subprocess.PIPE)
        try:
            yield Output(process)
        finally:
            process.kill()
            process.wait()
            process.stdout.close()

    def socket_of(self, output):
        path = self.folder / 'arbiter' / f'{output.process.pid}.sock'
        end = time.monotonic() + PATIENCE
        while not path.exists() and time.monotonic() < end:
            time.sleep(0.02)
        return path

    def programs(self):
        return json.loads(self.ctl('--json', 'programs').stdout)['programs']

    def effective(self):
        return next(row['id'] for row in self.programs() if row['effective'])


class Edits(Controlled):
    """TICKER draws green with local parameters that it sets around each draw, and complains where its
    queries answer anything but its own program."""

    def test_a_text_is_drawn_with_until_it_is_let_go(self):
        text = self.folder / 'mine.fp'
        text.write_text(RED)
        with self.running(TICKER) as output:
            self.assertTrue(output.waits_for('0 255 0'))
            program = self.effective()
            self.assertRegex(program, r'^[0-9a-f]{32}\.fp$')
            self.assertIn('program.local[0].yyyy', self.ctl('get', program).stdout)
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
        with self.running(TICKER) as output:  # bytes that are no UTF-8 come whole
            self.assertTrue(output.waits_for('0 255 0'))
            self.ctl('export', self.folder / 'own')
        self.assertIn(b'caf\xe9', (self.folder / 'own' / program).read_bytes())


class Hostile(Controlled):
    def test_nothing_listens_unless_it_is_asked_for(self):
        with self.running(TICKER, options=()) as output:
            self.assertTrue(output.waits_for('0 255 0'))
            self.assertFalse((self.folder / 'arbiter').exists())
            self.assertIn('no process listens', self.ctl('programs', code=1).stderr)

    def test_errors_say_what_to_do(self):
        self.assertIn('no process listens; start one', self.ctl('list', code=1).stderr)
        self.assertIn('arbiter run --control', self.ctl('--pid', '1', 'programs', code=1).stderr)
        with self.running(TICKER) as output, self.running(TICKER) as other:
            for each in (output, other):
                self.assertTrue(each.waits_for('0 255 0'))
            pids = [output.process.pid, other.process.pid]
            listed = self.ctl('list').stdout
            self.assertEqual(sorted(int(n) for n in re.findall(r'^ *(\d+) +layer +\S*ticker',
                                                               listed, re.M)), sorted(pids))
            self.assertIn('--pid', self.ctl('programs', code=1).stderr)
            self.ctl('--pid', pids[0], 'programs')
            self.assertIn('did you mean programs?',
                          self.ctl('--pid', pids[0], 'program', code=1).stderr)
            self.assertIn('there is no program', self.ctl('--pid', pids[0], 'get', 'no.fp',
                                                          code=1).stderr)
            output.process.send_signal(signal.SIGSTOP)
            stopped = subprocess.run([ARBITER, 'ctl', '--timeout', '0.2', '--pid', str(pids[0]),
                                      'programs'], env=self.environment, capture_output=True,
                                     text=True, timeout=PATIENCE)
            self.assertIn('is it stopped?', stopped.stderr)
        environment = {**self.environment}
        del environment['XDG_RUNTIME_DIR']
        result = subprocess.run([ARBITER, 'run', '--control', '--', 'true'], env=environment,
                                capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(result.returncode, 1)
        self.assertIn('XDG_RUNTIME_DIR', result.stderr)

    def test_hostile_messages_change_nothing(self):
        rng = random.Random(5)
        methods = ('hello', 'ping', 'program.list', 'program.get', 'program.set', 'program.reset',
                   'program.enable', 'param.list', 'param.set', 'param.reset', 'texture.list',
                   'texture.get', 'texture.set', 'texture.reset', 'frame.want', 'frame.release',
                   'stats', 'none')
        values = (None, -1, 0, 1, 1e308, 2 ** 64, '', 'x' * 1000, [], {}, [[1]], True,
                  '../../etc/passwd', {'width': 1 << 30, 'height': 1, 'rgba': 'AAAA'},
                  [1e39, 0, 0, 0], 'program.local[4294967296]', '\u0000')
        names = ('id', 'text', 'revision', 'enabled', 'name', 'value', 'target', 'size', 'image',
                 'every', 'width', 'height', 'slot', 'serial')
        with self.running(TICKER) as output:
            self.assertTrue(output.waits_for('0 255 0'))
            path = self.socket_of(output)
            for _ in range(6):
                with Raw(path) as raw:
                    for number in range(60):
                        params = {name: rng.choice(values) for name in names if rng.random() < 0.5}
                        answer = raw.call(rng.choice(methods), **params)
                        self.assertIsNotNone(answer)
                        self.assertIn('result' if 'result' in answer else 'error', answer)
            with Raw(path) as raw:
                raw.send(b'not json\n[]\n{"jsonrpc":"2.0","id":1}\n' + b'[' * 40 + b']' * 40 + b'\n')
                codes = [raw.line()['error']['code'] for _ in range(4)]
                self.assertEqual(codes, [-32700, -32600, -32600, -32600])
                self.assertIsNone(raw.line(), 'what nests too deep ends the connection')
            with Raw(path) as raw, contextlib.suppress(OSError):
                raw.send(b'x' * (5 << 20))
            self.assertFalse(output.waits_for('255 0 0', 0.3))
            self.assertTrue(self.effective())
            self.assertIsNone(output.process.poll())

    def test_revisions_and_writers(self):
        with self.running(TICKER) as output:
            self.assertTrue(output.waits_for('0 255 0'))
            path, program = self.socket_of(output), self.effective()
            with Raw(path) as one, Raw(path) as two:
                self.assertEqual(one.call('hello')['result']['pid'], output.process.pid)
                self.assertTrue(one.call('program.set', id=program, text=RED,
                                         revision=5)['result']['ok'])
                old = one.call('program.set', id=program, text=RED, revision=5)['error']
                self.assertEqual((old['code'], old['data']['revision']), (-32003, 5))
                other = two.call('program.set', id=program, text=RED, revision=6)['error']
                self.assertEqual((other['code'], other['data']['pid']), (-32002, os.getpid()))
                wrong = one.call('program.set', id=program, text=WRONG, revision=7)['result']
                self.assertFalse(wrong['ok'])
                self.assertEqual((wrong['diagnostics'][0]['line'],
                                  wrong['diagnostics'][0]['column']), (2, 19))
                self.assertTrue(output.waits_for('255 0 0'))
                one.call('program.enable', id=program, enabled=False)
                self.assertEqual([row['enabled'] for row in self.programs()
                                  if row['id'] == program], [False])
            self.assertTrue(output.waits_for('0 255 0'))
            with Raw(path) as raw:  # TICKER loads its text again and again
                self.assertGreaterEqual(raw.call('ping')['result']['idle'], 0)
                line = raw.line()
                while line.get('method') != 'program.loaded':
                    line = raw.line()
                self.assertEqual(line['params'], {'id': program})

    def test_the_socket_goes_with_the_process(self):
        with self.running(TICKER, 'fragment', '30') as output:
            output.process.wait(PATIENCE)
            self.assertEqual(list((self.folder / 'arbiter').iterdir()), [])


class Windows(Controlled):
    """PAINTER draws yellow: white texels times (1, 1, 0)."""
    # Of the layer, and of PAINTER.
    CASES = (((), ()), (('--backend', 'host'), ('-1', 'fbo')))

    @classmethod
    def setUpClass(cls):
        server = XServer()
        cls.display = server.__enter__()
        cls.addClassCleanup(server.__exit__)

    def painting(self, *words, options=('--control',)):
        return self.running(PAINTER, *words, options=options, DISPLAY=self.display)

    def unchanged(self, output):
        """Nothing of GL's that the client would have complained of."""
        output.waits_for('', 0.3)
        self.assertEqual([line for line in output.seen if line.startswith(('state', 'error'))], [])

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
                    self.painting(*words, options=('--hud', *more)) as output:
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


def green_picture(path):
    """A PNG of 16x16 whose every pixel is green."""
    def chunk(kind, data):
        return (len(data).to_bytes(4, 'big') + kind + data +
                zlib.crc32(kind + data).to_bytes(4, 'big'))
    head = (16).to_bytes(4, 'big') * 2 + b'\x08\x06\0\0\0'
    rows = zlib.compress((b'\0' + b'\0\xff\0\xff' * 16) * 16)
    path.write_bytes(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head) + chunk(b'IDAT', rows) +
                     chunk(b'IEND', b''))
    return path


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
