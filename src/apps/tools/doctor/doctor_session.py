"""The compiled programs and the examination that the doctor's tests share.

A test is called as TEST ARBITER LAYER SOURCE_ROOT CXX [unittest arguments].
"""
import json
import pathlib
import re
import struct
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
CXX = sys.argv.pop(4)
from command_session import FAKE as LAYER, Temporary, arbiter  # noqa: E402


def of_32_bits(path, loader='/bin/sh'):
    """Gives a program's file the header of an i386 program. The default loader is a file that each system has: not
    all have that of 32-bit programs, and the command looks for it."""
    header = bytearray(path.read_bytes())
    header[4] = 1  # ELFCLASS32
    struct.pack_into('<H', header, 18, 3)  # EM_386
    # A 32-bit header with one program header, PT_INTERP.
    struct.pack_into('<IIIIHHHHHH', header, 24, 0, 52, 0, 0, 52, 32, 1, 40, 0, 0)
    struct.pack_into('<IIIIIIII', header, 52, 3, 128, 0, 0, 20, 20, 4, 1)
    header[128:148] = loader.encode().ljust(20, b'\0')
    path.write_bytes(header)


def loader_of(path):
    """Returns the loader that a program's file names."""
    return re.search(rb'/lib[\w./-]*ld-linux[\w.-]*', path.read_bytes()).group().decode()


class Examined(Temporary):
    def setUp(self):
        super().setUp()
        self.root = pathlib.Path(self.folder.name)

    def compile(self, name, source, *options):
        path = self.path(name)
        path.parent.mkdir(parents=True, exist_ok=True)
        text = self.path(name.replace('/', '_') + '.cpp', source)
        subprocess.run([CXX, text, '-o', path, *options], check=True, capture_output=True)
        return path

    def script(self, name, text):
        path = self.path(name, text)
        path.chmod(0o755)
        return path

    def libgl(self, folder):
        """Makes a libGL that is not libglvnd's."""
        (self.root / folder).mkdir(parents=True, exist_ok=True)
        return self.compile(f'{folder}/libGL.so.1', 'extern "C" void glFinish() {}\n', '-shared', '-fPIC',
                            '-Wl,-soname,libGL.so.1')

    def ask(self, *words, options=(), **environment):
        """Returns the findings by their words, after checking that the text output reports the same."""
        environment.setdefault('EGL_PLATFORM', 'surfaceless')
        call = ['doctor', '--library', LAYER, *options]
        text = arbiter(*call, '--', *words, **environment)
        twin = arbiter(*call, '--json', '--', *words, **environment)
        report = json.loads(twin.stdout)
        self.assertEqual(twin.returncode, 0 if report['reached'] else 7, twin.stderr)
        self.assertEqual(text.returncode, twin.returncode)
        self.assertEqual(report['command'], [str(word) for word in words])
        for each in report['findings']:
            if '--run' not in options:  # sentences of --run contain times
                self.assertIn(f'{each["level"]}: {each["what"]}\n', text.stdout)
            self.assertTrue(each['what'].endswith('.'), each)
            self.assertTrue(each['level'] == 'note' or each['remedy'].endswith('.'), each)
        return {each['id']: each for each in report['findings']}

    def obstacles(self, found):
        return {name for name, each in found.items() if each['level'] == 'obstacle'}
