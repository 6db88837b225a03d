#!/usr/bin/env python3
"""Loads program texts with known verdicts, and draws them in four ways.

bare is the host's own implementation, in a process that runs as long as it survives; host, auto and swrast are the
layer's back ends. A text fails if

- the layer refuses in any way what the specification accepts, or the other way round;
- the bare host's verdict differs, and the case does not say why;
- a picture of the layer differs from the bare host's, and the specification defines the picture;
- two ways of the layer differ from each other, whatever the specification says;
- the case says `exact` and any two of these differ by a bit (sums and products decide whether passes drawn in
  different ways meet at equal depths), or it says `host-exact` and bare and host do.

usage: run.py --texts PROGRAM --layer LIBRARY [--json FILE] [--only WORD] [--list] FILE.cases...
Exit status: 0 all agree, 1 some differ, 2 a file of cases is malformed, 77 no GL.
"""

import argparse
import array
import concurrent.futures
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from case_files import Malformed, read_cases
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'clients'))
from plain_environment import plain  # noqa: E402

# The largest difference of a component, relative and absolute. The specification allows approximate functions (EX2,
# LG2, POW, SIN) to differ from the exact value by 2^-10.
RELATIVE, ABSOLUTE = 2.0 ** -10, 2.0 ** -10
WAYS = ('bare', 'host', 'auto', 'swrast')


class NoGl(Exception):
    """There is no GL context; the message says why."""


class Ended(Exception):
    """A process ended unexpectedly; the message says how."""


def environment(way, layer, cache):
    result = plain()
    if way != 'bare':
        result.update(LD_PRELOAD=str(layer), ARBITER_PROFILE='host', ARBITER_BACKEND=way,
                      XDG_CACHE_HOME=str(cache))
    return result


def one_process(texts, folder, lines, env):
    """Returns answers by name until the process ended; and, if it ended too soon, the name it ended at."""
    done = subprocess.run([texts, folder], input=''.join(lines), capture_output=True, text=True,
                          env=env, timeout=1500)
    answers, ended = {}, None
    for line in done.stdout.splitlines():
        name, _, rest = line.partition(' ')
        if rest:
            answers[name] = rest
        else:
            ended = name
    if done.returncode == 77:
        raise NoGl(done.stderr.strip())
    if done.returncode != 0 and ended is None:
        raise Ended(f'status {done.returncode}: {done.stderr.strip()[-300:]}')
    return answers, ended


def mesa_release(version):
    """Returns (23, 2) for a GL_VERSION "… Mesa 23.2.1"; None for other drivers."""
    found = re.search(r'Mesa (\d+)\.(\d+)', version)
    return found and tuple(map(int, found.groups()))


def way_of(texts, layer, folder, cases, way):
    """Returns for each case (position, errors), or None if the process crashed; last the GL_VERSION."""
    folder.mkdir()
    for index, case in enumerate(cases):
        (folder / f'{index}.txt').write_bytes(case.text.encode())
    env = environment(way, layer, folder / 'cache')
    results = [None] * len(cases) + ['']
    at = 0
    while at < len(cases):
        lines = [f'{index} {cases[index].stage} {cases[index].shown}\n'
                 for index in range(at, len(cases))]
        answers, ended = one_process(texts, folder, lines, env)
        results[-1] = answers.pop('version', results[-1])
        for name, answer in answers.items():
            position, _, errors = answer.partition(' ')
            results[int(name)] = (int(position), errors)
        if ended is None:
            break
        at = int(ended) + 1
    return results


def pixels(folder, index):
    values = array.array('f')
    values.frombytes((folder / f'{index}.raw').read_bytes())
    return values


