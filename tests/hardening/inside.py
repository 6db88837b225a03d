#!/usr/bin/env python3
"""Checks a process that draws with the rasterizer: no memory is ever writable and executable at once, and no table of
the layer's functions is writable once it is filled.

Runs itself as the client, with OSMesa, with EGL (surfaceless) and, if there is a display, with GLX.
`inside.py --plant` runs a client with such memory, which must be found.
"""
import argparse
import collections
import ctypes
import json
import mmap
import os
import pathlib
import subprocess
import sys
import tempfile
import threading

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / 'clients'))
import identity  # noqa: E402
from plain_environment import PYTHON, plain  # noqa: E402
import process  # noqa: E402
from properties import is_writable_table  # noqa: E402

PROGRAMS = 12
SIZE = 64
FRAGMENT, VERTEX, ASCII = 0x8804, 0x8620, 0x8875
TABLE = 16  # this many functions in a row are a table
# Memory that Mesa maps with all permissions, by size: how many mappings, and their purpose.
HOSTS = {4096: (1, 'stubs of libglapi for functions that it learns of'),
         10485760: (1, 'vertex code of rtasm')}


# --- The client ---

def glx_context(_):
    x, gl = ctypes.CDLL('libX11.so.6'), ctypes.CDLL('libGL.so.1')
    pointer, word = ctypes.c_void_p, ctypes.c_ulong
    x.XOpenDisplay.restype = gl.glXChooseVisual.restype = gl.glXCreateContext.restype = pointer
    gl.glXGetProcAddress.restype = pointer
    x.XRootWindow.restype = x.XCreateSimpleWindow.restype = word
    display = pointer(x.XOpenDisplay(None))
    if not display.value:
        return None
    visual = pointer(gl.glXChooseVisual(display, 0, (ctypes.c_int * 4)(4, 5, 12, 0)))
    context = pointer(gl.glXCreateContext(display, visual, None, 1))
    window = word(x.XCreateSimpleWindow(display, word(x.XRootWindow(display, 0)), 0, 0, SIZE, SIZE,
                                        0, word(0), word(0)))
    x.XMapWindow(display, window)
    if not gl.glXMakeCurrent(display, window, context):
        return None
    glx_context.swap = lambda: gl.glXSwapBuffers(display, window)
    return lambda name: gl.glXGetProcAddress(name)


CONTEXTS = {'osmesa': identity.osmesa_context, 'egl': identity.egl_context, 'glx': glx_context}


class Watch:
    """Inspects the permissions of all memory while the other thread draws."""

    def __init__(self):
        self.both, self.looks, self.done = {}, 0, threading.Event()
        self.thread = threading.Thread(target=self.watch)

    def watch(self):
        while not self.done.is_set():
            self.count_writable_code()

    def count_writable_code(self):
        self.looks += 1
        seen = collections.Counter(m.end - m.begin for m in process.mappings()
                                   if m.writable and m.is_code)
        self.both.update({size: max(count, self.both.get(size, 0)) for size, count in seen.items()})


def count_code():
    """Returns the number of code mappings without a file, which were made at run time."""
    return sum(m.is_code and not m.path for m in process.mappings())


def draw(find, turn):
    """Draws with a new program, sometimes with a vertex program. Each has a name of its own: the bare Mesa 25.0.7 frees
    memory twice if a vertex program is given another text."""
    uint, single = ctypes.c_uint, ctypes.c_float

    def call(name, *arguments):
        ctypes.CFUNCTYPE(None, *(type(a) for a in arguments))(find(name.encode()))(*arguments)

    def program(target, text):
        name = uint()
        call('glGenProgramsARB', ctypes.c_int(1), ctypes.c_void_p(ctypes.addressof(name)))
        call('glBindProgramARB', uint(target), name)
        call('glProgramStringARB', uint(target), uint(ASCII), ctypes.c_int(len(text)),
             ctypes.c_char_p(text.encode()))
        call('glEnable', uint(target))

    program(FRAGMENT, f'!!ARBfp1.0\nTEMP a;\nMUL a, fragment.color, {turn + 1}.25;\n'
                      f'FRC result.color, a;\nEND')
    if turn % 2:
        program(VERTEX, f'!!ARBvp1.0\nADD result.position, vertex.position, {{0, 0, 0.0{turn}, 0}};'
                        f'\nMOV result.color, vertex.color;\nEND')
    call('glRectf', single(-1), single(-1), single(1), single(1))
    call('glFinish')


