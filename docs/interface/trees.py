"""Turns JSON documents into a tree of places with types, as the list of the interface has it.

A place is the names on the way, `[]` for each element of a list and `{}` for each member of a map: an object whose
names are data, as the names of files are. Types are text, number, truth, null, object, map and list.
"""


class Tree:
    """The places that the documents of one report have had, with the texts that stood there."""

    def __init__(self, maps=(), named=(), same=()):
        """maps: places of maps. named: places of maps whose names belong to the interface. same: pairs of a place and
        the tree that it is the same as."""
        self.maps, self.named, self.same = set(maps), set(named), dict(same)
        self.kinds, self.names, self.words = {}, {}, {}

    def add(self, value, place=''):
        """Adds a document, or a part of one."""
        if place in self.same:
            tree, start = self.same[place]
            self.note(place, 'object')
            tree.add(value, start)
            return
        if isinstance(value, dict):
            self.add_object(value, place)
        elif isinstance(value, list):
            self.note(place, 'list')
            for each in value:
                self.add(each, place + '[]')
        else:
            self.note(place, {bool: 'truth', int: 'number', float: 'number', str: 'text'}.get(type(value), 'null'))
            if isinstance(value, str):
                self.words.setdefault(place, set()).add(value)

    def add_object(self, value, place):
        if place in self.maps or place in self.named:
            self.note(place, 'map')
            if place in self.named:
                self.names.setdefault(place, set()).update(value)
            self.words.setdefault(place, set()).update(value)
            for each in value.values():
                self.add(each, place + '{}')
            return
        self.note(place, 'object')
        for name, each in value.items():
            self.add(each, f'{place}.{name}' if place else name)

    def note(self, place, kind):
        self.kinds.setdefault(place, set()).add(kind)

    def type_of(self, place):
        """Returns the type of a place: "list of number or text", "null or object as files[] of check"."""
        parts = []
        for kind in sorted(self.kinds[place] - {'null'}):
            inner = place + {'list': '[]', 'map': '{}'}.get(kind, '')
            if kind in ('list', 'map') and inner in self.kinds:
                kind += ' of ' + self.type_of(inner)
            if kind == 'object' and place in self.same:
                tree, start = self.same[place]
                kind = f'object as {start} of {tree.name}' if start else f'object as {tree.name}'
            parts.append(kind)
        if 'null' in self.kinds[place]:
            parts.append('null')
        return ' or '.join(parts)

    def entries(self, name):
        """Returns an entry for each place that is no element of a list or a map of another."""
        found = []
        for place in self.kinds:
            if place and not place.endswith(('[]', '{}')):
                entry = {'key': f'{name} {place}', 'type': self.type_of(place)}
                if place in self.names:
                    entry['choices'] = sorted(self.names[place])
                found.append(entry)
        return found

    def keys(self):
        """Returns the names of members, for a comparison with the sources."""
        return {part.rstrip('[]{}') for place in self.kinds for part in place.split('.')} | \
            {name for names in self.names.values() for name in names}
