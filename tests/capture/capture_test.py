#!/usr/bin/env python3
"""Tests `arbiter capture` and `arbiter run --replace` on real clients: the folder's content, its tests under piglit,
and edited texts that are drawn while the application runs.

usage: capture_test.py ARBITER LIGHTING LIFE TICKER STATE_TICKER [unittest arguments]
TICKER draws repeatedly and prints the color; see ticker.cpp. STATE_TICKER does so by register combiners, texture
shaders, and a shader made by ATI_fragment_shader's commands; see state_ticker.cpp.
"""
import contextlib
import html.parser
import json
import os
import pathlib
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'clients'))
from plain_environment import plain  # noqa: E402
from setting import width  # noqa: E402

ARBITER, LIGHTING, LIFE, TICKER, STATE_TICKER = (os.path.abspath(path) for path in sys.argv[1:6])
SHADER_RUNNERS = list(pathlib.Path('/usr/lib').glob('*/piglit/bin/shader_runner'))
# A red and an invalid program in the other languages.
KINDS = {
    'vertex': ('.vp', b'!!ARBvp1.0\nMOV result.position, vertex.position;\n'
               b'MOV result.color, {1, 0, 0, 1};\nEND\n',
               b'!!ARBvp1.0\nMOV result.color, nothing;\nEND\n'),
    'ati': ('.atifs', b'!!ATIfs1.0\nStartConstants; CONSTANT c0 = {1.0, 0.0, 0.0, 1.0}; EndConstants;\n'
            b'StartOutputPass; MOV r0, c0; EndPass;\n',
            b'!!ATIfs1.0\nStartOutputPass;MOV nothing, c0;EndPass;\n'),
}
RED = b'!!ARBfp1.0\nMOV result.color, {1, 0, 0, 1};\nEND\n'
BLUE = b'!!ARBfp1.0\n# of another length\nMOV result.color, {0, 0, 1, 1};\nEND\n'
WRONG = b'!!ARBfp1.0\nMOV result.color, nothing;\nEND\n'


def run(*words, **more):
    return subprocess.run([str(word) for word in words], env=plain(**more), timeout=120,
                          capture_output=True, text=True, errors='replace')


class Folder(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix='arbiter-capture-')
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name) / 'folder'

    def capture(self, *command, code=0):
        result = run(ARBITER, 'capture', '-o', self.folder, '--', *command)
        self.assertEqual(result.returncode, code, result.stderr)
        return json.loads((self.folder / 'index.json').read_text())

    def put(self, name, text):
        (self.folder / (name + '.new')).write_bytes(text)
        os.replace(self.folder / (name + '.new'), self.folder / name)  # as editors do


class Page(html.parser.HTMLParser):
    """Fails on resources from elsewhere; keeps the text."""

    def __init__(self):
        super().__init__()
        self.text, self.outside, self.open = '', [], []

    def handle_starttag(self, tag, attributes):
        self.outside += [value for name, value in attributes
                         if name in ('src', 'href') and value and '//' in value]

    def handle_data(self, data):
        self.text += data


