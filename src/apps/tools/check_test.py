#!/usr/bin/env python3
"""Tests of `arbiter check` over many files and on a terminal, of its JSON and of --compare.

usage: check_test.py ARBITER SOURCE_ROOT [unittest arguments]
"""
import json
import os
import pathlib
import pty
import random
import re
import select
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'tests' / 'clients'))
from plain_environment import plain  # noqa: E402

ARBITER, ROOT = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2])
PROGRAMS = ROOT / 'demos' / 'programs'
GOOD = '!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n'
VERTEX = '!!ARBvp1.0\nMOV result.position, vertex.position;\nEND\n'
BAD = '!!ARBfp1.0\nMOV result.color, q;\nEND\n'
ATI = '!!ATIfs1.0\nStartOutputPass;\nSampleMap r0, t0.str;\nMOV r0, color0;\nEndPass;\n'
RESOURCES = ['instructions', 'alu_instructions', 'tex_instructions', 'tex_indirections',
             'temporaries', 'parameters', 'attribs']


def environment(**changes):
    base = {name: value for name, value in plain().items()
            if not name.startswith('LC_') and name not in ('LANG', 'NO_COLOR')}
    return {**base, 'LC_ALL': 'C', 'TERM': 'xterm', **changes}


def check(*words, cwd=None, text=None, **changes):
    return subprocess.run([ARBITER, 'check', *map(os.fsencode, words)], capture_output=True,
                          cwd=cwd, input=text, text=True, errors='surrogateescape',
                          env=environment(**changes), timeout=60)


