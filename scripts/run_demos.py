#!/usr/bin/env python3
"""Runs the demonstrations headless under the layer: one PNG and one statistics file each.

Prints where the pictures are and what the layer did for each, and at the end where the contact sheet is: a page
with all of them. With --list, prints the names.
"""

import argparse
import html
import json
import os
import pathlib
import re
import subprocess
import sys


def demos_of(build):
    """{name: path} of the executables that demos/meson.build declares."""
    targets = json.loads(subprocess.run(
        ["meson", "introspect", "--targets", str(build)], check=True, capture_output=True,
        text=True).stdout)
    found = {}
    for target in targets:
        folder = pathlib.Path(target["defined_in"]).parent.name
        path = pathlib.Path(target["filename"][0])
        if target["type"] == "executable" and folder == "demos" and not path.name.endswith("_test"):
            found[path.name] = path
    return found


def runs_of(demos):
    """[(name of the picture, path, further arguments)]: a demonstration's forms are runs of it."""
    runs = []
    for name, path in sorted(demos.items()):
        help_text = subprocess.run([str(path), "--help"], capture_output=True, text=True).stdout
        forms = re.search(r"--form [^{\n]*\{([^}]*)\}", help_text)
        if forms:
            runs += [("%s-%s" % (name, form), path, ["--form", form])
                     for form in forms.group(1).split(",")]
        else:
            runs.append((name, path, []))
    return runs


def compiled(path):
    """Whether the layer's statistics show a program; the picture alone could be the host's."""
    try:
        return bool(json.loads(path.read_text())["programs"])
    except (OSError, ValueError, KeyError):
        return False


def summary(path):
    """One line about what the layer saw: programs with their counts, draws by path."""
    try:
        stats = json.loads(path.read_text())
    except (OSError, ValueError):
        return "no statistics"
    parts = []
    for program in stats["programs"]:
        alu, tex, indirections = (program["counts"][name] for name in (
            "alu_instructions", "tex_instructions", "tex_indirections"))
        parts.append("%d ALU + %d TEX, %d indirection%s"
                     % (alu, tex, indirections, "" if indirections == 1 else "s"))
    draws = stats["draws"]
    parts.append("%d draws rasterized, %d by the host, %d untouched"
                 % (draws["rasterizer"], draws["host_glsl"] + draws["host_assembly"], draws["host_untouched"]))
    parts += ["%d %s" % (count, reason) for reason, count in draws["reasons"].items()]
    if stats["feedback"]["copies"]:
        parts.append("%d feedback copies" % stats["feedback"]["copies"])
    return "; ".join(parts)


SHEET = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Demonstrations</title>
<style>
:root {{ color-scheme: light dark; font-family: sans-serif; }}
main {{ display: grid; grid-template-columns: repeat(auto-fill, minmax(16em, 1fr)); gap: 1.5em; }}
figure {{ margin: 0; }} img {{ width: 100%; }} figcaption small {{ display: block; opacity: 0.7; }}
</style></head><body><h1>Demonstrations under Arbiter</h1><main>
{figures}</main></body></html>
"""
FIGURE = """<figure><a href="{picture}"><img src="{picture}" alt="{name}"></a>
<figcaption>{name}<small>{text}</small></figcaption></figure>
"""


def write_sheet(out, shown):
    """A page of the pictures. shown: [(name, what the layer did)]. Returns its path."""
    figures = [FIGURE.format(picture=html.escape(name) + ".png", name=html.escape(name), text=html.escape(text))
               for name, text in shown]
    sheet = out / "index.html"
    sheet.write_text(SHEET.format(figures="".join(figures)))
    return sheet


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("name", nargs="?")
    args = parser.parse_args()

    demos = demos_of(args.build)
    if args.list:
        print("\n".join(sorted(demos)))
        return 0
    if args.name and args.name not in demos:
        print("no demonstration '%s'; there are: %s" % (args.name, ", ".join(sorted(demos))),
              file=sys.stderr)
        return 2
    chosen = runs_of({args.name: demos[args.name]} if args.name else demos)
    if not chosen:
        print("no demonstrations are built", file=sys.stderr)
        return 1

    layer = args.build / "src/interposer/libGLX_arbiter.so.0"
    if not layer.exists():
        print("the layer is not built: %s" % layer, file=sys.stderr)
        return 1
    args.out.mkdir(parents=True, exist_ok=True)
    failed, shown = 0, []
    for number, (name, path, options) in enumerate(chosen, 1):
        picture = args.out / (name + ".png")
        stats = args.out / (name + ".json")
        for old in (picture, stats):
            old.unlink(missing_ok=True)
        environment = dict(os.environ, LD_PRELOAD=str(layer), ARBITER_STATS=str(stats),
                           LIBGL_ALWAYS_SOFTWARE="1")
        print("[%d/%d] %s" % (number, len(chosen), name), flush=True)
        run = subprocess.run([str(path), "--headless", "--out", str(picture), *options],
                             env=environment)
        if run.returncode or not picture.exists():
            print("      failed with status %d" % run.returncode)
            failed += 1
            continue
        shown.append((name, summary(stats)))
        print("      %s\n      %s" % (picture, shown[-1][1]), flush=True)
        if not compiled(stats):
            print("      the layer compiled no program")
            failed += 1
    print("%d of %d demonstrations drew their picture into %s"
          % (len(chosen) - failed, len(chosen), args.out))
    if shown:
        print("all of them on one page: %s" % write_sheet(args.out, shown))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