class Capture(Folder):
    def test_the_index_says_what_was_drawn(self):
        index = self.capture(LIGHTING, '--headless', '--size', '32x32', '--frames', '3')
        self.assertEqual(index['schema'], 2)
        self.assertEqual([p['complete'] for p in index['processes']], [True])
        program, = index['programs']
        text = (self.folder / program['file']).read_bytes()
        self.assertTrue(text.startswith(b'!!ARBfp1.0'))
        self.assertEqual(len(text), program['bytes'])
        checked = json.loads(run(ARBITER, 'check', '--json', self.folder / program['file']).stdout)
        self.assertEqual(checked['files'][0]['hash'], program['hash'])
        self.assertEqual((program['target'], program['loads'], program['draws']),
                         ('fragment', 1, 3))
        self.assertEqual(sum(program['draws_by'].values()), 3)
        self.assertIsNone(program['error'])
        for name, row in checked['files'][0]['counts'].items():
            self.assertEqual(program['counts'][name], row['used'], name)
        self.assertIn('#version 120', program['glsl'])
        self.assertEqual([(t['unit'], t['target'], t['width'], t['format'])
                          for t in program['textures']],
                         [(0, '2D', 32, 'RGBA8'), (1, '2D', 32, 'RGBA8')])
        self.assertEqual([p['name'] for p in program['parameters']],
                         [f'program.local[{i}]' for i in range(3)])

    def test_who_drew_is_counted(self):
        for backend, path in (('host', 'host_glsl'), ('swrast', 'rasterizer')):
            folder = self.folder.parent / backend
            result = run(ARBITER, 'capture', '--backend', backend, '-o', folder, '--', LIGHTING,
                         '--headless', '--size', '32x32', '--frames', '3')
            self.assertEqual(result.returncode, 0, result.stderr)
            program, = json.loads((folder / 'index.json').read_text())['programs']
            self.assertEqual((program['path'], program['draws_by']), (path, {path: 3}))
            self.assertIn(f'drawn by {path}.', (folder / 'index.html').read_text())
        # The two halves of a run stand for two processes in one index.
        record, = (self.folder.parent / 'swrast').glob('process-*.json')
        shutil.copy(record, self.folder.parent / 'host' / ('process-2' + record.name[7:]))
        run(ARBITER, 'capture', '--index-only', '-o', self.folder.parent / 'host')
        program, = json.loads((self.folder.parent / 'host' / 'index.json').read_text())['programs']
        self.assertEqual(program['draws_by'], {'host_glsl': 3, 'rasterizer': 3})
        self.assertEqual(program['path'], 'host_glsl 3, rasterizer 3')

    def test_parameters_are_those_of_the_last_draw(self):
        index = self.capture(TICKER, 'fragment', '3')
        program = next(p for p in index['programs'] if p['draws'])
        # It sets local[0].x to the frame's number before each draw, and to 99 after it.
        self.assertEqual(program['parameters'],
                         [{'name': 'program.local[0]', 'value': [2, 0, 0, 0]}])
        self.assertEqual((program['draws'], program['frames']), (3, 1))

    def test_a_refused_text_with_bytes_that_are_not_utf_8(self):
        index = self.capture(TICKER, 'fragment', '1')
        program = next(p for p in index['programs'] if p['error'])
        self.assertIn(b'\xe9', (self.folder / program['file']).read_bytes())
        self.assertEqual((program['error']['line'], program['error']['column']), (3, 19))
        self.assertIn("'missing' is not declared", program['error']['text'])
        page = Page()
        page.feed((self.folder / 'index.html').read_text())  # strict UTF-8
        self.assertEqual(page.outside, [])
        self.assertIn("'missing' is not declared", page.text)
        self.assertIn('\\xE9', page.text)
        self.assertIn(program['hash'][:12], page.text)

    def test_several_processes_are_merged(self):
        twice = f'"{LIGHTING}" --headless --size 8x8 --frames 2'
        index = self.capture('sh', '-c', f'{twice}; {twice}; "{LIFE}" --headless --size 32x32 '
                             '--frames 1 --form packed')
        self.assertEqual(len(index['processes']), 3)
        program = next(p for p in index['programs'] if len(p['processes']) == 2)
        self.assertEqual((program['loads'], program['draws']), (2, 4))
        self.assertEqual(len({each['pid'] for each in program['processes']}), 2)
        self.assertEqual([each['contexts'] for each in program['processes']], [[1], [1]])
        self.assertGreater(len(index['programs']), 1)

    def test_a_process_that_is_killed_leaves_what_it_loaded(self):
        with subprocess.Popen([ARBITER, 'capture', '-o', self.folder, '--', TICKER], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=plain()) as process:
            process.stdout.readline()  # it has drawn
            pid = int(next(self.folder.glob('process-*.json')).name.split('-')[1])
            os.kill(pid, signal.SIGKILL)
            said = process.communicate(timeout=60)[1]
            self.assertEqual(process.returncode, -signal.SIGKILL)
        self.assertIn(f'cut short: process {pid} (capture_ticker) was ended before', said)
        index = json.loads((self.folder / 'index.json').read_text())
        self.assertEqual([p['complete'] for p in index['processes']], [False])
        self.assertEqual(sorted(p['error'] is None for p in index['programs']), [False, True])
        self.assertEqual([p.name for p in self.folder.glob('*.tmp')], [])

    def test_a_text_that_cannot_be_written_is_said(self):
        """The size of the client's files is limited to 8 KiB, which its text does not fit."""
        result = run(ARBITER, 'capture', '-o', self.folder, '--', 'sh', '-c',
                     f"trap '' XFSZ; ulimit -f 16; exec '{TICKER}' long 1")
        self.assertEqual((result.returncode, result.stdout), (0, '0 255 0\n'))
        self.assertIn('(capture_ticker) could not write 1 file (File too large); its record holds 2 programs',
                      result.stderr)
        process, = json.loads((self.folder / 'index.json').read_text())['processes']
        self.assertEqual((process['complete'], process['files_not_written']), (True, 1))
        self.assertIn('could not write 1 file', (self.folder / 'index.html').read_text())

    def test_a_record_that_is_damaged_or_lost_leaves_the_texts(self):
        self.capture(LIGHTING, '--headless', '--size', '8x8', '--frames', '1')
        record, = self.folder.glob('process-*.json')
        for damage in (lambda: record.write_text(record.read_text()[:700]),
                       lambda: record.write_text('{"schema": 2, "programs": 7}'), record.unlink):
            damage()
            again = run(ARBITER, 'capture', '--index-only', '-o', self.folder)
            self.assertEqual(again.returncode, 0, again.stderr)
            program, = json.loads((self.folder / 'index.json').read_text())['programs']
            self.assertEqual(program['counts']['alu_instructions'], 24)

    def test_links_and_files_of_others_stay(self):
        self.folder.mkdir()
        self.capture(TICKER, 'fragment', '1')
        name = next(self.folder.glob('*.fp')).name
        for path in self.folder.iterdir():
            path.unlink()
        victim = self.folder.parent / 'victim'
        victim.write_text('precious')
        (self.folder / 'index.json').symlink_to(victim)
        (self.folder / name).symlink_to(victim)
        run(ARBITER, 'capture', '-o', self.folder, '--', TICKER, 'fragment', '1')
        self.assertEqual(victim.read_text(), 'precious')

    @unittest.skipUnless(SHADER_RUNNERS, 'not installed: piglit')
    def test_shader_tests_run(self):
        for name, command in (('pixels', (LIGHTING, '--headless', '--size', '32x32')),
                              ('vertices', (TICKER, 'vertex', '1'))):
            self.folder = self.folder.parent / name
            program = next(p for p in self.capture(*command)['programs'] if p['draws'])
            test = self.folder / (program['file'] + '.shader_test')
            fronts = [(), (ARBITER, 'run', '--')]
            if width(SHADER_RUNNERS[0]) != width(ARBITER):
                fronts.pop()  # a 32-bit tree, unlike this machine's piglit
            for front in fronts:
                result = run(*front, SHADER_RUNNERS[0], test, '-auto', '-fbo',
                             PIGLIT_PLATFORM='surfaceless_egl')
                self.assertIn('"result": "pass"', result.stdout, result.stderr)


