"""The tests of Debian's piglit package, and which of them a run takes.

Names come from the package's own profile files. Tests that hold ARB fragment programs are found by
their text, so that a newer package brings its new tests along: shader_test files with a
[fragment program] section, and test binaries that contain the header `!!ARBfp`.
"""

import ast
import gzip
import pathlib
import re
import xml.etree.ElementTree

PROFILES = ("quick_gl", "quick_shader", "glslparser")

# Groups whose names alone say that they are about assembly programs.
NAMED = re.compile(
    r"^(asmparsertest@"
    r"|spec@arb_fragment_program(_shadow)?@"
    r"|spec@arb_vertex_program@"
    r"|spec@ati_fragment_shader@"
    r"|spec@ati_draw_buffers@"
    r"|spec@nv_(fragment|vertex)_program"
    r"|spec@ext_gpu_program_parameters)")

# What every change runs: all of the fragment language and the program API; of the host's own
# vertex parser and of the many objects that a name could collide with, only the parts next to it;
# of fixed function what the rasterizer drew or answered otherwise once, with a test that takes its
# context away in an exit handler, and buffers in memory of the application's own.
QUICK = re.compile(
    r"^(asmparsertest@arbfp1\.0@"
    r"|spec@arb_fragment_program(_shadow)?@"
    r"|spec@arb_fragment_coord_conventions@fp-arb"
    r"|spec@ati_draw_buffers@"
    r"|spec@ati_fragment_shader@"
    r"|spec@ext_direct_state_access@named-program"
    r"|spec@arb_vertex_program@(getenv|getlocal|matrix|minmax|fogcoord|vp-(max|bad|address)"
    r"|arb_vertex_program-)"
    r"|spec@!opengl 1\.0@gl-1\.0-beginend-coverage$"
    r"|spec@!opengl 1\.1@depthstencil-default_fb-clear$"
    r"|spec@arb_point_parameters@"
    r"|spec@nv_fog_distance@"
    r"|spec@amd_pinned_memory@"
    r"|spec@amd_seamless_cubemap_per_texture@"
    r"|object namespace pollution@program )")


def library_of_piglit():
    """The folder that holds bin/, tests/ and framework/."""
    for folder in sorted(pathlib.Path("/usr/lib").glob("*/piglit")) + \
            [pathlib.Path("/usr/lib/piglit"), pathlib.Path("/usr/local/lib/piglit")]:
        if (folder / "tests").is_dir():
            return folder
    raise FileNotFoundError("the piglit package is not installed")


def read_profile(library, name):
    """{test name: (type, options)} of one profile file."""
    with gzip.open(library / "tests" / (name + ".xml.gz")) as stream:
        tree = xml.etree.ElementTree.parse(stream)
    tests = {}
    for test in tree.getroot().iter("Test"):
        options = {o.get("name"): o.get("value") for o in test.iter("option")}
        tests[test.get("name")] = (test.get("type"), options)
    return tests


def value(text):
    """An option's value: the profile files hold Python literals."""
    try:
        return ast.literal_eval(text)
    except (ValueError, SyntaxError, TypeError):
        return text


def holds_fragment_program(library, kind, options, cache={}):
    """Whether the test's shader file or binary contains an ARB fragment program."""
    if kind == "shader":
        command = value(options.get("command", "[]"))
        path = library / (command[-1] if command else str(value(options.get("shader_file"))))
        mark = re.compile(rb"^\[fragment program|^!!ARBfp", re.M)
    elif kind == "gl":
        command = value(options.get("command", "[]"))
        if not command:
            return False
        path = library / "bin" / command[0]
        mark = re.compile(rb"!!ARBfp")
    else:
        return False
    if path not in cache:
        try:
            cache[path] = bool(mark.search(path.read_bytes()))
        except OSError:
            cache[path] = False
    return cache[path]


def select(which):
    """{test name: profile} of the tests in set `which`: quick, named or full."""
    library = library_of_piglit()
    chosen = {}
    for profile in PROFILES:
        for name, (kind, options) in read_profile(library, profile).items():
            if which == "quick":
                wanted = QUICK.match(name)
            else:
                wanted = NAMED.match(name) or holds_fragment_program(library, kind, options)
                if which == "full":
                    wanted = wanted or profile == "quick_gl"
            if wanted:
                chosen.setdefault(name, profile)
    return dict(sorted(chosen.items()))
