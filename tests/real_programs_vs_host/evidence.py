"""Proves that fragment programs were really used, by apitrace's record on the bare host and the layer's statistics."""

import collections
import hashlib
import re
import subprocess
from pathlib import Path

import session
from cases import Case

_CALL = re.compile(r'^\d+ glProgramStringARB\(target = GL_FRAGMENT_PROGRAM_ARB,.*?string = "', re.M)
_ESCAPES = {"n": "\n", "r": "\r", "t": "\t"}


def record(case: Case, folder: Path, texts: Path) -> int:
    """Runs the case under apitrace on the bare host, writes each fragment program string to
    `texts` as CASE-HASH.fp, and returns how many were loaded."""
    folder.mkdir(parents=True, exist_ok=True)
    trace = folder / "case.trace"
    session.record(case, folder / "trace", trace)
    dump = subprocess.run(["apitrace", "dump", "--color=never", "--grep=^glProgramStringARB$",
                           str(trace)], capture_output=True, check=True)
    found = _strings(dump.stdout.decode("latin-1"))
    texts.mkdir(parents=True, exist_ok=True)
    for text in found:
        data = text.encode("latin-1")
        name = f"{case.name}-{hashlib.sha256(data).hexdigest()[:8]}.fp"
        (texts / name).write_bytes(data)
    return len(found)


def _strings(dump: str) -> list[str]:
    """Returns the string argument of each call, with the dump's escapes undone."""
    found = []
    for call in _CALL.finditer(dump):
        out, i = [], call.end()
        while i < len(dump) and dump[i] != '"':
            if dump[i] != "\\":
                out.append(dump[i])
                i += 1
            elif octal := re.compile(r"[0-7]{1,3}").match(dump, i + 1):
                out.append(chr(int(octal.group(), 8) & 255))
                i = octal.end()
            else:
                out.append(_ESCAPES.get(dump[i + 1], dump[i + 1]))
                i += 2
        found.append("".join(out))
    return found


def summarise(stats: list[dict]) -> dict:
    """Adds up the figures of all processes of a run: distinct fragment programs that compiled and
    that did not, and draws by path with the reasons for those that the rasterizer did not make."""
    programs = [p for s in stats for p in s.get("programs", []) if "fragment" in str(
        p.get("target", "")).lower()]

    def draws(path: str) -> int:
        return sum(s.get("draws", {}).get(path, 0) for s in stats)

    reasons: collections.Counter[str] = collections.Counter()
    for each in stats:
        reasons.update(each.get("draws", {}).get("reasons", {}))
    return {
        "programs": sum(1 for p in programs if not p.get("error")),
        "failed_programs": sum(1 for p in programs if p.get("error")),
        "draws_programs": draws("host_glsl") + draws("host_assembly") + draws("rasterizer"),
        "draws_rasterizer": draws("rasterizer"),
        "draws_recorded": draws("recorded_in_list"),
        "draws_untouched": draws("host_untouched"),
        "draws_dropped": draws("dropped"),
        "reasons": dict(reasons),
    }


def problems(summary: dict, least_programs: int, refused: int = 0) -> list[str]:
    """Returns why the statistics do not show that the layer compiled and drew."""
    found = []
    if summary["programs"] < least_programs:
        found.append(f"{summary['programs']} fragment programs compiled, "
                     f"{least_programs} expected")
    if summary["failed_programs"] > refused:
        found.append(f"{summary['failed_programs']} fragment programs refused")
    if least_programs and not summary["draws_programs"] and not summary["draws_recorded"]:
        found.append("no draw through a compiled program")
    if summary["draws_dropped"] and not refused:
        found.append(f"{summary['draws_dropped']} draws dropped: {summary['reasons']}")
    return found
