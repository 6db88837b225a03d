#!/usr/bin/env python3
"""Tests of `arbiter run` and `arbiter capture` from outside: the environment in which they start commands.

usage: command_run_test.py ARBITER FAKE_LAYER SOURCE_ROOT [unittest arguments]
"""
import json
import os
import pathlib
import signal
import subprocess

import command_session
from command_session import ARBITER, FAKE, Temporary, arbiter, plain


class Run(Temporary):
    def run_env(self, *options, **environment):
        """Returns the environment of a command under `arbiter run`."""
        result = arbiter('run', '--library', FAKE, *options, '--', 'env', '-0', **environment)
        self.assertEqual(result.returncode, 0, result.stderr)
        return dict(entry.split('=', 1) for entry in result.stdout.split('\0') if entry)

    def test_sets_what_the_options_say(self):
        seen = self.run_env('--profile', 'nv30', '--limits', 'report', '--log', 'debug',
                            '--debug', 'glsl', '--host-vendor', 'mesa', '--replace', '/tmp')
        self.assertEqual(seen['LD_PRELOAD'], FAKE)
        self.assertEqual({name: value for name, value in seen.items()
                          if name.startswith('ARBITER_')},
                         {'ARBITER_PROFILE': 'nv30', 'ARBITER_LIMITS': 'report',
                          'ARBITER_LOG': 'debug', 'ARBITER_DEBUG': 'glsl', 'ARBITER_REPLACE': '/tmp',
                          'ARBITER_HOST_VENDOR': 'mesa'})

    def test_paths_become_absolute(self):
        profile = self.path('mine.toml', 'inherits = "r300"\n')
        relative = os.path.relpath(profile)
        seen = self.run_env('--stats', 's-%p.json', '--log', 'warn:l.txt', '--profile', relative)
        self.assertEqual(seen['ARBITER_STATS'], os.path.join(os.getcwd(), 's-%p.json'))
        self.assertEqual(seen['ARBITER_LOG'], 'warn:' + os.path.join(os.getcwd(), 'l.txt'))
        self.assertTrue(os.path.isabs(seen['ARBITER_PROFILE']))
        self.assertTrue(os.path.samefile(seen['ARBITER_PROFILE'], profile))

    def test_keeps_what_is_there(self):
        other = self.path('libother.so')
        other.write_bytes(pathlib.Path(FAKE).read_bytes())
        seen = self.run_env(LD_PRELOAD=str(other), LD_LIBRARY_PATH='/opt/x', ARBITER_LIMITS='report')
        self.assertEqual(seen['LD_PRELOAD'], f'{FAKE}:{other}')
        self.assertTrue(seen['LD_LIBRARY_PATH'].endswith('/opt/x'))
        self.assertEqual(seen['ARBITER_LIMITS'], 'report')

    def test_the_front_of_osmesa_comes_first(self):
        library = self.path('libGLX_arbiter.so.0')
        library.write_bytes(pathlib.Path(FAKE).read_bytes())
        front = self.path('osmesa')
        front.mkdir()
        (front / 'libOSMesa.so.8').write_bytes(b'')
        result = arbiter('run', '--library', library, '--', 'env', LD_LIBRARY_PATH='/opt/x')
        self.assertIn(f'\nLD_LIBRARY_PATH={front}:/opt/x\n', '\n' + result.stdout)

    def test_egl_gets_the_vendor_file_that_fits(self):
        library = self.path('libGLX_arbiter.so.0')
        library.write_bytes(pathlib.Path(FAKE).read_bytes())
        folder = self.path('arbiter')
        folder.mkdir()
        by_path, by_name = folder / '10_arbiter.json', folder / '11_arbiter.json'

        def chosen(variable='__EGL_VENDOR_LIBRARY_FILENAMES', **environment):
            shell = f'printf "%s" "${variable}"'
            return arbiter('run', '--library', library, '--', 'sh', '-c', shell,
                           **environment).stdout
        self.assertEqual(chosen(), '')
        by_name.write_text('{"library_path": "libGLX_arbiter.so.0"}')
        self.assertEqual(chosen(), str(by_name))
        by_path.write_text('{"library_path": "/elsewhere/libGLX_arbiter.so.0"}')  # the library was moved
        self.assertEqual(chosen(), str(by_name))
        by_path.write_text(f'{{"library_path": "{library}"}}')
        self.assertEqual(chosen(), str(by_path))
        # A vendor selected earlier becomes the layer's host.
        before = {'__EGL_VENDOR_LIBRARY_FILENAMES': '/theirs'}
        self.assertEqual(chosen(**before), str(by_path))
        self.assertEqual(chosen('ARBITER_SAVED_EGL_VENDORS', **before), '/theirs')

    def test_the_command_is_passed_on_as_it_is(self):
        def run(*words):
            return arbiter('run', '--library', FAKE, *words)
        shell = 'printf "%s|" "$@"; exit 7'
        result = run('--', 'sh', '-c', shell, 'sh', '--profile', '-x', '--', 'a b')
        self.assertEqual((result.returncode, result.stdout), (7, '--profile|-x|--|a b|'))
        result = run('sh', '-c', shell, 'sh', '--json', 'c')  # without the "--"
        self.assertEqual((result.returncode, result.stdout), (7, '--json|c|'))
        self.assertEqual(run('--', 'no-such-command').returncode, 127)
        self.assertEqual(run('--', self.path('not-executable', 'x')).returncode, 126)

    def test_usage_errors(self):
        for words in ((), ('--bogus', '--', 'true'), ('--limits', 'maybe', '--', 'true'),
                      ('--profile', 'r30', '--', 'true')):
            result = arbiter('run', '--library', FAKE, *words)
            self.assertEqual(result.returncode, 125, words)
            self.assertNotEqual(result.stderr, '', words)
        self.assertEqual(arbiter('run', '--library', '/none.so', '--', 'true').returncode, 125)
        spaced = self.path('a b.so')
        spaced.write_bytes(pathlib.Path(FAKE).read_bytes())
        self.assertIn('cannot hold', arbiter('run', '--library', spaced, '--', 'true').stderr)

    @command_session.where_programs_have_the_width
    def test_a_folder_with_a_space_is_reached_by_a_link(self):
        folder, runtime = self.path('a: b'), self.path('runtime')
        folder.mkdir()
        runtime.mkdir(mode=0o700)
        library = folder / 'libGLX_arbiter.so.0'
        library.write_bytes(pathlib.Path(FAKE).read_bytes())
        preloads = [arbiter('run', '--library', library, '--', 'sh', '-c', 'echo "$LD_PRELOAD"',
                            XDG_RUNTIME_DIR=str(runtime))
                    for _ in range(2)]
        for run in preloads:
            self.assertEqual((run.returncode, run.stderr), (0, ''))
        path = pathlib.Path(preloads[0].stdout.strip())
        self.assertEqual(path.resolve(), library.resolve())
        self.assertTrue(path.is_relative_to(runtime))
        self.assertEqual(preloads[1].stdout, preloads[0].stdout)
        self.assertEqual(len(list((runtime / 'arbiter').iterdir())), 1, 'a link is made once')
        nowhere = arbiter('run', '--library', library, '--', 'true', XDG_RUNTIME_DIR='')
        self.assertEqual(nowhere.returncode, 125)
        self.assertIn('a link to it was not made', nowhere.stderr)

    def test_print_environment_is_read_by_a_shell(self):
        result = arbiter('run', '--library', FAKE, '--print-environment', '--stats', "it's.json")
        shell = subprocess.run(['sh', '-c', result.stdout + 'printf %s "$ARBITER_STATS"'],
                               capture_output=True, text=True, env=plain())
        self.assertEqual(shell.stdout, os.path.join(os.getcwd(), "it's.json"))

    def test_identity_options_become_variables(self):
        result = arbiter('run', '--library', FAKE, '--print-environment', '--identity', 'profile',
                         '--extensions-max-year', '2003', '--extensions-max-length', '4095',
                         '--fixed-function', 'always', '--attributes', 'alias', '--extensions', 'GL_NV_fence=on',
                         '--extensions', 'GLX_EXT_swap_control=off')
        for line in ("ARBITER_ATTRIBUTES='alias'", "ARBITER_IDENTITY='profile'", "ARBITER_FIXED_FUNCTION='always'",
                     "ARBITER_EXTENSIONS_MAX_YEAR='2003'", "ARBITER_EXTENSIONS_MAX_LENGTH='4095'",
                     "ARBITER_EXTENSIONS='GL_NV_fence=on,GLX_EXT_swap_control=off'"):
            self.assertIn('export ' + line + '\n', result.stdout)
        for bad in (('--identity', 'r300'), ('--extensions-max-year', '-1'),
                    ('--extensions-max-year', '1991'), ('--extensions-max-length', '0'),
                    ('--extensions-max-length', '4k'), ('--extensions', 'GL_NV_fence'),
                    ('--extensions', 'NV_fence=on')):
            self.assertEqual(arbiter('run', '--library', FAKE, *bad, '--', 'true').returncode, 125)

    def test_records_that_are_not_there(self):
        for words in (('stats', self.path('none.json')), ('stats', self.path('none-%p.json'))):
            seen = arbiter(*words)
            self.assertEqual((seen.returncode, seen.stdout), (1, ''))
            self.assertIn(': a process writes them when it ends, and none that was killed left a record', seen.stderr)
        seen = arbiter('stats', self.path('a.json'), self.path('b.json'))
        self.assertEqual(seen.returncode, 1)
        self.assertRegex(seen.stderr, r'no statistics in \S+/a\.json:.*\n.*no statistics in \S+/b\.json:.*\n')
        seen = arbiter('stats', self.path('a.json'), self.path('none/b.json'))
        self.assertEqual(seen.stderr, f'arbiter stats: {self.path("none/b.json")}: no such folder\n')

    def statistics(self, name, program, frames=1, schema=4, draws=None, given=None, errors=(None,)):
        """Writes a file as the layer does, with the members that are added."""
        draws = {'reasons': {}, 'host_untouched': 5, 'dropped': 7} | (draws or {})
        defaults = {'program': {'name': program, 'windows': None}}
        programs = [{'error': error, 'under_native_limits': True} for error in errors]
        self.path(name, json.dumps({
            'schema': schema, 'defaults': defaults, 'contexts': [{'id': 1}], 'contexts_not_listed': 0,
            'programs': programs, 'programs_not_listed': 0, 'frames': frames, 'draws': draws,
            'software': {'given_to_host': given or {}}}))

    def test_statistics_of_several_files_end_with_a_sum(self):
        self.statistics('s-1.json', 'game', 3, draws={'host_glsl': 2, 'rasterizer': 9, 'reasons': {'no_program': 5}},
                        given={'not_compiled': 2})
        refused = {'text': '', 'refused_by_profile': {'reason': 'long', 'remedy': ''}}
        self.statistics('s-2.json', 'tool', draws={'host_glsl': 1}, given={'not_compiled': 1, 'look': 9},
                        errors=(None, refused))
        self.statistics('s-2.json.77', 'child', draws={'recorded_in_list': 1})
        self.statistics('other.json', 'other')
        pattern = self.path('s-%p.json')
        self.assertEqual(arbiter('stats', pattern).stdout.splitlines(), [
            's-1.json (game): frames 3  programs 1  rasterizer 9  no_program 5  host_glsl 2',
            's-2.json (tool): frames 1  programs 2  refused 1  host_glsl 1',
            's-2.json.77 (child): frames 1  programs 1  recorded_in_list 1',
            'sum of 3: frames 5  programs 4  refused 1  rasterizer 9  no_program 5  host_glsl 3  recorded_in_list 1',
            'given to the host: look 9  not_compiled 3'])
        twice = json.loads(arbiter('stats', '--json', self.path('s-1.json'), pattern).stdout)
        self.assertEqual([[each['program'] for each in of['reports']] for of in twice['files']],
                         [['game'], ['tool', 'child']])
        self.assertEqual(twice['sum'], {
            'files': 3, 'contexts': 3, 'frames': 5, 'programs': 4, 'over_native': 0, 'refused': 1,
            'draws': {'host_glsl': 3, 'no_program': 5, 'rasterizer': 9, 'recorded_in_list': 1},
            'given_to_host': {'look': 9, 'not_compiled': 3}})
        seen = arbiter('stats', self.path('other.json'), self.path('none.json'))
        self.assertEqual((seen.returncode, len(seen.stdout.splitlines())), (0, 1))
        self.assertIn(f'no statistics in {self.path("none.json")}', seen.stderr)
        self.assertEqual(arbiter('stats', self.path('other.json')).stdout,
                         'other.json (other): frames 1  programs 1  no draws\n')

    def test_statistics_of_the_earlier_schema_have_the_words_of_today(self):
        self.statistics('old.json', 'game', schema=2, draws={'host_glsl': 2, 'host_assembly': 3, 'recorded': 4})
        self.assertEqual(json.loads(arbiter('stats', '--json', self.path('old.json')).stdout)['sum']['draws'],
                         {'host_assembly': 3, 'host_glsl': 2, 'recorded_in_list': 4})

    def test_files_that_are_no_statistics_are_named(self):
        self.statistics('good.json', 'game')
        self.statistics('later.json', 'game', schema=99)
        for text in ('', '[]', '{"schema": 4}', '{"schema": "4"}'):
            bad = self.path('bad.json', text)
            seen = arbiter('stats', bad, self.path('good.json'), self.path('later.json'))
            self.assertEqual((seen.returncode, seen.stdout),
                             (0, 'good.json (game): frames 1  programs 1  no draws\n'))
            self.assertEqual(seen.stderr, f'arbiter stats: {bad}: is no file of statistics\narbiter stats: '
                             f'{self.path("later.json")}: was written by a later version of Arbiter\n')