@contextlib.contextmanager
def ticking(folder, kind='fragment', client=TICKER, *options):
    """Starts a TICKER under replacement; yields a function that waits until it has drawn a color."""
    with subprocess.Popen([ARBITER, 'run', *options, '--replace', folder, '--', client, kind],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          env=plain()) as process:
        rest = last = b''

        def waits_for(colour, seconds=20):
            nonlocal rest, last
            end = time.monotonic() + seconds
            while time.monotonic() < end:
                if select.select([process.stdout], [], [], 0.1)[0]:
                    rest += os.read(process.stdout.fileno(), 4096)
                    lines = rest.split(b'\n')
                    rest = lines.pop()
                    if b'unlike' in b' '.join(lines):
                        raise AssertionError('the application noticed')
                    last = lines[-1] if lines else last
                if last == colour:
                    return True
            return False

        try:
            yield waits_for, process
        finally:
            process.terminate()


class Replace(Folder):
    """TICKER's own program draws green."""

    def test_an_edit_is_drawn_while_the_application_runs(self):
        index = self.capture(TICKER, 'fragment', '1')
        name = next(p['file'] for p in index['programs'] if p['draws'])
        own = (self.folder / name).read_bytes()
        with ticking(self.folder) as (waits_for, process):
            self.assertTrue(waits_for(b'0 255 0'))
            self.put(name, RED)
            self.assertTrue(waits_for(b'255 0 0'), 'the edit was not seen')
            with open(self.folder / name, 'wb') as file:  # in place
                file.write(BLUE)
            self.assertTrue(waits_for(b'0 0 255'))
            self.put(name, WRONG)
            end = time.monotonic() + 20
            log = b''
            while b'undeclared_name' not in log and time.monotonic() < end:
                if select.select([process.stderr], [], [], 0.1)[0]:
                    log += os.read(process.stderr.fileno(), 4096)
                waits_for(b'', 0.05)
            self.assertIn(f'{self.folder}/{name}:2:19: error: '.encode(), log)
            self.assertIn(b'\n                    ^~~~~~~\n', log)
            self.assertFalse(waits_for(b'0 255 0', 1), 'the last good text is lost')
            self.assertTrue(waits_for(b'0 0 255'))
            (self.folder / name).unlink()
            self.assertTrue(waits_for(b'0 255 0'), 'the own text is not back')
            self.put(name, RED)
            self.assertTrue(waits_for(b'255 0 0'), 'a new file was not seen')
            self.put(name, own)
            self.assertTrue(waits_for(b'0 255 0'))

    def test_the_other_languages(self):
        for kind, (extension, red, wrong) in KINDS.items():
            with self.subTest(kind=kind):
                self.folder = self.folder.parent / kind
                index = self.capture(TICKER, kind, '3')
                program = next(p for p in index['programs'] if p['draws'])
                name = program['file']
                self.assertTrue(name.endswith(extension))
                self.assertEqual(program['draws'], 3)
                self.assertEqual(program['parameters'],
                                 [{'name': 'program.local[0]', 'value': [2, 0, 0, 0]}])
                self.assertIn('#version 120', program['glsl'])
                self.assertEqual(sum(p['error'] is not None for p in index['programs']), 1)
                with ticking(self.folder, kind) as (waits_for, _):
                    self.assertTrue(waits_for(b'0 255 0'))
                    self.put(name, red)
                    self.assertTrue(waits_for(b'255 0 0'), 'the edit was not seen')
                    self.put(name, wrong)
                    self.assertFalse(waits_for(b'0 255 0', 1), 'the last good text is lost')
                    (self.folder / name).unlink()
                    self.assertTrue(waits_for(b'0 255 0'), 'the own text is not back')

    def test_a_file_with_both_programs_of_a_material(self):
        index = self.capture(TICKER, 'fragment', '1')
        name = next(p['file'] for p in index['programs'] if p['draws'])
        vertex = b'# A material.\n!!ARBvp1.0\nMOV result.position, vertex.position;\nEND\n\n'
        again = (ARBITER, 'run', '--replace', self.folder, '--', TICKER, 'fragment', '1')
        self.put(name, vertex + RED)
        self.assertEqual(run(*again).stdout, '255 0 0\n')
        self.put(name, vertex + WRONG)
        result = run(*again)
        self.assertEqual(result.stdout, '0 255 0\n')
        self.assertIn(f'{name}:7:19: error: ', result.stderr)

    def test_a_wrong_text_at_the_start_leaves_the_own(self):
        index = self.capture(TICKER, 'fragment', '1')
        name = next(p['file'] for p in index['programs'] if p['draws'])
        self.put(name, WRONG)
        result = run(ARBITER, 'run', '--replace', self.folder, '--', TICKER, 'fragment', '1')
        self.assertEqual(result.stdout, '0 255 0\n')
        self.assertIn(f'{name}:2:19: error: ', result.stderr)

    def test_a_refused_text_may_be_replaced(self):
        index = self.capture(TICKER, 'fragment', '1')
        name = next(p['file'] for p in index['programs'] if p['error'])
        self.put(name, RED)
        result = run(ARBITER, 'run', '--replace', self.folder, '--', TICKER, 'fragment', '1')
        self.assertEqual(result.stdout, 'accepted\n0 255 0\n')

    def test_a_capture_of_a_replaced_program_keeps_both(self):
        index = self.capture(TICKER, 'fragment', '1')
        name = next(p['file'] for p in index['programs'] if p['draws'])
        self.put(name, RED)
        other = self.folder.parent / 'other'
        result = run(ARBITER, 'capture', '--replace', self.folder, '-o', other, '--', TICKER,
                     'fragment', '1')
        self.assertEqual(result.stdout, '255 0 0\n')
        program = next(p for p in json.loads((other / 'index.json').read_text())['programs']
                       if p['draws'])
        self.assertEqual((program['file'], program['replaced'], program['edited']),
                         (name, True, False))


