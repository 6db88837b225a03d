#!/usr/bin/env python3
"""Makes a site with search of the pages of the tree, by Debian's mkdocs.

usage: build.py [--out FOLDER]     FOLDER/index.html; out/site by default

The pages stay as they are. They are laid out in a folder of their own with the files that they link to, so that a link
to a source file leads to its text, and a link to a folder to a list of what is in it.
"""

import argparse
import html
import json
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "tests" / "references"))
import links  # noqa: E402
from references import tracked  # noqa: E402

ROOT_PAGES = ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "bench/README.md", "demos/README.md",
              "editors/README.md")
SECTIONS = (("Run", "use"), ("Write", "write"), ("Driver", "driver"), ("Design", "design"), ("Reference", "reference"),
            ("Results", "results"))
EXTRA = {"css": HERE / "site.css", "js": HERE / "site.js"}


def title_of(text):
    return re.search(r"^# +(.*)$", text, re.M).group(1).replace("`", "")


def pages_of(names):
    return [name for name in names if name in ROOT_PAGES or name.startswith("docs/") and name.endswith(".md")]


def with_targets(page, text, source, names):
    """The text with each link to a file that is no page led to a page that shows it; writes those pages."""
    def led(match):
        target = match.group(1)
        file = links.resolved(page, target.partition("#")[0])
        if re.match(r"[a-z]+:", target) or target.startswith("#") or file.endswith((".md", ".png", ".svg")):
            return match.group()
        shown = source / f"{file}.md" if file in names else source / file / "index.md"
        if not shown.exists():
            shown.parent.mkdir(parents=True, exist_ok=True)
            shown.write_text(listing(file, names))
        up = "../" * page.count("/")
        return match.group().replace(f"({target}", f"({up}{shown.relative_to(source).as_posix()}")

    out, at = [], 0
    for fence in links.FENCE.finditer(text):
        out += [links.LINK.sub(led, text[at:fence.start()]), fence.group()]
        at = fence.end()
    return "".join(out) + links.LINK.sub(led, text[at:])


def listing(file, names):
    """A page of a file's text, or of the names in a folder."""
    if file in names:
        return f"# {file}\n\n<pre><code>{html.escape((ROOT / file).read_text())}</code></pre>\n"
    inside = sorted({name[len(file) + 1:].split("/")[0] for name in names if name.startswith(file + "/")})
    return f"# {file}/\n\n" + "".join(f"- `{name}`\n" for name in inside)


def lay_out(source):
    """Writes the pages, and what they show, into the folder that mkdocs reads."""
    names = set(tracked(ROOT))
    shutil.rmtree(source, ignore_errors=True)
    titles = {}
    for page in pages_of(sorted(names)):
        text = (ROOT / page).read_text()
        titles[page] = title_of(text)
        (source / page).parent.mkdir(parents=True, exist_ok=True)
        (source / page).write_text(with_targets(page, text, source, names))
    for picture in (name for name in names if name.startswith("docs/") and name.endswith((".png", ".svg"))):
        (source / picture).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / picture, source / picture)
    for kind, path in EXTRA.items():
        shutil.copy(path, source / f"site.{kind}")
    return titles


def navigation(titles):
    """The order of the pages: that of the index, then the files of the root."""
    index = (ROOT / links.INDEX).read_text()
    order = [links.resolved(links.INDEX, target.partition("#")[0])
             for target in links.LINK.findall(links.FENCE.sub(links.blank, index))]
    nav = [{"Arbiter": "README.md"}, {"Pages": links.INDEX}]
    for title, folder in SECTIONS:
        pages = [page for page in order if page in titles and page.startswith(f"docs/{folder}/")]
        nav.append({title: [{titles[page]: page} for page in pages]})
    nav.append({"More": [{titles[page]: page} for page in ROOT_PAGES[1:]]})
    return nav


def build(out):
    source = out.parent / (out.name + "-pages")
    titles = lay_out(source)
    config = {
        "site_name": "Arbiter", "docs_dir": str(source.resolve()), "site_dir": str(out.resolve()),
        "theme": {"name": "mkdocs", "highlightjs": False, "navigation_depth": 2},
        "copyright": "Arbiter " + (ROOT / "VERSION").read_text().strip(),  # the foot of each page
        "use_directory_urls": False, "extra_css": ["site.css"], "extra_javascript": ["site.js"],
        "plugins": ["search"], "nav": navigation(titles),
        "markdown_extensions": [{"toc": {"permalink": False}}, "sane_lists"],
    }
    file = source.parent / (out.name + ".yml")  # JSON is YAML
    file.write_text(json.dumps(config, indent=1, ensure_ascii=False))
    return subprocess.run(["mkdocs", "build", "--quiet", "--strict", "--config-file", str(file)]).returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out" / "site")
    out = parser.parse_args().out.absolute()
    out.parent.mkdir(parents=True, exist_ok=True)
    if status := build(out):
        return status
    print(out / "index.html")
    return 0


if __name__ == "__main__":
    sys.exit(main())
