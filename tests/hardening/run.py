#!/usr/bin/env python3
"""Checks every installed library and program for what an attacker of the process could use.

  run.py --build TREE [--json FILE]     all ELF files of `meson introspect --installed`, and in a
                                        tree with -Dhardening=true the options that each of their
                                        objects is compiled with
  run.py --self-test --compiler CXX...  libraries that lack one property each must be found

properties.py has the properties. Exit 1: a complaint. 77: the tree is not hardened.
"""
import argparse
import json
import pathlib
import subprocess
import sys

import self_test
from elf import Elf, NotElf
from properties import COMPILED, PROPERTIES, complaints

# The entry function of the machine code; kEntrySymbol of back/llvm.
ENTRY = 'arbiter_entry'
# Options that an object must be compiled with, and the exceptions with their reasons.
OPTIONS = ['-fstack-protector-strong', '-fstack-clash-protection']
X86_OPTIONS = ['-fcf-protection=full']
OPTIMISED_OPTIONS = ['-D_FORTIFY_SOURCE=3']
WITHOUT = {
    ('first.cpp', '-fno-stack-protector'): 'runs before libc has made a guard; it calls nothing',
    ('first.cpp', '-U_FORTIFY_SOURCE'): 'calls nothing that could be checked',
}


def introspect(build, what):
    answer = subprocess.run(['meson', 'introspect', what, str(build)], check=True,
                            capture_output=True, text=True)
    return json.loads(answer.stdout)


def installed(build):
    """Returns the ELF files of an installation, at their places in the build tree."""
    found = []
    for path in sorted(introspect(build, '--installed')):
        try:
            found.append(Elf(path))
        except (NotElf, OSError):
            continue
    return found


def objects_of(build, library):
    """Returns the object files that a library is linked from, including those of its static libraries."""
    inside = pathlib.Path(library).relative_to(build)
    inputs = subprocess.run(['ninja', '-C', str(build), '-t', 'inputs', str(inside)], check=True,
                            capture_output=True, text=True).stdout.split()
    return {name for name in inputs if name.endswith('.o')}


def option_complaints(source, words, wanted):
    name = pathlib.Path(source).name
    missing = [option for option in wanted if option not in words]
    undone = [word for word in words
              if word in ('-fno-stack-protector', '-fcf-protection=none', '-fno-stack-clash-protection')
              or (word == '-U_FORTIFY_SOURCE' and '-D_FORTIFY_SOURCE=3' in words
                  and words.index(word) > words.index('-D_FORTIFY_SOURCE=3'))]
    return ([f'{name} is compiled without {option}' for option in missing] +
            [f'{name} is compiled with {word}' for word in undone if (name, word) not in WITHOUT])


def check_options(build, files, machine_is_x86, optimised):
    """Returns [(file, complaint)] for the objects of all files."""
    wanted = (OPTIONS + (X86_OPTIONS if machine_is_x86 else []) +
              (OPTIMISED_OPTIONS if optimised else []))
    commands = {}
    for entry in json.loads((build / 'compile_commands.json').read_text()):
        commands[entry['output']] = (entry['file'], entry['command'].split())
    found, seen = [], set()
    for elf in files:
        for output in sorted(objects_of(build, elf.path)):
            if output in commands and output not in seen:
                seen.add(output)
                found += [(elf.path, text) for text in option_complaints(*commands[output], wanted)]
    return found, len(seen)


def machine_code_complaints(arbiter):
    """Checks code made by the rasterizer's compiler, which is called by address too."""
    program = pathlib.Path(__file__).parents[2] / 'demos' / 'programs' / 'lighting.fp'
    listing = subprocess.run([str(arbiter), 'compile', '--emit', 'machine', str(program)],
                             capture_output=True, text=True, check=False)
    if listing.returncode != 0:
        return [f'no listing of machine code: {listing.stderr.strip()}']
    lines = [line.strip() for line in listing.stdout.splitlines()]
    at = next((i for i, line in enumerate(lines) if line.startswith(ENTRY + ':')), None)
    if at is None:
        return [f'the machine code has no {ENTRY}']
    first = next((line for line in lines[at + 1:] if line[:1].isalpha()), '')
    return [] if first == 'endbr64' else [f'machine code is entered at {first}, not at endbr64']


def check_tree(options):
    build = options.build.resolve()
    settings = {entry['name']: entry['value'] for entry in introspect(build, '--buildoptions')}
    if settings['b_sanitize'] != 'none':
        print('skipped: a sanitizer stands in for these properties')
        return 77
    files = installed(build)
    optimised = settings['optimization'] not in ('0', 'plain')
    compiled = settings['hardening']
    report = {}
    for elf in files:
        name = str(pathlib.Path(elf.path).relative_to(build))
        report[name] = [{'property': kind, 'text': text} for kind, text in complaints(elf)
                        if (compiled or kind not in COMPILED) and
                        (optimised or kind != 'checks_buffers')]
    flagged, objects = check_options(build, files, files[0].machine == 62 if files else False,
                                     optimised) if compiled else ([], 0)
    for path, text in flagged:
        report[str(pathlib.Path(path).relative_to(build))].append(
            {'property': 'options', 'text': text})
    for elf in files:
        if elf.name == 'arbiter' and elf.machine == 62:
            report[str(pathlib.Path(elf.path).relative_to(build))] += [
                {'property': 'machine code', 'text': text}
                for text in machine_code_complaints(elf.path)]
    count = sum(len(texts) for texts in report.values())
    for name, texts in report.items():
        for entry in texts[:20]:
            print(f'{name}: {entry["property"]}: {entry["text"]}')
        if len(texts) > 20:
            print(f'{name}: and {len(texts) - 20} more')
    asked = len(PROPERTIES) - (0 if compiled else len(COMPILED))
    print(f'{len(files)} files, {asked} of {len(PROPERTIES)} properties, {objects} objects: '
          f'{count} complaints' + ('' if compiled else ' (-Dhardening=true asks all)'))
    if options.json:
        options.json.write_text(json.dumps({'files': report, 'objects': objects}, indent=1) + '\n')
    if len(files) < 5 or (compiled and objects < 100):
        print('too few: the tree installs more than this')
        return 1
    return 1 if count else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--build', type=pathlib.Path)
    parser.add_argument('--json', type=pathlib.Path)
    parser.add_argument('--self-test', action='store_true')
    parser.add_argument('--compiler', nargs='+', default=['c++'])
    options = parser.parse_args()
    if options.self_test:
        return self_test.run(options.compiler)
    if not options.build:
        parser.error('--build or --self-test')
    return check_tree(options)


if __name__ == '__main__':
    sys.exit(main())
