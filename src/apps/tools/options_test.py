#!/usr/bin/env python3
"""Runs each verb of `arbiter` with each option, and with each pair of its options, on several files.

usage: options_test.py ARBITER FAKE_LAYER [--valgrind] [--draw LAYER] [--sample N/M] [--verb VERB]

The verbs and their options are read from `arbiter --help`, so that new ones are covered without a change here. If a new
option has its own kind of value, the test fails until VALUES has a row for it.

Every run must end with a status that the verb's help documents, never 4 (an internal error) or a signal. A run that
fails must say why on standard error; one that succeeds must write something. JSON must parse. An accepted option
must have an effect: for `check`, `compile` and `report` it must change the output for some file. --valgrind also
requires that there are no memory errors. --sample N/M runs the Nth of every M runs.
"""

import argparse
import concurrent.futures
import dataclasses
import itertools
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'tests' / 'clients'))
from plain_environment import plain  # noqa: E402

GOOD = '!!ARBfp1.0\nTEMP a;\nMUL a, fragment.color, program.local[0];\nMOV result.color, a;\nEND\n'
DEPENDENT = ('!!ARBfp1.0\nTEMP a;\nTEX a, fragment.texcoord[0], texture[0], 2D;\n' +
             'TEX a, a, texture[0], 2D;\n' * 5 + 'MOV result.color, a;\nEND\n')


def added(header, source, result, count):
    return (f'{header}\nTEMP a;\nMOV a, {source};\n' + 'ADD a, a, a;\n' * count +
            f'MOV result.{result}, a;\nEND\n')


