#pragma once
#include <cstdint>

#include "fp_compiler/abi.h"
#include "swrast/image/deferred_clear.h"
#include "swrast/rect.h"

/// What a draw is made of, as all stages of the rasterizer see it: vertices, state, functions.
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

/// Transformed vertices as arrays, one float a vertex and component. `position` is in clip space.
struct Vertices {
  std::uint32_t count = 0;
  const float *position[4] = {};
  /// Fragment input i is components[i][c]; null components are 0, 0, 0, 1.
  const float *inputs[abi::kMaxInputs][4] = {};
  /// Two-sided colour: where set, a back-facing polygon takes input i from here.
  const float *backInputs[abi::kMaxInputs][4] = {};
  const float *pointSize = nullptr;        ///< in pixels; null: RasterState::pointSize
  const float *clipDistance[8] = {};       ///< user planes: outside if negative or NaN; null: off
  const std::uint8_t *edgeFlags = nullptr; ///< of unfilled polygons; null: all are edges

  /// So many vertices at a time, or what is left of them, are made.
  static constexpr std::uint32_t kStretch = 1024;
  /// Where set, the arrays are not filled yet. Called before anything of the vertices [begin, end)
  /// is read, a stretch's, once and on any thread: what it makes is looked at while it lies in that
  /// processor's cache. Only of draws of more than two stretches; edge flags are there from the
  /// start.
  void (*make)(const void *maker, std::uint32_t begin, std::uint32_t end) = nullptr;
  const void *maker = nullptr;
};

/// The targets of a draw whose clears are still to be written, in part.
struct PendingClears {
  DeferredClear *clears[abi::kMaxColorTargets + 1] = {};
  int count = 0;
  void add(DeferredClear *clear) {
    if (clear)
      clears[count++] = clear;
  }
  /// Before a thread reads or writes pixels of the rectangle: DeferredClear::reach().
  void reach(const Rect &rect) const {
    for (int i = 0; i < count; ++i)
      clears[i]->reach(rect);
  }
};

/// What the fixed functions between vertex and fragment do (OpenGL 1.4 chapter 3).
struct RasterState {
  float viewport[4] = {}; ///< x, y, width, height
  float depthNear = 0, depthFar = 1;
  Rect clip; ///< scissor and target's size, intersected
  bool cullFront = false, cullBack = false;
  bool frontIsClockwise = false;
  bool flatShade = false;        ///< colours (inputs whose key is Flat) of the provoking vertex
  bool provokingIsFirst = false; ///< as the application chose
  bool quadsProvokingIsFirst = false; ///< of quads and quad strips, for which it need not count
  /// The triangles are those of fans or polygons, whose provoking vertex is the other one. Hosts
  /// walk around them as the application chose all the same.
  bool partsProvokeOtherwise = false;
  bool depthClamp = false;
  PolygonMode front = PolygonMode::Fill, back = PolygonMode::Fill;
  bool offsetFill = false, offsetLine = false, offsetPoint = false;
  float offsetFactor = 0, offsetUnits = 0;
  double depthResolution = 1.0 / 16777215.0; ///< r of polygon offset
  float lineWidth = 1, pointSize = 1;
  /// Ends of lines that lie on pixels' centres are cut, and all are snapped, as polygons' edges are
  /// (llvmpipe from Mesa 23.2 on); else each by a rule of its own. Smooth lines' directions are by
  /// a division there, else by an angle's sine.
  bool lineEndsAsEdges = false;
  /// What is not Whole is drawn by lines, or by points, alone; the last input is its own.
  abi::Coverage coverage = abi::Coverage::Whole;
  float pointSizeMinimum = 1, pointSizeMaximum = 255;
  /// Point sprites: bit i: input i is (s, t, 0, 1) over the point.
  std::uint32_t spriteInputs = 0;
  bool spriteOriginLowerLeft = false;
  /// Their third component is the vertex's over q, of its s or r (NV_point_sprite); else 0.
  enum class SpriteThird : std::uint8_t { Zero, S, R };
  SpriteThird spriteThird = SpriteThird::Zero;
  std::uint16_t lineStipple = 0xFFFF;
  std::int32_t lineStippleFactor = 0; ///< 0: off
  const std::uint8_t *polygonStipple =
      nullptr; ///< 32 x 32 bits as glPolygonStipple unpacked; null: off
  /// Quads are cut from their second corner to the fourth. Hosts do so in a list, by indices, and
  /// where the provoking vertex counts, as the fourth one then is in both triangles.
  bool secondDiagonal = false;
  /// Hosts draw it in the path in which they clip (cutsOtherwise()).
  bool inOtherPath = false;
  /// Height of a target that the host keeps upside down (a window, not a framebuffer object), else
  /// 0: roundings and ties then fall as the host's do.
  std::int32_t upsideDownHeight = 0;
  PendingClears clears; ///< of what this draw reads or writes
};

/// Depth as the rasterizer tests it itself: the test and the buffer's write mask, no stencil.
struct DepthTest {
  abi::Layout layout = abi::Layout::None; ///< None: all pass, nothing is written
  abi::Compare compare = abi::Compare::Less;
  bool write = false;
};

/// The functions of one program and state. `quad` may be null where `row` is not and the other way;
/// where both are there, large primitives take rows and small ones blocks.
struct Shading {
  abi::ShadeFunction row = nullptr;
  abi::ShadeFunction quad = nullptr;
  std::uint32_t pixelCost = 1;                     ///< nanoseconds of one thread, roughly
  int lanes = 16, blockWidth = 4, blockHeight = 4; ///< of the engine
  const abi::FragmentData *data = nullptr;
  std::uint32_t inputCount = 0; ///< abi::Coverage's included
  abi::Interpolation interpolation[abi::kMaxInputs] = {};
  std::uint8_t inputComponents[abi::kMaxInputs] = {}; ///< bit a component that is read
  bool readsDepth = true;                             ///< Primitive::z is wanted
  bool readsW = true; ///< Primitive::inverseW is wanted, or an input is Perspective
  /// Fragments replace what is there whatever it is (no test, no blend, no kill, all components):
  /// what lies below a primitive that covers a tile need not be drawn.
  bool opaque = false;

  /// Lanes::Packed, for small triangles, with a key without depth, which `depth` describes. Only
  /// where nothing after the depth test may discard a fragment.
  abi::PackedShadeFunction packed = nullptr;
  DepthTest depth;
  bool packsQuads = false; ///< a level of detail or a derivative is wanted
  /// A fragment that passes replaces what was there, or its unmasked components, whatever it is.
  bool replaces = false;
};

struct DrawStatistics {
  std::uint64_t primitives = 0; ///< after clipping and culling
  std::uint64_t pixels = 0;     ///< given to shading
  bool incomplete = false;      ///< there was no memory for some of it, or for all
};

} // namespace arbiter::swrast