class States(Folder):
    """STATE_TICKER's state draws green."""
    KINDS = {
        'combiners': ('nv25', '.nvrc', b'!!RC1.0\n{\n  rgb {\n    spare0 = const0;\n  }\n  alpha {\n',
                      b'!!RC1.0\nconst0 = (1, 0, 0, 1);\nout.rgb = const0;\n'),
        'texture_shaders': ('nv25', '.nvts', b'!!TS1.0\npass_through();\n!!RC1.0\n{\n  rgb {\n    spare0 = tex0;\n',
                            b'!!TS1.0\npass_through();\n!!RC1.0\nconst0 = (1, 0, 0, 1);\n'
                            b'{ rgb { spare0 = unsigned_invert(tex0); } }\nout.rgb = const0 * spare0;\n'),
        'ati_fragment_api': ('r300', '.atifs',
                             b'!!ATIfs1.0\nStartConstants;\n  CONSTANT c0 = program.env[0];\nEndConstants;\n',
                             b'!!ATIfs1.0\nStartConstants; CONSTANT c0 = {1, 0, 0, 1}; EndConstants;\n'
                             b'StartOutputPass;\nMOV r0, c0;\nEndPass;\n'),
    }

    def capture(self, *command, code=0, card='nv25'):
        result = run(ARBITER, 'capture', '--profile', card, '-o', self.folder, '--', *command)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stdout, '0 255 0\n')
        return json.loads((self.folder / 'index.json').read_text())

    def test_states_are_captured_and_replaced(self):
        for kind, (card, extension, text, red) in self.KINDS.items():
            with self.subTest(kind=kind):
                self.folder = self.folder.parent / kind
                index = self.capture(STATE_TICKER, kind, '3', card=card)
                program, = index['programs']
                name = program['file']
                self.assertTrue(name.endswith(extension))
                self.assertEqual((program['draws'], program['error']), (3, None))
                self.assertEqual(program['counts']['alu_instructions'], 1)
                self.assertIn('#version 120', program['glsl'])
                self.assertFalse(list(self.folder.glob('*.shader_test')))
                own = (self.folder / name).read_bytes()
                self.assertTrue(own.startswith(text), own)
                checked = run(ARBITER, 'check', '--profile', card, self.folder / name)
                self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)
                with ticking(self.folder, kind, STATE_TICKER, '--profile', card) as (waits_for, _):
                    self.assertTrue(waits_for(b'0 255 0'))
                    self.put(name, red)
                    self.assertTrue(waits_for(b'255 0 0'), 'the edit was not seen')
                    self.put(name, red + b'nothing();\n')
                    self.assertFalse(waits_for(b'0 255 0', 1), 'the last good text is lost')
                    self.put(name, red.replace(b'1, 0, 0, 1', b'1, 0, 1, 1'))
                    self.assertTrue(waits_for(b'255 0 255'), 'a second edit was not seen')
                    (self.folder / name).unlink()
                    self.assertTrue(waits_for(b'0 255 0'), 'the own state is not back')

    def test_a_text_over_the_card_is_refused(self):
        index = self.capture(STATE_TICKER, 'combiners', '1')
        name = index['programs'][0]['file']
        stage = b'{ rgb { spare0 = const0; } }\n'
        self.put(name, b'!!RC1.0\n' + stage * 3 + b'out.rgb = unsigned_invert(spare0);\n')
        result = run(ARBITER, 'run', '--profile', 'nv10', '--replace', self.folder, '--', STATE_TICKER,
                     'combiners', '1')
        self.assertEqual(result.stdout, '0 255 0\n')
        self.assertIn(f'{name}:4:1: error: more than 2 general stages', result.stderr)
        result = run(ARBITER, 'run', '--profile', 'nv20', '--replace', self.folder, '--', STATE_TICKER,
                     'combiners', '1')
        self.assertEqual(result.stdout, '255 0 255\n')


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1] + sys.argv[6:], verbosity=2)
