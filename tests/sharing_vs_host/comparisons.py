#!/usr/bin/env python3
"""The table of comparisons of contexts that share, by the runner of ../rasterizer_vs_host.

  comparisons.py ROW --build build [NAME...]
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "rasterizer_vs_host"))
from checks import alike, has_drawn  # noqa: E402
from runner import Row, Way, main  # noqa: E402

BACKENDS = tuple(Way(backend, backend) for backend in ("host", "auto", "swrast"))
ROWS = {
    # Textures that EGLImages share: the client judges them itself.
    "images": Row("sharing-images", (), words=(), ways=BACKENDS),
    # Objects that share storage, and objects that shaders write.
    "storage": Row("sharing-storage", (alike, lambda run: has_drawn(run) if run.backend == "swrast" else []),
                   words=("{name}",), is_listed=True, ways=BACKENDS),
}

if __name__ == "__main__":
    sys.exit(main(ROWS, "sharing_vs_host"))
