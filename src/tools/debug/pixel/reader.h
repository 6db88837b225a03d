#pragma once
#include <array>
#include <map>
#include <optional>

#include "tools/debug/pixel/cut.h"
#include "tools/debug/pixel/drawer.h"
#include "tools/debug/trace/record.h"

namespace arbiter::tools::debug {

/// A value in each pixel of a 2x2 quad: lower left, lower right, upper left, upper right.
using Quad = std::array<Vec4, 4>;

/// What a fragment program reads in one pixel, as the drawer itself gives it: each attribute and
/// row of parameters is drawn to a float target, and each texture access with the program cut
/// behind it, so that its level of detail is the draw's own.
class PixelReader {
public:
  /// \param drawn the arithmetic that the drawer runs programs with
  /// \p drawer and \p program must outlive the reader, and the reader its inputs().
  PixelReader(Drawer &drawer, const fp::ir::Program &program, int x, int y, fp::Numerics drawn);

  /// Errors: the pixel lies outside the picture, nothing covers it, or the drawer fails.
  [[nodiscard]] std::optional<DebugError> read();
  /// After read(). Texels of another arithmetic, whose coordinates differ, are sampled at those,
  /// with the derivatives that the drawer's coordinates have.
  [[nodiscard]] const TraceInputs &inputs() const { return m_inputs; }
  /// Where sampling for another arithmetic failed, why.
  [[nodiscard]] const std::optional<DebugError> &failure() const { return m_failure; }
  /// Whether the fragment is one that the program leaves; else one that it discards.
  [[nodiscard]] Fragments fragments() const { return m_fragments; }
  /// In window pixels and [0,1].
  [[nodiscard]] const Vec4 &position() const { return m_position; }

private:
  struct Access {
    Quad texel = {}, coordinate = {}; ///< TXP has divided
    std::optional<float> lod;
  };

  std::optional<DebugError> chooseFragments();
  std::optional<DebugError> readOperands();
  std::optional<DebugError> readAccesses();
  std::optional<DebugError> drawProbes(const std::vector<std::size_t> &rows);
  /// Quads of a program's colours.
  Result<std::vector<Quad>, DebugError> drawQuads(const fp::ir::Program &program,
                                                  std::size_t targets,
                                                  const std::vector<Vec4> &locals = {});
  std::optional<float> levelOf(const fp::ir::Instruction &instruction, const Access &access);
  Vec4 texel(std::size_t index, const fp::ir::Sample &sample, fp::Numerics numerics);
  Vec4 sampleAt(const fp::ir::Sample &sample, bool biased, const Access &access);
  [[nodiscard]] Vec4 own(const Quad &quad) const { return quad[m_lane]; }

  Drawer &m_drawer;
  const fp::ir::Program &m_program;
  const int m_x, m_y;
  const std::size_t m_lane; ///< of the pixel in its quad
  const fp::Numerics m_drawn;
  Fragments m_fragments = Fragments::Covered;
  TraceInputs m_inputs;
  Vec4 m_position = {};
  std::array<bool, 4> m_covered = {};
  std::map<std::size_t, Access> m_accesses; ///< by instruction
  std::map<std::pair<std::size_t, Vec4>, Vec4> m_sampled;
  std::optional<DebugError> m_failure;
};

} // namespace arbiter::tools::debug
