"""Runs tests that are their own client: a context without a window, on the bare host and under `arbiter run`. Each is
a process that prints its answers as JSON.
"""
import argparse
import ctypes
import json
import pathlib
import subprocess
import sys

from plain_environment import PYTHON, plain

GL_XML = '/usr/share/khronos-api/gl.xml'
SKIPPED = 77


class Failure(Exception):
    """A check failed; says what was seen and what was expected."""


def expect(holds, text):
    if not holds:
        raise Failure(text)


def egl_context(core):
    """Makes a context without a surface current; returns how its functions are found."""
    egl = ctypes.CDLL('libEGL.so.1')
    for name in ('eglGetPlatformDisplay', 'eglCreateContext', 'eglGetProcAddress'):
        getattr(egl, name).restype = ctypes.c_void_p
    display = ctypes.c_void_p(egl.eglGetPlatformDisplay(0x31DD, None, None))
    if not egl.eglInitialize(display, None, None):
        return None
    egl.eglBindAPI(0x30A2)
    attributes = (ctypes.c_int * 7)(0x3098, 4, 0x30FB, 5, 0x30FD, 1, 0x3038)
    context = ctypes.c_void_p(egl.eglCreateContext(display, None, None,
                                                   attributes if core else None))
    if not context.value or not egl.eglMakeCurrent(display, None, None, context):
        return None
    return lambda name: egl.eglGetProcAddress(name)


def osmesa_context(_):
    library = ctypes.CDLL('libOSMesa.so.8')
    library.OSMesaCreateContext.restype = ctypes.c_void_p
    library.OSMesaGetProcAddress.restype = ctypes.c_void_p
    context = ctypes.c_void_p(library.OSMesaCreateContext(0x1908, None))
    picture = ctypes.create_string_buffer(16 * 16 * 4)
    if not library.OSMesaMakeCurrent(context, picture, 0x1401, 16, 16):
        return None
    library.kept = picture
    return lambda name: library.OSMesaGetProcAddress(name)


def ask(script, options, kind, arguments, **variables):
    """Returns the output of `script --client kind` under `arbiter run` with the arguments; on the bare host if they
    are None. Returns None if the client cannot run here."""
    command = [PYTHON, str(pathlib.Path(script).resolve()), '--client', kind]
    if arguments is not None:
        command = [options.arbiter, 'run', '--library', options.library, *arguments, '--', *command]
    environment = plain(EGL_PLATFORM='surfaceless', **variables)
    result = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=120,
                            check=False)
    if result.returncode == SKIPPED:
        return None
    expect(result.returncode == 0, f'{command}: exit {result.returncode}\n{result.stderr}')
    return json.loads(result.stdout)


def main(name, client, check):
    """Runs the script by its command line: the client of a kind, or check(options), which returns False if
    nothing could run.

    Returns the exit status.
    """
    parser = argparse.ArgumentParser(description=sys.modules['__main__'].__doc__.splitlines()[0])
    parser.add_argument('--client', help='be the client of that kind')
    parser.add_argument('--arbiter')
    parser.add_argument('--library')
    options = parser.parse_args()
    if options.client:
        return client(options.client)
    try:
        if check(options):
            return 0
        print('skipped: no context without a window')
        return SKIPPED
    except Failure as failure:
        print(f'{name}: {failure}', file=sys.stderr)
        return 1