FILES = {
    'good.fp': GOOD,
    'dependent.fp': DEPENDENT,
    'long.fp': added('!!ARBfp1.0', 'fragment.color', 'color', 63),
    'huge.fp': added('!!ARBfp1.0', 'fragment.color', 'color', 1100),
    'huge.vp': added('!!ARBvp1.0', 'vertex.position', 'position', 300),
    'infinite.fp': '!!ARBfp1.0\nTEMP a;\nRCP a, fragment.color.x;\nMUL a, a, fragment.texcoord[0];\n'
                   'MUL result.color, a, 0.0;\nEND\n',
    'wasteful.fp': '!!ARBfp1.0\nTEMP a, b;\nMUL b, fragment.color, 2.0;\nMOV a, fragment.color;\n'
                   'ADD a, a, a;\nMOV result.color, a;\nEND\n',
    'naive.fp': '!!ARBfp1.0\nTEMP a;\nMUL a, fragment.color, 3.0;\nMAX a, a, 0.0;\n'
                'MIN result.color, a, 1.0;\nEND\n',
    'sampling.fp': '!!ARBfp1.0\nTEX result.color, fragment.texcoord[0], texture[0], 2D;\nEND\n',
    'bad.fp': '!!ARBfp1.0\nMOV result.color, q;\nEND\n',
    'good.vp': '!!ARBvp1.0\nMOV result.position, vertex.position;\n'
               'MUL result.color, vertex.color, program.local[1];\nEND\n',
    'good.atifs': '!!ATIfs1.0\nStartOutputPass;\nSampleMap r0, t0.str;\nMUL r0, r0, color0;\nEndPass;\n',
    'good.nvrc': '!!RC1.0\n#@ profile nv25\nconst0 = (1, 0.5, 0, 1);\n'
                 '{ rgb { spare0 = col0 * const0; } }\nout.rgb = spare0;\n',
    'good.nvts': '!!TS1.0\n#@ profile nv25\ntexture_2d();\ndependent_ar(tex0);\n',
    'two.vp': '!!ARBvp1.0\nADDRESS a, b;\nPARAM p[2] = { program.env[0..1] };\n'
              'ARL a.x, vertex.color.x;\nARL b.x, vertex.color.y;\n'
              'ADD result.position, p[a.x], p[b.x];\nEND\n',
    'empty.fp': '',
    'start.sh': '#!/bin/sh\n',
    'defaults.toml': '[[program]]\ntitle = "t"\nmatch.name = "true"\nset.threads = 1\n',
}
# Two values that are not the default for each option. An option whose help lists its values needs no row.
VALUES = {
    ('*', '--profile'): ['nv30', 'r300-catalyst-2004'],
    ('*', '--output'): ['@out'],
    ('*', '--extensions-max-year'): ['2003'],
    ('*', '--extensions-max-length'): ['4095'],
    ('*', '--extensions'): ['GL_EXT_abgr=off', 'GL_EXT_abgr=off,GL_EXT_bgra=on'],
    ('*', '--stats'): ['@stats.json'],
    ('*', '--log'): ['error', 'info:@log'],
    ('*', '--debug'): ['host'],
    ('*', '--replace'): ['@texts'],
    ('*', '--host-vendor'): ['mesa'],
    ('*', '--library'): ['@library'],
    ('defaults', '--check'): ['defaults.toml', 'none.toml'],
    ('doctor', '--for'): ['0.2'],
    ('doctor', '--root'): ['texts'],
    ('ctl', '--pid'): ['4194303'],
    ('ctl', '--timeout'): ['0.5'],
    ('ctl', '--for'): ['0.5'],
    ('render', '--folder'): ['texts'],
    ('render', '--fd'): ['1000'],
    ('builder', '--screenshot'): ['@png'],
    ('builder', '--size'): ['640x480'],
    ('builder', '--edit'): ['color=>colour'],
    ('builder', '--attach'): ['4194303'],
    ('builder', '--pixel'): ['1,1'],
    ('builder', '--watch'): ['2'],
    ('builder', '--panel'): ['Scene'],
    ('draw', '--size'): ['16x8'],
    ('draw', '--texture'): ['0=checker', '0=noise'],
    ('draw', '--local'): ['0=1,0.5', 'fp:0=0.25,1,0,1'],
    ('draw', '--env'): ['0=1'],
    ('draw', '--attrib'): ['3=1,0,0,1'],
    ('draw', '--frames'): ['3'],
    ('draw', '--frame'): ['2'],
    ('draw', '--feedback'): ['0'],
    ('debug', '--pixel'): ['1,1'],
    ('debug', '--texture'): ['0=checker', '0=noise'],
    ('debug', '--break'): ['nan'],
    ('debug', '--line'): ['3'],
    ('debug', '--watch'): ['fragment.color@2'],
    ('debug', '--range'): ['0,2'],
    ('debug', '--pass'): ['2'],
    ('debug', '--frame'): ['1'],
    ('debug', '--against'): ['host', 'good.fp'],
}
DRAWING = ('draw', 'debug')  # verbs that need the real layer
EFFECTS = ('check', 'compile', 'report')
# Options that are accepted but change nothing, with the reason.
NO_EFFECT = {
    ('check', '--limits', '--language=atifs'): 'a shader that loads fits: the language has no limits',
    ('check', '--limits', '--language=rc'): 'likewise',
    ('check', '--limits', '--language=ts'): 'likewise',
    ('compile', '--profile', '--language=atifs'): 'likewise',
    ('compile', '--profile', '--language=rc'): 'two cards may have the same combiners',
    ('compile', '--profile', '--language=ts'): 'likewise',
    ('compile', '--numerics', '--language=rc'): 'legacy is as host where there is no infinity',
    ('compile', '--profile', '--language=arbvp'): 'two profiles may have the same limits of vertices',
}
# The words after the options that each verb is run with.
OPERANDS = {
    'check': [['good.fp'], ['dependent.fp'], ['long.fp'], ['bad.fp'], ['good.vp'], ['good.atifs'],
              ['huge.fp'], ['huge.vp'], ['.'], ['none.fp'], ['good.fp', 'dependent.fp'],
              ['good.vp', 'long.fp'], ['good.fp', 'huge.fp'], ['naive.fp'], ['good.nvrc'], ['good.nvts']],
    'compile': [['good.fp'], ['long.fp'], ['infinite.fp'], ['wasteful.fp'], ['bad.fp'], ['good.vp'],
                ['two.vp'], ['good.atifs'], ['good.nvrc'], ['good.nvts']],
    'draw': [['good.fp'], ['good.vp', 'dependent.fp'], ['bad.fp']],
    'debug': [['good.fp'], ['bad.fp'], ['sampling.fp']],
    'run': [[], ['--', 'true'], ['--', './none']],
    'capture': [[], ['--', 'true']],
    'report': [['good.fp', 'dependent.fp', 'bad.fp', 'good.vp'], ['.'], ['none.fp']],
    'profiles': [[], ['r300'], ['none']],
    'defaults': [[], ['--', 'true'], ['--', './none']],
    'doctor': [[], ['--', 'true'], ['--', './none'], ['--', './start.sh']],
    'stats': [['none.json'], ['none/none-%p.json']],
    'cache': [[]],
    'lsp': [[]],
    'ctl': [['list'], ['programs'], ['nothing'], ['get'], ['-']],
    # An invalid descriptor, because a renderer that listens would not end.
    'render': [['--fd', '1001']],
    'help': [[], ['check'], ['chek']],
    'builder': [['good.fp', 'bad.fp']],  # too many: an accepted document would open a window
}
# Exit statuses of the command that the verb runs, besides the verb's own.
BESIDE = {'run': {0, 1}, 'capture': {0, 1}}


