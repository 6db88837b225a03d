"""Wild Magic's sample programs, each a scene whose ARB programs are part of the engine."""

from pathlib import Path

from cases import Case, PrepareError, Program

# The package's data contain these samples' programs; the others stop at a missing file.
NAMES = (
    "BillboardNodes BspNodes CameraAndLightNodes ClodMeshes DlodNodes InverseKinematics Lights "
    "MaterialTextures NonuniformScale ParticleSystems PlanarReflections PlanarShadows PointSystems "
    "PolygonOffsets Polysegments Portals RenderToTexture ScreenPolygons SortFaces SurfaceMeshes "
    "SwitchNodes TriStripsFans VertexTextures"
).split()
# This sample needs NV_fragment_program2 and NV_vertex_program3. Mesa offers neither, so that the bare host draws
# nothing of it, and there is no frame to compare a profile that offers them with.
REFUSED = ("VertexTextures",)
OFFERING = ("auto-late", "auto-cold", "auto-warm", "swrast", "host", "programs")
# This sample shows z-fighting of two triangles in one plane without an offset, which the last bit decides.
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
