#pragma once
#include <array>
#include <map>
#include <optional>

#include "apps/tools/debug/pixel/cut.h"
#include "apps/tools/debug/pixel/drawer.h"
#include "apps/tools/debug/trace/record.h"

namespace arbiter::tools::debug {

/// A value for each pixel of a 2x2 quad: lower left, lower right, upper left, upper right.
using Quad = std::array<Vec4, 4>;

/// Returns a complaint if the pixel lies outside the picture.
[[nodiscard]] std::optional<DebugError> outside(const Drawer &drawer, int x, int y);

/// Reads the inputs of a fragment program in one pixel from the drawer. Attributes and parameters
/// are drawn to float targets. A texture access is drawn by the program cut after it, so that its
/// level of detail is the original draw's.
class PixelReader {
public:
  /// \param drawn the arithmetic with which the drawer runs programs
  /// \p drawer and \p program must outlive the reader, and the reader must outlive its inputs().
  PixelReader(Drawer &drawer, const fp::ir::Program &program, int x, int y, fp::Numerics drawn);

  /// Reads the inputs. Fails if the pixel lies outside the picture, if nothing covers it, or if the
  /// drawer fails.
  [[nodiscard]] std::optional<DebugError> read();
  /// Returns the inputs after read(). If another arithmetic computes other texture coordinates, the
  /// texel there is sampled with the derivatives of the drawer's coordinates.
  [[nodiscard]] const TraceInputs &inputs() const { return m_inputs; }
  /// Returns why sampling for another arithmetic failed, or nothing.
  [[nodiscard]] const std::optional<DebugError> &failure() const { return m_failure; }
  /// Returns whether a surviving fragment was read; otherwise it was one that the program discards.
  [[nodiscard]] Fragments fragments() const { return m_fragments; }
  /// Returns the position in window pixels, with a depth in [0,1].
  [[nodiscard]] const Vec4 &position() const { return m_position; }

private:
  struct Access {
    Quad texel = {}, coordinate = {}; ///< after TXP's division
    std::optional<float> lod;
  };

  std::optional<DebugError> chooseFragments();
  std::optional<DebugError> readOperands();
  std::optional<DebugError> readAccesses();
  std::optional<DebugError> drawProbes(const std::vector<std::size_t> &rows);
  /// Draws a program and returns each of its colors as a quad.
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
  const std::size_t m_lane; ///< index of the pixel in its quad
  const fp::Numerics m_drawn;
  Fragments m_fragments = Fragments::Covered;
  TraceInputs m_inputs;
  Vec4 m_position = {};
  std::array<bool, 4> m_covered = {};
  std::map<std::size_t, Access> m_accesses; ///< by index of the instruction
  std::map<std::pair<std::size_t, Vec4>, Vec4> m_sampled;
  std::optional<DebugError> m_failure;
};

} // namespace arbiter::tools::debug
