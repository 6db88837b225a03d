"""Games: menus and attract modes in fixed function, and one whose shaders are GLSL."""

from pathlib import Path

from cases import WITHOUT_ANISOTROPY, Case, Program

FOLDER = Path("/usr/games")
SECONDS = 8.0
SLOW_SECONDS = 25.0
FRAMES = 60
GAMES = {
    "armagetronad": (),
    "billard-gl": (),
    "briquolo": (),
    "chromium-bsu": ("-w", "-na"),  # in a window, without sound
    "crack-attack": ("--solo",),
    "etr": (),
    "gltron": (),
    "trackballs": ("-w",),
}
GLSL = "trackballs"  # the rasterizer has nothing to draw
# Its textures are anisotropic, text included: the filter is each implementation's own (cases.py).
ANISOTROPIC = "neverball"


class Games(Program):
    def cases(self, work: Path) -> list[Case]:
        def case(name: str, options: tuple[str, ...] = (), environment: dict[str, str] | None = None,
                 seconds: float = SECONDS) -> Case:
            home = work / f"home-{name}"  # where they keep their settings
            home.mkdir(parents=True, exist_ok=True)
            return Case(f"games-{name}", [str(FOLDER / name), *options], stop_after=seconds, recorded=True,
                        least_programs=0, frames=FRAMES, ways_left_out=("swrast",) if name == GLSL else (),
                        environment={"HOME": str(home), "XDG_RUNTIME_DIR": str(home), "SDL_AUDIODRIVER": "dummy",
                                     "ALSOFT_DRIVERS": "null", **(environment or {})})

        return [*(case(name, options) for name, options in GAMES.items()),
                case(ANISOTROPIC, environment=WITHOUT_ANISOTROPY, seconds=SLOW_SECONDS)]


PROGRAM = Games("games", ("armagetronad", "billard-gl", "briquolo", "chromium-bsu", "crack-attack", "extremetuxracer",
                          "gltron", "trackballs", "neverball", "apitrace", "xvfb", "libgl1-mesa-dri"),
                "nine games, from a record: what they show depends on the clock")
