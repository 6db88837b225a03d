"""The cases of the client tests by name: the client that each starts, or another proof."""
import subprocess

from extra_cases import (run_apitrace, run_arbiter, run_array_memory, run_chosen, run_close, run_count, run_cycles,
                         run_disassembly, run_early, run_exports, run_overlay, run_secure, run_selected_host, run_spawn,
                         run_vendor_gpa, run_vendor_only)
from plain_environment import PYTHON
from setting import Client, Piglit


def system_gl():
    """Returns the folder of libGL for processes of this word size."""
    script = ("import ctypes; ctypes.CDLL('libGL.so.1');"
              "print(*[line.split()[5] for line in open('/proc/self/maps') if '/libGL.so.1' in line][:1])")
    return subprocess.run([PYTHON, "-c", script], capture_output=True, text=True, check=True).stdout.strip()


def all_cases():
    """Returns {name: callable}; the first 24 are the kinds of client, the others the extra cases."""
    c = "{clients}/"
    kinds = {
        "libGL linked": Client([c + "client_libgl"]),
        "libOpenGL+libGLX linked": Client([c + "client_libopengl"]),
        "piglit glx": Piglit("glx", "fp-kil"),
        "piglit x11_egl": Piglit("x11_egl", "fp-kil"),
        "piglit surfaceless_egl": Piglit("surfaceless_egl", "fp-kil"),
        "shader_runner": Piglit("glx", "shader_runner", ("{source}/mul.shader_test",)),
        "SDL2": Client([c + "client_sdl2"]),
        "GLFW on GLX": Client([c + "client_glfw"]),
        "GLFW on EGL": Client([c + "client_glfw", "egl"]),
        "libepoxy": Client([c + "client_epoxy"]),
        "GLEW": Client([c + "client_glew"]),
        "OSMesa linked": Client([c + "client_osmesa_direct"]),
        "OSMesa by dlsym": Client([c + "client_osmesa_dynamic", "dlsym"]),
        "OSMesa by GetProcAddress": Client([c + "client_osmesa_dynamic", "gpa"]),
        "EGL linked": Client([c + "client_egl_direct"]),
        "EGL by dlsym": Client([c + "client_egl_dynamic"]),
        "dlopen libGL": Client([c + "client_glx_dynamic", "libGL"]),
        "dlopen libOpenGL": Client([c + "client_glx_dynamic", "libOpenGL"]),
        "RTLD_DEFAULT": Client([c + "client_glx_dynamic", "default"]),
        "dlvsym": Client([c + "client_glx_dynamic", "dlvsym"]),
        "dlsym from libdl": Client([c + "client_glx_dynamic", "libdl"]),
        "RTLD_LOCAL plugin": Client([c + "client_plugin_host", c + "libclient_plugin.so", "local"]),
        "DEEPBIND plugin": Client([c + "client_plugin_host", c + "libclient_plugin.so", "deepbind"]),
        "Python ctypes": Client([PYTHON, "{source}/ctypes_client.py"]),
    }
    extras = {
        "RPATH": Client([c + "client_rpath"]),
        "absolute path": Client([c + "client_glx_dynamic", "absolute", system_gl()]),
        "EGL surfaceless": Client([c + "client_egl_direct", "surfaceless"]),
        "EGL alone asked, X11": Client([c + "client_egl_every_function", "x11"], draws=4),
        "EGL alone asked, surfaceless": Client([c + "client_egl_every_function", "surfaceless"], draws=4),
        "EGL device": Client([c + "client_egl_direct", "device"]),
        "handle reuse, GLX": Client([c + "client_reuse", "glx", "1000"], bare=False),
        "handle reuse, EGL": Client([c + "client_reuse", "egl", "1000"], bare=False),
        "handle reuse, OSMesa": Client([c + "client_reuse", "osmesa", "1000"], bare=False),
        "GLX, OSMesa, EGL, GLX": Client([c + "client_mixed"], draws=4),
        "display closed": run_close,
        "1,000 contexts": run_cycles,
        "memory of a vertex array range": run_array_memory,
        # The bare host mixes up the drawings of threads that share a vertex program.
        "4 threads share": Client([c + "client_threads", "4", "100"], bare=False, draws=401),
        "GL in a constructor": run_early,
        "vendor chosen by variable": run_chosen,
        "fork and exec": run_spawn,
        "vendor without preload": run_vendor_only,
        "arbiter run": run_arbiter,
        "host selected before": run_selected_host,
        "AT_SECURE": run_secure,
        "overlay beside": run_overlay,
        "apitrace": run_apitrace,
        "glClear once per call": run_count,
        "GetProcAddress": run_vendor_gpa,
        "exports": run_exports,
        "disassembly": run_disassembly,
    }
    return kinds, extras


def sanitized_cases():
    """Returns the cases whose program is built with the sanitizer too."""
    kinds, extras = all_cases()
    names = ("EGL linked", "OSMesa linked", "libGL linked", "handle reuse, GLX", "handle reuse, EGL",
             "handle reuse, OSMesa", "GLX, OSMesa, EGL, GLX", "4 threads share")
    everything = {**kinds, **extras}
    chosen = {name: everything[name] for name in names}
    for name, case in chosen.items():
        if name.startswith("handle reuse"):
            case.command[-1] = "100"  # the sanitizer takes five times as long
    return chosen


def headless_cases():
    """Returns the cases that only need EGL on a device: no X, no Mesa, no piglit."""
    kinds, extras = all_cases()
    names = ("EGL linked", "EGL by dlsym", "EGL device", "handle reuse, EGL",
             "4 threads share", "GL in a constructor", "fork and exec", "glClear once per call")
    everything = {**kinds, **extras}
    return {name: everything[name] for name in names}
