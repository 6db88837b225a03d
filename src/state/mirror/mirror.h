#pragma once
#include <array>
#include <cstdint>
#include <span>

#include <GL/gl.h>

#include "fp_compiler/abi.h"
#include "state/mirror/attributes.h"
#include "state/mirror/generation_counter.h"
#include "swrast/rasterize.h"

/// A copy of the host's state, as far as draws of the rasterizer need it. The host's state is
/// authoritative, and a group is queried only after a command that may have changed it
/// (dirty_bits.h).
namespace arbiter::host {
struct HostTable;
}
namespace arbiter::state {
struct AttributeAliases;
struct HostCaps;
} // namespace arbiter::state

namespace arbiter::state {

struct SamplerState {
  GLuint texture = 0;                               ///< bound to the program's texture target
  abi::SamplerKey key;                              ///< without format, completeness and size
  float lodBias = 0, minLod = -1000, maxLod = 1000; ///< lodBias: sum of the texture's and the
                                                    ///< unit's
  float maxAnisotropy = 1; ///< as the host limits it; used if the key is anisotropic
  GLint baseLevel = 0, maxLevel = 1000;
  float borderColor[4] = {};       ///< as the application set it
  GLenum depthMode = GL_LUMINANCE; ///< DEPTH_TEXTURE_MODE
  std::array<GLenum, 4> swizzle = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA}; ///< TEXTURE_SWIZZLE_RGBA
  /// The texture's compare mode is on. The caller sets the key's `shadow` if the program's target
  /// is SHADOW too; otherwise nothing is compared (ARB_fragment_program_shadow).
  bool compares = false;
  bool decodes = true;            ///< decodes sRGB texels (TEXTURE_SRGB_DECODE_EXT)
  const char *obstacle = nullptr; ///< a mode that the rasterizer lacks; null: none
  std::uint64_t seen = 0;         ///< the GenerationCounter's time of the query
};

/// The current raster position, for pixel rectangles and bitmaps (OpenGL 2.1, 2.13).
struct RasterPosition {
  bool valid = false;
  float position[4] = {0, 0, 0, 1}; ///< window x, y and depth; clip w
};

/// An array as the application set it: in `buffer` at offset `base`, or in client memory if
/// `buffer` is 0.
struct ArrayBinding {
  VertexSource::Array array; ///< not enabled: `base` is null and `buffer` is 0
  GLuint buffer = 0;
  bool enabled = false;
};
struct ArrayBindings {
  std::array<ArrayBinding, kSlots> slots;
  GLuint elementBuffer = 0;
  std::uint32_t enabled = 0; ///< one bit per slot
  bool restart = false;      ///< primitive restart is on, which the rasterizer lacks
  /// Slots whose arrays the rasterizer does not read (integers, doubles, a divisor).
  std::uint32_t foreign = 0;
};

enum class TexGenMode : std::uint8_t { ObjectLinear, EyeLinear, Sphere, Reflection, Normal };

/// The clamping of vertex colours to [0,1] (CLAMP_VERTEX_COLOR; FIXED_ONLY clamps for fixed-point
/// targets), and the value that NaN becomes. The specification leaves the latter to the host
/// (HostCaps::clampsNanToOne).
enum class ColorClamp : std::uint8_t { None, NanIsZero, NanIsOne };

/// The source of fixed-function fog: the fog coordinate or its absolute value
/// (HostCaps::foldsFogCoordinates), or |z|, z or the distance to the eye (OpenGL 2.1, 3.10;
/// NV_fog_distance).
enum class FogFrom : std::uint8_t {
  Coordinate,
  AbsoluteCoordinate,
  AbsoluteDepth,
  Depth,
  Distance
};

/// State of fixed-function vertices that their program does not read as parameters
/// (fixed_vertex.h).
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
  /// By unit and coordinate (s, t, r, q): 0 is off, else 1 + TexGenMode.
  std::array<std::array<std::uint8_t, 4>, 8> texGen{};
  FogFrom fogFrom = FogFrom::AbsoluteDepth;
  ColorClamp clampColors = ColorClamp::NanIsZero;
  bool pointAttenuation = false;
  std::uint8_t clipPlanes = 0; ///< enabled, one bit each
  std::uint32_t version = 0;   ///< counts changes of the above
  bool operator==(const VertexState &) const = default;
};

struct SamplerUse {
  std::uint8_t unit = 0;
  abi::Dimension dimension = abi::Dimension::Tex2D;
};

/// The cached copy of the host's state. Its queries must not run while a display list is compiled
/// or between Begin and End. They raise no error and leave the host's state as it was.
class Mirror {
public:
  /// Makes a mirror. All arguments must outlive it.
  /// \param aliases generic arrays that alias conventional ones; null: none do
  Mirror(const host::HostTable &host, const HostCaps &caps,
         const AttributeAliases *aliases = nullptr)
      : m_host(host), m_caps(caps), m_aliases(aliases) {}

