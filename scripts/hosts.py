#!/usr/bin/env python3
"""The GL drivers that tests may have as their host.

  hosts.py list                   their names
  hosts.py known NAME...          2 if there is no host of a name, and says which there are
  hosts.py environment NAME       the variables that choose it, as NAME=VALUE, a line each
  hosts.py check NAME             prints its renderer; "skipped: REASON" and 77 where it cannot be here; 1 where
                                  another one draws

Tests that make their own environment ask TEST_HOST, which has a name of these. Without it the host is llvmpipe."""

import dataclasses
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SKIPPED = 77
VULKAN = ("/usr/share/vulkan/icd.d", "lvp_icd*.json")
GLVND = ("/etc/glvnd/egl_vendor.d", "/usr/share/glvnd/egl_vendor.d", "/usr/local/nvidia/share/glvnd/egl_vendor.d")


@dataclasses.dataclass(frozen=True)
class Host:
    renderer: str  # a pattern of GL's names of the renderer and of the version, a line each
    variables: dict = dataclasses.field(default_factory=dict)  # beside those of all, which ask Mesa for software
    lacking: str = ""  # why it may be missing on a machine that has the packages


def lavapipe():
    """Returns the file by which Vulkan's loader finds llvmpipe's Vulkan driver. Debian's releases name it apart."""
    found = sorted(pathlib.Path(VULKAN[0]).glob(VULKAN[1]))
    return str(found[0]) if found else f"{VULKAN[0]}/lvp_icd.json"


def nvidia_vendor():
    """Returns the file by which libglvnd finds NVIDIA's EGL, in the first folder that has it."""
    files = [pathlib.Path(folder) / "10_nvidia.json" for folder in GLVND]
    return str(next((file for file in files if file.exists()), files[1]))


HOSTS = {
    "llvmpipe": Host("^llvmpipe "),
    "softpipe": Host("^softpipe$", variables={"GALLIUM_DRIVER": "softpipe"}),
    "zink": Host(r"^zink \(llvmpipe ", variables={"GALLIUM_DRIVER": "zink", "VK_ICD_FILENAMES": lavapipe()}),
    "nvidia": Host("NVIDIA", variables={"__EGL_VENDOR_LIBRARY_FILENAMES": nvidia_vendor(),
                                        "__GLX_VENDOR_LIBRARY_NAME": "nvidia"},
                   lacking="no driver of NVIDIA's here"),
}


def environment(name=None):
    """Returns the variables that choose a host: the named one, else that of TEST_HOST, else llvmpipe."""
    name = name or os.environ.get("TEST_HOST") or "llvmpipe"
    named = {} if name == "llvmpipe" else {"TEST_HOST": name}
    return {"LIBGL_ALWAYS_SOFTWARE": "1", **HOSTS[name].variables, **named}


def check(name, said):
    """Returns (status, line) for a host, whose GL says these names of the renderer and the version."""
    host, text = HOSTS[name], "\n".join(said)
    if re.search(host.renderer, text, re.M):
        return 0, ", ".join(said)
    if host.lacking:
        return SKIPPED, f"skipped: {host.lacking}"
    return 1, f"{name} was asked for, and {said[0] or 'no GL'} draws"


def renderer(name):
    """Returns the names of the GL renderer and version of a host, as release.py asks for them."""
    code = "import release; print(*release.renderer(), sep='\\n')"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT / "scripts", capture_output=True, text=True,
                          env={**os.environ, **environment(name)})
    return (done.stdout.splitlines() + ["", ""])[:2]


def main(words):
    verb, names = (words or [""])[0], words[1:]
    unknown = [name for name in names if name not in HOSTS]
    if unknown:
        print(f"hosts: no host {', '.join(unknown)}; there are: {' '.join(HOSTS)}", file=sys.stderr)
        return 2
    if verb == "list" and not names:
        print(*HOSTS, sep="\n")
    elif verb == "known" and names:
        pass
    elif verb == "environment" and len(names) == 1:
        print(*(f"{key}={value}" for key, value in environment(names[0]).items()), sep="\n")
    elif verb == "check" and len(names) == 1:
        status, line = check(names[0], renderer(names[0]))
        print(line)
        return status
    else:
        print(__doc__, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
