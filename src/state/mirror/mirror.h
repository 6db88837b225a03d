#pragma once
#include <array>
#include <cstdint>
#include <span>

#include <GL/gl.h>

#include "fp_compiler/abi.h"
#include "state/mirror/attributes.h"
#include "state/mirror/generation_counter.h"
#include "swrast/rasterize.h"

/// The host's state as far as a draw of the rasterizer's depends on it. The host is always right
/// about state, and is asked for a group only after a command that may have changed it
/// (dirty_bits.h).
namespace arbiter::host {
struct HostTable;
}
namespace arbiter::state {
struct AttributeAliases;
struct HostCaps;
} // namespace arbiter::state

namespace arbiter::state::software {

struct SamplerState {
  GLuint texture = 0;  ///< bound to the target that the program samples
  abi::SamplerKey key; ///< without format, completeness and size
  float lodBias = 0, minLod = -1000, maxLod = 1000; ///< lodBias: texture's and unit's, summed
  float maxAnisotropy = 1; ///< as the host limits it; the key says whether it matters
  GLint baseLevel = 0, maxLevel = 1000;
  float borderColor[4] = {};       ///< as the application gave it
  GLenum depthMode = GL_LUMINANCE; ///< DEPTH_TEXTURE_MODE
  std::array<GLenum, 4> swizzle = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA}; ///< TEXTURE_SWIZZLE_RGBA
  /// The texture compares: the key's `shadow` is for the caller to set, where the program's target
  /// is a SHADOW one too (else the comparison is not made, ARB_fragment_program_shadow).
  bool compares = false;
  bool decodes = true;            ///< texels of sRGB formats (TEXTURE_SRGB_DECODE_EXT)
  const char *obstacle = nullptr; ///< a mode that we lack; null: none
  std::uint64_t seen = 0;         ///< GenerationCounter
};

/// Where pixel rectangles and bitmaps go (OpenGL 2.1, 2.13).
struct RasterPosition {
  bool valid = false;
  float position[4] = {0, 0, 0, 1}; ///< window x, y and depth; clip w
};

/// An array as the application gave it: in `buffer` at offset `base`, or (0) in client memory.
struct ArrayBinding {
  VertexSource::Array array; ///< `base` null and `buffer` 0: not enabled
  GLuint buffer = 0;
  bool enabled = false;
};
struct ArrayBindings {
  std::array<ArrayBinding, kSlots> slots;
  GLuint elementBuffer = 0;
  std::uint32_t enabled = 0; ///< one bit a slot
  bool restart = false;      ///< indices may restart a primitive, which we lack
  /// Slots whose arrays are none that we read (integers, doubles, a divisor).
  std::uint32_t foreign = 0;
};

enum class TexGenMode : std::uint8_t { ObjectLinear, EyeLinear, Sphere, Reflection, Normal };

/// How the colours of vertices are clamped to [0,1] (CLAMP_VERTEX_COLOR; FIXED_ONLY clamps for
/// fixed-point targets), and what a value that is no number becomes: the specification leaves that
/// to the host (HostCaps::clampsNanToOne).
enum class ColorClamp : std::uint8_t { None, NanIsZero, NanIsOne };

/// What the fog of fixed-function vertices is of: the coordinate that they are given, or how far
/// that is from 0 (HostCaps::foldsFogCoordinates), |z| or z to the eye, or how far they are from it
/// (OpenGL 2.1, 3.10; NV_fog_distance).
enum class FogFrom : std::uint8_t {
  Coordinate,
  AbsoluteCoordinate,
  AbsoluteDepth,
  Depth,
  Distance
};

/// State of fixed-function vertices, beside what its program reads as parameters (fixed_vertex.h).
struct VertexState {
  bool lighting = false, twoSided = false, localViewer = false, separateSpecular = false;
  bool colorMaterial = false, normalize = false, rescale = false;
  std::uint8_t colorMaterialFace = 0;  ///< bit 0 front, 1 back
  std::uint8_t colorMaterialParts = 0; ///< bit 0 emission, 1 ambient, 2 diffuse, 3 specular
  std::uint8_t lights = 0;             ///< enabled, one bit each
  std::uint8_t positional = 0;         ///< lights whose position has w != 0
  std::uint8_t spots = 0;              ///< lights with a cutoff other than 180
  std::uint8_t attenuated = 0;         ///< positional lights with attenuation other than 1
  std::uint8_t textureMatrix = 0;      ///< units whose matrix is not the identity
  /// Of unit and coordinate (s, t, r, q): 0 off, else 1 + TexGenMode.
  std::array<std::array<std::uint8_t, 4>, 8> texGen{};
  FogFrom fogFrom = FogFrom::AbsoluteDepth;
  ColorClamp clampColors = ColorClamp::NanIsZero;
  bool pointAttenuation = false;
  std::uint8_t clipPlanes = 0; ///< enabled, one bit each
  std::uint32_t version = 0;   ///< changes with the above
  bool operator==(const VertexState &) const = default;
};

struct SamplerUse {
  std::uint8_t unit = 0;
  abi::Dimension dimension = abi::Dimension::Tex2D;
};

