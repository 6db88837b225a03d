#!/usr/bin/env python3
"""Takes pictures of the window's views, light and dark, at one and two pixels a unit.

usage: screenshots.py ARBITER_BUILDER GALLERY [--quick | --pages] [--out FOLDER] [--demo PROGRAM]

Every picture must have the size that its scale implies, and more than one color; light and dark pictures of a view
must differ. --quick takes one of each kind. --pages takes the pictures of the documentation (docs/pictures), which
have at most 100 KB each; --out docs/pictures replaces them. Without --out pictures are deleted. --demo is an
application that the window is attached to, on a display of its own (Xvfb); without it that picture is left out. The
environment's ARBITER_COMMAND is the `arbiter` that runs it.
"""
import argparse
import contextlib
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import time
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[4] / 'tests' / 'clients'))
import x_server  # noqa: E402

WRONG = ('MAD offset, offset, magnitude.x', 'MAD offset, ofset, magnitude.x')
# (name, document, replacement in its text, panel, pixel to debug)
SHOTS = [
    ('picture', 'twirl.fp', None, 'Parameters', ''),
    ('error', 'twirl.fp', WRONG, 'Problems', ''),
    ('debug', 'twirl.fp', None, 'Debug', '200,300'),
    ('textures', 'twirl.fp', None, 'Textures', ''),
    ('scene', 'gooch.fp', None, 'Scene', ''),
    ('words', 'twirl.fp', None, 'Words', ''),
    ('native', 'lighting_4_all.fp', None, 'Native', ''),
    ('advice', 'life.fp', None, 'Advice', ''),
    ('compare', 'gooch.fp', None, 'Compare', ''),
    ('bench', 'gooch.fp', None, 'Bench', ''),
    ('gallery', None, None, 'Gallery', ''),
]
# The pages' pictures have colors, size and further options as well. A text that is edited was drawn before, and the old
# picture stays.
PAGES = [  # pictures of few colors compress well
    ('window', 'cartoon.fp', None, 'Parameters', '', 'light', (920, 640), ()),
    ('error', 'life.fp', None, 'Problems', '', 'light', (920, 680),
     ('--edit', 'ADD n, here, step.wyww=>ADD n, here, stp.wyww')),
    ('held', 'life.fp', None, 'Parameters', '', 'dark', (900, 680),
     ('--edit', 'TEX self, here=>TEX slef, here')),
    ('debug', 'life.fp', None, 'Debug', '60,60', 'dark', (800, 600), ()),
    ('watch', 'life.fp', None, 'Debug', '60,60', 'light', (760, 540), ('--watch', '31')),
    ('scene', 'cartoon.fp', None, 'Scene', '', 'light', (890, 640), ()),
    ('gallery', None, None, 'Gallery', '', 'dark', (900, 600), ()),
]
ATTACHED = ('attach', None, None, 'Attach', '')
ATTACHED_SIZE = (1000, 720)
LARGEST = 100 * 1024  # bytes
KINDS = [(colours, scale) for colours in ('light', 'dark') for scale in (1, 2)]


def size_of(png):
    """Returns (width, height) of a PNG, and whether it has more than one color."""
    data = png.read_bytes()
    assert data[:8] == b'\x89PNG\r\n\x1a\n', png
    size = struct.unpack('>II', data[16:24])
    at, packed = 8, b''
    while at < len(data):
        length, kind = struct.unpack('>I4s', data[at:at + 8])
        if kind == b'IDAT':
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    return size, len(set(zlib.decompress(packed)[::7])) > 8


def shoot(arguments, shot, colours, scale, png, folder, more=(), **further):
    name, document, change, panel, pixel = shot
    words = [arguments.builder, '--screenshot', str(png), '--colors', colours, '--panel', panel, *more]
    if pixel:
        words += ['--pixel', pixel]
    if document:
        text = (arguments.gallery / document).read_text()
        if change:
            assert change[0] in text, (name, change)
            path = folder / document
            path.write_text(text.replace(*change))
        else:
            path = arguments.gallery / document
        words += ['--', str(path)]
    environment = dict(os.environ, QT_QPA_PLATFORM='offscreen', QT_SCALE_FACTOR=str(scale),
                       XDG_CONFIG_HOME=str(folder / 'config'), XDG_STATE_HOME=str(folder / png.stem),
                       XDG_CACHE_HOME=str(folder / 'cache'), ARBITER_GALLERY=str(arguments.gallery),
                       **further)
    environment.pop('DISPLAY', None)
    return subprocess.run(words, env=environment, timeout=120, capture_output=True, text=True)


