"""Wild Magic's sample programs: a scene each, whose ARB programs are part of the engine."""

from pathlib import Path

from cases import Case, PrepareError, Program

# Those whose programs are in the package's data; the others stop at a missing file.
NAMES = (
    "BillboardNodes BspNodes CameraAndLightNodes ClodMeshes DlodNodes InverseKinematics Lights "
    "MaterialTextures NonuniformScale ParticleSystems PlanarReflections PlanarShadows PointSystems "
    "PolygonOffsets Polysegments Portals RenderToTexture ScreenPolygons SortFaces SurfaceMeshes "
    "SwitchNodes TriStripsFans VertexTextures"
).split()
# Asks for NV_fragment_program2 and NV_vertex_program3. Mesa offers neither, so that the bare host draws nothing
# of it: a profile that does draws what no frame here can be compared with.
REFUSED = ("VertexTextures",)
OFFERING = ("auto-late", "auto-cold", "auto-warm", "swrast", "host")
# Shows how two triangles of one plane fight without an offset; who wins is a matter of the last bit.
FIGHTS = ("PolygonOffsets",)
SAMPLES = Path("/usr/lib/x86_64-linux-gnu/libwildmagic/SampleGraphics")


class WildMagic(Program):
    def cases(self, work: Path) -> list[Case]:
        if not SAMPLES.exists():
            raise PrepareError("libwildmagic-examples is not installed")
        environment = {"WM5_PATH": "/usr/share/libwildmagic"}
        return [Case(f"wildmagic-{name}", [str(SAMPLES / name / name)], environment=environment,
                     stop_after=3.0, recorded=True, frames=30, least_programs=int(name not in REFUSED),
                     refused=int(name in REFUSED), ways_left_out=OFFERING if name in REFUSED else (),
                     wrong_pixels=200 if name in FIGHTS else 60) for name in NAMES]


PROGRAM = WildMagic("wildmagic", ("libwildmagic-examples", "apitrace", "xvfb", "libgl1-mesa-dri"),
                    "the sample programs of a shader-based engine")
