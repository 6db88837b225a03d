#!/usr/bin/env python3
"""Fails if the interface is not that of the last release any more, or if its pages are stale.

usage: interface.py BUILD | interface.py --self-test BUILD

The interface of a built tree is collected anew (docs/interface) and compared with the newest list of this folder. An
entry that is gone, or that has another type, value or meaning, is a fault. So is an option that takes less than before.
Entries that are new are listed with the version that they come with.
"""
import copy
import pathlib
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / 'docs' / 'interface'))
import commands  # noqa: E402
import installed  # noqa: E402
import interface_page  # noqa: E402
import lists  # noqa: E402
import reports  # noqa: E402
import sources  # noqa: E402
import style  # noqa: E402
import trees  # noqa: E402
import write  # noqa: E402


def test(build):
    """Compares a built tree with the newest list. Returns the exit code."""
    released = lists.published()
    if not released:
        print('tests/interface: no list of a release')
        return 1
    try:
        made = write.list_of(build)
    except (sources.Broken, ValueError) as error:
        print(f'the interface cannot be collected: {error}')
        return 1
    newest = released[-1]
    faults, added = lists.compared(newest, made)
    for kind, entry in added:
        print(f'new in {entry["since"]}: {kind}: {entry["key"]}')
    for fault in faults:
        print(f'the interface of {newest["version"]} is broken: {fault}')
    if faults:
        print(lists.REMEDY)
    stale = write.stale_files(made)
    for path in stale:
        print(f'{path.relative_to(ROOT)}: stale; run docs/interface/write.py {build}')
    count = sum(len(entries) for entries in newest['kinds'].values())
    print(f'{count} entries of {newest["version"]}, {len(faults)} broken, {len(added)} new')
    return 1 if faults or stale else 0


def entry_of(made, kind, key):
    return next(entry for entry in made['kinds'][kind] if entry['key'] == key)


def remove(kind, key):
    return lambda made: made['kinds'][kind].remove(entry_of(made, kind, key))


def change(kind, key, **facts):
    return lambda made: entry_of(made, kind, key).update({name.replace('_', ' '): value
                                                          for name, value in facts.items()})


def forget(kind, key, name):
    return lambda made: entry_of(made, kind, key).pop(name)


def rename(kind, key, other):
    return lambda made: entry_of(made, kind, key).update(key=other)


def add(kind, **entry):
    return lambda made: made['kinds'][kind].append({**entry, 'since': '1.1'})


def take_choice(kind, key, word):
    return lambda made: entry_of(made, kind, key)['choices'].remove(word)


def add_choice(kind, key, word):
    return lambda made: entry_of(made, kind, key)['choices'].append(word)