class Capture(Temporary):
    def capture(self, *words):
        library = () if '--index-only' in words else ('--library', FAKE)
        # A layer built with AddressSanitizer would make a crashing command end with another status.
        env = plain(ASAN_OPTIONS=os.environ.get('ASAN_OPTIONS', '') + ':handle_segv=0')
        return subprocess.run([os.path.abspath(ARBITER), 'capture', *library, *map(str, words)],
                              capture_output=True, text=True, timeout=60, env=env,
                              cwd=self.folder.name)

    def test_the_command_sees_a_folder_that_is_private(self):
        result = self.capture('-o', 'kept', '--', 'sh', '-c',
                              'stat -c %a "$ARBITER_CAPTURE"; touch "$ARBITER_CAPTURE/x"; exit 5')
        self.assertEqual((result.returncode, result.stdout), (5, '700\n'), result.stderr)
        self.assertEqual(json.loads(self.path('kept/index.json').read_text())['programs'], [])

    def test_the_folder_is_named_for_the_command(self):
        seen = self.capture('--', 'sh', '-c', 'basename "$ARBITER_CAPTURE"')
        self.assertEqual(seen.stdout, 'sh.capture\n')
        self.assertFalse(self.path('sh.capture').exists(), 'nothing was captured')
        self.path('sh.capture').mkdir()
        seen = self.capture('--', 'sh', '-c', 'basename "$ARBITER_CAPTURE"')
        self.assertEqual(seen.stdout, 'sh.capture-2\n')

    def test_what_a_capture_lacks_is_said(self):
        folder = self.path('cut')
        folder.mkdir()
        record = {'schema': 2, 'pid': 7, 'command': 'game', 'profile': 'r300', 'frames': 300, 'contexts_made': 1,
                  'programs_not_listed': 0, 'files_not_written': 0, 'complete': True, 'programs': []}

        def said(**more):
            (folder / 'process-7-1.json').write_text(json.dumps(record | more))
            result = self.capture('--index-only', '-o', 'cut')
            self.assertEqual(result.returncode, 0, result.stderr)
            cut = [line.removeprefix('arbiter capture: cut short: ') for line in result.stderr.splitlines()
                   if 'cut short' in line]
            for line in cut:
                self.assertIn(line, (folder / 'index.html').read_text())
            return cut
        self.assertEqual(said(), [])
        self.assertEqual(said(complete=False), [
            'process 7 (game) was ended before it could complete its record, which holds 0 programs and 300 frames; '
            'what came in its last second may be missing'])
        self.assertEqual(said(programs_not_listed=17), [
            'process 7 (game) reached the limit of a record, which holds 0 programs and 300 frames; '
            '17 loads of further texts are missing'])
        self.assertEqual(said(files_not_written=1, why_not_written='No space left on device'), [
            'process 7 (game) could not write 1 file (No space left on device); '
            'its record holds 0 programs and 300 frames'])
        text = b'!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n'
        (folder / ('0' * 32 + '.fp')).write_bytes(text)
        self.assertEqual(said(), ['1 text came without a record: the process was ended too early, or could not '
                                  'write it'])

    @command_session.where_signals_come_at_once
    def test_signals(self):
        result = self.capture('--', 'sh', '-c', 'kill -ABRT $$')  # sanitizers handle SEGV themselves
        self.assertEqual(result.returncode, -signal.SIGABRT)
        for _ in range(20):  # repeated: the command's first act races with the parent's after the fork
            result = self.capture('--', 'sh', '-c', 'kill -TERM $PPID; exec sleep 30')
            self.assertEqual(result.returncode, -signal.SIGTERM, 'TERM was not passed on')

    def expect_ends(self, words, code):
        """Expects this exit status of a command, negative for a signal, under `run` and under `capture`."""
        words = words if words[:1] == ('--bogus',) else ('--', *words)
        ran = arbiter('run', '--library', FAKE, '--stats', self.path('s.json'), *words)
        self.assertEqual((ran.returncode, self.capture(*words).returncode), (code, code), words)

    def test_run_ends_alike(self):
        plain = self.path('plain', 'x')
        for words, code in ((('sh', '-c', 'exit 7'), 7), (('sh', '-c', 'exit 1'), 1),
                            (('sh', '-c', 'kill -ABRT $$'), -signal.SIGABRT),
                            (('./nothing',), 127), ((plain,), 126), (('--bogus',), 125), ((), 125)):
            self.expect_ends(words, code)

    @command_session.where_signals_come_at_once
    def test_run_passes_signals_on_alike(self):
        self.expect_ends(('sh', '-c', 'kill -TERM $PPID; exec sleep 30'), -signal.SIGTERM)

    def test_errors(self):
        self.path('file').write_text('')
        self.path('kept').mkdir()
        (self.path('kept') / ('0' * 32 + '.fp')).write_text('edited')
        self.path('old').mkdir()
        (self.path('old') / 'process-1-2.json').write_text('{}')
        for words, text in ((('-o', 'file', '--', 'true'), 'file'),
                            (('-o', 'no/such', '--', 'true'), 'no/such'),
                            (('-o', 'kept', '--', 'true'), 'is edited'),
                            (('-o', 'old', '--', 'true'), 'holds a capture'),
                            ((), 'no command to run'),
                            (('--index-only',), '--index-only takes a folder'),
                            (('--index-only', '-o', 'none'), 'none: no such folder'),
                            (('--index-only', '-o', 'kept', '--', 'true'), 'no command'),
                            (('--replace', 'none', '--', 'true'), 'none: no such folder')):
            result = self.capture(*words)
            self.assertEqual(result.returncode, 125, words)
            self.assertIn(text, result.stderr, words)
        self.assertEqual(self.capture('--', './nothing').returncode, 127)
        self.assertEqual((self.path('kept') / ('0' * 32 + '.fp')).read_text(), 'edited')


if __name__ == '__main__':
    command_session.main()
