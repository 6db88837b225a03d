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

namespace arbiter::state::software {

struct DrawTargets;
struct Joining;
struct PlacedBits;
class Mirror;

/// A context's way from the effective programs to pixels. choose() looks at state and has functions
/// made; shade() draws vertices with what was chosen. Nothing is written before shade(), so a draw
/// may be given to the host at any step before.
///
/// A draw works only on what changed since the one before: what was chosen is kept with what it was
/// chosen by (Basis, and the groups of state that decide), and what pixels are drawn with is filled
/// again group by group.
class Pipeline {
public:
  /// What of a draw decides about functions.
  struct Kind {
    GLenum mode = GL_TRIANGLES;
    std::uint32_t count = 0;    ///< vertices; many small primitives take quads
    MaterialMask materials = 0; ///< that vary from vertex to vertex
  };
  /// For a draw of vertices. Requires: the context's programs are validated.
  Outcome choose(Context &context, const Kind &kind) { return chooseFor(context, &kind); }
  /// Draws vertices [first, first + count) of the source, or those that indices name.
  Outcome shade(Context &context, const VertexSource &source, const IndexRange &indices,
                std::uint32_t first, std::uint32_t count);
  /// The same of a part of a draw (large_draw.h), whose primitives are `topology`. Inputs are
  /// always Perspective, so that all parts have the functions of the first.
  Outcome shadePart(Context &context, const VertexSource &source, const IndexRange &indices,
                    std::uint32_t first, std::uint32_t count, swrast::Topology topology);
  /// The same of primitives that are joined (primitives/joined.h) by the indices.
  Outcome shadeJoined(Context &context, const VertexSource &source, const IndexRange &indices,
                      const Joining &joining);
  /// For fragments that no vertices give, but the current raster position.
  Outcome chooseFragments(Context &context) { return chooseFor(context, nullptr); }
  /// True if the chosen draw is of fragments at the raster position, and their program reads more
  /// of its values than its colour: hosts have no others, so the draw is the rasterizer's in any
  /// frame.
  [[nodiscard]] bool readsRasterValues() const { return m_readsRasterValues; }
  /// Chooses, and draws bits (bitmap.h) as fragments that have the current raster position's
  /// values.
  Outcome shadeBits(Context &context, const PlacedBits &bits);
  /// Chooses, and draws an image at the raster position. Its fragments have a colour each.
  Outcome shadePixels(Context &context, const imaging::Pixels &pixels);
  [[nodiscard]] swrast::Topology topology() const { return m_topology; }
  /// The chosen draw tests depth or stencil.
  [[nodiscard]] bool testsDepth() const {
    return m_key.depthStencil.depthTest != 0 || m_key.depthStencil.stencilTest != 0;
  }
  /// The chosen draw has a program of the application's that reads materials, which are the same
  /// for a whole primitive.
  [[nodiscard]] bool programReadsMaterials() const {
    return (m_compiled && m_program->values->readsMaterials()) ||
           (m_vertices.isApplications() && m_vertices.readsMaterials());
  }
  /// Fixed function makes the chosen draw's vertices.
  [[nodiscard]] bool hasFixedVertices() const { return !m_vertices.isApplications(); }
  /// The attributes that the chosen vertex function reads.
  [[nodiscard]] SlotMask slots() const { return m_vertices.slots(); }
  [[nodiscard]] std::uint32_t currentSlots() const { return m_vertices.currentSlots(); }
  [[nodiscard]] VertexFetcher &fetcher() { return m_vertices.fetcher(); }
  [[nodiscard]] ArraySource &arrays() { return m_arrays; }

private:
  /// What decides about a choice, beside groups of state.
  struct Basis {
    std::uint64_t selections = 0; ///< Context::selections
    std::uint64_t images = 0;     ///< Residency::version()
    bool mayTestDepth = false;    ///< ContextState::mayTestDepth()
    bool mixesInVain = false;     ///< FrameHistory's
    KeptLook::Side look = {};     ///< FrameHistory::look
    /// Where there are vertices; the rest is of them.
    bool vertices = false;
    std::uint32_t vertexState = 0; ///< VertexState::version
    GLenum mode = 0;
    bool many = false;
    MaterialMask materials = 0;
    bool operator==(const Basis &) const = default;
  };
  [[nodiscard]] static Basis basisOf(const Context &context, const Mirror &mirror,
                                     const Kind *vertices);
  Outcome transform(Context &context, const VertexSource &source, const IndexRange &indices,
                    std::uint32_t first, std::uint32_t count, bool later);
  Outcome rasterize(Context &context, const VertexSource &source, const IndexRange &indices,
                    std::uint32_t count, abi::Interpolation inputs, const Joining &primitives);
  [[nodiscard]] bool cutsSecondDiagonal(const Context &context, const VertexSource &source,
                                        const IndexRange &indices,
                                        const swrast::Shading &shading) const;
  /// The functions, the targets and what pixels are drawn with; nothing has been drawn before.
  Outcome readyPixels(Context &context, const IndexRange &indices, std::uint32_t count,
                      abi::Interpolation inputs, swrast::Topology topology,
                      const swrast::Shading *&shading);
  /// \param vertices null: fragments that no vertices give
  Outcome chooseFor(Context &context, const Kind *vertices);
  Outcome chooseAnew(Context &context, Mirror &mirror, const Kind *vertices);
  /// The fragment program and the targets.
  Outcome choosePixels(Context &context, Mirror &mirror, const Kind *vertices);
  /// The current program's looks, and whether its code is waited for. Not ok: the host draws looks.
  Outcome chooseSide(Context &context, Mirror &mirror, const Kind *vertices);
  /// The draw has a look, which one side draws for the whole context. Like isMixed(), false of a
  /// draw that only the rasterizer can draw right.
  [[nodiscard]] bool keepsLooks(const ContextState &state) const;
  /// The rasterizer draws it in frames that it draws as a whole: it tests depths, or was too little
  /// beside the host's draws.
  [[nodiscard]] bool needsWhole(const ContextState &state, bool testsDepths) const;
  /// That, and in this frame the host draws.
  [[nodiscard]] bool isMixed(const ContextState &state, bool testsDepths) const;
  /// Assembly, and the vertex program. Requires: choosePixels().
  Outcome chooseVertices(Context &context, Mirror &mirror, const Kind &kind);
  /// What pixels' functions are compiled for. Requires: all else is chosen, as what the rasterizer
  /// lacks is judged before the frame is.
  Outcome makeKey(Context &context, Mirror &mirror, abi::Coverage coverage, bool hasVertices);
  Outcome chooseFunctions(const Mirror &mirror, abi::Interpolation inputs);
  /// The function for small triangles whose depth the rasterizer tests.
  /// \param levels a sampler wants a level of detail
  void choosePacked(bool quads, swrast::Shading &shading, Fallback &why);
  [[nodiscard]] abi::ShadeFunction functionFor(abi::Lanes lanes, Fallback &why);
  [[nodiscard]] bool isOpaque() const;
  /// chooseFragments(), readyPixels(), and what all of the fragments have.
  Outcome readyFragments(Context &context, const swrast::Shading *&shading,
                         swrast::BitFragments &fragments);
  Outcome acquire(Context &context, const IndexRange &indices, std::uint32_t count, bool opaque,
                  swrast::Topology topology);
  void fillRaster(const Mirror &mirror);
  void fillData(const Mirror &mirror);
  void takeClears();
  void describeUse();

