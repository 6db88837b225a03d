"""Qt Multimedia 5 on a host without GLSL: one fragment program converts its films from YUV,
between Qt's own fixed-function drawing. data/video.cpp is a small player of the project.
"""

from pathlib import Path

from cases import Case, Program, build_client, shell


class QtVideo(Program):
    def cases(self, work: Path) -> list[Case]:
        flags = shell(["pkg-config", "--cflags", "--libs", "Qt5Multimedia", "Qt5MultimediaWidgets",
                       "Qt5OpenGL", "Qt5Widgets"]).split()
        client, film = build_client(work, "video.cpp", flags), work / "film.ogv"
        if not film.exists():
            shell(["ffmpeg", "-v", "error", "-f", "lavfi", "-i",
                   "testsrc2=size=320x240:rate=10:duration=3", "-c:v", "libtheora", "-q:v", "6",
                   "-y", str(film)])
        environment = {"QT_QPA_PLATFORM": "xcb", "XDG_RUNTIME_DIR": str(work),
                       "MESA_EXTENSION_OVERRIDE": "-GL_ARB_shader_objects"}
        return [Case("qtvideo", [str(client), str(film)], environment=environment, recorded=True)]


PROGRAM = QtVideo("qtvideo", ("qtmultimedia5-dev", "libqt5opengl5-dev", "libqt5multimedia5-plugins",
                              "gstreamer1.0-plugins-base", "ffmpeg", "pkg-config", "g++", "apitrace",
                              "xvfb", "libgl1-mesa-dri"),
                  "a film through Qt Multimedia's fragment program")
