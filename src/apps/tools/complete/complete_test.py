#!/usr/bin/env python3
"""Tests the completions of `arbiter` in bash, zsh and fish; each shell is used as a person would at a terminal.

usage: complete_test.py ARBITER SOURCE_ROOT [unittest arguments]
"""
import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

ARBITER, ROOT = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
SHELLS = ROOT / 'src' / 'apps' / 'tools' / 'complete'
sys.path.insert(0, str(ROOT / 'tests' / 'clients'))
from plain_environment import plain  # noqa: E402


def answers(*words, **environment):
    """Returns the lines of `arbiter complete` without their help texts."""
    result = subprocess.run([ARBITER, 'complete', '--', *words], capture_output=True, text=True, timeout=60,
                            env=plain(**environment))
    assert (result.returncode, result.stderr) == (0, ''), result
    return [line.split('\t')[0] for line in result.stdout.splitlines()]


def help_of(*words):
    return subprocess.run([ARBITER, *words, '--help'], capture_output=True, text=True, check=True).stdout


class Answers(unittest.TestCase):
    def test_verbs_are_those_of_help(self):
        verbs = re.findall(r'^  ([a-z]+)  ', help_of().partition('Subcommands:')[2], re.M)
        self.assertGreater(len(verbs), 15)
        self.assertEqual(answers(''), verbs)
        self.assertEqual(answers('help', ''), verbs)
        self.assertEqual(answers('ch'), ['check'])

    def test_options_are_those_of_help(self):
        for verb in answers(''):
            text = help_of(verb).partition('Usage:')[2]
            names = [name for line in re.findall(r'^  (-\S+)', text, re.M) for name in line.split(',')
                     if name.startswith('--')]
            self.assertEqual(sorted(answers(verb, '--')), sorted(names), verb)

    def test_values(self):
        self.assertEqual(answers('check', '--limits', ''), ['enforce', 'report'])
        self.assertEqual(answers('check', '--limits=e'), ['--limits=enforce'])
        self.assertEqual(answers('compile', '--emit', 'as'), ['assembly'])
        cards = answers('run', '--profile', '')
        for name in ('r300', 'nv40', 'host', 'radeon9700', ':files'):
            self.assertIn(name, cards)
        self.assertIn('all', answers('check', '--profile', ''))
        self.assertEqual(answers('profiles', 'geforcefx5'), ['geforcefx5800', 'geforcefx5900', ':files'])
        self.assertEqual(answers('draw', '-o', ''), [':files'])
        self.assertEqual(answers('draw', '--frames', ''),
                         [':hint draw this many times'])
        self.assertEqual(answers('debug', '--against', ''), ['swrast', 'host', 'bare', 'fp24', ':files'])
        self.assertEqual(answers('debug', '--against=b'), ['--against=bare', ':files --against='])

    def test_a_value_of_its_own_form_is_hinted(self):
        self.assertEqual(answers('debug', '--pixel', ''), [':hint X,Y: the pixel'])
        self.assertEqual(answers('debug', '--pass', ''), [":hint which of the document's passes, from 1"])
        self.assertEqual(answers('draw', '--texture', '')[0][:12], ':hint N=IMG:')
        self.assertEqual(answers('run', '--extensions-max-year', ''),
                         [':hint announce no extension of a later year'])

    def test_a_part_of_a_value(self):
        self.assertEqual(answers('draw', '--texture', '3=l'), ['3=landscape', ':files 3='])
        self.assertEqual(answers('draw', '--texture=3=cl'), ['--texture=3=clouds', ':files --texture=3='])
        words = answers('draw', '--texture', '0=')
        self.assertIn('0=checker', words)
        self.assertNotIn('0=sky', words)
        self.assertEqual(answers('debug', '--texture', '3=l'), ['3=landscape', ':files 3='])
        # An option takes one profile.
        self.assertEqual(answers('check', '--profile', 'r300,nv3'), [':files'])

    def test_operands(self):
        names = sorted(path.stem for path in (ROOT / 'demos' / 'gallery').glob('*.fp')
                       if '#@ title' in path.read_text())
        self.assertGreater(len(names), 5)
        for verb in ('check', 'draw', 'debug', 'builder'):
            self.assertEqual(answers(verb, ''), [f'gallery:{name}' for name in names] + [':files'], verb)
        self.assertEqual(answers('draw', 'gallery:twi'), ['gallery:twirl', ':files'])
        self.assertEqual(answers('compile', ''), [':files'])
        self.assertEqual(answers('cache', ''), [])

    def test_commands_of_others(self):
        self.assertEqual(answers('run', ''), [':command 1'])
        self.assertEqual(answers('run', '--hud', '--profile', 'nv30', 'game', '--'), [':command 4'])
        self.assertEqual(answers('doctor', '--', 'game', '--f'), [':command 2'])
        self.assertEqual(answers('defaults', '--ch'), ['--check'])

    def test_control(self):
        actions = re.findall(r'^  ([a-z]+) ', help_of('ctl').partition('Actions:')[2].partition('What set')[0], re.M)
        self.assertIn('disable', actions)
        self.assertEqual(set(answers('ctl', '')), {'list', '-', *actions})
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(answers('ctl', 'get', '', XDG_RUNTIME_DIR=folder), [])  # no process listens
        self.assertEqual(answers('ctl', 'set', 'a.fp', ''), [':files'])
        self.assertEqual(answers('ctl', 'frame', ''), [])

    def test_nonsense(self):
        for words in ((), ('chek', ''), ('check', '--bogus', ''), ('--', ''), ('debug-draws', '')):
            answers(*words)


