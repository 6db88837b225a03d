#!/usr/bin/env python3
"""Uses libEGL and libGL through Python's ctypes, as PyOpenGL does: every call goes through a loaded library."""
import ctypes
import json
import sys

egl = ctypes.CDLL("libEGL.so.1")
gl = ctypes.CDLL("libGL.so.1")
P, I, U, F = ctypes.c_void_p, ctypes.c_int, ctypes.c_uint, ctypes.c_float
for name, result, *arguments in (
        ("eglGetDisplay", P, P), ("eglInitialize", U, P, P, P), ("eglBindAPI", U, U),
        ("eglChooseConfig", U, P, P, P, I, P), ("eglCreatePbufferSurface", P, P, P, P),
        ("eglCreateContext", P, P, P, P, P), ("eglMakeCurrent", U, P, P, P, P),
        ("eglDestroyContext", U, P, P), ("eglTerminate", U, P), ("eglGetProcAddress", P, ctypes.c_char_p)):
    function = getattr(egl, name)
    function.restype, function.argtypes = result, arguments


def proc(name, *arguments):
    return ctypes.CFUNCTYPE(None, *arguments)(egl.eglGetProcAddress(name))


display = egl.eglGetDisplay(None)
assert egl.eglInitialize(display, None, None), "eglInitialize"
assert egl.eglBindAPI(0x30A2)
config, count = P(), I()
wanted = (I * 9)(0x3033, 1, 0x3040, 8, 0x3024, 8, 0x3023, 8, 0x3038)
assert egl.eglChooseConfig(display, wanted, ctypes.byref(config), 1, ctypes.byref(count)) and count.value
surface = egl.eglCreatePbufferSurface(display, config, (I * 5)(0x3057, 64, 0x3056, 64, 0x3038))
context = egl.eglCreateContext(display, config, None, None)
assert egl.eglMakeCurrent(display, surface, surface, context), "eglMakeCurrent"

gl.glColor4f.argtypes = [F] * 4
gl.glVertex2f.argtypes = [F] * 2
program, text = U(), b"!!ARBfp1.0\nMUL result.color, fragment.color, program.local[0];\nEND\n"
proc(b"glGenProgramsARB", I, P)(1, ctypes.byref(program))
proc(b"glBindProgramARB", U, U)(0x8804, program)
proc(b"glProgramStringARB", U, U, I, ctypes.c_char_p)(0x8804, 0x8875, len(text), text)
proc(b"glProgramLocalParameter4fARB", U, U, F, F, F, F)(0x8804, 0, 1, 0.5, 0.25, 1)
gl.glViewport(0, 0, 32, 32)
gl.glEnable(0x8804)
gl.glColor4f(0.8, 0.8, 0.8, 1)
gl.glBegin(7)
for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
    gl.glVertex2f(x, y)
gl.glEnd()
pixel, indirections = (ctypes.c_ubyte * 4)(), I()
gl.glReadPixels(16, 16, 1, 1, 0x1908, 0x1401, pixel)
proc(b"glGetProgramivARB", U, U, P)(0x8804, 0x880D, ctypes.byref(indirections))
right = all(abs(a - b) <= 1 for a, b in zip(pixel, (204, 102, 51, 255))) and gl.glGetError() == 0
print(json.dumps({"client": "ctypes", "pixel": list(pixel), "indirections": indirections.value,
                  "right": right}), flush=True)
egl.eglMakeCurrent(display, None, None, None)
egl.eglDestroyContext(display, context)
egl.eglTerminate(display)
sys.exit(0 if right else 1)