# Each fault of the list: what is planted, and the words that a complaint has.
FAULTS = (
    (remove('options', 'check --brief'), 'options: check --brief: is gone'),
    (remove('options', 'stats'), 'options: stats: is gone'),
    (change('options', 'debug --pixel', takes='nothing'), 'options: debug --pixel: takes: nothing, no longer a value'),
    (change('options', 'check --json', takes='a value'), 'options: check --json: takes: a value, no longer nothing'),
    (forget('options', 'draw --output', 'short'), 'options: draw --output: short: nothing, no longer -o'),
    (take_choice('options', 'run --backend', 'auto'), 'options: run --backend: has no longer auto'),
    (change('options', 'debug --pass', range=[1, 8]), 'options: debug --pass: takes 1 to 8, no longer 1 to 16'),
    (change('options', 'capture --output', required=True), 'options: capture --output: has to be given now'),
    (change('options', 'profiles NAME', choices=['r300']), 'options: profiles NAME: takes only r300 now'),
    (forget('options', 'draw --mesh', 'other values'), 'options: draw --mesh: takes the listed words only'),
    (forget('options', 'draw --texture', 'repeatable'), 'options: draw --texture: may be given once only'),
    (change('options', 'draw --size', not_with=['--frame']), 'options: draw --size: not with --frame now'),
    (change('options', 'compile --emit', default='ir'), 'options: compile --emit: default: ir, no longer glsl'),
    (change('options', 'ctl set', operands='FILE ID'), 'options: ctl set: operands: FILE ID, no longer ID FILE'),
    (add('options', key='check --card', takes='a value', required=True), 'check --card: is new, and has to be given'),
    (take_choice('exit codes', '3', 'check'), 'exit codes: 3: has no longer check'),
    (change('exit codes', '5', meaning='no GL'), 'exit codes: 5: meaning: no GL, no longer a comparison'),
    (remove('variables', 'ARBITER_STATS'), 'variables: ARBITER_STATS: is gone'),
    (take_choice('variables', 'ARBITER_LIMITS', 'report'), 'variables: ARBITER_LIMITS: has no longer report'),
    (change('variables', 'ARBITER_PROFILE', default='nv30'), 'variables: ARBITER_PROFILE: default: nv30'),
    (rename('TOML', 'profile: api.temporaries', 'profile: api.temps'), 'TOML: profile: api.temporaries: is gone'),
    (rename('TOML', 'defaults: program.set.threads', 'defaults: program.set.cores'),
     'TOML: defaults: program.set.threads: is gone'),
    (take_choice('profiles', 'nv40', 'geforce6800'), 'profiles: nv40: has no longer geforce6800'),
    (remove('panels', 'setting: mesh'), 'panels: setting: mesh: is gone'),
    (remove('identifiers', 'diagnostic undeclared_name'), 'identifiers: diagnostic undeclared_name: is gone'),
    (change('JSON', 'check files[].bytes', type='text'), 'JSON: check files[].bytes: type: text, no longer number'),
    (remove('JSON', 'statistics draws.host_glsl'), 'JSON: statistics draws.host_glsl: is gone'),
    (take_choice('JSON', 'check files[].counts', 'temporaries'), 'check files[].counts: has no longer temporaries'),
    (remove('control', 'layer program.set'), 'control: layer program.set: is gone'),
    (change('control', 'protocol', value='2'), 'control: protocol: value: 2, no longer 1'),
    (change('control', 'layer param.list < id', required=True), 'control: layer param.list < id: has to be given now'),
    (add('control', key='layer ping < since', type='number', required=True),
     'control: layer ping < since: is new, and has to be given'),
    (remove('control', 'error -32003'), 'control: error -32003: is gone'),
    (remove('editors', 'lsp arbiter/report'), 'editors: lsp arbiter/report: is gone'),
    (change('header', 'GL_FEEDBACK_COPIES_ARBITER', value='0x41524209'),
     'header: GL_FEEDBACK_COPIES_ARBITER: value: 0x41524209, no longer 0x41524200'),
    (remove('libraries', 'libGLX_arbiter.so.0: __glx_Main'), 'libraries: libGLX_arbiter.so.0: __glx_Main: is gone'),
    (change('libraries', '<libdir>/arbiter/libGLX_arbiter.so.0', value='libGLX_arbiter.so.1'),
     'value: libGLX_arbiter.so.1, no longer libGLX_arbiter.so.0'),
    (take_choice('files', 'text/x-arb-fragment-program', '*.fp'), 'text/x-arb-fragment-program: has no longer *.fp'),
    (remove('packages', 'libglx-arbiter0'), 'packages: libglx-arbiter0: is gone'),
    (lambda made: made['kinds'].pop('control'), 'control: the whole kind is gone'),
)
# Changes that who relied on the list does not see.
ALLOWED = (
    (add('options', key='check --loud', takes='nothing'), 'check --loud'),
    (add('control', key='layer ping < since', type='number'), 'layer ping < since'),
    (add('JSON', key='check files[].mood', type='text'), 'check files[].mood'),
    (add_choice('options', 'run --backend', 'zink'), ''),
    (change('options', 'debug --pass', range=[0, 32]), ''),
    (forget('options', 'debug --pass', 'range'), ''),
    (change('options', 'check --json', takes='a value or nothing'), ''),
    (forget('options', 'check FILE', 'required'), ''),
    (change('options', 'draw --size', repeatable=True), ''),
    (forget('options', 'builder --size', 'needs'), ''),
    (remove('libraries', 'libarbiter_jit.so: arbiter_jit_interface'), ''),
)
HEADER = '''#define TWO 2
typedef void (*ArbiterTold)(int what);
int arbiterCount(const char *name);
'''