@dataclasses.dataclass(frozen=True)
class Option:
    name: str
    value: str = None  # None: a flag

    def words(self):
        return (self.name,) if self.value is None else (self.name, self.value)


class Verb:
    """One verb as its help describes it."""

    def __init__(self, arbiter, name):
        self.name = name
        text = subprocess.run([arbiter, name, '--help'], capture_output=True, text=True,
                              check=True).stdout
        self.options = list(self.options_of(text))
        statuses = re.search(r'Exit code:(.*?)(?:\n[A-Z]|\Z)', text, re.S)
        self.statuses = {int(each) for each in re.findall(r'\b\d+\b', statuses.group(1))} \
            if statuses else {0, 1}
        self.statuses |= {0, 1} if name not in BESIDE else BESIDE[name]

    def options_of(self, text):
        for match in re.finditer(r'^  (-\S+)(?: (\S.*?))?(?: {2,}.*)?$', text, re.M):
            names, rest = match.group(1).split(','), match.group(2) or ''
            name = next(each for each in names if each.startswith('--'))
            if name in ('--help', '--help-all'):
                continue
            if not rest or rest.startswith('('):
                yield Option(name)
                continue
            choices = re.match(r'\{([^}]*)\}', rest)
            default = re.search(r'by default ([\w-]+)', rest)
            if choices:
                values = [each for each in choices.group(1).split(',')
                          if not default or each != default.group(1)]
            else:
                values = VALUES.get((self.name, name)) or VALUES.get(('*', name))
                if not values:
                    raise AssertionError(f'arbiter {self.name} {name}: VALUES has none for it')
            for value in values:
                yield Option(name, value)


def verbs_of(arbiter):
    text = subprocess.run([arbiter, '--help'], capture_output=True, text=True, check=True).stdout
    names = re.findall(r'^  ([a-z]+)  ', text[text.index('Subcommands:'):], re.M)
    assert set(OPERANDS) == set(names), f'verbs {names}; OPERANDS has {sorted(OPERANDS)}'
    return [Verb(arbiter, name) for name in names]


class Place:
    """A separate folder for one run."""

    def __init__(self, root, number):
        self.folder = pathlib.Path(root) / str(number)
        (self.folder / 'texts').mkdir(parents=True)
        for name, text in FILES.items():
            (self.folder / name).write_text(text)
        self.before = set(self.folder.iterdir())

    def written(self):
        """Returns the files that the run wrote, by name. A report's page contains no times."""
        return {path.name: path.read_bytes() for path in sorted(self.folder.iterdir())
                if path not in self.before and path.is_file()}


class Runner:
    def __init__(self, arguments, root):
        self.arguments, self.root = arguments, root
        self.count = itertools.count()

    def run(self, verb, options, operands):
        """Returns (status, standard output, standard error, files written)."""
        place = Place(self.root, next(self.count))
        at = {'@library': os.path.abspath(self.library(verb)), '@texts': 'texts', '@out': 'out',
              '@json': 'out.json', '@stats.json': 'stats.json'}
        words = [at.get(word, word.replace('@log', './log')) for option in options
                 for word in option.words()]
        given = {option.name for option in options}
        if verb.name in ('run', 'capture', 'draw', 'debug') and '--library' not in given and \
                not given & {'--bare', '--index-only'}:
            words += ['--library', at['@library']]
        if verb.name == 'draw' and '--output' not in given:
            words += ['--output', 'out']
        if verb.name == 'debug' and '--from-top' in given and '--pixel' not in given:
            words += ['--pixel', '8,4']
        prefix = ['valgrind', '-q', '--error-exitcode=99', '--leak-check=no'] \
            if self.arguments.valgrind else []
        environment = plain(XDG_CACHE_HOME=str(place.folder / 'texts'), LC_ALL='C.UTF-8')
        done = subprocess.run([*prefix, self.arguments.arbiter, verb.name, *words, *operands],
                              cwd=place.folder, capture_output=True, stdin=subprocess.DEVNULL,
                              env=environment, timeout=300)
        return done.returncode, done.stdout, done.stderr, place.written()

    def library(self, verb):
        return self.arguments.draw if verb.name in DRAWING else self.arguments.fake_layer