  /// A fragment program that was drawn with, and what its draws need beside its code.
  struct Program {
    std::shared_ptr<const fp::ir::Program> source;
    std::shared_ptr<FragmentFunctions> functions;
    std::unique_ptr<ProgramValues> values; ///< null until it is prepared
    RecentFunctions<FragmentFunctions, abi::FragmentKey> recent;
    std::optional<LookBasis> looks; ///< none until the first draw
  };

  swrast::Topology m_topology = swrast::Topology::Triangles;
  bool m_many = false; ///< vertices
  Wait m_wait = Wait::Briefly;
  bool m_readsRasterValues = false;
  const CompiledProgram *m_compiled = nullptr; ///< null: fixed function
  ProgramTable<Program> m_programs;
  Program *m_program = nullptr; ///< current; one of m_programs
  FixedFragments m_fixed;
  Units m_units;
  VertexStage m_vertices;
  ArraySource m_arrays;
  const DrawTargets *m_targets = nullptr;
  abi::FragmentKey m_key{};

  // --- What was chosen, and when ---
  bool m_chosen = false;
  std::optional<Fallback> m_isHosts; ///< the choice was that the host draws for now
  Looks m_looks = 0;
  Basis m_basis;
  std::uint64_t m_seen = 0; ///< GenerationCounter
  bool m_floatTarget = false;
  /// By how inputs vary that are not flat.
  struct Prepared {
    bool ready = false; ///< nothing that it wants is still being compiled
    swrast::Shading shading;
  };
  Prepared m_prepared[4];

  // --- What pixels are drawn with ---
  bool m_filled = false; ///< since the last choice
  std::uint64_t m_filledSeen = 0, m_filledImages = 0;
  swrast::RasterState m_raster;
  abi::FragmentData m_data;
  swrast::ShadingUse m_use; ///< what they refer to
  std::array<swrast::Storage *, abi::kMaxColorTargets + 1> m_written;
};

} // namespace arbiter::state::software
