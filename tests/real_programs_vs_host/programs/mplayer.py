"""MPlayer's gl output: YUV to RGB conversion and scalers, with one generated program for each mode."""

from pathlib import Path

from cases import Case, Program, shell

# The name of the case, the options of -vo gl, further options.
MODES = (
    ("yuv2", "yuv=2", ()),
    ("yuv3-gamma", "yuv=3", ("-gamma", "25")),
    ("yuv4-gamma", "yuv=4", ("-gamma", "-20")),
    ("yuv6-gamma", "yuv=6", ("-gamma", "40")),
    ("scale1", "yuv=4:lscale=1:cscale=1", ()),
    ("scale2", "yuv=2:lscale=2:cscale=2", ()),
    ("scale3", "yuv=2:lscale=3:cscale=3", ()),
    ("rectangle", "yuv=2:rectangle=2", ()),
    ("equalizer", "yuv=3", ("-brightness", "20", "-contrast", "30")),
)


# Mesa computes the LRPs of this mode in another order, which is visible in single pixels.
MIXED = "scale1"


class MPlayer(Program):
    def cases(self, work: Path) -> list[Case]:
        clip = work / "still.y4m"
        if not clip.exists():
            # The clip repeats one picture, so that the screen always shows the same.
            shell(["ffmpeg", "-v", "error", "-f", "lavfi", "-i",
                   "testsrc2=size=320x240:rate=25:duration=1,loop=loop=-1:size=1,"
                   "trim=end_frame=25", "-pix_fmt", "yuv420p", "-y", str(clip)])
        cases = []
        for name, options, more in MODES:
            command = ["mplayer", "-noconfig", "all", "-nosound", "-noconsolecontrols",
                       "-vo", f"gl:{options}", "-xy", "640", "-geometry", "0:0", *more, str(clip)]
            cases.append(Case(f"mplayer-{name}", command, size=(640, 480),
                              maximum=int(name == MIXED), mean=0.0005 * (name == MIXED),
                              over_limits=name.startswith("scale")))
        return cases


PROGRAM = MPlayer("mplayer", ("mplayer", "ffmpeg", "xvfb", "libgl1-mesa-dri"),
                  "nine modes of -vo gl on a still test picture")
