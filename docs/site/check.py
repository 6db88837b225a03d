#!/usr/bin/env python3
"""Fails on a dead link of the built site, and on a page that a browser does not show whole.

usage: check.py SITE [--shots FOLDER] | check.py --self-test

Every page is opened in headless chromium, 1280 and 420 pixels wide, in light and in dark: the page itself must not
scroll sideways, its pictures must be there, and its text must stand out from what is behind it. Search must find
a word. --shots keeps a picture of some pages.
"""

import argparse
import functools
import html.parser
import http.server
import json
import os
import pathlib
import queue
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import urllib.parse

WIDTHS = (1280, 420)
SCHEMES = {"light": 1, "dark": 0}  # Blink's numbers
SHOTS = ("index.html", "docs/index.html", "docs/driver/performance.html", "docs/write/builder_window.html",
         "docs/use/programs.html", "docs/reference/profiles.html", "docs/design/ir.html", "docs/results/index.html",
         "docs/results/deviations.html", "docs/results/pictures.html")
TEXTS = ("src/", "tests/", "debian/")
CONTRAST = 4.5  # of text, as WCAG 2 asks for
SECONDS = 600
SEARCHED = "combiners"

# Shows each page in a frame of its own width, and tells the server what it saw.
HARNESS = """<!doctype html><meta charset="utf-8"><body style="margin:0"><script>
const pages = PAGES, widths = WIDTHS, told = [];
const luminance = ([r, g, b]) => [r, g, b].map(c => (c /= 255) <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
  .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
const colour = text => text.match(/[\\d.]+/g).map(Number);
function behind(view, node) {
  for (; node; node = node.parentElement) {
    const found = colour(view.getComputedStyle(node).backgroundColor);
    if (found.length < 4 || found[3] > 0.5) return found;
  }
  return [255, 255, 255];
}
function least(view, root) {
  let worst = 99, where = "";
  for (const node of root.querySelectorAll("p, li, td, th, h1, h2, h3, a, code")) {
    if (!node.textContent.trim() || !node.getClientRects().length) continue;
    const [a, b] = [luminance(colour(view.getComputedStyle(node).color)), luminance(behind(view, node))];
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < worst) [worst, where] = [contrast, node.tagName + " " + node.textContent.slice(0, 40)];
  }
  return [worst, where];
}
async function look(page, width) {
  const frame = document.createElement("iframe");
  frame.style = `border:0;width:${width}px;height:900px`;
  frame.src = "/" + page;
  document.body.append(frame);
  await new Promise(done => frame.onload = done);
  const view = frame.contentWindow, root = view.document.documentElement;
  const [contrast, where] = least(view, view.document.querySelector("[role=main]") || view.document.body);
  told.push({page, width, inner: root.clientWidth, content: Math.max(root.scrollWidth, view.document.body.scrollWidth),
             pictures: view.document.images.length,
             missing: [...view.document.images].filter(i => !i.complete || !i.naturalWidth).map(i => i.src),
             contrast, where, back: luminance(behind(view, view.document.querySelector("[role=main]") || root))});
  frame.remove();
}
async function search() {
  const frame = document.createElement("iframe");
  frame.src = "/index.html?q=SEARCHED";
  document.body.append(frame);
  await new Promise(done => frame.onload = done);
  for (let turn = 0; turn < 100; turn++) {
    const found = frame.contentDocument.querySelectorAll("#mkdocs-search-results article").length;
    if (found) return found;
    await new Promise(done => setTimeout(done, 100));
  }
  return 0;
}
(async () => {
  for (const page of pages) for (const width of widths) await look(page, width);
  const found = await search();
  await fetch("/told", {method: "POST", body: JSON.stringify({told, found})});
})();
</script>"""


