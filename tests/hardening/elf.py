"""Reads ELF files for the hardening test: 64-bit, little-endian, by the System V ABI."""
import bisect
import os
import struct
from dataclasses import dataclass

PT_LOAD, PT_DYNAMIC, PT_NOTE = 1, 2, 4
PT_GNU_STACK, PT_GNU_RELRO, PT_GNU_PROPERTY = 0x6474e551, 0x6474e552, 0x6474e553
PF_X, PF_W = 1, 2
SHT_SYMTAB, SHT_RELA, SHT_NOBITS, SHT_DYNSYM = 2, 4, 8, 11
SHF_WRITE, SHF_ALLOC, SHF_EXEC = 1, 2, 4
DT_INIT, DT_TEXTREL, DT_FLAGS, DT_FLAGS_1, DT_FINI = 12, 22, 30, 0x6ffffffb, 13
DF_TEXTREL, DF_BIND_NOW = 4, 8
DF_1_NOW, DF_1_PIE = 1, 0x08000000
ET_DYN = 3
STT_OBJECT, STT_FUNC, STT_IFUNC = 1, 2, 10
EM_X86_64, EM_AARCH64 = 62, 183
# Relocations by machine: those that add the load address to a number, and those that name a symbol.
RELATIVE = {EM_X86_64: {8, 37}, EM_AARCH64: {1027, 1032}}
BY_SYMBOL = {EM_X86_64: {1, 6, 7}, EM_AARCH64: {257, 1025, 1026}}
X86_FEATURES = 0xc0000002  # GNU_PROPERTY_X86_FEATURE_1_AND
IBT, SHSTK = 1, 2


@dataclass(frozen=True)
class Segment:
    type: int
    flags: int
    offset: int
    address: int
    file_size: int
    size: int

    def holds(self, address):
        return self.address <= address < self.address + self.size


@dataclass(frozen=True)
class Section:
    name: str
    type: int
    flags: int
    address: int
    offset: int
    size: int
    link: int


@dataclass(frozen=True)
class Symbol:
    name: str
    type: int
    section: int
    value: int
    size: int


@dataclass(frozen=True)
class Pointer:
    """A place that the loader fills with an address: in this file, or of a function by name."""
    place: int
    target: int | None
    symbol: str


class NotElf(Exception):
    """The file is not such an ELF file."""


class Elf:
    def __init__(self, path):
        self.path = path
        self.name = os.path.basename(path)
        with open(path, 'rb') as stream:
            self.data = stream.read()
        if self.data[:6] != b'\x7fELF\x02\x01':
            raise NotElf(path)
        (self.type, self.machine, _, self.entry, programs, sections, _, _, program_size,
         program_count, section_size, section_count, names) = struct.unpack_from(
             '<HHIQQQIHHHHHH', self.data, 16)
        self.segments = [self._segment(programs + i * program_size) for i in range(program_count)]
        raw = [struct.unpack_from('<IIQQQQII', self.data, sections + i * section_size)
               for i in range(section_count)]
        at = raw[names][4] if raw else 0
        self.sections = [Section(self._text(at + name), kind, flags, address, offset, size, link)
                         for name, kind, flags, address, offset, size, link, _ in raw]
        self.dynamic = self._dynamic()
        self.imports = {s.name for s in self.symbols(SHT_DYNSYM) if s.section == 0 and s.name}

    def _segment(self, at):
        kind, flags, offset, address, _, file_size, size, _ = struct.unpack_from(
            '<IIQQQQQQ', self.data, at)
        return Segment(kind, flags, offset, address, file_size, size)

    def _text(self, at):
        return self.data[at:self.data.index(b'\0', at)].decode(errors='replace')

    def _dynamic(self):
        entries = {}
        for segment in self.of_type(PT_DYNAMIC):
            for at in range(segment.offset, segment.offset + segment.file_size, 16):
                tag, value = struct.unpack_from('<QQ', self.data, at)
                entries.setdefault(tag, value)
        return entries

    def of_type(self, kind):
        return [segment for segment in self.segments if segment.type == kind]

    def bytes_at(self, address, count):
        """Returns the file's bytes at a load address; empty if the file has none there."""
        for segment in self.of_type(PT_LOAD):
            if segment.address <= address < segment.address + segment.file_size:
                at = segment.offset + address - segment.address
                return self.data[at:at + count]
        return b''

    def symbols(self, kind):
        found = []
        for section in self.sections:
            if section.type != kind:
                continue
            names = self.sections[section.link].offset
            for at in range(section.offset, section.offset + section.size, 24):
                name, info, _, where, value, size = struct.unpack_from('<IBBHQQ', self.data, at)
                found.append(Symbol(self._text(names + name), info & 15, where, value, size))
        return found

    def object_at(self, address):
        """Returns the name of the datum there, by the full symbol table, else by the section."""
        if not hasattr(self, '_objects'):
            data = sorted((s.value, s.size, s.name) for s in self.symbols(SHT_SYMTAB)
                          if s.type == STT_OBJECT and s.section)
            self._objects = data, [value for value, _, _ in data]
        data, starts = self._objects
        at = bisect.bisect_right(starts, address) - 1
        if at >= 0 and address < data[at][0] + data[at][1]:
            return data[at][2]
        for section in self.sections:
            if section.flags & SHF_ALLOC and section.address <= address < section.address + section.size:
                return f'{section.name}+{address - section.address:#x}'
        return f'{address:#x}'

    def is_code(self, address):
        return any(s.flags & PF_X and s.holds(address) for s in self.of_type(PT_LOAD))

    def stays_writable(self, address):
        """True if the place is still writable after loading."""
        return (any(s.flags & PF_W and s.holds(address) for s in self.of_type(PT_LOAD)) and
                not any(s.holds(address) for s in self.of_type(PT_GNU_RELRO)))

    def pointers(self):
        dynamic = self.symbols(SHT_DYNSYM)
        found = []
        for section in self.sections:
            if section.type != SHT_RELA or not section.flags & SHF_ALLOC:
                continue
            for at in range(section.offset, section.offset + section.size, 24):
                place, info, addend = struct.unpack_from('<QQq', self.data, at)
                kind, symbol = info & 0xffffffff, info >> 32
                if kind in RELATIVE.get(self.machine, ()):
                    found.append(Pointer(place, addend, ''))
                elif kind in BY_SYMBOL.get(self.machine, ()):
                    named = dynamic[symbol]
                    target = named.value + addend if named.section else None
                    is_function = named.type in (STT_FUNC, STT_IFUNC)
                    found.append(Pointer(place, target, named.name if is_function else ''))
        return found

    def code_pointers(self):
        return [p for p in self.pointers()
                if (p.target is not None and self.is_code(p.target)) or p.symbol]

    def x86_features(self):
        """Returns the features that all of the file's parts are marked with (IBT, SHSTK)."""
        features = 0
        for segment in self.of_type(PT_GNU_PROPERTY):
            at, end = segment.offset, segment.offset + segment.file_size
            while at + 16 <= end:
                _, size, _ = struct.unpack_from('<III', self.data, at)
                features |= self._property(at + 16, at + 16 + size)
                at += 16 + (size + 7 & ~7)
        return features

    def _property(self, at, end):
        features = 0
        while at + 8 <= end:
            kind, size = struct.unpack_from('<II', self.data, at)
            if kind == X86_FEATURES:
                features |= struct.unpack_from('<I', self.data, at + 8)[0]
            at += 8 + (size + 7 & ~7)
        return features
