#pragma once
#include <memory>
#include <vector>

#include "fp_compiler/jit.h"
#include "state/mirror/attributes.h"
#include "state/mirror/mirror.h"
#include "state/raster_draw/fixed_function/fixed_vertex.h"
#include "state/raster_draw/functions/functions.h"
#include "state/raster_draw/functions/program_table.h"
#include "state/raster_draw/outcome.h"
#include "state/raster_draw/program_state.h"
#include "state/raster_draw/units.h"
#include "state/raster_draw/vertices/vertex_fetch.h"
#include "swrast/rasterize.h"

namespace arbiter::state {
class Context;
struct CompiledProgram;
} // namespace arbiter::state

namespace arbiter::state::software {

/// From the application's vertices to transformed ones: the effective vertex program or fixed
/// function's, its function, and the arrays that it reads and writes.
class VertexStage {
public:
  /// What a draw says of its vertices.
  struct Use {
    bool points = false;
    MaterialMask materials = 0; ///< that vary from vertex to vertex
  };
  /// Chooses the function for what the fragments need. `compiled` is the application's vertex
  /// program, or null; `floatTarget`: a colour buffer holds floats.
  Outcome choose(Context &context, Mirror &mirror, const CompiledProgram *compiled,
                 const fp::jit::FragmentShape &fragments, const Use &use, bool floatTarget,
                 Wait wait);
  /// Back sides have colours of their own.
  [[nodiscard]] bool isTwoSided() const { return m_twoSided; }
  /// The chosen program is the application's.
  [[nodiscard]] bool isApplications() const { return m_compiled != nullptr; }
  /// It reads materials as they are before the primitive. Requires: choose().
  [[nodiscard]] bool readsMaterials() const { return m_program->values->readsMaterials(); }
  /// Of the textures that the program samples, as Units::judge(). Requires: choose().
  [[nodiscard]] Outcome judgeTextures(Context &context, Mirror &mirror);
  /// Has them ready, and the function for them. Requires: choose().
  Outcome bindTextures(Context &context, Mirror &mirror, Wait wait);
  /// The slots that the function reads.
  [[nodiscard]] SlotMask slots() const { return m_slots; }
  /// Those, and the others whose current values are wanted.
  [[nodiscard]] std::uint32_t currentSlots() const;

  /// Transforms vertices [first, first + count) of the source.
  /// \param later that may wait until the rasterizer comes to them (swrast::Vertices::make)
  Outcome run(Context &context, Mirror &mirror, const VertexSource &source, std::uint32_t first,
              std::uint32_t count, bool edgeFlags, bool later);
  /// The result of the last run() that succeeded; fragment inputs are in the order of the shape
  /// that was chosen for.
  [[nodiscard]] const swrast::Vertices &vertices() const { return m_vertices; }
  [[nodiscard]] VertexFetcher &fetcher() { return m_fetcher; }

private:
  struct Program {
    std::shared_ptr<const fp::ir::Program> source;
    std::shared_ptr<VertexFunctions> functions;
    std::unique_ptr<ProgramValues> values;
    RecentFunctions<VertexFunctions, abi::VertexKey> recent; ///< of one that samples
  };
  void take(Context &context, const std::shared_ptr<const fp::ir::Program> &source, Wait wait);
  void connect(float *const *outputs);
  void findUnwritten(const Context &context);
  [[nodiscard]] bool connectUnwritten(const Mirror &mirror);
  void transformStretch(std::uint32_t begin, std::uint32_t end) const;
  void transformAll(std::uint32_t count) const;

  const CompiledProgram *m_compiled = nullptr;
  const fp::jit::FragmentShape *m_fragments = nullptr;
  FixedVertexPrograms m_fixed;
  /// Application programs with what fixed function adds.
  ExtendedPrograms m_extended;
  ProgramTable<Program> m_programs;
  Program *m_program = nullptr; ///< current; one of m_programs
  abi::VertexFunction m_function = nullptr;
  Units m_units;
  std::array<const abi::TextureView *, abi::kMaxUnits> m_textures = {};
  SlotMask m_slots = 0;
  bool m_twoSided = false;
  bool m_pointSize = false;
  std::uint8_t m_clipPlanes = 0;
  VertexFetcher m_fetcher;
  const fp::jit::VertexShape *m_shape = nullptr; ///< of m_program
  swrast::Vertices m_vertices;
  abi::VertexData m_data; ///< of the vertices that the fetcher has open
  /// Fragment inputs of fixed function that the application's program does not write. They are
  /// undefined; hosts take the vertex's current values, and some applications count on it.
  struct Unwritten {
    std::uint8_t input = 0; ///< of swrast::Vertices::inputs
    std::uint8_t slot = 0;
  };
  std::vector<Unwritten> m_unwritten;
  bool m_connected = false;        ///< m_vertices points at the outputs of m_shape ..
  std::uint32_t m_connectedTo = 0; ///< .. at this VertexFetcher::outputsVersion()
};

} // namespace arbiter::state::software