class Page(html.parser.HTMLParser):
    """The links, the sources and the anchors of a page."""

    def __init__(self, text):
        super().__init__()
        self.links, self.loaded, self.anchors = [], [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.anchors.update(filter(None, (found.get("id"), found.get("name"))))
        if tag == "a" and found.get("href"):
            self.links.append(found["href"])
        elif found.get("src") or (tag == "link" and found.get("href")):
            self.loaded.append(found.get("src") or found["href"])


def dead_links(site):
    """Returns what is wrong with the links of all pages, and how many there are."""
    pages = {path.relative_to(site).as_posix(): Page(path.read_text()) for path in sorted(site.rglob("*.html"))}
    wrong, count = [], 0
    for name, page in pages.items():
        for target in page.loaded:
            if target.startswith(("http:", "https:", "//")):
                wrong.append(f"{name}: is no page without {target}")
        for target in page.links + page.loaded:
            address = urllib.parse.urlsplit(target)
            if address.scheme or address.netloc or name == "404.html":
                continue
            count += 1
            path = urllib.parse.unquote(address.path)
            file = os.path.normpath(os.path.join(os.path.dirname(name), path)) if path else name
            if not (site / file).is_file():
                wrong.append(f"{name}: dead link {target}")
            elif address.fragment and file in pages and \
                    urllib.parse.unquote(address.fragment) not in pages[file].anchors:
                wrong.append(f"{name}: no place {target}")
    return wrong, count


class Server(http.server.SimpleHTTPRequestHandler):
    """Serves the site, the harness, and takes what the harness tells."""

    answers = queue.Queue()
    harness = ""

    def log_message(self, *_):
        pass

    def do_GET(self):
        if self.path != "/harness":
            return super().do_GET()
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.end_headers()
        self.wfile.write(self.harness.encode())

    def do_POST(self):
        self.answers.put(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.send_response(204)
        self.end_headers()


def chromium(folder, scheme, *options):
    return ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
            "--disable-background-networking", "--disable-component-update", f"--user-data-dir={folder}",
            f"--blink-settings=preferredColorScheme={SCHEMES[scheme]}", *options]


def opened(address, scheme):
    """What the harness told of all pages."""
    with tempfile.TemporaryDirectory(prefix="arbiter-site-", ignore_cleanup_errors=True) as folder:
        browser = subprocess.Popen(chromium(folder, scheme, "--window-size=1400,1000", "--remote-debugging-port=0",
                                            address + "/harness"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   start_new_session=True)
        try:
            return Server.answers.get(timeout=SECONDS)
        finally:
            os.killpg(browser.pid, signal.SIGTERM)
            browser.wait()


def judged(row, scheme):
    """What is wrong with a page as it was shown."""
    where = f"{row['page']}, {row['width']} wide, {scheme}: "
    if row["content"] > row["inner"]:
        yield where + f"scrolls sideways, {row['content']} in {row['inner']} pixels"
    for picture in row["missing"]:
        yield where + f"no picture {picture}"
    if row["contrast"] < CONTRAST:
        yield where + f"contrast {row['contrast']:.1f} of {row['where']}"
    if (row["back"] < 0.2) != (scheme == "dark"):
        yield where + f"luminance {row['back']:.2f} behind the text"


def shoot(address, folder, scheme):
    folder.mkdir(parents=True, exist_ok=True)
    for page in SHOTS:
        for width in WIDTHS:
            png = folder / f"{page.replace('/', '-')[:-5]}-{width}-{scheme}.png"
            # A window is at least 500 wide, and a frame is not.
            frame = (f"<body style='margin:0'><iframe src='{address}/{page}' "
                     f"style='border:0;width:{width}px;height:1400px'>")
            with tempfile.TemporaryDirectory(prefix="arbiter-site-", ignore_cleanup_errors=True) as profile:
                file = pathlib.Path(profile) / "frame.html"
                file.write_text(frame)
                subprocess.run(chromium(profile, scheme, f"--window-size={max(width, 500)},1400",
                                        "--run-all-compositor-stages-before-draw", f"--screenshot={png}",
                                        file.as_uri()),
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=60)


def check(site, shots=None):
    wrong, count = dead_links(site)
    names = sorted(path.relative_to(site).as_posix() for path in site.rglob("*.html") if path.name != "404.html")
    # Texts of source files are all of one kind: the first is opened.
    texts = [name for name in names if name.startswith(TEXTS)]
    pages = [name for name in names if name not in texts[1:]]
    Server.harness = HARNESS.replace("PAGES", json.dumps(pages)).replace("WIDTHS", json.dumps(WIDTHS)) \
        .replace("SEARCHED", SEARCHED)
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Server, directory=str(site)))
    server.handle_error = lambda *_: None  # a page that is left early closes what it asked for
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_address[1]}"
    pictures = 0
    for scheme in SCHEMES:
        told = opened(address, scheme)
        if len(told["told"]) != len(pages) * len(WIDTHS):
            wrong.append(f"{scheme}: {len(told['told'])} pages were opened")
        if not told["found"]:
            wrong.append(f"{scheme}: search finds nothing of {SEARCHED}")
        pictures += sum(row["pictures"] for row in told["told"])
        wrong += [one for row in told["told"] for one in judged(row, scheme)]
        if shots:
            shoot(address, shots, scheme)
    server.shutdown()
    print("\n".join(wrong + [f"{len(pages)} of {len(names)} pages opened, {count} links, {pictures} pictures, "
                             f"{len(wrong)} complaints"]))
    return wrong


GOOD = ("<!doctype html><style>@media (prefers-color-scheme: dark) "
        "{ body { background: #111; color: #eee } a { color: #9cf } }</style>"
        "<body><div role=main><p id=here>text <img src=p.png></p>")
SEARCH = "<div id=mkdocs-search-results></div><script>setTimeout(() => document.getElementById(" \
         "'mkdocs-search-results').innerHTML = '<article>x</article>', 100)</script>"


def self_test():
    """Pages with faults: every one must be found, and the page without must pass."""
    png = (pathlib.Path(__file__).resolve().parents[1] / "pictures" / "error.png").read_bytes()
    # A picture as it comes is wider than a narrow page, so the good one is held to its page.
    good = GOOD.replace("<style>", "<style>img { max-width: 90% } ")
    links = good.replace("p.png", "q.png") + "<a href=none.html>x</a><a href='#there'>x</a>" \
        "<script src='https://example.org/x.js'></script><p style='color:#777;background:#888'>x"
    cases = ((good, ()), (links, ("dead link none.html", "no place #there", "is no page without", "dead link q.png",
                                  "no picture", "contrast")),
             (GOOD.replace("#111; color: #eee", "#eee; color: #111"), ("scrolls sideways", "luminance")))
    for text, faults in cases:
        with tempfile.TemporaryDirectory() as folder:
            site = pathlib.Path(folder)
            (site / "index.html").write_text(text + SEARCH)
            (site / "p.png").write_bytes(png)
            found = check(site)
            assert all(any(fault in one for one in found) for fault in faults), (faults, found)
            assert all(any(fault in one for fault in faults) for one in found), (faults, found)
    print(f"{len(cases)} passed, 0 failed, 0 skipped")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("site", type=pathlib.Path, nargs="?")
    parser.add_argument("--shots", type=pathlib.Path)
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # so that a browser ends too
    if not shutil.which("chromium"):
        print("check.py: skipped: not installed: chromium", file=sys.stderr)
        return 77
    if options.self_test:
        self_test()
        return 0
    return 1 if check(options.site.absolute(), options.shots and options.shots.absolute()) else 0


if __name__ == "__main__":
    sys.exit(main())
