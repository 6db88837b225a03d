#!/usr/bin/env python3
"""Compares traces of the pixel debugger with the bits that the rasterizer drew, pixel by pixel.

usage: run.py --build BUILD [--count N] [--seed S] [--json FILE] [--latency]

Half of the traces are of the gallery's documents, every pass of them at several frames; half of generated
programs on a quad and on a torus. A trace is the interpreter's result for the pixel's inputs. The rasterizer's
color must equal it to the bit (NaNs are equal), or both must discard. If a program calls a function, the colors may
differ by 2^-16, relative above 1: machine code has its own functions, within 2^-21.8
(docs/design/machine_code.md).
If the bits are equal and the pass neither blends nor masks, the picture has the trace's 8 bits too, except for one
in a hundred. In a draw of the whole picture the last bit of an attribute may differ from that in a draw of one
quad, and a nearest sample or a KIL then goes the other way. Each document is first traced by a command, which tells
whether the rasterizer drew everything itself; further pixels are requested from the language server. The times of
both are printed; --latency fails if they exceed the debugger's requirement (median 50 ms, 99th percentile 150 ms).
"""
import argparse
import json
import math
import os
import pathlib
import random
import re
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / 'src' / 'apps' / 'tools' / 'lsp'))
sys.path.insert(0, str(ROOT / 'tests' / 'clients'))
from lsp_client import Client  # noqa: E402
from plain_environment import plain  # noqa: E402

MOST_TRIES = 60  # to find a pixel that the document covers
MOST_COMMANDS = 15
MOST_BARE = 2  # allowed passes without a covered pixel in that many tries
PIXELS_OF_PROGRAM = 20
# Machine code has polynomials for these, the interpreter calls the C library.
FUNCTIONS = {'COS', 'EX2', 'EXP', 'LG2', 'LIT', 'LOG', 'POW', 'RSQ', 'SCS', 'SIN'}
ROUNDING = 2.0 ** -16
ASKED = {'median': 0.050, 'p99': 0.150}


class Subject:
    """A pass of a document at a frame."""

    def __init__(self, name, path, text, drawn=1, frame=0):
        self.name, self.path, self.text = name, path, text
        self.number, self.frame = drawn, frame
        size = re.search(r'\bsize (\d+) (\d+)', text)
        self.size = (int(size[1]), int(size[2])) if size else (512, 512)

    def describe(self, pixel):
        return f'{self.name}, pass {self.number}, frame {self.frame}, pixel {pixel[0]},{pixel[1]}'


class Times:
    def __init__(self):
        self.all = []

    def line(self, what):
        return f'{what}: {self.median * 1e3:.1f} ms median, {self.p99 * 1e3:.1f} ms p99 of {len(self.all)}'

    @property
    def median(self):
        return statistics.median(self.all) if self.all else 0.0

    @property
    def p99(self):
        return sorted(self.all)[math.ceil(0.99 * len(self.all)) - 1] if self.all else 0.0

    def good(self):
        return self.median <= ASKED['median'] and self.p99 <= ASKED['p99']


def is_opaque(text):
    """True if the picture has the fragment's own color."""
    return not re.search(r'^#@.*\b(blend (?!off)|color off)', text, re.MULTILINE)


def calls_functions(trace, text):
    return 'ARB_fog_exp' in text or any(row['opcode'].split('_')[0] in FUNCTIONS for row in trace['rows'])


def colour_of(trace):
    """Returns (value, the letters of its components that are written)."""
    results = {each['name']: each for each in trace['results']}
    colour = results.get('result.color') or results.get('result.color[0]')
    return (colour['value'], colour.get('mask', 'xyzw')) if colour else ([], '')


def within(mine, drawn):
    if isinstance(mine, str) or isinstance(drawn, str):  # "nan", "inf", "-inf"
        return mine == drawn
    return abs(mine - drawn) <= ROUNDING * max(1.0, abs(mine))


def is_pictured(value, picture):
    """True if 8 bits match a color; the middle between two levels may be rounded either way."""
    for component, level in zip(value, bytes.fromhex(picture)):
        exact = component if isinstance(component, str) else 255 * min(max(component, 0.0), 1.0)
        if not isinstance(exact, str) and abs(exact - level) > 0.5 + 1e-4:
            return False
    return True