def surface(find):
    """Makes a target for drawing without a window: a texture."""
    def call(name, *arguments):
        ctypes.CFUNCTYPE(None, *(type(a) for a in arguments))(find(name.encode()))(*arguments)

    uint, number = ctypes.c_uint, ctypes.c_int
    names = (uint * 2)()
    call('glGenTextures', number(1), ctypes.c_void_p(ctypes.addressof(names)))
    call('glBindTexture', uint(0xDE1), uint(names[0]))
    call('glTexImage2D', uint(0xDE1), number(0), number(0x8058), number(SIZE), number(SIZE),
         number(0), uint(0x1908), uint(0x1401), ctypes.c_void_p(None))
    call('glGenFramebuffers', number(1), ctypes.c_void_p(ctypes.addressof(names) + 4))
    call('glBindFramebuffer', uint(0x8D40), uint(names[1]))
    call('glFramebufferTexture2D', uint(0x8D40), uint(0x8CE0), uint(0xDE1), uint(names[0]),
         number(0))
    call('glViewport', number(0), number(0), number(SIZE), number(SIZE))


def is_layer(path):
    name = os.path.basename(path)
    return name.startswith(('libGLX_arbiter', 'libarbiter_')) or '/osmesa/libOSMesa' in path


def real_osmesa():
    """Returns the addresses of the host's gl functions, if OSMesa is the host."""
    library = os.environ.get('HARDENING_OSMESA')
    loaded = {os.path.realpath(m.path): m for m in reversed(process.mappings())
              if m.path.startswith('/')}
    mapping = loaded.get(os.path.realpath(library)) if library else None
    if not mapping:
        return []
    elf = process.Elf(mapping.path)
    return [mapping.begin + s.value for s in elf.symbols(11)
            if s.section and s.name.startswith('gl') and s.type == 2]


def plant():
    """Makes memory with all permissions, and a writable table of functions."""
    plant.memory = mmap.mmap(-1, 12345 * 4096, prot=mmap.PROT_READ | mmap.PROT_WRITE | mmap.PROT_EXEC)
    functions = real_osmesa()[:2 * TABLE]
    plant.table = (ctypes.c_uint64 * len(functions))(*functions)


def client(kind, planted):
    find = CONTEXTS[kind](False)
    if find is None:
        return 77
    if kind != 'glx':
        surface(find)
    watch = Watch()
    watch.count_writable_code()
    before = count_code()
    watch.thread.start()
    if planted:
        plant()
    for turn in range(PROGRAMS):
        draw(find, turn)
        if kind == 'glx':
            glx_context.swap()
    watch.done.set()
    watch.thread.join()
    watch.count_writable_code()
    written, looked = process.writable_functions(is_layer)
    functions = real_osmesa() if kind == 'osmesa' and looked else []
    print(json.dumps({
        'looks': watch.looks, 'both': sorted(watch.both.items()),
        'code': count_code() - before,
        'written': [(os.path.basename(library), name, count) for (library, name), count in
                    collections.Counter((w.library, w.name) for w in written).items()],
        'looked': [os.path.basename(path) for path in looked],
        'functions': len(functions),
        'tables': process.tables_of(functions, TABLE) if functions else [],
    }))
    return 0


# --- The harness ---