def on_terminal(*words, cwd=None, stdin=None, **changes):
    """Returns the output of `arbiter check` on a terminal, both streams, without the CR before each LF.

    stdin: (seconds, text): the text to send, and the delay before it.
    """
    terminal, client = pty.openpty()
    with subprocess.Popen([ARBITER, 'check', *map(str, words)], stdin=subprocess.PIPE,
                          stdout=client, stderr=client, cwd=cwd,
                          env=environment(**changes)) as process:
        os.close(client)
        if stdin:
            time.sleep(stdin[0])
            process.stdin.write(stdin[1].encode())
        process.stdin.close()
        seen = b''
        while select.select([terminal], [], [], 30)[0]:
            try:
                piece = os.read(terminal, 65536)
            except OSError:  # Linux reports a closed other side as an error
                break
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
        folder = tempfile.TemporaryDirectory(prefix='arbiter-check-')
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def path(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path


class Terminal(Temporary):
    ROW = r'(?m)^  attribs +1 +10 +1 +10  (.*)$'

    def row(self, text):
        return re.search(self.ROW, text).group(1)

    def test_ascii_in_a_pipe(self):
        path = self.path('good.fp', GOOD)
        self.assertEqual(self.row(check(path, LC_ALL='C.UTF-8').stdout), '[#.........] [#.........]')
        self.assertEqual(self.row(check('--gauges=always', path).stdout),
                         '[#.........] [#.........]', 'the locale C has no blocks')
        self.assertEqual(self.row(check('--gauges=always', path, LC_ALL='C.UTF-8').stdout),
                         '█········· █·········')
        self.assertRegex(check('--gauges=never', path).stdout, r'(?m)^  attribs +1 +10 +1 +10$')

    def test_blocks_and_colours_on_a_terminal(self):
        path = self.path('good.fp', GOOD)
        green = '\x1b[32m{}\x1b[0m'
        bar = green.format('█·········')
        seen = on_terminal(path, LC_ALL='C.UTF-8')
        self.assertEqual(self.row(seen), f'{bar} {bar}')
        self.assertIn(green.format('valid, within the native limits of r300'), seen)
        self.assertEqual(self.row(on_terminal(path, LC_ALL='C.UTF-8', NO_COLOR='1')),
                         '█········· █·········')
        self.assertEqual(self.row(on_terminal(path, LC_ALL='C.UTF-8', TERM='dumb')),
                         '█········· █·········')
        bar = green.format('[#.........]')
        self.assertEqual(self.row(on_terminal(path)), f'{bar} {bar}')

    def test_diagnostics_have_colours_on_a_terminal(self):
        """Colors the place, the kind, the carets and the hint as GCC does."""
        path = self.path('bad.fp', '!!ARBfp1.0\nTEMP colour;\nMOV result.color, color;\nEND\n')
        lines = check(path).stdout.splitlines()
        self.assertEqual([lines[0].split(': ')[1], lines[2].strip(), lines[3].split(':')[0]],
                         ['error', '^~~~~', '  hint'])
        lines[0] = lines[0].replace(f'{path}:3:19:', f'\x1b[1m{path}:3:19:\x1b[0m') \
            .replace(' error:', ' \x1b[1;31merror:\x1b[0m')
        lines[2] = f'\x1b[1;31m{lines[2]}\x1b[0m'
        lines[3] = lines[3].replace('  hint:', '\x1b[1;36m  hint:\x1b[0m')
        self.assertEqual(on_terminal(path).splitlines()[:4], lines[:4])
        self.assertEqual(on_terminal('--brief', path).splitlines()[0], lines[0])
        self.assertNotIn('\x1b', on_terminal(path, NO_COLOR='1'))

    def test_over_is_red_on_a_terminal(self):
        seen = on_terminal('--profile', 'r300-catalyst-2004', self.path('wide.fp', alu(70)))
        self.assertIn('\x1b[31m[#########>]\x1b[0m\x1b[31m  over the native limit\x1b[0m\n', seen)

    def test_progress_of_a_long_run_leaves_nothing_behind(self):
        for i in range(9):
            self.path(f'{i}.fp', GOOD)
        for delay in (0.5, 3, 12):  # a busy machine may start the command after its input arrives
            seen = on_terminal('-', self.folder, stdin=(delay, GOOD), NO_COLOR='1')
            if '1 of 10 files' in seen:
                break
        self.assertRegex(seen, r'\r\[#\.{9}\] 1 of 10 files')
        self.assertIn('\r\x1b[K10 files under r300: 10 valid\n', seen)
        self.assertNotIn('of 10 files', check('-', self.folder, text=GOOD).stderr)


class Many(Temporary):
    def test_folders(self):
        self.path('b/good.fp', GOOD)
        self.path('b/deep/er/v.vp', VERTEX)
        self.path('b/by_header.txt', ATI)
        self.path('b/notes.txt', 'MOV result.color, fragment.color;\n')
        self.path('b/.hidden/x.fp', BAD)
        self.path('a.fp', BAD)
        self.path('b/B.fp', alu(65))
        os.symlink('.', self.folder / 'b' / 'loop')
        result = check('.', cwd=self.folder)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stderr, '')
        self.assertEqual(result.stdout, '''\
./a.fp:2:19: error: 'q' is not declared [undeclared_name]
./b/B.fp:67:1: error: more than 64 ALU instructions, the limit of ATI Radeon 9700 (r300) [limit_alu_instructions]
5 files under r300: 3 valid, 2 invalid
''' + result.stdout[result.stdout.index('the fullest'):])
        self.assertIn('the fullest of 1 ARBvp1.0 program:\n', result.stdout)
        self.assertIn('''\
do not fit:
  ALU instructions         -       -  ./b/B.fp: more than 64 ALU instructions, the limit of ATI Radeon 9700 (r300)
''', result.stdout)
        files = json.loads(check('--json', 'b', 'a.fp', cwd=self.folder).stdout)['files']
        self.assertEqual([file['file'] for file in files],
                         ['b/B.fp', 'b/by_header.txt', 'b/deep/er/v.vp', 'b/good.fp', 'a.fp'])
        brief = check('--brief', '.', cwd=self.folder).stdout
        self.assertEqual(brief.splitlines(), result.stdout.splitlines()[:2])

    def test_why_and_gauges_give_each_file_its_table(self):
        self.path('good.fp', GOOD)
        for option in ('--why', '--gauges=always'):
            self.assertIn('good.fp: valid, within', check(option, self.folder).stdout)
        self.assertNotIn('good.fp: valid, within', check(self.folder).stdout)

    def test_few_files_have_tables_and_a_line(self):
        good, bad = self.path('good.fp', GOOD), self.path('bad.fp', BAD)
        lines = check(good, bad).stdout.splitlines()
        self.assertEqual(lines[-1], '2 files under r300: 1 valid, 1 invalid')
        self.assertIn(f'{good}: valid, within the native limits of r300', lines)
        self.assertNotIn(' under r300:', check(good).stdout)

    def test_what_a_valid_program_hardly_means(self):
        doubtful = self.path('a.fp', '!!ARBfp1.0\nTEMP a;\nMUL result.color, a, 2.0;\nEND\n')
        result = check(doubtful)
        self.assertEqual(result.returncode, 0)
        self.assertIn(f'{doubtful}: valid, within', result.stdout)
        self.assertIn(f"{doubtful}:3:19: warning: 'a' is read before anything writes it [unwritten_temporary]\n",
                      result.stdout)
        [found] = json.loads(check('--json', doubtful).stdout)['files'][0]['diagnostics']
        self.assertEqual((found['severity'], found['id']), ('warning', 'unwritten_temporary'))
        for program in (GOOD, VERTEX):
            self.assertNotIn('warning', check(self.path('b.fp', program)).stdout)

    def test_what_cannot_be_read(self):
        self.path('good.fp', GOOD)
        os.symlink('nowhere', self.folder / 'gone.fp')
        (self.folder / 'empty').mkdir()
        result = check('.', 'empty', 'none.fp', cwd=self.folder)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr, '''\
arbiter check: empty: no programs in this folder
arbiter check: ./gone.fp: No such file or directory
arbiter check: none.fp: No such file or directory
''')
        self.assertIn('3 files under r300: 1 valid, 2 unreadable\n', result.stdout)
        document = json.loads(check('--json', '.', 'empty', cwd=self.folder).stdout)
        self.assertEqual([file['status'] for file in document['files']], ['unreadable', 'valid'])
        self.assertEqual(document['summary']['unreadable'], 1)

    def test_the_folder_of_a_capture(self):
        for name, text in (('0123.fp', GOOD), ('0123.fp.glsl', '#version 120\n'),
                           ('0123.fp.shader_test', '[require]\n\n[fragment program]\n' + GOOD),
                           ('45.vp', VERTEX), ('67.atifs', ATI), ('index.json', '{}'),
                           ('index.html', '<html>')):
            self.path('game.capture/' + name, text)
        files = json.loads(check('--json', self.folder / 'game.capture').stdout)['files']
        self.assertEqual([pathlib.Path(file['file']).name for file in files],
                         ['0123.fp', '45.vp', '67.atifs'])

    def test_a_full_disk_is_no_success(self):
        for i in range(200):  # more output than a buffer holds
            self.path(f'{i}.fp', GOOD)
        with open('/dev/full', 'w') as full:
            for words in (('--json', self.folder), (self.folder,)):
                result = subprocess.run([ARBITER, 'check', *words], stdout=full, text=True,
                                        stderr=subprocess.PIPE, env=environment(), timeout=60)
                self.assertEqual(result.returncode, 1)
                self.assertEqual(result.stderr, 'arbiter check: standard output cannot be written\n')

    def test_names_that_are_not_text(self):
        odd = os.fsencode(self.folder) + b'/\xff\x1b[2J.fp'
        with open(odd, 'w') as file:
            file.write(BAD)
        seen = check(os.fsdecode(odd))
        self.assertNotIn('\x1b', seen.stdout)
        self.assertIn('\udcff\\x1b[2J.fp:2:19: error: ', seen.stdout)
        [file] = json.loads(check('--json', self.folder).stdout)['files']
        self.assertIn('\ufffd', file['file'])
        self.assertEqual(bytes.fromhex(file['file_hex']), odd)

    def test_a_thousand_files(self):
        chance = random.Random(7)
        operations = ('ADD {}, {}, {};', 'MUL {}, {}, {};', 'DP3 {}, {}, {};', 'MAX {}, {}, {};')
        for i in range(1000):
            lines = ['!!ARBfp1.0', 'TEMP a, b, c, d;', 'TEX a, fragment.texcoord[0], texture[0], 2D;']
            lines += [chance.choice(operations).format(*chance.choices('abcd', k=3))
                      for _ in range(chance.randrange(4, 60))]
            lines += ['TEX b, a, texture[1], 2D;', 'MOV result.color, b;', 'END', '']
            self.path(f'{i % 10}/{i:04}.fp', '\n'.join(lines))
        for words in ((), ('--json',), ('--why',)):
            begin = time.monotonic()
            result = check(*words, self.folder)
            seconds = time.monotonic() - begin
            print(f'1,000 files {" ".join(words)}: {seconds:.3f} s', file=sys.stderr)
            self.assertIn(result.returncode, (0, 3), result.stderr)
            self.assertLess(seconds, 30, 'not the promise, which a busy machine may miss')
        self.assertIn('1000 files under r300: ', result.stdout)
        self.assertEqual(check(self.folder).stdout, check(self.folder).stdout)