@contextlib.contextmanager
def application(demo, folder):
    """Starts the demo under `arbiter run --control`. Returns its process, and the folder of its socket."""
    runtime = folder / 'runtime'
    runtime.mkdir(mode=0o700)
    with x_server.XServer('640x480x24') as display:
        client = subprocess.Popen(
            [os.environ.get('ARBITER_COMMAND', 'arbiter'), 'run', '--control', '--', demo, '--size',
             '256x256'], stdout=subprocess.DEVNULL,
            env=dict(os.environ, DISPLAY=display, XDG_RUNTIME_DIR=str(runtime), LIBGL_ALWAYS_SOFTWARE='1'))
        try:
            for _ in range(600):
                if client.poll() is not None or list(runtime.glob('arbiter/*')):
                    break
                time.sleep(0.1)
            yield client, runtime
        finally:
            client.kill()
            client.wait()


def fault_of(done, png, size):
    """Returns the fault of a page's picture, or nothing."""
    if done.returncode != 0 or not png.exists():
        return f'status {done.returncode}: {done.stderr[-400:]}'
    if size_of(png)[0] != size:
        return f'size {size_of(png)[0]}'
    return f'{png.stat().st_size} bytes' if png.stat().st_size > LARGEST else None


def page_options(size, more=()):
    return ['--small', '--size', '%dx%d' % size, *more]


def take_attached(arguments, png, folder):
    with application(arguments.demo, folder) as (client, runtime):
        done = shoot(arguments, ATTACHED, 'light', 1, png, folder,
                     page_options(ATTACHED_SIZE, ('--attach', str(client.pid))),
                     XDG_RUNTIME_DIR=str(runtime))
        return fault_of(done, png, ATTACHED_SIZE)


def take_pages(arguments, out, folder):
    """Takes the documentation's pictures; returns how many failed."""
    failed = 0
    for *shot, colours, size, more in PAGES:
        if arguments.only not in (None, shot[0]):
            continue
        png = out / f'{shot[0]}.png'
        fault = fault_of(shoot(arguments, shot, colours, 1, png, folder, page_options(size, more)),
                         png, size)
        failed += bool(fault)
        print(f'{png.name}: {fault or "ok"}', flush=True)
    if arguments.demo and arguments.only in (None, 'attach'):
        fault = take_attached(arguments, out / 'attach.png', folder)
        failed += bool(fault)
        print(f'attach.png: {fault or "ok"}', flush=True)
    return failed


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument('builder')
    parser.add_argument('gallery', type=pathlib.Path)
    parser.add_argument('--quick', action='store_true')
    parser.add_argument('--pages', action='store_true')
    parser.add_argument('--out', type=pathlib.Path)
    parser.add_argument('--only')
    parser.add_argument('--demo')
    arguments = parser.parse_args()
    failed = 0
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        out = arguments.out or folder
        out.mkdir(parents=True, exist_ok=True)
        if arguments.pages:
            return 1 if take_pages(arguments, out, folder) else 0
        shots = [shot for shot in SHOTS if arguments.only in (None, shot[0])]
        for shot in shots[:2] if arguments.quick else shots:
            before = None
            for colours, scale in KINDS[::3] if arguments.quick else KINDS:
                png = out / f'{shot[0]}-{colours}-{scale}x.png'
                done = shoot(arguments, shot, colours, scale, png, folder)
                fault = None
                if done.returncode != 0 or not png.exists():
                    fault = f'status {done.returncode}: {done.stderr[-400:]}'
                else:
                    size, colourful = size_of(png)
                    if size != (1280 * scale, 800 * scale):
                        fault = f'size {size}'
                    elif not colourful:
                        fault = 'one colour'
                    elif png.read_bytes() == before:
                        fault = 'light and dark are one'
                    before = png.read_bytes()
                failed += fault is not None
                print(f'{png.name}: {fault or "ok"}', flush=True)
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
