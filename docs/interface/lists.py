"""Reads lists of the interface, and tells what one breaks of an earlier one.

A list is {"schema": 1, "version": "1.0", "kinds": {KIND: [entry..]}}. An entry has a key, the version since which it is
there, and what its users rely on. An entry that says "own" belongs to Arbiter alone, and may go.
"""
import json
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
PUBLISHED = ROOT / 'tests' / 'interface'
SCHEMA = 1
NOT_COMPARED = {'key', 'since', 'own', 'of the layer', 'command'}
REMEDY = ('The interface is kept within 1.x: undo the change, or add a second name beside the first. '
          'What has to go waits for 2.0 (docs/reference/interface.md).')


def numbers_of(version):
    return tuple(int(part) for part in version.split('.'))


def published(folder=PUBLISHED):
    """Returns the lists of releases, the oldest first."""
    files = [path for path in folder.glob('*.json') if re.fullmatch(r'\d+\.\d+', path.stem)]
    return [json.loads(path.read_text()) for path in sorted(files, key=lambda path: numbers_of(path.stem))]


def with_versions(kinds, version, earlier):
    """Returns the list of a version: each entry is since the first list that has it. What is not yet in a list is
    since this version, or since that of the newest list where that is still to come."""
    now = max([version, *(each['version'] for each in earlier)], key=numbers_of)
    since = {}
    for each in earlier:
        for kind, entries in each['kinds'].items():
            for entry in entries:
                since.setdefault((kind, entry['key']), entry['since'])
    made = {kind: [{**entry, 'since': since.get((kind, entry['key']), now)}
                   for entry in sorted(entries, key=lambda entry: entry['key'])] for kind, entries in kinds.items()}
    for kind, entries in made.items():
        keys = [entry['key'] for entry in entries]
        if len(set(keys)) != len(keys):
            raise ValueError(f'{kind}: two entries of {[key for key in keys if keys.count(key) > 1][0]}')
    return {'schema': SCHEMA, 'version': now, 'kinds': made}


def text_of_list(made):
    """Returns a list as text, an entry a line."""
    kinds = []
    for kind, entries in made['kinds'].items():
        rows = ',\n'.join('   ' + json.dumps(entry, ensure_ascii=False) for entry in entries)
        kinds.append(f'  {json.dumps(kind)}: [\n{rows}\n  ]')
    head = f'{{\n "schema": {made["schema"]},\n "version": "{made["version"]}",\n "kinds": {{\n'
    return head + ',\n'.join(kinds) + '\n }\n}\n'


def is_wider(old, new):
    """True if the new range has all of the old one. None is no bound."""
    return ((new[0] is None or old[0] is not None and new[0] <= old[0]) and
            (new[1] is None or old[1] is not None and new[1] >= old[1]))


def fault_of(name, old, new):
    """Returns what a changed fact breaks, or "" if who relied on the old one may go on. None: there is no such fact."""
    if name in ('form', 'operands') and old and new and re.fullmatch(r'(\s*\[.*\])+', new.removeprefix(old)):
        return ''
    if name == 'choices':
        gone = [word for word in old or () if word not in (new or ())]
        if old is None:
            return f'takes only {", ".join(new)} now'
        return f'has no longer {", ".join(gone)}' if gone and new is not None else ''
    if name == 'range':
        if old is None:
            return f'takes only {new[0]} to {new[1]} now'
        return f'takes {new[0]} to {new[1]}, no longer {old[0]} to {old[1]}' if new and not is_wider(old, new) else ''
    if name == 'required':
        return 'has to be given now' if new else ''
    if name in ('repeatable', 'other values'):
        return '' if new else 'may be given once only' if name == 'repeatable' else 'takes the listed words only'
    if name in ('needs', 'not with'):
        more = sorted(set(new or ()) - set(old or ()))
        return f'{name} {", ".join(more)} now' if more else ''
    if name == 'takes' and old == 'nothing' and new == 'a value or nothing':
        return ''
    return f'{name}: {said(new)}, no longer {said(old)}'


def said(value):
    return 'nothing' if value is None else value if isinstance(value, str) and value else json.dumps(value)


def parent_of(key, keys):
    """True if a shorter key of the list has this one below it: a verb its options, a request its parameters."""
    return any(key != other and key.startswith(other + ' ') for other in keys)


def compared(old, new):
    """Returns what a list breaks of an earlier one, as lines, and the entries that are new, as (kind, entry)."""
    faults, added = [], []
    for kind in old['kinds']:
        if kind not in new['kinds']:
            faults.append(f'{kind}: the whole kind is gone')
    for kind, entries in new['kinds'].items():
        before = {entry['key']: entry for entry in old['kinds'].get(kind, ())}
        after = {entry['key']: entry for entry in entries}
        for key, entry in before.items():
            if key not in after:
                if not entry.get('own'):
                    faults.append(f'{kind}: {key}: is gone')
                continue
            names = [name for name in {**entry, **after[key]} if name not in NOT_COMPARED]
            for name in names:
                if entry.get(name) != after[key].get(name):
                    if fault := fault_of(name, entry.get(name), after[key].get(name)):
                        faults.append(f'{kind}: {key}: {fault}')
        for key, entry in after.items():
            if key not in before:
                added.append((kind, entry))
                if entry.get('required') and parent_of(key, before):
                    faults.append(f'{kind}: {key}: is new, and has to be given')
    return faults, added
