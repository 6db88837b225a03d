#pragma once
#include <array>
#include <string>
#include <vector>

#include "backend.h"
#include "expectation.h"
#include "gl_host.h"

namespace arbiter::differential {

/// All buffers after a draw.
class Drawn {
public:
  explicit Drawn(const FloatTarget &target);
  [[nodiscard]] Vec4 color(int buffer, int x, int y) const;
  [[nodiscard]] float depth(int x, int y) const;

private:
  std::array<Pixels, kColorBuffers> m_pixels;
};

/// Shows up to two results of a vertex program as colors, by a fragment program that copies the
/// interpolated attributes. A point has one vertex, so that nothing is interpolated.
class Reader {
public:
  explicit Reader(const fp::ir::Program &vertexProgram);

  /// Draws the points; returns a reason if something failed.
  [[nodiscard]] std::string draw(Backend &backend, const std::string &text,
                                 const fp::ir::Program &program, const FloatTarget &target,
                                 void (*points)(const fp::ir::Program &) = drawPoints) const;
  /// Returns the program with its results as colors, for the interpreter.
  [[nodiscard]] fp::ir::Program shown(fp::ir::Program program) const;
  /// Returns the colors of one vertex; components that a result lacks are the expected ones.
  [[nodiscard]] std::array<Vec4, kColorBuffers> seen(const Drawn &drawn, int x, int y,
                                                     const ExpectedPixel &expected) const;

private:
  std::vector<fp::ir::Output> m_results;
};

} // namespace arbiter::differential