def style_faults():
    """Returns complaints about the rules for words, types and schema numbers."""
    complaints = []

    def refused(rule, *arguments):
        try:
            rule(*arguments)
        except sources.Broken as error:
            return str(error)
        return ''
    for document in (*STYLES, TYPED):
        tree = trees.Tree(maps={'map', 'set'})
        tree.name = 'x'
        tree.add(document)
        if bool(refused(style.style_of, [tree])) != (document is not TYPED):
            complaints.append(f'style: {document}')
    entries = {'JSON': [], 'control': [], 'identifiers': []}
    for kind, key in (('JSON', 'check files[].endLine'), ('control', 'layer stats > a-b'), ('identifiers', 'path a-b')):
        if not refused(style.style_of_entries, {**entries, kind: [{'key': key, 'type': 'text'}]}):
            complaints.append(f'style: {kind}: {key}')
    for kind in ('list of number or text or truth', 'number or truth', 'object or text or null', 'list of text or map'):
        if not refused(style.one_type, {**entries, 'JSON': [{'key': 'check x', 'type': kind}]}):
            complaints.append(f'type: {kind}')
    for kind in ('list of number or text or null', 'object or null', 'text', 'list of object as files[] of check'):
        if refused(style.one_type, {**entries, 'JSON': [{'key': 'check x', 'type': kind}]}):
            complaints.append(f'type: {kind}')
    for text in ('json.key("schema").value(2);', 'x = {{"schema", kOne}};', 'json["schema"] = 1;', 'none'):
        if not refused(style.schema_numbers, {'a.cpp': text}):
            complaints.append(f'schema: {text}')
    if refused(style.schema_numbers, {'a.cpp': 'json.key("schema").value(ARBITER_CHECK_SCHEMA)'}):
        complaints.append('schema: of the header')
    return complaints


def planted(released):
    """Returns complaints about the comparison: a fault that it does not see, or a change that it should allow."""
    complaints = []
    for plant, words in FAULTS:
        made = copy.deepcopy(released)
        plant(made)
        faults, _ = lists.compared(released, made)
        if len(faults) != 1 or words not in faults[0]:
            complaints.append(f'planted {words!r}, found {faults}')
    for plant, key in ALLOWED:
        made = copy.deepcopy(released)
        plant(made)
        faults, added = lists.compared(released, made)
        if faults or [entry['key'] for _, entry in added] != ([key] if key else []):
            complaints.append(f'allowed {key!r}, found {faults} and {added}')
    return complaints


def header_faults():
    """Returns complaints about the reader of headers."""
    complaints = []
    for old, new, said in (('int arbiterCount', 'long arbiterCount', 'arbiterCount: signature: long'),
                            ('const char *name', 'const char *name, int n', 'arbiterCount: signature: int'),
                            ('(int what)', '(long what)', 'ArbiterTold: signature: typedef'),
                            ('TWO 2', 'TWO 3', 'TWO: value: 3'), ('#define TWO 2', '', 'TWO: is gone')):
        before, after = ({'kinds': {'header': sources.header(text=text)}}
                         for text in (HEADER, HEADER.replace(old, new)))
        faults, _ = lists.compared(before, after)
        if len(faults) != 1 or said not in faults[0]:
            complaints.append(f'header: planted {said!r}, found {faults}')
    if len(sources.header(text=HEADER)) != 3:
        complaints.append(f'header: {sources.header(text=HEADER)}')
    return complaints


def reader_faults(released):
    """Returns complaints about the readers of help and of documents, about versions and about the page."""
    tree = trees.Tree(maps={'m'}, named={'n'})
    tree.name = 'x'
    for document in ({'a': 1, 'm': {'p': 1}, 'n': {'q': True}, 'l': []}, {'a': None, 'm': {}, 'l': [{'b': 'c'}]}):
        tree.add(document)
    found = {entry['key']: (entry['type'], entry.get('choices')) for entry in tree.entries('x')}
    expected = {'x a': ('number or null', None), 'x m': ('map of number', None), 'x n': ('map of truth', ['q']),
                'x l': ('list of object', None), 'x l[].b': ('text', None)}
    codes = commands.codes_of('0; 1 usage, or a file; 126 it cannot be run. The worst one decides.')
    made = lists.with_versions({'options': [{'key': 'check'}, {'key': 'new'}]}, '1.2', [released])
    later = {entry['key']: entry['since'] for entry in made['kinds']['options']}
    broken = copy.deepcopy(released)
    entry_of(broken, 'options', 'check --brief')['key'] = 'check --terse'
    return [text for text, wrong in (
        (f'documents: {found}', found != expected),
        (f'codes: {codes}', codes != {0: 'it was done', 1: 'usage, or a file', 126: 'it cannot be run'}),
        (f'versions: {later}', later != {'check': '1.0', 'new': '1.2'}),
        ('the page is the same with another option', interface_page.page(broken) == interface_page.page(released)),
        ('the list is the same with another option', lists.text_of_list(broken) == lists.text_of_list(released)),
    ) if wrong]