def differs(a, b, exact=False):
    """Returns the first difference of two pictures as text; empty if they agree."""
    if len(a) != len(b):
        return f'{len(a)} and {len(b)} values'
    for index, (x, y) in enumerate(zip(a, b)):
        if x == y or (math.isnan(x) and math.isnan(y)):
            continue
        if exact or not abs(x - y) <= ABSOLUTE + RELATIVE * max(abs(x), abs(y)):
            return f'value {index} is {x:.9g} and {y:.9g}'
    return ''


def verdict(result):
    return 'crashed' if result is None else 'accepts' if result[0] == -1 else \
        f'refuses at {result[0]}'


def faults_of(case, results, folders, index):
    """Returns what is wrong with one case, a line each."""
    accepted = {way: results[way][index] is not None and results[way][index][0] == -1 for way in WAYS}
    for way in WAYS[1:]:
        if results[way][index] is None or accepted[way] != case.accepted:
            yield f'{way}: {verdict(results[way][index])}'
        elif results[way][index][1]:
            yield f'{way}: GL errors: {results[way][index][1]}'
    wanted = case.accepted if case.bare_accepted is None else case.bare_accepted
    if results['bare'][index] is not None and accepted['bare'] != wanted:
        yield f'bare: {verdict(results["bare"][index])}'
    if not all(accepted[way] for way in WAYS[1:]):
        return
    drawn = {way: pixels(folders[way], index) for way in WAYS if accepted[way]}
    for way in ('auto', 'swrast'):
        if difference := differs(drawn['host'], drawn[way], case.exact):
            yield f'host and {way}: {difference}'
    if 'bare' in drawn and not case.undefined and not case.bare_varies:
        release = mesa_release(results['bare'][-1])
        rounds = case.bare_rounds_from and release and release >= case.bare_rounds_from
        if difference := differs(drawn['bare'], drawn['host'], (case.exact or case.host_exact) and not rounds):
            yield f'bare and host: {difference}'


def parse():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--texts', required=True)
    parser.add_argument('--layer', type=pathlib.Path, required=True)
    parser.add_argument('--json', type=pathlib.Path)
    parser.add_argument('--only', default='', help='cases whose name or file has this word')
    parser.add_argument('--list', action='store_true', help='print the texts, load nothing')
    parser.add_argument('files', nargs='+')
    return parser.parse_args()


def main():
    args = parse()
    try:
        cases = [case for file in args.files for case in read_cases(file)
                 if args.only in case.name or args.only in case.place]
    except Malformed as error:
        print(error, file=sys.stderr)
        return 2
    if args.list:
        for case in cases:
            print(f'# {case.place}: {case.name}: {case.accepted and "accept" or "refuse"}\n{case.text}')
        return 0
    with tempfile.TemporaryDirectory(prefix='arbiter-texts-') as root:
        folders = {way: pathlib.Path(root) / way for way in WAYS}
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            jobs = {way: pool.submit(way_of, os.path.abspath(args.texts), args.layer.resolve(),
                                     folders[way], cases, way) for way in WAYS}
            try:
                results = {way: job.result() for way, job in jobs.items()}
            except (Ended, NoGl) as error:
                print(error, file=sys.stderr)
                return 77 if isinstance(error, NoGl) else 1
        failed, report = 0, []
        for index, case in enumerate(cases):
            faults = list(faults_of(case, results, folders, index))
            report.append({'name': case.name, 'place': case.place, 'faults': faults,
                           'positions': {way: results[way][index] and results[way][index][0]
                                         for way in WAYS}})
            if faults:
                failed += 1
                print(f'{case.place}: {case.name}: expected to '
                      f'{"accept" if case.accepted else "refuse"} ({case.reason})')
                print(''.join(f'  {fault}\n' for fault in faults), end='')
    crashed = results['bare'].count(None)
    other = sum(case.bare_accepted is not None for case in cases)
    print(f'{len(cases) - failed} of {len(cases)} texts agree; the bare host judges {other} otherwise '
          f'and crashed {crashed} times')
    if args.json:
        args.json.write_text(json.dumps({'schema': 1, 'cases': report}) + '\n')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
