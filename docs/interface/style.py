"""Holds the words of documents to one style, members to one type, and schema numbers to one header.

A member's name is snake_case, and so is a value that is a word of a closed list. What a user types as the value of an
option stays as it is typed: names of profiles, of back ends, of extensions and of files.
"""
import re

from sources import ROOT, Broken

WORD = re.compile(r'[a-z][a-z0-9]*(_[a-z0-9]+)*')
# What looks like a word of a list, but in another style.
OTHER_STYLE = re.compile(r'[a-z0-9]+(-[a-z0-9]+)+|[a-z]+([A-Z][a-z0-9]+)+')
# The last name of a place whose value a user types or named: a file, a profile, a command.
TYPED = {'file', 'name', 'title', 'path', 'program', 'profile', 'command', 'picture', 'document', 'folder', 'source',
         'aliases', 'default', 'set', 'settings', 'valid_by_profile', 'match'}
KINDS = ('JSON', 'control')
# Kinds of identifiers are two words or more, and the word that they list is the last.
SCHEMA = re.compile(r'(?:"schema"\)\s*\.value\(|"schema",\s*|\["schema"\]\s*=\s*)([\w:]+)')
HEADER_NAME = re.compile(r'ARBITER_[A-Z_]*SCHEMA')


def style_of(trees):
    """Fails if a document has a word of another style: as a name of a member, as a value, or as a name in a map."""
    for tree in trees:
        for place, words in sorted(tree.words.items()):
            names = re.findall(r'[\w-]+', place)
            if set(names) & TYPED:
                continue
            for word in sorted(words):
                if OTHER_STYLE.fullmatch(word):
                    raise Broken(f'{tree.name} {place}: "{word}" is not in snake_case (docs/interface/style.py)')


def style_of_entries(kinds):
    """Fails if the list has a member or an identifier of another style."""
    for kind in KINDS:
        for entry in kinds[kind]:
            place = entry['key'] if 'type' in entry else ''
            names = re.findall(r'[\w-]+', re.split(r'[ <>]', place)[-1])
            for name in names + list(entry.get('choices', ())):
                if not WORD.fullmatch(name):
                    raise Broken(f'{kind}: {entry["key"]}: "{name}" is not in snake_case (docs/interface/style.py)')
    for entry in kinds['identifiers']:
        if not WORD.fullmatch(entry['key'].split()[-1]):
            raise Broken(f'identifiers: {entry["key"]} is not in snake_case (docs/interface/style.py)')


def one_type(kinds):
    """Fails if a member has two types. A number that is none is a text, and null stands for nothing."""
    for kind in KINDS:
        for entry in kinds[kind]:
            types = set(re.sub(r'(list|map) of |object as .*? of ', '', entry.get('type', '')).split(' or ')) - {'null'}
            if len(types) > 1 and types != {'number', 'text'}:
                raise Broken(f'{kind}: {entry["key"]} has two types: {entry["type"]} (docs/interface/style.py)')


def schema_numbers(files=None):
    """Fails if a source writes a schema that is no constant of GL/arbiter.h."""
    if files is None:
        paths = [path for path in sorted((ROOT / 'src').rglob('*.cpp')) if not path.name.endswith('_test.cpp')]
        files = {str(path.relative_to(ROOT)): path.read_text() for path in paths}
    count = 0
    for name, text in files.items():
        for value in SCHEMA.findall(text):
            count += 1
            if not HEADER_NAME.fullmatch(value):
                raise Broken(f'{name}: the schema {value} is no constant of include/GL/arbiter.h')
    if not count:
        raise Broken('no source writes a schema')