class Json(Temporary):
    def test_native(self):
        document = json.loads(check('--json', PROGRAMS / 'life_packed.fp').stdout)
        [file] = document['files']
        native = file['native']
        self.assertEqual(list(native), ['model', 'fits', 'reasons', 'instructions', 'nodes',
                                        'chain', 'cycles'])
        self.assertIn(native['model'], ('documented', 'r300', 'nv30', 'i915', 'nv35'))
        self.assertEqual(native['fits'], file['under_native_limits'])
        text = (PROGRAMS / 'life_packed.fp').read_bytes()
        places = [place for reason in native['reasons'] for place in reason['instructions']]
        places += native['instructions'] + native['chain']
        places += [place for node in native['nodes'] for place in node['textures']]
        for place in places:
            statement = text[place['begin']:place['end']]
            self.assertTrue(statement.startswith(place['opcode'].encode()), place)
            self.assertEqual(text[:place['begin']].count(b'\n') + 1, place['line'])
        for reason in native['reasons']:
            self.assertIn(reason['resource'], RESOURCES)
            self.assertTrue(reason['text'])
        if native['model'] == 'r300':
            self.assertEqual(len(native['instructions']), file['counts']['instructions']['used'])
            self.assertEqual(len(native['nodes']),
                             file['counts']['tex_indirections']['native_used'])
            self.assertEqual(native['nodes'][0]['reason'], '')
            self.assertTrue(all(node['reason'] for node in native['nodes'][1:]))
            self.assertGreater(native['cycles']['cycles'], 0)

    def test_what_is_only_documented(self):
        [file] = json.loads(check('--json', self.path('v.vp', VERTEX)).stdout)['files']
        self.assertEqual(file['native']['model'], 'documented')
        self.assertEqual(file['native']['instructions'], [])
        self.assertIsNone(file['native']['cycles'])
        self.assertIn('  native: documented, not modelled: ', check(self.folder / 'v.vp').stdout)

    def test_summary(self):
        good, wide = self.path('good.fp', GOOD), self.path('wide.fp', alu(70))
        bad = self.path('bad.fp', BAD)
        summary = json.loads(check('--json', '--profile', 'r300-catalyst-2004', good, wide,
                                   bad).stdout)['summary']
        self.assertEqual([summary[key] for key in ('valid', 'over_native', 'invalid', 'unreadable')],
                         [1, 1, 1, 0])
        self.assertEqual([row['resource'] for row in summary['fullest']], RESOURCES)
        fullest = summary['fullest'][1]
        self.assertEqual((fullest['language'], fullest['file'], fullest['native_limit']),
                         ('ARBfp1.0', str(wide), 64))
        [misfit] = summary['misfits']
        self.assertEqual(misfit['file'], str(wide))
        self.assertEqual(misfit['resource'], 'alu_instructions')

    def test_ati_is_held_to_its_own_language(self):
        result = check('--json', self.path('a.atifs', ATI))
        [file] = json.loads(result.stdout)['files']
        self.assertEqual({name: (row['used'], row['limit'], row['native_limit'])
                          for name, row in file['counts'].items()},
                         {'instructions': (2, 28, 28), 'alu_instructions': (1, 16, 16),
                          'tex_instructions': (1, 12, 12), 'tex_indirections': (1, 2, 2),
                          'temporaries': (1, 6, 6), 'parameters': (0, 8, 8), 'attribs': (2, 8, 8)})
        self.assertIn('  native: the limits are those of the language; what loads fits\n',
                      check(self.folder / 'a.atifs').stdout)


