"""Reads this process's memory from /proc, to find writable places that contain function addresses."""
import array
import re
import struct
from dataclasses import dataclass

from elf import PF_W, PT_LOAD, Elf, NotElf

LINE = re.compile(r'([0-9a-f]+)-([0-9a-f]+) (\S{4}) ([0-9a-f]+) \S+ \d+\s*(.*)')
ENTRY = 8  # bytes of a pointer


@dataclass(frozen=True)
class Mapping:
    begin: int
    end: int
    rights: str
    offset: int
    path: str

    @property
    def writable(self):
        return 'w' in self.rights

    @property
    def is_code(self):
        return 'x' in self.rights

    def __str__(self):
        return f'{self.begin:x}-{self.end:x} {self.rights} {self.path}'


def mappings():
    with open('/proc/self/maps', encoding='utf-8', errors='surrogateescape') as stream:
        found = []
        for line in stream:
            begin, end, rights, offset, path = LINE.match(line).groups()
            found.append(Mapping(int(begin, 16), int(end, 16), rights, int(offset, 16), path))
        return found


def words(mapping, begin=None, end=None):
    """Returns (address, the words from there on), aligned; nothing if the memory is unreadable."""
    begin = max(mapping.begin, begin or 0) + 7 & ~7
    end = min(mapping.end, end or mapping.end) & ~7
    if end <= begin:
        return begin, array.array('Q')
    try:
        with open('/proc/self/mem', 'rb') as stream:
            stream.seek(begin)
            return begin, array.array('Q', stream.read(end - begin))
    except (OSError, ValueError, OverflowError):
        return begin, array.array('Q')


class Code:
    """Knows where code is mapped, for quick answers."""

    def __init__(self, maps):
        self.ranges = [(m.begin, m.end) for m in maps if m.is_code and 'vsyscall' not in m.path]
        self.least = min(begin for begin, _ in self.ranges)
        self.most = max(end for _, end in self.ranges)

    def __contains__(self, word):
        return (self.least <= word < self.most and
                any(begin <= word < end for begin, end in self.ranges))


@dataclass(frozen=True)
class Written:
    """A pointer to code in writable memory."""
    library: str
    name: str
    place: int
    to: int


def writable_functions(is_layers):
    """Finds pointers to code in the writable memory of libraries, including data filled at run time.

    is_layers(path) selects the libraries. Returns the pointers, and the libraries' paths.
    """
    maps = mappings()
    code = Code(maps)
    found, looked = [], []
    for path in sorted({m.path for m in maps if is_layers(m.path)}):
        try:
            elf = Elf(path)
        except (NotElf, OSError):
            continue
        base = min(m.begin for m in maps if m.path == path)
        looked.append(path)
        for segment in elf.of_type(PT_LOAD):
            if not segment.flags & PF_W:
                continue
            begin, end = base + segment.address, base + segment.address + segment.size
            for mapping in maps:
                if mapping.writable and mapping.begin < end and begin < mapping.end:
                    at, content = words(mapping, begin, end)
                    found += [Written(path, elf.object_at(at + i * ENTRY - base), at + i * ENTRY, word)
                              for i, word in enumerate(content) if word in code]
    return found, looked


def tables_of(functions, least):
    """Returns places in writable memory where `least` of these addresses follow each other, such as copies of
    GetProcAddress's answers."""
    known = set(functions)
    # All bytes of an address but the low three have few values, so that memory without them is skipped quickly.
    upper = {struct.pack('<Q', address)[3:] for address in known}
    pattern = re.compile(b'|'.join(map(re.escape, sorted(upper))))
    tables = []
    for mapping in mappings():
        if not mapping.writable or mapping.path.startswith('/'):
            continue
        begin, content = words(mapping)
        data = content.tobytes()
        places = [match.start() - 3 for match in pattern.finditer(data)
                  if (match.start() - 3) % ENTRY == 0]
        run = []
        for place in [p for p in places if content[p // ENTRY] in known] + [-1]:
            if run and place == run[-1] + ENTRY:
                run.append(place)
                continue
            if len(run) >= least:
                tables.append((begin + run[0], len(run), str(mapping)))
            run = [place]
    return tables
