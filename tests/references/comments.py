#!/usr/bin/env python3
"""Fails when too many comments of a room do not read as plain English.

A comment is a run of // lines, in Python a run of # lines or a docstring. It is faulty for one of two reasons:
- Its first word is one of FIRST, as in "What a draw reads." A question may begin so.
- It stands above a function and its first sentence has no verb, as in "The color of a pixel." Only verbs of a list are
  known, and every word that looks like one counts, so that some faults are missed and no sound comment is reported.

A room is a folder of src/, or one of tests, demos, bench and include. Single comments have no exceptions: a room fails
when its share of faulty comments is above its bound.

usage: comments.py ROOT | comments.py --list ROOT [ROOM] | comments.py --self-test
"""

import ast
import io
import pathlib
import re
import sys
import tokenize

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "include_graph"))
import tree
from references import tracked
from sentences import END, WORD

FIRST = {"Of", "So", "Those", "What", "Where", "Which", "Whom", "Whose"}
ROOMS = ("src/", "tests/", "demos/", "bench/", "include/")
BOUND = 10  # faulty comments in 1000

# Words that are verbs without an s or -ed at their end. A word with such an end is a verb unless it is in NOUNS.
VERBS = set("""
    is are was were be been being am have had having do done can cannot could may might must shall should will would
    let began came did drew fell found gave got held kept knew laid led left lost made met ran read sat saw sent set
    stood threw told took went wrote became broke chose grew began won
    agree allow answer apply ask become begin belong bind call change come compare compile cost count cover decide
    depend differ do draw end exist expect fail fall fit follow get give go grow happen have hold keep know lack last
    lead leave lie live look lose make match matter mean meet move need pass reach read refuse remain return run say
    see show stand start stay stop take tell test turn use wait want work write
    call clear look see stop use
""".split())
CONTRACTED = re.compile(r"(?:isn|aren|wasn|doesn|don|didn|can|won|couldn|wouldn)['’]?t|(?:it|that|there|let)['’]s")
NOUNS = set("""
    across actions addresses alarms alternatives always applications arguments arithmetics arrays as attributes
    backwards bindings bitmaps blocks borders buffers bytes bits callers cameras cards cases cells characters choices
    class clauses clients colours columns combiners commands comparisons complaints components constants contents
    contexts coordinates corners counters cycles declarations defaults denormals depths derivatives descriptions
    descriptors diagnostics digits dimensions directions displays documents edges eighths elements enumerators errors
    events exceptions extensions faces factors fields figures files flags floats folders formats forwards fractions
    fragments framebuffers frames functions games groups halves handlers hosts images indices infinities inputs
    instructions integers its iterations keys labels languages lanes layers less letters levels libraries limits lines
    lists logarithms machines materials matrices members meshes milliseconds models modes nanoseconds neighbours nodes
    normals nulls numbers numerals objects ones opcodes operands options others outputs pages pairs parameters
    perhaps pictures pieces pixels pixmaps planes plus points polygons polynomials positions primitives products
    profiles programs quads radius ranges reasons recordings rectangles registers results rights rows samplers samples
    scalars scenes scripts seconds segments semantics sentences setups shaders shadows sides siblings signs sizes
    slots sockets sources spaces spans squares stages statements states status statuses statistics steps stencils
    storages strings strips suffixes swizzles symbols tables targets temporaries terms texels texts textures this
    threads ths ties tiles times tokens towards triangles types uniforms units unless values vectors vertices ways
    widgets windows words zeros
    red need seed speed fixed indeed signed unsigned shared nested packed
""".split())
# Words that begin a sentence with a verb, as in "True if ...": the last ones are nouns elsewhere.
OPENERS = set("""
    true false whether
    blocks figures files frames groups labels limits lists models numbers pairs points programs registers samples
    scripts states targets times
""".split())
TAG = re.compile(r"^(?:TODO|NOTE|FIXME)\b:?\s*")


def joined(lines):
    return " ".join(line.strip() for line in lines).strip()


def after(lines, number):
    """Returns the first line of code after a 1-based line, or nothing."""
    return next((line.strip() for line in lines[number:] if line.strip()), "")


def is_function(line):
    """True if a line of C++ begins the declaration or the definition of a function."""
    line = re.sub(r"^template\s*<.*?>\s*(?=\w)", "", line)
    head = re.split(r"[{;=]", line, maxsplit=1)[0]
    return bool(re.match(r"[A-Za-z_:\[~]", line) and re.search(r"[\w>\])&*~]\s*\(|operator", head)
                and not re.match(r"(?:#|if|for|while|switch|return|case|else|do|static_assert|using|typedef|struct|"
                                 r"class|enum|union|namespace|[A-Z][A-Z0-9_]*\(|\w+(?:::\w+)*\s*\()", line))


def tail(line):
    """Returns the column of a line's // comment, or -1. A // within a string is none."""
    for match in re.finditer(r"//", line):
        before = re.sub(r"\\.", "", line[:match.start()])
        if before.count('"') % 2 == 0:
            return match.start()
    return -1


def comments_of_cpp(text):
    """Yields (line number, text, whether it documents a function) of each comment."""
    lines = text.split("\n")
    run, start, column, whole = [], 0, -1, False
    for number, line in enumerate(lines + [""], 1):
        place = tail(line)
        alone = place >= 0 and not line[:place].strip()
        if run and not (alone and place == column):
            documents = whole and run[0].startswith("///") and is_function(after(lines, number - 1))
            yield start, joined(part.lstrip("/").lstrip("<!") for part in run), documents
            run = []
        if place >= 0:
            if not run:
                start, column, whole = number, place, alone
            run.append(line[place:])


