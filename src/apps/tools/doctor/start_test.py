#!/usr/bin/env python3
"""Tests of the warnings by `arbiter run` before it starts a program that the layer cannot reach.

usage: start_test.py ARBITER LAYER SOURCE_ROOT CXX [unittest arguments]
"""
import errno
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from command_session import ARBITER, FAKE as LAYER, arbiter, where_programs_have_the_width  # noqa: E402
from doctor_session import Examined, loader_of, of_32_bits  # noqa: E402
from plain_environment import plain  # noqa: E402

STATIC = 'It is statically linked: nothing can be loaded into it.'


class Start(Examined):
    def said(self, *command, **environment):
        """Returns the command's own lines on standard error, and its exit code."""
        done = arbiter('run', '--library', LAYER, '--', *command, **environment)
        return [line for line in done.stderr.splitlines() if line.startswith('arbiter run: ')], done.returncode

    @where_programs_have_the_width
    def test_nothing_is_said_of_what_is_reached(self):
        game = self.compile('game', 'int main() { return 7; }\n')
        self.assertEqual(self.said(game), ([], 7))
        self.assertEqual(self.said(self.script('start.sh', f'#!/bin/sh\nexec {game}\n')), ([], 7))

    def test_a_static_program_runs_and_is_named(self):
        game = self.compile('game', 'int main() { return 7; }\n', '-static')
        (line,), status = self.said(game)
        self.assertTrue(line.startswith(f'arbiter run: {game}: {STATIC}'), line)
        self.assertEqual(status, 7)

    def test_the_interpreter_of_a_script_is_what_is_started(self):
        shell = self.compile('shell', 'int main() { return 7; }\n', '-static')
        for line in (f'#!{shell}', '#!/usr/bin/env shell'):
            script = self.script('start', line + '\n')
            (line,), status = self.said(script, PATH=f'{self.root}:{os.environ["PATH"]}')
            self.assertTrue(line.startswith(f'arbiter run: {shell}: {STATIC}'), line)
            self.assertEqual(status, 7)

    @where_programs_have_the_width
    def test_a_program_of_32_bits(self):
        game = self.compile('game', 'int main() {}\n')
        of_32_bits(game)
        line = self.said(game)[0][0]
        self.assertIn('It is a 32-bit (i386) program', line)
        self.assertIn('sudo dpkg --add-architecture i386', line)

    def test_a_program_of_another_machine_is_no_script(self):
        game = self.compile('game', 'int main() {}\n')
        header = bytearray(game.read_bytes())
        header[18:20] = b'\xff\x7f'  # e_machine
        game.write_bytes(header)
        lines, status = self.said(game)
        self.assertEqual(lines[-1], f'arbiter run: {game}: this kernel runs no programs of its kind')
        self.assertEqual(status, 126)

    @where_programs_have_the_width
    def test_a_loader_that_is_missing(self):
        game = self.compile('game', 'int main() {}\n')
        of_32_bits(game, '/nil/ld-linux.so.2')
        lines, status = self.said(game)
        self.assertIn('a 32-bit (i386) program, and its loader /nil/ld-linux.so.2 is not on this system', lines[0])
        self.assertIn('sudo dpkg --add-architecture i386 && sudo apt update && sudo apt install libc6:i386', lines[0])
        # A kernel without programs of 32 bits does not look for their loader.
        with self.assertRaises(OSError) as bare:
            subprocess.run([game])
        self.assertEqual(status, 126 if bare.exception.errno == errno.ENOEXEC else 127)
        of_32_bits(game, '/nil/ld-linux.so.1')
        self.assertIn('libc 5', self.said(game)[0][0])
        of_32_bits(game, '/nil/ld-linux-x.so.2')
        self.assertIn('Install what has that file', self.said(game)[0][0])
        line, *_ = self.said(self.script('start', '#!/none/python2\n'))[0]
        self.assertIn('its first line names /none/python2, which is not on this system', line)

    def test_a_program_that_the_loader_is_given(self):
        game = self.compile('game', 'int main() { return 7; }\n')
        self.assertEqual(self.said(loader_of(game), game), ([], 7))
        self.assertEqual(self.said(loader_of(game), '--library-path', self.root, game), ([], 7))

    @unittest.skipUnless(os.geteuid() == 0, 'needs root: another user is wanted')
    def test_a_set_user_id_program(self):
        game = self.compile('game', 'int main() { return 7; }\n')
        os.chown(game, 65533, 65533)
        game.chmod(0o4755)
        (line,), status = self.said(game)
        self.assertIn('set-user-ID', line)
        self.assertEqual(status, 7)

    def test_sandboxes(self):
        flatpak = self.script('flatpak', '#!/bin/sh\n')
        (line,), _ = self.said(flatpak, 'run', 'org.example.Game')
        self.assertIn('Flatpak runs org.example.Game in a sandbox', line)


class Widths(Examined):
    """Installs the layer for one width or for both beside the command."""

    def setUp(self):
        super().setUp()
        if os.uname().machine != 'x86_64':
            self.skipTest('a processor of one width')
        (self.root / 'bin').mkdir()
        self.command = self.root / 'bin' / 'arbiter'
        shutil.copy(ARBITER, self.command)
        self.lib = self.root / 'lib'
        for folder in ('x86_64-linux-gnu/arbiter', 'x86_64-linux-gnu/arbiter/preload/lib/x86_64-linux-gnu'):
            (self.lib / folder).mkdir(parents=True)
            shutil.copy(LAYER, self.lib / folder / 'libGLX_arbiter.so.0')
        self.game = self.compile('game', 'int main() {}\n')
        of_32_bits(self.game)

    def said(self):
        done = subprocess.run([self.command, 'run', '--', self.game], capture_output=True, text=True, timeout=60,
                              env=plain())
        if 'the layer is not there' in done.stderr:
            self.skipTest('this build installs its libraries elsewhere')
        return 'It is a 32-bit' in done.stderr

    def test_the_layer_of_32_bits_is_found_beside_the_other(self):
        self.assertTrue(self.said())
        other = self.lib / 'i386-linux-gnu' / 'arbiter'
        other.mkdir(parents=True)
        shutil.copy(self.game, other / 'libGLX_arbiter.so.0')
        self.assertFalse(self.said())


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0]] + sys.argv[4:], verbosity=2)