def fault(trace, rounded):
    """Returns what is wrong with a trace; empty: nothing."""
    verdict = trace['verdict']
    if verdict['drawn'] is None or trace['discarded']:
        return '' if verdict['equal'] and verdict['drawn'] is None else 'one of the two discards'
    value, mask = colour_of(trace)
    if not rounded and not verdict['bits_equal']:
        return 'other bits'
    if not all(within(value['xyzw'.index(c)], verdict['drawn']['xyzw'.index(c)]) for c in mask):
        return 'apart by more than rounding'
    return ''


def is_another_picture(trace):
    verdict = trace['verdict']
    value, mask = colour_of(trace)
    return (not trace['discarded'] and not verdict['hidden'] and verdict['bits_equal'] and mask == 'xyzw' and
            not is_pictured(value, verdict['picture']))


class Count:
    """Counts all traces, and those whose color equals the drawn one to the bit."""

    def __init__(self):
        self.all = self.equal = 0

    def add(self, trace):
        self.all += 1
        self.equal += trace['discarded'] or trace['verdict']['bits_equal']

    def line(self, what):
        return f'{what}: {self.equal} of {self.all} equal to the bit'


class Suite:
    def __init__(self, build, seed):
        self.arbiter = str(build / 'src' / 'apps' / 'tools' / 'arbiter')
        self.random = random.Random(seed)
        self.process_times, self.request_times = Times(), Times()
        self.discarded = self.opaque = self.pictures = self.bare = 0
        self.plain, self.functions = Count(), Count()
        self.failures = []
        self.client = Client([self.arbiter, 'lsp'])
        self.client.initialize()
        self.version = 0

    def fail(self, subject, pixel, text):
        self.failures.append(subject.describe(pixel) + ': ' + text)
        print('FAIL ' + self.failures[-1], flush=True)

    def count(self, subject, pixel, trace, opaque):
        self.discarded += trace['discarded']
        rounded = calls_functions(trace, subject.text)
        (self.functions if rounded else self.plain).add(trace)
        if said := fault(trace, rounded):
            self.fail(subject, pixel, said + '; ' + trace['verdict']['line'])
        self.opaque += opaque
        if opaque and is_another_picture(trace):
            self.pictures += 1
            print(subject.describe(pixel) + ': ' + trace['verdict']['line'], flush=True)

    @property
    def traces(self):
        return self.plain.all + self.functions.all

    def pixel(self, subject):
        return [self.random.randrange(subject.size[0]), self.random.randrange(subject.size[1])]

    def middle_pixel(self, subject):
        return [each // 4 + self.random.randrange(each // 2) for each in subject.size]

    def one_command(self, subject):
        """Traces a covered pixel by a process. Returns None if there is none."""
        for _ in range(MOST_COMMANDS):
            pixel = self.middle_pixel(subject)
            begin = time.monotonic()
            done = subprocess.run(
                [self.arbiter, 'debug', str(subject.path), '--pixel', '%d,%d' % tuple(pixel), '--json',
                 '--pass', str(subject.number), '--frame', str(subject.frame)],
                capture_output=True, text=True, env=plain(), timeout=300)
            if 'covers this pixel' in done.stderr:
                continue
            took = time.monotonic() - begin
            if done.returncode not in (0, 5):
                self.fail(subject, pixel, done.stderr)
                return None
            self.process_times.all.append(took)
            trace = json.loads(done.stdout)
            if trace['note']:
                self.fail(subject, pixel, trace['note'])
            self.count(subject, pixel, trace, is_opaque(subject.text))
            return pixel
        print(subject.describe(pixel) + f': none of {MOST_COMMANDS} pixels is covered', flush=True)
        self.bare += 1
        return None

    def ask(self, uri, subject, pixel):
        begin = time.monotonic()
        answer = self.client.response(self.client.ask('arbiter/trace', {
            'textDocument': {'uri': uri}, 'pixel': pixel, 'pass': subject.number, 'frame': subject.frame}))
        return answer, time.monotonic() - begin

    def further(self, subject, main, first, count):
        """Traces more pixels of the same pass, as an editor requests them."""
        uri = main.as_uri()
        self.client.open(uri, main.read_text())
        self.ask(uri, subject, first)  # starts the process that draws
        opaque = is_opaque(subject.text)
        done = tries = 0
        while done < count and tries < count * MOST_TRIES:
            tries += 1
            pixel = self.pixel(subject)
            answer, took = self.ask(uri, subject, pixel)
            if 'error' in answer:
                if 'covers this pixel' not in answer['error']['message']:
                    self.fail(subject, pixel, answer['error']['message'])
                    break
                # A pixel that nothing covers ends the session; the next request starts another.
                self.ask(uri, subject, first)
                continue
            done += 1
            self.request_times.all.append(took)
            self.count(subject, pixel, answer['result'], opaque)
        self.client.notify('textDocument/didClose', {'textDocument': {'uri': uri}})

    def run(self, subject, main, count):
        first = self.one_command(subject)
        if first is not None and count > 1:
            self.further(subject, main, first, count - 1)


def gallery(build, chooser):
    """Yields (Subject, the document's file) of every pass."""
    folder = ROOT / 'demos' / 'gallery'
    for main in sorted(folder.glob('*.fp')):
        text = main.read_text()
        if not re.search(r'^#@.*\btitle\b', text, re.MULTILINE):
            continue  # a further pass of another document
        panel = '\n'.join(re.findall(r'^#@.*', text, re.MULTILINE))
        names = [main.name] + re.findall(r'\bthen ([\w.-]+)', panel)
        for number, name in enumerate(names, 1):
            own = (folder / name).read_text()
            target = re.search(r'\btarget \w+ (\d+) (\d+)', own)
            size = re.search(r'\bsize (\d+) (\d+)', text)
            subject = Subject(main.name, main, own, number,
                              chooser.randrange(6 if 'feedback' in text else 60))
            if target or size:
                subject.size = tuple(int(each) for each in (target or size).groups())
            yield subject, main


def programs(build, seed, count, folder):
    texts = json.loads(subprocess.run(
        [str(build / 'tests/traces_vs_rasterizer/spell_programs'), str(seed), str(count)],
        capture_output=True, text=True, check=True).stdout)
    for i, text in enumerate(texts):
        path = folder / f'program_{seed + i}.fp'
        path.write_text(text)
        yield Subject(path.name, path, text), path


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('--build', type=pathlib.Path, required=True)
    parser.add_argument('--count', type=int, default=10000)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--json', type=pathlib.Path)
    parser.add_argument('--keep', type=pathlib.Path, help='a folder for the generated programs')
    parser.add_argument('--latency', action='store_true', help='times beyond what is asked fail')
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    os.environ.update(plain())
    suite = Suite(build, arguments.seed)
    with tempfile.TemporaryDirectory(prefix='arbiter-traces-') as made:
        folder = arguments.keep or pathlib.Path(made)
        folder.mkdir(parents=True, exist_ok=True)
        passes = list(gallery(build, suite.random))
        each = math.ceil(arguments.count / 2 / len(passes))
        for subject, document in passes:
            suite.run(subject, document, each)
        left = arguments.count - suite.traces
        generated = math.ceil(left / PIXELS_OF_PROGRAM)
        for subject, document in programs(build, arguments.seed * 1000, generated, folder):
            suite.run(subject, document, math.ceil(left / generated))
    suite.client.leave()
    print(f'{suite.traces} traces of {len(passes)} passes and {generated} programs, '
          f'{suite.discarded} discarded: {len(suite.failures)} differ from what the rasterizer drew')
    print(f'pictures with another colour: {suite.pictures} of {suite.opaque}')
    print(suite.functions.line('programs that call functions'))
    print(suite.plain.line('programs that call none'))
    print(suite.process_times.line('in a process of its own'))
    print(suite.request_times.line('a further request'))
    slow = arguments.latency and not (suite.process_times.good() and suite.request_times.good())
    if arguments.json:
        arguments.json.write_text(json.dumps({
            'name': 'traces', 'passed': suite.traces - len(suite.failures), 'failed': len(suite.failures),
            'failures': suite.failures,
            'equal': {'functions': [suite.functions.equal, suite.functions.all],
                      'none': [suite.plain.equal, suite.plain.all]},
            'process': [suite.process_times.median, suite.process_times.p99],
            'request': [suite.request_times.median, suite.request_times.p99]}, indent=1) + '\n')
    enough = (suite.traces >= 0.99 * arguments.count and
              suite.pictures <= max(2, 0.01 * suite.opaque) and suite.bare <= MOST_BARE)
    if not enough:
        print(f'FAIL {arguments.count} traces were asked for, and 99 in 100 pictures of their colour')
    if slow:
        print('FAIL the times are longer than what is asked')
    failed = len(suite.failures) + (not enough) + slow
    print(f'{suite.traces - len(suite.failures)} passed, {failed} failed, 0 skipped')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