/// The functions that ask the host are not called while a display list is compiled, or between
/// Begin and End. They raise no error, and leave the host's state as it was.
class Mirror {
public:
  /// All outlive the mirror.
  /// \param aliases an array of a generic attribute is that of the conventional one as well; null:
  /// it is not
  Mirror(const host::HostTable &host, const HostCaps &caps,
         const AttributeAliases *aliases = nullptr)
      : m_host(host), m_caps(caps), m_aliases(aliases) {}

  /// Takes the bits of `dirty` (ContextHot::dirty) and asks for the groups that every draw needs:
  /// raster, pixelOps, constants, obstacle.
  void refresh(std::uint32_t &dirty);
  /// What refreshSamplers() would ask for. Samplers of the layer's that are bound in the
  /// application's place are released before it does.
  [[nodiscard]] bool samplersAreDirty(std::span<const SamplerUse> uses) const;
  /// Brings samplers[unit][dimension] up to date, for all that the program samples. After
  /// refresh().
  void refreshSamplers(std::span<const SamplerUse> uses);
  /// `current` of the slots of a mask. Takes the bits itself: also before Begin.
  void refreshCurrent(std::uint32_t &dirty, std::uint32_t slots);
  /// The layer set current values of the host itself, and knows them.
  void noteCurrent(const CurrentValues &values, std::uint32_t slots);
  /// `rasterPosition`, and of `rasterValues` the slots of a mask. Takes the bits itself.
  void refreshRasterPosition(std::uint32_t &dirty, std::uint32_t slots);
  /// The host was made to move its raster position, which was up to date here.
  void noteRasterMove(float x, float y) {
    rasterPosition.position[0] += x;
    rasterPosition.position[1] += y;
  }
  /// `arrays`. After refresh().
  void refreshArrays();
  /// `vertex`: only where fixed function transforms. After refresh().
  void refreshVertexState(bool floatTarget = false);

  /// Primitives of that kind come to points, of which vertices may say the size.
  [[nodiscard]] bool drawsPoints(swrast::Topology topology) const;
  /// Primitives of that kind come to lines.
  [[nodiscard]] bool drawsLines(swrast::Topology topology) const;
  /// What smooth primitives of that kind are drawn with.
  [[nodiscard]] abi::Coverage coverageOf(swrast::Topology topology) const;
  /// Why primitives of that kind cannot be the rasterizer's, beside `obstacle`: smooth sprites,
  /// smooth lines or points beside others in one draw; null: they can.
  [[nodiscard]] const char *obstacleOf(swrast::Topology topology) const;

  swrast::RasterState raster; ///< without clip, which depends on the target
  swrast::Rect scissor;       ///< where the test is disabled: all that there can be
  bool scissorEnabled = false;
  abi::FragmentKey pixelOps;   ///< tests, blending, masks; without formats, inputs and samplers
  abi::FragmentData constants; ///< references, blend colour, fog
  /// CLAMP_FRAGMENT_COLOR is FIXED_ONLY: pixelOps.clampColors is what fixed-point targets want, and
  /// float targets want 0.
  bool clampFixedOnly = true;
  /// CLAMP_VERTEX_COLOR, likewise.
  bool clampVertexColors = true, clampVertexFixedOnly = false;
  bool blendLacking = false; ///< a blend function or equation that we lack
  /// As pixelOps has them, the stencil write and depth write masks are state of their own:
  /// constants.stencilWriteMask, pixelOps.depthStencil.depthWrite (with depthTest).
  std::array<std::array<SamplerState, 5>, abi::kMaxUnits> samplers; ///< by unit and abi::Dimension
  CurrentValues current{};
  std::uint32_t currentKnown = 0; ///< slots of `current` that hold the host's values
  RasterPosition rasterPosition;
  CurrentValues rasterValues{};        ///< that go with it: colours, raster distance, coordinates
  std::uint32_t rasterValuesKnown = 0; ///< slots of `rasterValues` that hold the host's values
  ArrayBindings arrays;
  VertexState vertex;
  /// What of the state keeps draws with the host: a key of reasons.def, and the state's name.
  const char *obstacle = nullptr;
  const char *obstacleDetail = nullptr;
  bool smoothPoints = false, smoothLines = false;
  bool sprites = false; ///< POINT_SPRITE is enabled
  /// Between Begin- and EndConditionalRender; GL has no question for it, so their handlers say it.
  bool conditional = false;
  bool twoSidedColor = false;        ///< VERTEX_PROGRAM_TWO_SIDE, for vertex programs
  bool pointSizeFromProgram = false; ///< VERTEX_PROGRAM_POINT_SIZE
  std::uint8_t spriteCoords = 0;     ///< units with COORD_REPLACE, where POINT_SPRITE is enabled

  GenerationCounter clock;
  std::uint64_t seen = 0, currentSeen = 0, arraysSeen = 0, vertexSeen = 0, rasterSeen = 0;
  std::uint8_t polygonStipple[128] = {};

private:
  /// Are there polygons, and is a face of theirs that is not culled drawn so?
  [[nodiscard]] bool drawnAs(swrast::Topology topology, swrast::PolygonMode mode) const;
  [[nodiscard]] bool isDirty(const SamplerUse &use) const;

  const host::HostTable &m_host;
  const HostCaps &m_caps;
  const AttributeAliases *m_aliases;
};

} // namespace arbiter::state::software