def comments_of_python(text):
    """Yields (line number, text, whether it documents a function) of each docstring and each run of # lines."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node):
            yield node.body[0].lineno, joined(ast.get_docstring(node).split("\n")), isinstance(node, ast.FunctionDef)
    run, start, last = [], 0, None
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type != tokenize.COMMENT or token.string.startswith("#!"):
            continue
        alone = not token.line[:token.start[1]].strip()
        if run and not (alone and last == (token.start[0] - 1, token.start[1])):
            yield start, joined(part.lstrip("#") for part in run), False
            run = []
        if not run:
            start = token.start[0]
        run.append(token.string)
        last = token.start
    if run:
        yield start, joined(part.lstrip("#") for part in run), False


def comments_of(name, text):
    return comments_of_python(text) if name.endswith(".py") else comments_of_cpp(text)


def has_verb(sentence):
    """True if a sentence has a word that may be a verb."""
    words = [word.lower() for word in re.findall(r"[\w'’]+", sentence)]
    return words[0] in OPENERS or any(word in VERBS or CONTRACTED.fullmatch(word) or
                                      (word.endswith(("s", "ed")) and word not in NOUNS) for word in words)


def fault_of(text, documents):
    """Returns what is wrong with a comment, or None."""
    text = TAG.sub("", text)
    first = re.match(r"[A-Za-z]+", text)
    sentence = END.split(text)[0] if text else ""
    asked = "?" in text[len(sentence):len(sentence) + 1]
    if first and first.group() in FIRST and not asked:
        return f"begins with {first.group()}"
    if documents and first and not has_verb(sentence):
        return "has no verb"
    return None


def room_of(name):
    parts = name.split("/")
    return "/".join(parts[:2]) if parts[0] == "src" and len(parts) > 2 else parts[0]


def found(root):
    """Yields (room, file, line number, text, fault) of each comment of a tree."""
    for name in sorted(tracked(root)):
        if name.startswith(ROOMS) and name.endswith((".cpp", ".h", ".def", ".py")) and (root / name).is_file():
            for number, text, documents in comments_of(name, (root / name).read_text()):
                yield room_of(name), name, number, text, fault_of(text, documents)


def share(comments):
    """Returns how many of 1000 comments are faulty."""
    return 1000 * sum(1 for *_, fault in comments if fault) / len(comments)


def by_room(root):
    rooms = {}
    for comment in found(root):
        rooms.setdefault(comment[0], []).append(comment)
    return rooms


def complaints_of(root):
    rooms = by_room(root)
    complaints = [f"{room}: {share(comments):.1f} of 1000 comments are faulty, {BOUND} at most; "
                  f"comments.py --list ROOT {room} shows them"
                  for room, comments in sorted(rooms.items()) if share(comments) > BOUND]
    return complaints, sum(len(comments) for comments in rooms.values())


def listed(root, chosen):
    """Prints each faulty comment of a room, then the figures of all rooms."""
    for room, comments in sorted(by_room(root).items()):
        for _, name, number, text, fault in comments if room == chosen else []:
            if fault:
                print(f"{name}:{number}: {fault}: {text[:100]}")
    print("of 1000  bound  comments  words a sentence")
    for room, comments in sorted(by_room(root).items()):
        lengths = [len(WORD.findall(sentence)) for *_, text, _ in comments for sentence in END.split(text)]
        lengths = [length for length in lengths if length]
        print(f"{share(comments):7.1f}  {BOUND:5}  {len(comments):8}  "
              f"{sum(lengths) / max(1, len(lengths)):16.1f}  {room}")


DOCUMENTED = [  # (a comment above a function, whether it is faulty)
    ("Returns the color of a pixel.", False),
    ("True if the host offers it.", False),
    ("The color of a pixel.", True),
    ("The color that a pixel has.", False),
    ("Color. It is read by each draw.", True),
    ("Of a pixel: returns its color.", True),
    ("What a pixel shows.", True),
    ("What does a pixel show?", False),
    ("Whatever a pixel shows is returned.", False),
    ("Samples the texture.", False),
    ("A pixel of the samples.", True),
]
PLANTED = [({"src/a/a.h": f"/// {text}\nint color(int x);\n"}, int(wrong)) for text, wrong in DOCUMENTED] + [
    ({"demos/a.py": f'def color(x):\n    """{text}"""\n    return x\n'}, int(wrong)) for text, wrong in DOCUMENTED] + [
    ({"src/a/a.h": "/// The color of a pixel.\nint color = 0;\n"}, 0),
    ({"src/a/a.h": "int color; // What a pixel shows.\n"}, 1),
    ({"src/a/a.h": 'const char *kAddress = "http://What"; // a page\n'}, 0),
    ({"src/a/a.h": "// The color of a pixel.\n// Of one pixel alone.\nint color(int x);\n"}, 0),
    ({"src/a/a.h": "// Sound.\n\n" * 100 + "// What a pixel shows.\n"}, 0),
    ({"src/a/a.h": "// Sound.\n\n" * 99 + "// What a pixel shows.\n", "src/b/b.h": "// Sound.\n\n" * 99}, 0),
    ({"src/a/a.h": "// Sound.\n\n" * 98 + "// What a pixel shows.\n", "src/b/b.h": "// Sound.\n\n" * 99}, 1),
    ({"tests/a.py": "color = 1  # What a pixel shows.\n"}, 1),
    ({"docs/a.py": "color = 1  # What a pixel shows.\n", "src/a/a.h": "// Sound.\n"}, 0),
]

if __name__ == "__main__":
    if sys.argv[1:2] == ["--list"]:
        listed(pathlib.Path(sys.argv[2]), "".join(sys.argv[3:4]))
        sys.exit(0)
    sys.exit(tree.main(__doc__, complaints_of, PLANTED, "{read} comments, {wrong} rooms above their bound"))
