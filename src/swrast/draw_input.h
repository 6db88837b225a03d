#pragma once
#include <cstdint>

#include "fp_compiler/abi.h"
#include "swrast/image/deferred_clear.h"
#include "swrast/rect.h"

/// The input of a draw for all stages of the rasterizer: vertices, state and shading functions.
namespace arbiter::swrast {

enum class Topology : std::uint8_t {
  Points,
  Lines,
  LineLoop,
  LineStrip,
  Triangles,
  TriangleStrip,
  TriangleFan,
  Quads,
  QuadStrip,
  Polygon,
};
enum class PolygonMode : std::uint8_t { Point, Line, Fill };

/// Transformed vertices: one array of floats for each component. `position` is in clip space.
struct Vertices {
  std::uint32_t count = 0;
  const float *position[4] = {};
  /// Component c of fragment input i is inputs[i][c]; null components are 0, 0, 0, 1.
  const float *inputs[abi::kMaxInputs][4] = {};
  /// Two-sided colours: a back-facing polygon takes input i from here where an array is set.
  const float *backInputs[abi::kMaxInputs][4] = {};
  const float *pointSize = nullptr; ///< in pixels; null: RasterState::pointSize
  /// distances to user clip planes; negative or NaN is outside; null: off
  const float *clipDistance[8] = {};
  /// true if an edge is drawn in unfilled polygons; null: all are
  const std::uint8_t *edgeFlags = nullptr;

