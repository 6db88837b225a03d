"""xine's OpenGL output: YUV to RGB conversion in one program."""

from pathlib import Path

from cases import Case, Program, shell


class Xine(Program):
    def cases(self, work: Path) -> list[Case]:
        clip = work / "clip.avi"
        if not clip.exists():
            shell(["ffmpeg", "-v", "error", "-f", "lavfi", "-i",
                   "testsrc2=size=320x240:rate=25:duration=1", "-c:v", "mpeg4", "-q:v", "3", "-y",
                   str(clip)])
        command = ["xine", "-V", "opengl", "-A", "none", "-g", "-p", "--no-gui", "--auto-play=q",
                   "-D", str(clip)]
        return [Case("xine", command, stop_after=20.0, recorded=True)]


PROGRAM = Xine("xine", ("xine-ui", "libxine2-bin", "libxine2-x", "ffmpeg", "apitrace", "xvfb",
                        "libgl1-mesa-dri"), "its OpenGL output, from a record")
