"""Games: menus and attract modes in fixed function, and one with GLSL shaders."""

from pathlib import Path

from cases import WITHOUT_ANISOTROPY, Case, Program

FOLDERS = (Path("/usr/games"), Path("/usr/bin"))
SECONDS = 8.0
SLOW_SECONDS = 25.0
FRAMES = 60
GAMES = {
    "armagetronad": (),
    "billard-gl": (),
    "briquolo": (),
    "brutalchess": (),
    "chromium-bsu": ("-w", "-na"),  # in a window, without sound
    "crack-attack": ("--solo",),
    "etr": (),
    "gltron": (),
    "lugaru": (),
    "openuniverse": (),
    "trackballs": ("-w",),
}
GLSL = "trackballs"  # the rasterizer has nothing to draw
# Their textures are anisotropic, including text; the filter is implementation-dependent (cases.py).
ANISOTROPIC = ("neverball", "trigger-rally")
# A level of the game, by its renderer without GLSL, without its introduction and sound.
OPENARENA = ("+set", "cl_renderer", "opengl1", "+set", "r_fullscreen", "0", "+set", "r_mode", "-1",
             "+set", "r_customwidth", "640", "+set", "r_customheight", "480", "+set", "com_introplayed", "1",
             "+set", "s_initsound", "0", "+devmap", "oa_dm1")


class Games(Program):
    def cases(self, work: Path) -> list[Case]:
        def case(name: str, options: tuple[str, ...] = (), environment: dict[str, str] | None = None,
                 seconds: float = SECONDS) -> Case:
            home = work / f"home-{name}"  # for their settings
            home.mkdir(parents=True, exist_ok=True)
            path = next((folder / name for folder in FOLDERS if (folder / name).exists()), Path(name))
            return Case(f"games-{name}", [str(path), *options], stop_after=seconds, recorded=True,
                        least_programs=0, frames=FRAMES, ways_left_out=("swrast",) if name == GLSL else (),
                        environment={"HOME": str(home), "XDG_RUNTIME_DIR": str(home), "SDL_AUDIODRIVER": "dummy",
                                     "ALSOFT_DRIVERS": "null", **(environment or {})})

        return [*(case(name, options) for name, options in GAMES.items()),
                case("openarena", OPENARENA, seconds=SLOW_SECONDS),
                *(case(name, environment=WITHOUT_ANISOTROPY, seconds=SLOW_SECONDS) for name in ANISOTROPIC)]


PROGRAM = Games("games", ("armagetronad", "billard-gl", "briquolo", "brutalchess", "chromium-bsu", "crack-attack",
                          "extremetuxracer", "gltron", "lugaru", "neverball", "openarena", "openuniverse", "trackballs",
                          "trigger-rally", "apitrace", "xvfb", "libgl1-mesa-dri"),
                "fourteen games, from a record: what they show depends on the clock")
