"""Shared parts of the control tests: running clients, `arbiter ctl`, the socket itself, pictures.

A test's arguments are ARBITER TICKER PAINTER [unittest arguments]. TICKER (tests/capture) ends no frames;
PAINTER has a window, and complains about changed state.
"""
import contextlib
import json
import os
import pathlib
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
from x_server import XServer  # noqa: E402,F401

ARBITER, TICKER, PAINTER = (os.path.abspath(path) for path in sys.argv[1:4])
RED = '!!ARBfp1.0\nMOV result.color, {1, 0, 0, 1};\nEND\n'
WRONG = '!!ARBfp1.0\nMOV result.color, nothing;\nEND\n'
PATIENCE = 60  # seconds, as the machine may be busy


class Output:
    """Collects the lines of a client as they come."""

    def __init__(self, process):
        self.process, self.rest, self.lines = process, b'', []
        self.seen = []  # all lines

    def waits_for(self, text, seconds=PATIENCE):
        """Waits until the client prints the text, from now on."""
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

    def drain(self):
        """Reads what is there, so that the client never waits for its reader."""
        while select.select([self.process.stdout], [], [], 0)[0]:
            part = os.read(self.process.stdout.fileno(), 1 << 16)
            if not part:
                return
            *lines, self.rest = (self.rest + part).split(b'\n')
            self.lines = [line.decode() for line in lines][-16:]


def pixels(path):
    """Returns size and rows of an RGBA PNG without interlacing, top row first."""
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
    """Speaks the protocol directly on the socket."""

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
        """Returns the next line; None if the connection ends."""
        while b'\n' not in self.rest:
            part = self.socket.recv(1 << 16)
            if not part:
                return None
            self.rest += part
        line, _, self.rest = self.rest.partition(b'\n')
        return json.loads(line)

    def call(self, method, **params):
        """Returns the result, or the error, of a request; skips events on the way."""
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
        """Runs `arbiter ctl` until it is interrupted."""
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


class Painting(Controlled):
    """A test with a display, for PAINTER."""
    @classmethod
    def setUpClass(cls):
        server = XServer()
        cls.display = server.__enter__()
        cls.addClassCleanup(server.__exit__)

    def painting(self, *words, options=('--control',)):
        return self.running(PAINTER, *words, options=options, DISPLAY=self.display)

    def unchanged(self, output):
        """Checks that the client has not reported any changed GL state."""
        output.waits_for('', 0.3)
        self.assertEqual([line for line in output.seen if line.startswith(('state', 'error'))], [])


def main():
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
