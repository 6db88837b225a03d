#pragma once
#include <array>
#include <optional>

#include "state/imaging/pixels.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/fixed_function/fixed_fragment.h"
#include "state/raster_draw/frames/looks.h"
#include "state/raster_draw/functions/functions.h"
#include "state/raster_draw/functions/program_table.h"
#include "state/raster_draw/outcome.h"
#include "state/raster_draw/program_state.h"
#include "state/raster_draw/units.h"
#include "state/raster_draw/vertices/array_source.h"
#include "state/raster_draw/vertices/vertex_stage.h"
#include "swrast/bits.h"
#include "swrast/rasterize.h"

namespace arbiter::state {

struct DrawTargets;
struct Joining;
struct PlacedBits;
class Mirror;

/// A context's path from the effective programs to pixels. choose() looks at state and has
/// functions compiled; shade() draws vertices with what was chosen. No pixel is written before
/// shade(), so any earlier step may still give the draw to the host.
///
/// A draw only handles what has changed since the last one. The choice is kept with its inputs:
/// Basis, and the groups of state that decide. The data for drawing pixels is updated group by
/// group.
class Pipeline {
public:
  /// The properties of a draw that decide about functions.
  struct Kind {
    GLenum mode = GL_TRIANGLES;
    std::uint32_t count = 0;    ///< number of vertices; many small primitives use quads
    MaterialMask materials = 0; ///< parts of the material that vary from vertex to vertex
  };
  /// Chooses for a draw of vertices. Requires that the context's programs are validated.
  Outcome choose(RasterContext &context, const Kind &kind) { return chooseFor(context, &kind); }
  /// Draws vertices [first, first + count) of the source, or those that indices name.
  Outcome shade(RasterContext &context, const VertexSource &source, const IndexRange &indices,
                std::uint32_t first, std::uint32_t count);
  /// Draws a part of a large draw (large_draw.h), with primitives of `topology`. Inputs are always
  /// Perspective, so that all parts use the same functions.
  Outcome shadePart(RasterContext &context, const VertexSource &source, const IndexRange &indices,
                    std::uint32_t first, std::uint32_t count, swrast::Topology topology);
  /// Draws primitives that were joined (primitives/joined.h), by indices.
  Outcome shadeJoined(RasterContext &context, const VertexSource &source, const IndexRange &indices,
                      const Joining &joining);
  /// Chooses for fragments at the current raster position.
  Outcome chooseFragments(RasterContext &context) { return chooseFor(context, nullptr); }
  /// True if the chosen fragments read more of the raster position than its colour. Hosts lack the
  /// other values, so the draw is always the rasterizer's.
  [[nodiscard]] bool readsRasterValues() const { return m_readsRasterValues; }
  /// Chooses, and draws a bitmap (bitmap.h) with the current raster position's values.
  Outcome shadeBits(RasterContext &context, const PlacedBits &bits);
  /// Chooses, and draws an image at the raster position. Each fragment has its own colour.
  Outcome shadePixels(RasterContext &context, const imaging::Pixels &pixels);
  [[nodiscard]] swrast::Topology topology() const { return m_topology; }
  /// True if the chosen draw tests depth or stencil.
  [[nodiscard]] bool testsDepth() const {
    return m_key.depthStencil.depthTest != 0 || m_key.depthStencil.stencilTest != 0;
  }
  /// True if a program of the application reads materials in the chosen draw. Materials are then
  /// the same for a whole primitive.
  [[nodiscard]] bool programReadsMaterials() const {
    return (m_compiled && m_program->values->readsMaterials()) ||
           (m_vertices.isApplications() && m_vertices.readsMaterials());
  }
  /// True if fixed function computes the chosen draw's vertices.
  [[nodiscard]] bool hasFixedVertices() const { return !m_vertices.isApplications(); }
  /// Returns the attributes that the chosen vertex function reads.
  [[nodiscard]] SlotMask slots() const { return m_vertices.slots(); }
  [[nodiscard]] std::uint32_t currentSlots() const { return m_vertices.currentSlots(); }
  [[nodiscard]] VertexFetcher &fetcher() { return m_vertices.fetcher(); }
  [[nodiscard]] ArraySource &arrays() { return m_arrays; }

private:
  /// The inputs of a choice, except groups of state.
  struct Basis {
    std::uint64_t selections = 0; ///< DrawChoice::selections
    std::uint64_t images = 0;     ///< Residency::version()
    bool mayTestDepth = false;    ///< ContextState::mayTestDepth()
    bool mixesInVain = false;     ///< FrameHistory::mixesInVain
    KeptLook::Side look = {};     ///< FrameHistory::look
    /// True for draws of vertices; the members below are used only then.
    bool vertices = false;
    std::uint32_t vertexState = 0; ///< VertexState::version
    GLenum mode = 0;
    bool many = false;
    MaterialMask materials = 0;
    bool operator==(const Basis &) const = default;
  };
  [[nodiscard]] static Basis basisOf(const RasterContext &context, const Mirror &mirror,
                                     const Kind *vertices);
  Outcome transform(RasterContext &context, const VertexSource &source, const IndexRange &indices,
                    std::uint32_t first, std::uint32_t count, bool later);
  Outcome rasterize(RasterContext &context, const VertexSource &source, const IndexRange &indices,
                    std::uint32_t count, abi::Interpolation inputs, const Joining &primitives);
  [[nodiscard]] bool cutsSecondDiagonal(const RasterContext &context, const VertexSource &source,
                                        const IndexRange &indices,
                                        const swrast::Shading &shading) const;
  /// Prepares the functions, the targets and the data for pixels. No pixel has been written before.
  Outcome readyPixels(RasterContext &context, const IndexRange &indices, std::uint32_t count,
                      abi::Interpolation inputs, swrast::Topology topology,
                      const swrast::Shading *&shading);
  /// Chooses, or keeps the last choice. \param vertices null: fragments at the raster position
  Outcome chooseFor(RasterContext &context, const Kind *vertices);
  Outcome chooseAnew(RasterContext &context, Mirror &mirror, const Kind *vertices);
  /// Chooses the fragment program and the targets.
  Outcome choosePixels(RasterContext &context, Mirror &mirror, const Kind *vertices);
  /// Finds the draw's looks, and decides how long to wait for code. Not ok if the host draws looks.
  Outcome chooseSide(RasterContext &context, Mirror &mirror, const Kind *vertices);
  /// True if the draw has a look and must therefore keep the context's side. Like isMixed(), it is
  /// false for draws that only the rasterizer draws correctly.
  [[nodiscard]] bool keepsLooks(const ContextState &state) const;
  /// True if the rasterizer does the draw only in whole frames: it tests depth, or such draws were
  /// too few in mixed frames.
  [[nodiscard]] bool needsWhole(const ContextState &state, bool testsDepths) const;
  /// True if needsWhole(), and the frame is a mixed one.
  [[nodiscard]] bool isMixed(const ContextState &state, bool testsDepths) const;
  /// Chooses the topology and the vertex program. Requires choosePixels().
  Outcome chooseVertices(RasterContext &context, Mirror &mirror, const Kind &kind);
  /// Makes the key for pixels' functions. Requires all other choices: what the rasterizer lacks is
  /// judged before the frame is.
  Outcome makeKey(RasterContext &context, Mirror &mirror, abi::Coverage coverage, bool hasVertices);
  Outcome chooseFunctions(const Mirror &mirror, abi::Interpolation inputs);
  /// Chooses the function for small triangles, for which the rasterizer tests depth.
  /// \param quads true if a level of detail or a derivative is wanted
  void choosePacked(bool quads, swrast::Shading &shading, Fallback &why);
  [[nodiscard]] abi::ShadeFunction functionFor(abi::Lanes lanes, Fallback &why);
  [[nodiscard]] bool isOpaque() const;
  /// Does chooseFragments() and readyPixels(), and computes the attributes that all fragments
  /// share.
  Outcome readyFragments(RasterContext &context, const swrast::Shading *&shading,
                         swrast::BitFragments &fragments);
  Outcome acquire(RasterContext &context, const IndexRange &indices, std::uint32_t count,
                  bool opaque, swrast::Topology topology);
  void fillRaster(const Mirror &mirror);
  void fillData(const Mirror &mirror);
  void takeClears();
  void describeUse();

