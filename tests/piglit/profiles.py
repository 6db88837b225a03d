"""Selects the tests of Debian's piglit package for a run.

Names come from the package's own profile files. Tests that contain ARB fragment programs are found by
their text, so that a newer package brings its new tests: shader_test files with a
[fragment program] section, and test binaries that contain the header `!!ARBfp`.
"""

import ast
import gzip
import pathlib
import re
import xml.etree.ElementTree

PROFILES = ("quick_gl", "quick_shader", "glslparser")

# The names of these groups tell that they are about assembly programs.
NAMED = re.compile(
    r"^(asmparsertest@"
    r"|spec@arb_fragment_program(_shadow)?@"
    r"|spec@arb_vertex_program@"
    r"|spec@ati_fragment_shader@"
    r"|spec@ati_draw_buffers@"
    r"|spec@nv_(fragment|vertex)_program"
    r"|spec@ext_gpu_program_parameters)")

# Every change runs these tests. They cover the whole fragment language and program API, and only the related parts of
# the host's vertex parser and of other objects with names. They also cover fixed function that the rasterizer once drew
# or answered differently, a test that destroys its context in an exit handler, and buffers in the application's memory.
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
    """Returns the folder that holds bin/, tests/ and framework/."""
    for folder in sorted(pathlib.Path("/usr/lib").glob("*/piglit")) + \
            [pathlib.Path("/usr/lib/piglit"), pathlib.Path("/usr/local/lib/piglit")]:
        if (folder / "tests").is_dir():
            return folder
    raise FileNotFoundError("the piglit package is not installed")


def read_profile(library, name):
    """Returns {test name: (type, options)} of one profile file."""
    with gzip.open(library / "tests" / (name + ".xml.gz")) as stream:
        tree = xml.etree.ElementTree.parse(stream)
    tests = {}
    for test in tree.getroot().iter("Test"):
        options = {o.get("name"): o.get("value") for o in test.iter("option")}
        tests[test.get("name")] = (test.get("type"), options)
    return tests


def value(text):
    """Parses an option's value, which is a Python literal in the profile files."""
    try:
        return ast.literal_eval(text)
    except (ValueError, SyntaxError, TypeError):
        return text


def holds_fragment_program(library, kind, options, cache={}):
    """True if the test's shader file or binary contains an ARB fragment program."""
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
    """Returns {test name: profile} of the tests in set `which`: quick, named or full."""
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
