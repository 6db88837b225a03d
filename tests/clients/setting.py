"""The environment of a case of the client tests: its folders, how a program is started, and the required results."""
import json
import os
import shutil
import signal
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

from plain_environment import sanitized

# MAX_PROGRAM_NATIVE_TEX_INDIRECTIONS_ARB of the r300 profile; no host returns it.
R300_INDIRECTIONS = 4
TIMEOUT = 300  # of a process: 1,000 contexts take two minutes on a busy machine
PIGLIT_FOLDERS = ("/usr/lib/x86_64-linux-gnu/piglit/bin", "/usr/lib/piglit/bin")


class Skip(Exception):
    """The case needs something that this machine lacks."""


class Failure(Exception):
    """The case ran and failed."""


@dataclass
class Setting:
    """The folders that cases need, and a scratch folder for each case."""
    build: Path
    source: Path
    scratch: Path
    display: str | None
    """None on a machine without X: only the cases of headless_cases() run there."""
    egl_vendor: str | None = None
    """The host's EGL vendor library, where it is not libglvnd's own choice."""

    @property
    def clients(self):
        return self.build / "tests/clients"

    @property
    def layer(self):
        return self.build / "src/interposer/libGLX_arbiter.so.0"

    @property
    def osmesa(self):
        return self.build / "src/interposer/osmesa"

    @property
    def icd(self):
        """Writes the ICD file; it is made here, so that a build tree may be moved."""
        folder = self.scratch / "arbiter"
        folder.mkdir(exist_ok=True)
        return write_icd(folder / "10_arbiter.json", self.layer)

    @property
    def stats(self):
        return self.scratch / "stats.json"

    def environment(self, layer, extra=None):
        """Returns the bare host's environment, or the layer's by LD_PRELOAD alone."""
        env = sanitized(bool(layer), XDG_RUNTIME_DIR=str(self.scratch))
        if self.display is None:
            env.pop("DISPLAY", None)
            del env["LIBGL_ALWAYS_SOFTWARE"]  # an EGL device is used
            env["CLIENT_EGL_PLATFORM"] = "device"
        else:
            env["DISPLAY"] = self.display
        if self.egl_vendor:
            env["__EGL_VENDOR_LIBRARY_FILENAMES"] = str(write_icd(self.scratch / "host.json",
                                                                  self.egl_vendor))
        if layer:
            env.update(LD_PRELOAD=str(self.layer), LD_LIBRARY_PATH=str(self.osmesa),
                       ARBITER_STATS=str(self.stats))
        env.update(extra or {})
        return env


def write_icd(path, library):
    """Writes an ICD file for libglvnd that names an EGL vendor library."""
    path.write_text(json.dumps({"file_format_version": "1.0.0",
                                "ICD": {"library_path": str(library)}}))
    return path


def width(path):
    """Returns the word size of an ELF file, in bits."""
    with open(path, "rb") as file:
        return {1: 32, 2: 64}[file.read(5)[4]]


@dataclass
class Outcome:
    code: int
    out: str
    err: str

    def reports(self):
        """Returns the JSON lines that clients print."""
        return [json.loads(line) for line in self.out.splitlines() if line.startswith("{")]


def execute(command, env, cwd=None, user=None):
    process = subprocess.Popen([str(c) for c in command], env=env, cwd=cwd, text=True, user=user,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               start_new_session=True)
    try:
        out, err = process.communicate(timeout=TIMEOUT)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        out, err = process.communicate()
        raise Failure(f"no end after {TIMEOUT} s: {err[-300:]}") from None
    return Outcome(process.returncode, out, err)


def need(ok, message):
    if not ok:
        raise Failure(message)


def need_success(outcome, where):
    need(outcome.code == 0,
         f"{where}: exit {outcome.code}: {(outcome.out + outcome.err).strip()[-400:]}")


def need_statistics(path, draws=1):
    """Requires that the layer compiled a program without error, and drew with it."""
    need(path.exists(), "the layer wrote no statistics")
    stats = json.loads(path.read_text())
    need(any(not p["error"] for p in stats["programs"]), "the layer saw no valid program")
    drawn = sum(stats["draws"][path] for path in ("host_glsl", "host_assembly", "rasterizer"))
    need(drawn >= draws, f"draws by the layer: {stats['draws']}")
    return stats


@dataclass
class Client:
    """A client of this folder: prints a report, exits 0 if its pixels are right."""
    command: list
    env: dict = field(default_factory=dict)
    bare: bool = True
    reports: int = 1
    draws: int = 1

    def __call__(self, setting):
        command = [Path(str(c).format(clients=setting.clients, source=setting.source))
                   if "{" in str(c) else c for c in self.command]
        if not Path(command[0]).exists() and not shutil.which(str(command[0])):
            raise Skip(f"not built: {Path(command[0]).name}")
        if self.bare:
            outcome = execute(command, setting.environment(False, self.env))
            need_success(outcome, "bare host")
            for report in outcome.reports():
                need(report["indirections"] != R300_INDIRECTIONS, "the bare host answers as r300")
        outcome = execute(command, setting.environment(True, self.env))
        need_success(outcome, "layer")
        reports = outcome.reports()
        need(len(reports) == self.reports, f"{len(reports)} reports, not {self.reports}")
        for report in reports:
            need(report["indirections"] == R300_INDIRECTIONS,
                 f"answered by the host: {report['indirections']} indirections")
        need_statistics(setting.stats, self.draws)


@dataclass
class Piglit:
    """A piglit program on one of waffle's platforms."""
    platform: str
    program: str
    arguments: tuple = ()

    def __call__(self, setting):
        found = [Path(f) / self.program for f in PIGLIT_FOLDERS if (Path(f) / self.program).exists()]
        if not found or width(found[0]) != width(setting.layer):
            raise Skip("not installed: piglit" if not found else "of another width: piglit")
        command = [found[0], *[a.format(source=setting.source) for a in self.arguments], "-auto",
                   "-fbo"]
        for layer in (False, True):
            outcome = execute(command, setting.environment(layer, {"PIGLIT_PLATFORM": self.platform}))
            need('"result": "pass"' in outcome.out,
                 f"{'layer' if layer else 'bare host'}: {(outcome.out + outcome.err)[-300:]}")
        need_statistics(setting.stats)