# What a command says otherwise than the built one, by an expression of sed, and the complaint about it.
OTHERWISE = (
    ('/^  --brief/d', 'options', 'help and source differ in [\'--brief\']'),
    ('s/^  --pixel X,Y /  --pixel     /', 'options', 'options: debug --pixel: takes: nothing, no longer a value'),
    ('s/auto,host,swrast/auto,host/', 'options', 'options: capture --backend: has no longer swrast'),
    ('s/; 3 a program is valid/; 4 a program is valid/', 'exit codes', 'exit codes: check says that 4 is "a program'),
    ('s/; 2 a program, or/; 2 a text, or/', 'exit codes', 'exit codes: check says that 2 is "a text'),
    ('s/"bytes": \\([0-9]*\\)/"bytes": "\\1"/', 'JSON', 'JSON: check files[].bytes: type: text, no longer number'),
    ('s/"status"/"state"/', 'JSON', 'JSON: check files[].status: is gone'),
    ('s/"over_native"/"over-native"/', 'JSON', '"over-native" is not in snake_case'),
    ('s/"end_line"/"endLine"/', 'JSON', '"endLine" is not in snake_case'),
)
# Words of a document, each of which is refused, and some that users type, which are not.
STYLES = ({'kind': 'two-words'}, {'kind': 'twoWords'}, {'kinds': ['right', 'two-words']}, {'map': {'two-words': 1}})
TYPED = {'profile': 'r300-catalyst-2004', 'file': 'a-b', 'kind': 'Two-words, a text',
         'set': {'key': 'x-y'}, 'hash': '09f3'}


def entries_of_check(arbiter, folder):
    """Returns the entries of the JSON of `arbiter check`, in which words have the style of all."""
    tree = reports.checks(reports.Runs(arbiter, folder))[0]
    style.style_of([tree])
    entries = tree.entries('check')
    style.style_of_entries({'JSON': entries, 'control': [], 'identifiers': []})
    return entries


def collected_otherwise(arbiter, folder):
    """Returns for each kind how it is collected from a command that stands before the built one."""
    return {'options': lambda: commands.options(str(arbiter))[0] + commands.window(),
            'exit codes': lambda: commands.exit_codes(commands.options(str(arbiter))[1]),
            'JSON': lambda: entries_of_check(arbiter, folder)}


def otherwise_faults(build, released):
    """Returns complaints about the collection from a command that says something else."""
    complaints = []
    real = pathlib.Path(build).resolve() / 'src' / 'apps' / 'tools' / 'arbiter'
    with tempfile.TemporaryDirectory(prefix='arbiter-interface-') as folder:
        arbiter = pathlib.Path(folder) / 'arbiter'
        for expression, kind, words in OTHERWISE:
            arbiter.write_text(f"#!/bin/sh\n{real} \"$@\" | sed '{expression}'\n")
            arbiter.chmod(0o755)
            try:
                made = {kind: collected_otherwise(arbiter, folder)[kind]()}
                faults, _ = lists.compared({'kinds': {kind: released['kinds'][kind]}}, {'kinds': made})
            except sources.Broken as error:
                faults = [str(error)]
            if not any(words in fault for fault in faults):
                complaints.append(f'sed {expression}: found {faults[:3]}')
        complaints += symbol_faults(build, pathlib.Path(folder))
    return complaints


def symbol_faults(build, folder):
    """Returns complaints about the reading of a library's symbols, one of which is given another name."""
    library = folder / 'library.so'
    built = pathlib.Path(build) / installed.LIBRARIES['arbiter/libGLX_arbiter.so.0']
    library.write_bytes(built.read_bytes().replace(b'\0__glx_Main\0', b'\0__glx_Mane\0'))
    names = [installed.exported(path)[1] for path in (built, library)]
    return [] if '__glx_Main' in names[0] and '__glx_Main' not in names[1] else [f'symbols: {names}']


def self_test(build):
    """Plants a fault of each kind. Returns the exit code."""
    released = lists.published()[0]
    complaints = planted(released) + header_faults() + style_faults() + reader_faults(released)
    complaints += otherwise_faults(build, released)
    for complaint in complaints:
        print(complaint)
    print(f'{len(FAULTS) + len(OTHERWISE) + len(STYLES)} faults and {len(ALLOWED)} allowed changes planted, '
          f'{len(complaints)} complaints')
    return 1 if complaints else 0


def main():
    if sys.argv[1:2] == ['--self-test'] and len(sys.argv) == 3:
        return self_test(sys.argv[2])
    if len(sys.argv) != 2 or sys.argv[1].startswith('-'):
        print(__doc__, file=sys.stderr)
        return 2
    return test(sys.argv[1])


if __name__ == '__main__':
    sys.exit(main())