def ask(options, kind, layered=True, planted=False):
    """Returns the client's answers, and the layer's statistics."""
    with tempfile.TemporaryDirectory(prefix='arbiter-inside-') as folder:
        stats = pathlib.Path(folder) / 'stats.json'
        command = [PYTHON, str(HERE / 'inside.py'), '--client', kind]
        if planted:
            command.append('--plant')
        if layered:
            command = [options.arbiter, 'run', '--library', options.library, '--backend', 'swrast',
                       '--stats', str(stats), '--', *command]
        environment = plain(ARBITER_CACHE='0', HARDENING_OSMESA=options.osmesa)
        if kind == 'egl':
            environment['EGL_PLATFORM'] = 'surfaceless'
        result = subprocess.run(command, env=environment, capture_output=True, text=True,
                                timeout=240, check=False)
        if result.returncode == 77:
            return None, None
        if result.returncode != 0:
            raise SystemExit(f'{kind}: exit {result.returncode}\n{result.stderr}')
        return json.loads(result.stdout), json.loads(stats.read_text()) if layered else None


def complaints(answers, drawn, bare):
    """Returns complaints as texts; empty if all is well."""
    hosts = {size: count for size, (count, _) in HOSTS.items()}
    for size, count in bare['both']:
        hosts[size] = max(count, hosts.get(size, 0))
    found = [f'{count} mappings of {size} bytes are writable and executable'
             for size, count in answers['both'] if count > hosts.get(size, 0)]
    found += [f'{count} pointers to functions may be written in {library}: {name}'
              for library, name, count in answers['written'] if is_writable_table(library, name, count)]
    found += [f'{count} functions of the host in a row may be written at {place:#x} ({where})'
              for place, count, where in answers['tables']]
    # These faults would make the answers worthless.
    if drawn < PROGRAMS:
        found.append(f'the rasterizer drew {drawn} of {PROGRAMS}')
    if answers['code'] <= 0:  # code of the layer's draws
        found.append('no machine code of the layer is there')
    if answers['looks'] < PROGRAMS or not {'libarbiter_jit.so'} <= set(answers['looked']):
        found.append(f'looked {answers["looks"]} times, at {answers["looked"]}')
    return found


def check_kind(options, kind):
    bare, _ = ask(options, kind, layered=False)
    if bare is None:
        print(f'{kind}: not here')
        return None
    answers, stats = ask(options, kind)
    if answers is None:
        raise SystemExit(f'{kind}: the client found it on the bare host, and not under the layer')
    drawn = stats['draws']['rasterizer']
    found = complaints(answers, drawn, bare)
    for text in found[:40]:
        print(f'{kind}: {text}')
    print(f'{kind}: {answers["looks"]} looks, {len(answers["looked"])} libraries, '
          f'{answers["functions"]} functions of the host, {drawn} draws: {len(found)} complaints')
    return not found


def check_plant(options):
    """Checks that the client's own bad memory is found."""
    bare, _ = ask(options, 'osmesa', layered=False)
    if bare is None:
        return True
    answers, stats = ask(options, 'osmesa', planted=True)
    found = complaints(answers, stats['draws']['rasterizer'], bare)
    wanted = ['are writable and executable'] + (['in a row may be written'] if answers['functions']
                                                else [])
    lacking = [text for text in wanted if not any(text in line for line in found)]
    print(f'planted: {"not found: " + ", ".join(lacking) if lacking else "found"}')
    return not lacking


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--client', choices=CONTEXTS)
    parser.add_argument('--plant', action='store_true')
    parser.add_argument('--arbiter')
    parser.add_argument('--library')
    parser.add_argument('--osmesa', default='', help='the real libOSMesa, by its path')
    options = parser.parse_args()
    if options.client:
        return client(options.client, options.plant)
    kinds = ['osmesa', 'egl'] + (['glx'] if os.environ.get('DISPLAY') else [])
    results = [check_kind(options, kind) for kind in kinds]
    if not any(result is not None for result in results):
        print('skipped: no context without a window')
        return 77
    return 0 if check_plant(options) and all(result is not False for result in results) else 1


if __name__ == '__main__':
    sys.exit(main())