  /// Takes the bits of `dirty` (ContextHot::dirty) and updates the groups that every draw needs:
  /// raster, pixelOps, constants, obstacle.
  void refresh(std::uint32_t &dirty);
  /// True if refreshSamplers() would query anything. The caller then first unbinds the layer's
  /// samplers, which stand in for the application's.
  [[nodiscard]] bool samplersAreDirty(std::span<const SamplerUse> uses) const;
  /// Updates samplers[unit][dimension] for all that the program samples. Call it after refresh().
  void refreshSamplers(std::span<const SamplerUse> uses);
  /// Updates `current` for a mask of slots. Takes the dirty bits itself, so it works before Begin.
  void refreshCurrent(std::uint32_t &dirty, std::uint32_t slots);
  /// Stores current values that the layer itself has set on the host.
  void noteCurrent(const CurrentValues &values, std::uint32_t slots);
  /// Updates `rasterPosition`, and `rasterValues` for a mask of slots. Takes the dirty bits itself.
  void refreshRasterPosition(std::uint32_t &dirty, std::uint32_t slots);
  /// Moves the raster position as the host has moved its own. It must be up to date.
  void noteRasterMove(float x, float y) {
    rasterPosition.position[0] += x;
    rasterPosition.position[1] += y;
  }
  /// Updates `arrays`. Call it after refresh().
  void refreshArrays();
  /// Updates `vertex`, which only fixed-function vertices need. Call it after refresh().
  void refreshVertexState(bool floatTarget = false);

  /// True if such primitives are drawn as points. Vertices may then set the point size.
  [[nodiscard]] bool drawsPoints(swrast::Topology topology) const;
  /// True if such primitives are drawn as lines.
  [[nodiscard]] bool drawsLines(swrast::Topology topology) const;
  /// Returns the coverage that such primitives are drawn with, if they are smooth.
  [[nodiscard]] abi::Coverage coverageOf(swrast::Topology topology) const;
  /// Returns why the rasterizer cannot draw such primitives, besides `obstacle`; null if it can. It
  /// lacks smooth sprites, and smooth lines or points mixed with other kinds in one draw.
  [[nodiscard]] const char *obstacleOf(swrast::Topology topology) const;

  swrast::RasterState raster; ///< without the clip rectangle, which depends on the target
  swrast::Rect scissor;       ///< the largest rectangle while the scissor test is disabled
  bool scissorEnabled = false;
  /// The stencil and depth write masks are in constants.stencilWriteMask and
  /// pixelOps.depthStencil.depthWrite (with depthTest).
  abi::FragmentKey pixelOps;   ///< tests, blending, masks; without formats, inputs and samplers
  abi::FragmentData constants; ///< references, blend colour
  /// CLAMP_FRAGMENT_COLOR is FIXED_ONLY: pixelOps.clampColors applies to fixed-point targets, and
  /// float targets are not clamped.
  bool clampFixedOnly = true;
  /// CLAMP_VERTEX_COLOR, with its FIXED_ONLY.
  bool clampVertexColors = true, clampVertexFixedOnly = false;
  bool blendLacking = false; ///< a blend function or equation is set that the rasterizer lacks
  std::array<std::array<SamplerState, 5>, abi::kMaxUnits> samplers; ///< by unit and abi::Dimension
  CurrentValues current{};
  std::uint32_t currentKnown = 0; ///< slots of `current` that are up to date
  RasterPosition rasterPosition;
  CurrentValues rasterValues{};        ///< of the raster position: colours, distance, texture
                                       ///< coordinates
  std::uint32_t rasterValuesKnown = 0; ///< slots of `rasterValues` that are up to date
  ArrayBindings arrays;
  VertexState vertex;
  /// Why all draws stay with the host: a key of reasons.def, and the name of the state.
  const char *obstacle = nullptr;
  const char *obstacleDetail = nullptr;
  bool smoothPoints = false, smoothLines = false;
  bool sprites = false; ///< POINT_SPRITE is enabled
  /// Between BeginConditionalRender and EndConditionalRender. GL has no query for it, so the
  /// handlers of these commands set it.
  bool conditional = false;
  bool twoSidedColor = false;        ///< VERTEX_PROGRAM_TWO_SIDE, for vertex programs
  bool pointSizeFromProgram = false; ///< VERTEX_PROGRAM_POINT_SIZE
  std::uint8_t spriteCoords = 0;     ///< units with COORD_REPLACE, where POINT_SPRITE is enabled

  GenerationCounter clock;
  std::uint64_t seen = 0, currentSeen = 0, arraysSeen = 0, vertexSeen = 0, rasterSeen = 0;
  std::uint8_t polygonStipple[128] = {};

private:
  /// True if there are polygons, and a face that is not culled is drawn in this mode.
  [[nodiscard]] bool drawnAs(swrast::Topology topology, swrast::PolygonMode mode) const;
  [[nodiscard]] bool isDirty(const SamplerUse &use) const;

  const host::HostTable &m_host;
  const HostCaps &m_caps;
  const AttributeAliases *m_aliases;
};

} // namespace arbiter::state
