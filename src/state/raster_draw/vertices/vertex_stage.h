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
struct RasterContext;
struct CompiledProgram;
} // namespace arbiter::state

namespace arbiter::state {

/// Transforms the application's vertices: chooses the effective vertex program or fixed function's,
/// its machine code, and the arrays that it reads and writes.
class VertexStage {
public:
  /// The properties of a draw that the choice needs.
  struct Use {
    bool points = false;
    MaterialMask materials = 0; ///< parts of the material that vary from vertex to vertex
  };
  /// Chooses the function for what the fragments need. `compiled` is the application's vertex
  /// program, or null. `floatTarget` is true if a colour buffer holds floats.
  Outcome choose(RasterContext &context, Mirror &mirror, const CompiledProgram *compiled,
                 const fp::jit::FragmentShape &fragments, const Use &use, bool floatTarget,
                 Wait wait);
  /// True if back faces have colours of their own.
  [[nodiscard]] bool isTwoSided() const { return m_twoSided; }
  /// True if the chosen program is the application's.
  [[nodiscard]] bool isApplications() const { return m_compiled != nullptr; }
  /// True if the program reads materials, as they are before the primitive. Requires choose().
  [[nodiscard]] bool readsMaterials() const { return m_program->values->readsMaterials(); }
  /// Judges the textures that the program samples, like Units::judge(). Requires choose().
  [[nodiscard]] Outcome judgeTextures(RasterContext &context, Mirror &mirror);
  /// Makes these textures ready, and the function for them. Requires choose().
  Outcome bindTextures(RasterContext &context, Mirror &mirror, Wait wait);
  /// Returns the slots that the function reads.
  [[nodiscard]] SlotMask slots() const { return m_slots; }
  /// Returns the slots whose current values are needed, including slots().
  [[nodiscard]] std::uint32_t currentSlots() const;

  /// Transforms vertices [first, first + count) of the source.
  /// \param later true if the rasterizer may do it when it needs them (swrast::Vertices::make)
  Outcome run(RasterContext &context, Mirror &mirror, const VertexSource &source,
              std::uint32_t first, std::uint32_t count, bool edgeFlags, bool later);
  /// Returns the result of the last successful run(). Fragment inputs are in the order of the
  /// chosen shape.
  [[nodiscard]] const swrast::Vertices &vertices() const { return m_vertices; }
  [[nodiscard]] VertexFetcher &fetcher() { return m_fetcher; }

private:
  struct Program {
    std::shared_ptr<const fp::ir::Program> source;
    std::shared_ptr<VertexFunctions> functions;
    std::unique_ptr<ProgramValues> values;
    RecentFunctions<VertexFunctions, abi::VertexKey> recent; ///< for a program that samples
  };
  /// Makes m_program the entry of `source`, and requests its functions at the first use.
  void selectProgram(RasterContext &context, const std::shared_ptr<const fp::ir::Program> &source,
                     Wait wait);
  /// Points m_vertices at the outputs of the chosen program.
  void connect(float *const *outputs);
  /// Fills m_unwritten for the chosen program.
  void findUnwritten(const RasterContext &context);
  /// Points the unwritten inputs at current values. Returns false if there is no memory.
  [[nodiscard]] bool connectUnwritten(const Mirror &mirror);
  void transformStretch(std::uint32_t begin, std::uint32_t end) const;
  void transformAll(std::uint32_t count) const;

  const CompiledProgram *m_compiled = nullptr;
  const fp::jit::FragmentShape *m_fragments = nullptr;
  FixedVertexPrograms m_fixed;
  /// The application's programs, with additions for fixed function.
  ExtendedPrograms m_extended;
  ProgramTable<Program> m_programs;
  Program *m_program = nullptr; ///< one of m_programs
  abi::VertexFunction m_function = nullptr;
  Units m_units;
  std::array<const abi::TextureView *, abi::kMaxUnits> m_textures = {};
  SlotMask m_slots = 0;
  bool m_twoSided = false;
  bool m_pointSize = false;
  std::uint8_t m_clipPlanes = 0;
  VertexFetcher m_fetcher;
  const fp::jit::VertexShape *m_shape = nullptr; ///< the shape of m_program
  swrast::Vertices m_vertices;
  abi::VertexData m_data; ///< refers to the vertices that the fetcher has open
  /// Fragment inputs of fixed function that the application's program does not write. They are
  /// undefined, but hosts use current values, and some applications rely on it.
  struct Unwritten {
    std::uint8_t input = 0; ///< index into swrast::Vertices::inputs
    std::uint8_t slot = 0;
  };
  std::vector<Unwritten> m_unwritten;
  bool m_connected = false;        ///< true if m_vertices points at the outputs of m_shape
  std::uint32_t m_connectedTo = 0; ///< the VertexFetcher::outputsVersion() of that moment
};

} // namespace arbiter::state