def faults_of(verb, options, operands, result):
    status, out, err, written = result
    if status not in verb.statuses or status in (4, 6):
        yield f'status {status}: {err.decode(errors="replace")[-400:]}'
        return
    if status in (1, 125) and not err:
        yield f'status {status} and nothing said'
    names = {option.name for option in options}
    quiet = ('--' in operands or '--brief' in names or '--library' in names and verb.name == 'run'
             or verb.name == 'lsp')
    if status == 0 and not quiet and not out and not written:
        yield 'success, and nothing written'
    printed = status != 1 if verb.name == 'check' else verb.name == 'debug' and status in (0, 5, 8)
    printed = printed or verb.name in ('defaults', 'doctor', 'profiles', 'cache', 'stats') and status != 1
    printed = printed or verb.name == 'compile' and status != 1 and '--output' not in names
    texts = [out] if '--json' in names and printed else []
    texts += [written[name] for name in written if name.endswith('.json')]
    for text in texts:
        try:
            json.loads(text)
        except ValueError as error:
            yield f'no JSON: {error}'


def combinations(verb):
    """Yields no option, each option, and each pair of two different options."""
    yield ()
    for option in verb.options:
        yield (option,)
    for pair in itertools.combinations(verb.options, 2):
        if pair[0].name != pair[1].name:
            yield pair


def without_effect(verb, results):
    """Yields pairs and single options that can lose one option without a change of any file's output."""
    by_options = {}
    for options, operands, result in results:
        by_options.setdefault(options, {})[tuple(operands)] = result
    for options, outputs in by_options.items():
        for option in options:
            less = tuple(each for each in options if each != option)
            base = by_options.get(less)
            if not base or all(result[0] in (1, 125) for result in outputs.values()):
                continue
            if any((verb.name, option.name, '='.join(other.words())) in NO_EFFECT
                   for other in options):
                continue
            if all(outputs[operands] == base[operands] for operands in outputs):
                yield options, option


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('arbiter', type=os.path.abspath)
    parser.add_argument('fake_layer', type=os.path.abspath)
    parser.add_argument('--valgrind', action='store_true')
    parser.add_argument('--draw', type=os.path.abspath, help='the layer, to draw with too')
    parser.add_argument('--sample', default='1/1')
    parser.add_argument('--verb', help='this one alone')
    arguments = parser.parse_args()
    part, parts = map(int, arguments.sample.split('/'))
    verbs = [verb for verb in verbs_of(arguments.arbiter)
             if verb.name == (arguments.verb or verb.name) and
             (verb.name not in DRAWING or arguments.draw)]
    failed = total = 0
    with tempfile.TemporaryDirectory(prefix='arbiter-options-') as root:
        runner = Runner(arguments, root)
        for verb in verbs:
            jobs = [(options, operands) for options in combinations(verb)
                    for operands in OPERANDS[verb.name]][part - 1::parts]
            with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
                results = list(pool.map(lambda job: (*job, runner.run(verb, *job)), jobs))
            lines = [(options, operands, fault) for options, operands, result in results
                     for fault in faults_of(verb, options, operands, result)]
            if verb.name in EFFECTS and parts == 1 and not arguments.valgrind:
                lines += [(options, [], f'{" ".join(option.words())} has no effect')
                          for options, option in without_effect(verb, results)]
            for options, operands, fault in lines:
                words = [word for option in options for word in option.words()]
                print(f'arbiter {verb.name} {" ".join([*words, *operands])}: {fault}')
            print(f'{"FAIL" if lines else "pass"} {verb.name}: {len(verb.options)} options with their values, '
                  f'{len(jobs)} runs, {len(lines)} faults', flush=True)
            failed += bool(lines)
            total += len(jobs)
    print(f'{total} runs\n{len(verbs) - failed} passed, {failed} failed, 0 skipped')
    return 1 if failed or not total else 0


if __name__ == '__main__':
    sys.exit(main())