  /// Number of vertices that one call of `make` fills; the last call may fill fewer.
  static constexpr std::uint32_t kStretch = 1024;
  /// If set, the arrays are empty at first, and the rasterizer calls this function to fill the
  /// vertices [begin, end). It calls it once a stretch, on any thread, just before it reads them:
  /// the values then still lie in that processor's cache. It is set only for draws of more than two
  /// stretches. Edge flags are valid from the start.
  void (*make)(const void *maker, std::uint32_t begin, std::uint32_t end) = nullptr;
  const void *maker = nullptr;
};

/// Pending clears of the draw's targets, whose tiles are written only when a draw reaches them.
struct PendingClears {
  DeferredClear *clears[abi::kMaxColorTargets + 1] = {};
  int count = 0;
  void add(DeferredClear *clear) {
    if (clear)
      clears[count++] = clear;
  }
  /// Writes the pending clears of the rectangle (DeferredClear::reach()). Call it before a thread
  /// reads or writes pixels there.
  void reach(const Rect &rect) const {
    for (int i = 0; i < count; ++i)
      clears[i]->reach(rect);
  }
};

/// The state of rasterization (OpenGL 1.4, chapter 3).
struct RasterState {
  float viewport[4] = {}; ///< x, y, width, height
  float depthNear = 0, depthFar = 1;
  Rect clip; ///< intersection of the scissor and the target's size
  bool cullFront = false, cullBack = false;
  bool frontIsClockwise = false;
  bool flatShade = false; ///< colours are the provoking vertex's (Interpolation::Flat)
  /// True if the application has made the first vertex of a primitive the provoking one, instead of
  /// the last (ARB_provoking_vertex).
  bool provokingIsFirst = false;
  /// The same for quads and quad strips, where a host may ignore the application's choice.
  bool quadsProvokingIsFirst = false;
  /// True for triangles that joined strips, fans or polygons consist of, if the provoking vertex is
  /// first where provokingIsFirst says last, or the reverse. (A polygon's is always its first.)
  /// Hosts still choose the order of a triangle's vertices by provokingIsFirst.
  bool partsProvokeOtherwise = false;
  bool depthClamp = false;
  PolygonMode front = PolygonMode::Fill, back = PolygonMode::Fill;
  bool offsetFill = false, offsetLine = false, offsetPoint = false;
  float offsetFactor = 0, offsetUnits = 0;
  /// r, the smallest resolvable depth difference, for polygon offset
  double depthResolution = 1.0 / 16777215.0;
  float lineWidth = 1, pointSize = 1;
  /// Selects llvmpipe's rules for lines from Mesa 23.2 on. An end on a pixel's centre follows the
  /// fill rule of polygon edges, and coordinates are snapped as theirs are. Directions of smooth
  /// lines are computed by a division. If false, ends and snapping have rules of their own, and
  /// directions come from an angle.
  bool lineEndsAsEdges = false;
  /// Coverage of smooth lines and points. Any other value than Whole is used with lines alone or
  /// points alone, and the last input then holds the coverage.
  abi::Coverage coverage = abi::Coverage::Whole;
  float pointSizeMinimum = 1, pointSizeMaximum = 255;
  /// Point sprites: if bit i is set, input i is (s, t, 0, 1) across the point.
  std::uint32_t spriteInputs = 0;
  bool spriteOriginLowerLeft = false;
  /// Selects the third component of sprite coordinates: 0, or the vertex's s or r divided by its q
  /// (NV_point_sprite).
  enum class SpriteThird : std::uint8_t { Zero, S, R };
  SpriteThird spriteThird = SpriteThird::Zero;
  std::uint16_t lineStipple = 0xFFFF;
  std::int32_t lineStippleFactor = 0; ///< 0: off
  const std::uint8_t *polygonStipple =
      nullptr; ///< 32 x 32 bits in glPolygonStipple's unpacked layout; null: off
  /// True if quads are split along the diagonal from their second corner to the fourth. Hosts do so
  /// in display lists, with indices, and where the provoking vertex matters: the fourth vertex is
  /// then in both triangles.
  bool secondDiagonal = false;
  /// True if the host draws this with its clipping path though nothing is clipped. That path splits
  /// quads along the other diagonal (cutsOtherwise()).
  bool inClippingPath = false;
  /// Height of a target that the host stores upside down (a window, but no framebuffer object),
  /// else 0. Rounding and ties then match the host's.
  std::int32_t upsideDownHeight = 0;
  PendingClears clears; ///< pending clears of the images that this draw reads or writes
};

/// The depth test and write mask, for when the rasterizer itself tests depth. Stencil is never part
/// of it.
struct DepthTest {
  abi::Layout layout = abi::Layout::None; ///< None: every fragment passes and no depth is written
  abi::Compare compare = abi::Compare::Less;
  bool write = false;
};

/// The machine code of one program and state. At least one of `row` and `quad` is set. If both are,
/// large primitives are shaded by rows and small ones by blocks.
struct Shading {
  abi::ShadeFunction row = nullptr;  ///< code for Lanes::Row, which shades rows
  abi::ShadeFunction quad = nullptr; ///< code for Lanes::Quad, which shades blocks of 2x2 quads
  std::uint32_t pixelCost = 1;       ///< approximate cost of a pixel on one thread, in nanoseconds
  int lanes = 16, blockWidth = 4, blockHeight = 4; ///< the engine's lanes, and block size
  const abi::FragmentData *data = nullptr;
  std::uint32_t inputCount = 0; ///< includes the input of abi::Coverage
  abi::Interpolation interpolation[abi::kMaxInputs] = {};
  std::uint8_t inputComponents[abi::kMaxInputs] = {}; ///< bit c is set if component c is read
  bool readsDepth = true;                             ///< true if the code reads Primitive::z
  bool readsW = true; ///< true if the code reads Primitive::inverseW, or an input is Perspective
  /// True if every fragment replaces the whole pixel: no test, blend, kill or write mask. A
  /// primitive that covers a tile then hides all that was drawn there before.
  bool opaque = false;

  /// Code for Lanes::Packed, used for small triangles. Its key has no depth test; `depth` describes
  /// the test that the rasterizer makes. Set only if nothing after the depth test may discard a
  /// fragment.
  abi::PackedShadeFunction packed = nullptr;
  DepthTest depth;
  /// True if `packed` takes whole 2x2 quads, because the code needs a level of detail or a
  /// derivative.
  bool packsQuads = false;
  /// True if a fragment that passes the depth test replaces the unmasked components without reading
  /// them.
  bool replaces = false;
};

struct DrawStatistics {
  std::uint64_t primitives = 0; ///< number after clipping and culling
  std::uint64_t pixels = 0;     ///< number of pixels given to the shading function
  bool incomplete = false;      ///< true if a part was not drawn, for lack of memory
};

} // namespace arbiter::swrast