class Life(Temporary):
    """Checks the two Life demos on the modelled Radeon 9700: their costs, and the reasons."""

    def test_the_packed_program_says_why_each_node(self):
        path = PROGRAMS / 'life_packed.fp'
        result = check('--why', path)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('  native: modelled (r300): 2 texture nodes, 1 dependent read, about ',
                      result.stdout)
        [file] = json.loads(check('--json', path).stdout)['files']
        native, used = file['native'], {name: row['native_used']
                                        for name, row in file['counts'].items()}
        self.assertLessEqual(used['tex_indirections'], 4)
        self.assertEqual(used['instructions'], used['alu_instructions'] + used['tex_instructions'])
        self.assertEqual([len(node['textures']) for node in native['nodes']], [3, 1])
        self.assertEqual([node['reason'] for node in native['nodes']],
                         ['', 'TEX reads cell, which MAD wrote in node 1'])
        self.assertEqual(sum(node['pairs'] for node in native['nodes']), used['alu_instructions'])
        self.assertEqual([place['opcode'] for place in native['chain']],
                         ['TEX', 'MOV', 'MAD', 'TEX'])
        for resource in ('alu_instructions', 'tex_instructions', 'tex_indirections'):
            self.assertEqual(sum(reason['amount'] for reason in native['reasons']
                                 if reason['resource'] == resource), used[resource], resource)
        drawn = re.search(r'(?s)depend.* reads \(1 read\):\n(.*?)  cycles: ', result.stdout).group(1)
        lines = path.read_text().splitlines()
        for line, place in zip(drawn.splitlines(), native['chain'], strict=True):
            self.assertIn(f'{place["line"]} | ' + lines[place['line'] - 1].split(';')[0], line)
        self.assertEqual([line.split()[0:2] for line in drawn.splitlines() if 'node' in line],
                         [['node', '1'], ['node', '2']])

    def test_packing_pays(self):
        document = json.loads(check('--compare', '--json', PROGRAMS / 'life_naive.fp',
                                    PROGRAMS / 'life_packed.fp').stdout)['compare']
        for pair in (document['resources']['alu_instructions']['native_used'], document['cycles']):
            self.assertLess(2 * pair['b'], pair['a'])
            self.assertEqual(pair['delta'], pair['b'] - pair['a'])
        self.assertEqual(document['dependent_reads']['b'], 1)

    def test_a_program_that_does_not_fit_draws_its_chain(self):
        lines = ['!!ARBfp1.0', 'TEMP a;', 'TEX a, fragment.texcoord[0], texture[0], 2D;']
        lines += ['MUL a, a, a;', 'TEX a, a, texture[1], 2D;'] * 4
        path = self.path('deep.fp', '\n'.join(lines + ['MOV result.color, a;', 'END', '']))
        result = check('--profile', 'r300-catalyst-2004', path)
        self.assertEqual(result.returncode, 3, result.stdout)
        self.assertRegex(result.stdout, r'(?m)^  TEX indirections +5 +31 +5 +4  .*native limit$')
        self.assertIn('       1  TEX reads a, which MUL wrote in node 4\n'
                      '           11 | TEX a, a, texture[1], 2D\n', result.stdout)
        self.assertIn('dependent reads (4 reads):\n    node 1  *     3 | TEX a, fragment',
                      result.stdout)
        self.assertTrue(result.stdout.endswith('    node 5  *    11 | TEX a, a, texture[1], 2D\n'))
        self.assertIn(f'       4  {path}: TEX reads a, which MUL wrote in node 1 (1)\n',
                      check('--profile', 'r300-catalyst-2004', self.folder).stdout)

    def test_the_cards_own_program(self):
        result = subprocess.run([ARBITER, 'compile', '--emit', 'native',
                                 PROGRAMS / 'life_packed.fp'], capture_output=True, text=True,
                                env=environment(), timeout=60)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('R300', result.stdout.splitlines()[0])
        self.assertEqual(re.findall(r'(?m)^node (\d)$', result.stdout), ['1', '2'], 'as reasons say')
        self.assertEqual(len(re.findall(r'(?m)^ +\d+ rgb ', result.stdout)),
                         json.loads(check('--json', PROGRAMS / 'life_packed.fp').stdout)
                         ['files'][0]['counts']['alu_instructions']['native_used'])