  /// A fragment program in use, and what its draws need beside its code.
  struct Program {
    std::shared_ptr<const fp::ir::Program> source;
    std::shared_ptr<FragmentFunctions> functions;
    std::unique_ptr<ProgramValues> values; ///< null until it is prepared
    RecentFunctions<FragmentFunctions, abi::FragmentKey> recent;
    std::optional<LookBasis> looks; ///< empty until the first draw
  };

  swrast::Topology m_topology = swrast::Topology::Triangles;
  bool m_many = false; ///< many vertices
  Wait m_wait = Wait::Briefly;
  bool m_readsRasterValues = false;
  const CompiledProgram *m_compiled = nullptr; ///< null: fixed function
  ProgramTable<Program> m_programs;
  Program *m_program = nullptr; ///< one of m_programs
  FixedFragments m_fixed;
  Units m_units;
  VertexStage m_vertices;
  ArraySource m_arrays;
  const DrawTargets *m_targets = nullptr;
  abi::FragmentKey m_key{};

  // --- The choice, and its inputs ---
  bool m_chosen = false;
  std::optional<Fallback> m_isHosts; ///< set if the choice was that the host draws for now
  Looks m_looks = 0;
  Basis m_basis;
  std::uint64_t m_seen = 0; ///< a value of GenerationCounter
  bool m_floatTarget = false;
  /// Shading for each kind of non-flat interpolation.
  struct Prepared {
    bool ready = false; ///< true if none of its functions is still being compiled
    swrast::Shading shading;
  };
  Prepared m_prepared[4];

  // --- The data that pixels are drawn with ---
  bool m_filled = false; ///< true if filled since the last choice
  std::uint64_t m_filledSeen = 0, m_filledImages = 0;
  swrast::RasterState m_raster;
  abi::FragmentData m_data;
  swrast::ShadingUse m_use; ///< the objects that m_data refers to
  std::array<swrast::Storage *, abi::kMaxColorTargets + 1> m_written;
};

} // namespace arbiter::state
