#!/usr/bin/env python3
"""Fails on two functions of one unit that agree in name and number of arguments, if both are local to their
sources, or if one is and the other's header is included by another source, which calls it.

A tree that is built once compiles a dozen sources as one unit (units in meson.build), in which each
sees the others' unnamed namespaces. Two equal functions are an error there. If they differ in the
types of their arguments, a call may silently take the other source's.

usage: units.py BUILD | units.py --self-test
"""

import collections
import functools
import pathlib
import re
import sys

UNNAMED = re.compile(r"^namespace \{\n(.*?)^\} // namespace$", re.M | re.S)
# The pattern matches at the beginning of a line and no name of a class, as methods belong to their classes.
FUNCTION = re.compile(r"^(?! )[^\n;{}()#]*?(?<!::)\b(\w+)\(([^;{}]*?)\)[ \w]*\{", re.M | re.S)
DECLARATION = re.compile(r"^(?! )[^\n;{}()#=]*?(?<!::)\b(\w+)\(([^;{}]*?)\)[ \w]*[;{]", re.M | re.S)
IN_ANGLES = re.compile(r"<[^<>]*>")
INCLUDE = re.compile(r'^#include "([^"]+\.h)"', re.M)


def found_in(text, pattern):
    """Yields (name, fewest arguments, most) of what looks like a function."""
    for found in pattern.finditer(re.sub(r"//[^\n]*", "", text)):
        if found.group(1).isupper():  # a macro, as TEST
            continue
        arguments = found.group(2)
        while arguments != IN_ANGLES.sub("", arguments):
            arguments = IN_ANGLES.sub("", arguments)
        most = arguments.count(",") + 1 if arguments.strip() else 0
        yield found.group(1), most - arguments.count("="), most


def space_of(text):
    space = re.search(r"^namespace ([\w:]+) \{", text, re.M)
    return space.group(1) if space else ""


def functions(text):
    """Yields (namespace, name, fewest arguments, most) of each function in an unnamed namespace."""
    for block in UNNAMED.finditer(text):
        for function in found_in(block.group(1), FUNCTION):
            yield space_of(text), *function


def called(sources, headers):
    """Returns {(namespace, name): [(source, header, fewest arguments, most)]} of what sources call of their headers."""
    known = collections.defaultdict(list)
    for name, text in sources:
        for header in INCLUDE.findall(text):
            declared = headers(header)
            for function, fewest, most in found_in(declared, DECLARATION):
                if re.search(rf"\b{function}\(", text):
                    known[space_of(declared), function].append((name, header, fewest, most))
    return known


def clashes(sources, headers=lambda name: ""):
    """Returns the complaints about one unit. sources: names and texts; headers: a header's text by its name"""
    known = collections.defaultdict(list)
    calls = called(sources, headers)
    for name, text in sources:
        for space, function, fewest, most in functions(text):
            for other, low, high in known[space, function]:
                if other != name and low <= most and fewest <= high:
                    yield f"{name}: {function}() is a function of {other} too, and both are compiled as one unit"
            known[space, function].append((name, fewest, most))
            for other, header, low, high in calls[space, function]:
                if other != name and low <= most and fewest <= high:
                    yield f"{name}: {function}() hides that of {header} from {other}, as both are compiled as one unit"


def check(build):
    units = sorted(build.rglob("*-unity*.cpp"))
    if not units:
        print("skipped: no units in this tree")
        return 77
    source = pathlib.Path(__file__).resolve().parents[2] / "src"
    headers = functools.cache(lambda name: (source / name).read_text() if (source / name).exists() else "")
    failed = 0
    for unit in units:
        paths = [build / name for name in re.findall(r"#include\s*<(.*)>", unit.read_text())]
        for complaint in clashes([(path.name, path.read_text()) for path in paths if path.exists()], headers):
            print(complaint)
            failed += 1
    print(f"{len(units)} units")
    return min(failed, 1)


def self_test():
    one = ("namespace a {\nnamespace {\nvoid none() {\n}\nint get(std::map<int, int> x) {\n  return 1;\n}\n"
           "} // namespace\n}\n")
    two = one.replace("std::map<int, int> x", "float x, int y = 0").replace("none", "nothing")
    assert len(list(clashes([("one", one), ("two", two)]))) == 1
    assert not list(clashes([("one", one), ("two", two.replace(" = 0", ""))]))
    assert not list(clashes([("one", one), ("two", one.replace("namespace a", "namespace b"))]))
    assert not list(clashes([("one", one), ("two", two.replace("int get", "  int get"))]))
    test = one.replace("int get(std::map<int, int> x)", "TEST_F(Get, One)")
    assert not list(clashes([("one", test), ("two", test.replace("One", "Two").replace("none", "nothing"))]))
    header = "namespace a {\n[[nodiscard]] int get(const float &x);\nint put();\n}\n"
    user = '#include "a.h"\nnamespace a {\nint two() { return get(1); }\n}\n'
    assert len(list(clashes([("one", one), ("user", user)], lambda name: header))) == 1
    assert not list(clashes([("one", one), ("user", user.replace("get", "put"))], lambda name: header))
    print("7 passed, 0 failed, 0 skipped")
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(self_test() if sys.argv[1] == "--self-test" else check(pathlib.Path(sys.argv[1])))
