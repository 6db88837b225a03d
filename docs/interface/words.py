"""Holds the words of documents to one style.

A member's name is snake_case, and so is a value that is a word of a closed list. What a user types as the value of an
option stays as it is typed: names of profiles, of back ends, of extensions and of files.
"""
import re

from sources import Broken

WORD = re.compile(r'[a-z][a-z0-9]*(_[a-z0-9]+)*')
# What looks like a word of a list, but in another style.
OTHER_STYLE = re.compile(r'[a-z0-9]+(-[a-z0-9]+)+|[a-z]+([A-Z][a-z0-9]+)+')
# The last name of a place whose value a user types or named: a file, a profile, a command.
TYPED = {'file', 'name', 'title', 'path', 'program', 'profile', 'command', 'picture', 'document', 'folder', 'source',
         'aliases', 'default', 'set', 'settings', 'valid_by_profile', 'match'}
KINDS = ('JSON', 'control')


def style_of(trees):
    """Fails if a document has a word of another style: as a name of a member, as a value, or as a name in a map."""
    for tree in trees:
        for place, words in sorted(tree.words.items()):
            names = re.findall(r'[\w-]+', place)
            if set(names) & TYPED:
                continue
            for word in sorted(words):
                if OTHER_STYLE.fullmatch(word):
                    raise Broken(f'{tree.name} {place}: "{word}" is not in snake_case (docs/interface/words.py)')


def style_of_entries(kinds):
    """Fails if the list has a member or an identifier of another style."""
    for kind in KINDS:
        for entry in kinds[kind]:
            place = entry['key'] if 'type' in entry else ''
            names = re.findall(r'[\w-]+', re.split(r'[ <>]', place)[-1])
            for name in names + list(entry.get('choices', ())):
                if not WORD.fullmatch(name):
                    raise Broken(f'{kind}: {entry["key"]}: "{name}" is not in snake_case (docs/interface/words.py)')
    for entry in kinds['identifiers']:
        if not WORD.fullmatch(entry['key'].split()[-1]):
            raise Broken(f'identifiers: {entry["key"]} is not in snake_case (docs/interface/words.py)')
