"""Builds libraries that lack one property each; the check of that property must find each."""
import pathlib
import platform
import struct
import subprocess
import tempfile

from elf import PF_W, PF_X, PT_LOAD, Elf
from properties import complaints

GOOD = ['-fstack-protector-strong', '-fstack-clash-protection', '-O2', '-fPIC']
GOOD_LINK = ['-Wl,-z,relro', '-Wl,-z,now', '-Wl,-z,noexecstack', '-Wl,-z,separate-code']
CET = ['-fcf-protection=full']
CET_LINK = ['-Wl,-z,ibt', '-Wl,-z,shstk', '-Wl,-init=hasNone', '-Wl,-fini=hasNone']
FORTIFY = ['-U_FORTIFY_SOURCE', '-D_FORTIFY_SOURCE=3']

SOURCE = r'''
#include <cstdio>
#include <cstring>
#define SEEN extern "C" __attribute__((visibility("default")))
using Function = int (*)(int);
static int twice(int n) { return 2 * n; }
static int thrice(int n) { return 3 * n; }
SEEN int call(int at, int n) {
  TABLE Function s_table[] = {twice, thrice, twice, thrice, twice, thrice, twice, thrice};
#ifdef WRITES
  if (n == 77) s_table[0] = s_table[1];
#endif
  return s_table[at & 7](n);
}
SEEN int length(const char *text) {
  char copy[64];
  std::strcpy(copy, text);
  return std::printf("%s %d\n", copy, int(std::strlen(copy)));
}
PROGRAM
'''


def drop(options, *gone):
    return [option for option in options if option not in gone]


def cases(x86):
    """Returns (fault, property that must report it or None, compile options, link options, defines)."""
    compiled = GOOD + FORTIFY + (CET if x86 else [])
    linked = GOOD_LINK + (CET_LINK if x86 else [])
    plain = ['-DTABLE=static const', '-DPROGRAM=']
    written = ['-DTABLE=static', '-DWRITES', '-DPROGRAM=']
    found = [
        ('nothing', None, compiled, linked, plain),
        ('lazy binding', 'binds_now', compiled, drop(linked, '-Wl,-z,now') + ['-Wl,-z,lazy'], plain),
        ('no relro', 'full_relro', compiled, drop(linked, '-Wl,-z,relro') + ['-Wl,-z,norelro'], plain),
        ('an executable stack', 'stack_holds_no_code', compiled,
         drop(linked, '-Wl,-z,noexecstack') + ['-Wl,-z,execstack'], plain),
        ('code among data', 'code_lies_apart', compiled,
         drop(linked, '-Wl,-z,separate-code') + ['-Wl,-z,noseparate-code'], plain),
        ('a segment of all rights', 'nothing_is_writable_and_code', compiled, linked, plain),
        ('no stack protector', 'guards_stacks',
         drop(compiled, '-fstack-protector-strong') + ['-fno-stack-protector'], linked, plain),
        ('nothing fortified', 'checks_buffers',
         drop(compiled, '-D_FORTIFY_SOURCE=3'), linked, plain),
        ('a table of functions that is written', 'functions_are_not_written', compiled, linked,
         written),
        ('code that is relocated', 'text_is_not_relocated',
         drop(compiled, '-fPIC') + ['-fno-pic', '-mcmodel=large'], linked + ['-Wl,-z,notext'], plain),
        ('a fixed address', 'lies_anywhere', drop(compiled, '-fPIC') + ['-fno-pie'],
         ['-no-pie'] + drop(linked, *CET_LINK), ['-DTABLE=static const', '-DPROGRAM=int main(){}']),
    ]
    if x86:
        found += [
            ('no marks', 'control_flow_is_marked', compiled, drop(linked, *CET_LINK[:2]), plain),
            ('marked, without landing pads', 'control_flow_lands_on_pads',
             drop(compiled, *CET) + ['-fcf-protection=none'], linked, plain),
            ('marked, with the start-up files of the C library', 'control_flow_lands_on_pads',
             compiled, drop(linked, *CET_LINK[2:]), plain),
        ]
    return found


def give_all_rights(path):
    """Makes the code segment writable, which linkers refuse to do."""
    data = bytearray(path.read_bytes())
    programs, = struct.unpack_from('<Q', data, 32)
    size, count = struct.unpack_from('<HH', data, 54)
    for at in range(programs, programs + size * count, size):
        kind, flags = struct.unpack_from('<II', data, at)
        if kind == PT_LOAD and flags & PF_X:
            struct.pack_into('<I', data, at + 4, flags | PF_W)
    path.write_bytes(data)


def run(compiler):
    failed = 0
    with tempfile.TemporaryDirectory(prefix='arbiter-hardening-') as scratch:
        source = pathlib.Path(scratch) / 'planted.cpp'
        source.write_text(SOURCE)
        for name, wanted, compiled, linked, defines in cases(platform.machine() == 'x86_64'):
            output = pathlib.Path(scratch) / 'planted.so'
            output.unlink(missing_ok=True)
            shared = [] if '-no-pie' in linked else ['-shared']
            subprocess.run([*compiler, *compiled, *defines, *shared, str(source), *linked, '-o',
                            str(output)], check=True, stderr=subprocess.DEVNULL)
            if name == 'a segment of all rights':
                give_all_rights(output)
            found = {kind for kind, _ in complaints(Elf(output))}
            if wanted is None and found:
                print(f'{name} is wrong, and found was: {complaints(Elf(output))}')
                failed += 1
            elif wanted is not None and wanted not in found:
                print(f'{name}: not found by {wanted}; found: {sorted(found) or "nothing"}')
                failed += 1
            else:
                print(f'{name}: {", ".join(sorted(found)) or "no complaint"}')
    return 1 if failed else 0
