"""The command line, programs and temporary folders that the tests of the `arbiter` command share.

A test is called as TEST ARBITER FAKE_LAYER SOURCE_ROOT [unittest arguments]; FAKE_LAYER is a shared library that
does nothing when it is preloaded.
"""
import os
import pathlib
import pty
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'tests' / 'clients'))
from plain_environment import plain  # noqa: E402

ARBITER, FAKE, ROOT = sys.argv[1], os.path.abspath(sys.argv[2]), pathlib.Path(sys.argv[3])
PROGRAMS = ROOT / 'demos' / 'programs'
GOOD = '!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n'
VERTEX = ('!!ARBvp1.0\nPARAM c[2] = { program.env[0..1] };\nADDRESS A;\n'
          'ARL A.x, vertex.attrib[7].x;\nMOV result.position, c[A.x];\nEND\n')
BAD = '!!ARBfp1.0\n# a comment\nMOV result.color, q;\nEND\n'


# A system's own shell and its other programs have 64 bits, and a layer of 32 does not reach them.
where_programs_have_the_width = unittest.skipIf(pathlib.Path(ARBITER).read_bytes()[4:5] == b'\1', '32 bits')
# In GCC 12's ThreadSanitizer a handler runs once waitpid() has returned.
where_signals_come_at_once = unittest.skipIf(
    b'__tsan_init' in pathlib.Path(ARBITER).read_bytes(),
    'ThreadSanitizer holds signals back while a process waits for another')


def arbiter(*words, text=None, **environment):
    return subprocess.run([ARBITER, *map(str, words)], input=text, capture_output=True,
                          env=plain(**environment), timeout=60,
                          text=not isinstance(text, bytes))


def on_terminal(*words, **environment):
    """Returns the command's output on a terminal, both streams, without the CR before each LF."""
    terminal, client = pty.openpty()
    with subprocess.Popen([ARBITER, *map(str, words)], stdin=subprocess.DEVNULL, stdout=client, stderr=client,
                          env=plain(TERM='xterm', **environment)):
        os.close(client)
        seen = b''
        while True:
            try:
                piece = os.read(terminal, 65536)
            except OSError:  # Linux reports a closed other side as an error
                piece = b''
            if not piece:
                break
            seen += piece
    os.close(terminal)
    return seen.decode().replace('\r\n', '\n')


def alu(count):
    return ('!!ARBfp1.0\nTEMP a;\nMOV a, fragment.color;\n' + 'ADD a, a, a;\n' * (count - 2) +
            'MOV result.color, a;\nEND\n')


class Temporary(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix='arbiter-tools-')
        self.addCleanup(self.folder.cleanup)

    def path(self, name, text=None):
        path = pathlib.Path(self.folder.name) / name
        if text is not None:
            path.write_text(text)
        return path


def main():
    unittest.main(argv=[sys.argv[0]] + sys.argv[4:], verbosity=2)