class Compare(Temporary):
    def test_two_files(self):
        result = check('--compare', self.path('a.fp', alu(10)), self.path('b.fp', alu(7)))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout, r'(?m)^A: .*a.fp: valid, within the native limits of r300\n'
                                        r'B: .*b.fp: valid, within')
        self.assertRegex(result.stdout, r'(?m)^  ALU instructions +10/64 +7/64 +-3 ')
        document = json.loads(check('--compare', '--json', self.folder / 'a.fp',
                                    self.folder / 'b.fp').stdout)
        self.assertEqual(document['compare']['resources']['alu_instructions']['used'],
                         {'a': 10, 'b': 7, 'delta': -3})
        self.assertEqual([file['status'] for file in document['files']], ['valid', 'valid'])
        self.assertEqual(list(document['compare'])[1:], ['nodes', 'dependent_reads', 'cycles'])

    def test_one_file_under_two_profiles(self):
        path = self.path('a.fp', alu(70))
        words = ('--compare', '--profile', 'r300-catalyst-2004', '--profile', 'nv30', path)
        result = check(*words)
        self.assertEqual(result.returncode, 0, 'the second side decides')
        self.assertEqual(check('--compare', '--profile', 'nv30', '--profile', 'r300-catalyst-2004', path).returncode, 3)
        self.assertRegex(result.stdout, r'(?m)^  ALU instructions +70/128 +70/1024 +0 ')
        document = json.loads(check(*words, '--json').stdout)
        self.assertEqual([file['profile'] for file in document['files']],
                         ['r300-catalyst-2004', 'nv30'])
        self.assertEqual([file['status'] for file in document['files']], ['over_native', 'valid'])

    def test_the_file_after_the_change_decides(self):
        long, short, bad = self.path('long.fp', alu(70)), self.path('short.fp', GOOD), self.path('bad.fp', BAD)
        catalyst = ('--compare', '--profile', 'r300-catalyst-2004')
        for before, after, code in ((long, short, 0), (short, long, 3), (bad, short, 0), (long, bad, 2),
                                    (self.folder / 'none', short, 1)):
            self.assertEqual(check(*catalyst, before, after).returncode, code, (before, after))

    def test_a_side_without_counts(self):
        result = check('--compare', self.path('a.fp', GOOD), self.path('b.fp', BAD))
        self.assertEqual(result.returncode, 2)
        self.assertIn("b.fp:2:19: error: 'q' is not declared [undeclared_name]\n", result.stdout)
        self.assertTrue(result.stdout.endswith('b.fp: invalid under r300\n'))
        document = json.loads(check('--compare', '--json', self.folder / 'a.fp',
                                    self.folder / 'none').stdout)
        self.assertIsNone(document['compare'])
        self.assertEqual(document['files'][1]['status'], 'unreadable')

    def test_usage(self):
        path = self.path('a.fp', GOOD)
        for words in ((path,), (path, path, path), ('--profile', 'r300', '--profile', 'nv30', path,
                                                    path)):
            result = check('--compare', *words)
            self.assertEqual(result.returncode, 1, words)
            self.assertIn('two files, or one file and --profile twice', result.stderr)
        for option in ('--why', '--brief'):
            result = check('--compare', option, path, path)
            self.assertEqual(result.returncode, 1)
            self.assertIn(f'{option} cannot be given with --compare', result.stderr)
        result = check('--profile', 'r300', '--profile', 'nv30', path)
        self.assertEqual(result.returncode, 1)
        self.assertIn('--profile twice is for --compare', result.stderr)


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0]] + sys.argv[3:])