class Shell(unittest.TestCase):
    """A shell with the command's folder in PATH, in a folder with one file."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix='arbiter-complete-')
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / 'bin').mkdir()
        (self.folder / 'bin' / 'arbiter').symlink_to(ARBITER)
        (self.folder / 'here').mkdir()
        (self.folder / 'here' / 'water shader.fp').write_text('')
        self.environment = plain(PATH=f'{self.folder}/bin:' + os.environ['PATH'], HOME=str(self.folder),
                                 LC_ALL='C.UTF-8', ARBITER_GALLERY=str(ROOT / 'demos' / 'gallery'), TERM='dumb')

    def need(self, name):
        if not shutil.which(name):
            self.skipTest(f'not installed: {name}')

    def ask(self, *command):
        result = subprocess.run(command, capture_output=True, text=True, timeout=60, env=self.environment,
                                cwd=self.folder / 'here')
        self.assertEqual(result.stderr, '')
        return result.stdout.splitlines()


class Bash(Shell):
    def complete(self, line):
        self.need('bash')
        script = (f'source {SHELLS}/arbiter.bash; compopt() {{ :; }}; COMP_LINE=$1; COMP_POINT=${{#1}}; _arbiter; '
                  'printf "%s\\n" "${COMPREPLY[@]}"')
        return self.ask('bash', '--norc', '-c', script, 'bash', line)

    def test_words(self):
        self.assertEqual(self.complete('arbiter che'), ['check'])
        self.assertEqual(self.complete('arbiter check --limits '), ['enforce', 'report'])
        self.assertEqual(self.complete('arbiter check --limits=r'), ['report'])
        self.assertEqual(self.complete('arbiter draw gallery:twi'), ['twirl'])
        self.assertEqual(self.complete('arbiter compile wat'), ['water shader.fp'])
        self.assertEqual(self.complete('arbiter compile --profile=wat'), ['water shader.fp'])
        self.assertEqual(self.complete('arbiter draw --texture 0=wat'), ['water shader.fp'])
        self.assertEqual(self.complete('arbiter draw --texture 0=lan'), ['landscape'])
        self.assertEqual(self.complete('arbiter debug --pixel '), ['X,Y: the pixel', ' '])
        self.assertEqual(self.complete('arbiter debug --pixel 5'), [''])
        self.assertIn('true', self.complete('arbiter run -- tru'))


class Fish(Shell):
    def complete(self, line):
        self.need('fish')
        return self.ask('fish', '--no-config', '-c', f'source {SHELLS}/arbiter.fish; complete -C $argv[1]', line)

    def test_words(self):
        check = self.complete('arbiter che')
        self.assertEqual([line.split('\t')[0] for line in check], ['check'])
        self.assertTrue(check[0].split('\t')[1].startswith('Check programs'))
        self.assertEqual([line.strip() for line in self.complete('arbiter check --limits ')], ['enforce', 'report'])
        self.assertEqual([line.split('\t')[0] for line in self.complete('arbiter draw gallery:twi')], ['gallery:twirl'])
        self.assertIn('water shader.fp', [line.split('\t')[0] for line in self.complete('arbiter compile wat')])
        for typed in ('0=', '--texture=0='):
            texture = self.complete('arbiter draw ' + ('' if '--' in typed else '--texture ') + typed)
            words = [line.split('\t')[0] for line in texture]
            self.assertIn(f'{typed}landscape', words)
            self.assertIn(f'{typed}water shader.fp', words)
        self.assertEqual(self.complete('arbiter debug --pixel '), [])
        self.assertIn('true', [line.split('\t')[0] for line in self.complete('arbiter run -- tru')])


class Zsh(Shell):
    """Types lines into a terminal, which zsh's completion needs, and reads the completed lines."""

    def complete(self, lines):
        """Types each line followed by a tab, and returns the completed lines."""
        self.need('zsh')
        child, terminal = pty.fork()
        if child == 0:
            os.chdir(self.folder / 'here')
            os.execvpe('zsh', ['zsh', '-f'], self.environment)
        self.addCleanup(os.close, terminal)

        def read_until(mark):
            text, end = '', time.monotonic() + 60
            while mark not in text and time.monotonic() < end:
                if select.select([terminal], [], [], 0.2)[0]:
                    text += os.read(terminal, 4096).decode(errors='replace')
            self.assertIn(mark, text)
            return text

        setup = (f"PS1=''; unsetopt zle_bracketed_paste prompt_sp; fpath=({SHELLS} $fpath); autoload -Uz compinit; "
                 'compinit -u -D; zstyle ":completion:*" menu no; bindkey -e; '
                 'show() { print -r -- "<<$BUFFER>>"; BUFFER=; zle accept-line }; zle -N show; bindkey "^Xd" show; '
                 'print rea""dy\n')
        os.write(terminal, setup.encode())
        read_until('ready')
        became = []
        for line in lines:
            os.write(terminal, line.encode() + b'\t\x18d')
            became.append(re.search(r'<<(.*?)>>', read_until('>>'), re.S).group(1))
        os.write(terminal, b'exit\n')
        os.waitpid(child, 0)
        return became

    def test_words(self):
        rows = {'arbiter che': 'arbiter check ',
                'arbiter check --limits en': 'arbiter check --limits enforce ',
                'arbiter check --limits=en': 'arbiter check --limits=enforce ',
                'arbiter draw gallery:twi': 'arbiter draw gallery:twirl ',
                'arbiter draw --texture 0=landsc': 'arbiter draw --texture 0=landscape ',
                'arbiter draw --texture 0=wat': r'arbiter draw --texture 0=water\ shader.fp ',
                'arbiter compile --profile=wat': r'arbiter compile --profile=water\ shader.fp ',
                'arbiter compile wat': r'arbiter compile water\ shader.fp ',
                'arbiter run -- arbiter chec': 'arbiter run -- arbiter check '}
        self.assertEqual(self.complete(rows), list(rows.values()))


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0]] + sys.argv[3:], verbosity=2)
