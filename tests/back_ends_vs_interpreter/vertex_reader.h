#pragma once
#include <array>
#include <string>
#include <vector>

#include "backend.h"
#include "expectation.h"
#include "gl_host.h"

namespace arbiter::differential {

/// Everything that a draw left.
class Drawn {
public:
  explicit Drawn(const FloatTarget &target);
  [[nodiscard]] Vec4 color(int buffer, int x, int y) const;
  [[nodiscard]] float depth(int x, int y) const;

private:
  std::array<Pixels, kColorBuffers> m_pixels;
};

/// Shows up to two results of a vertex program as colours, by a fragment program that copies the
/// interpolated attributes that they become. A point has one vertex, so nothing is interpolated.
class Reader {
public:
  explicit Reader(const fp::ir::Program &vertexProgram);

  /// Draws the points; a reason if something went wrong.
  [[nodiscard]] std::string draw(Backend &backend, const std::string &text,
                                 const fp::ir::Program &program, const FloatTarget &target,
                                 void (*points)(const fp::ir::Program &) = drawPoints) const;
  /// The program with its results as colours, for the interpreter.
  [[nodiscard]] fp::ir::Program shown(fp::ir::Program program) const;
  /// The colours of one vertex; where a result has no such component, what is expected.
  [[nodiscard]] std::array<Vec4, kColorBuffers> seen(const Drawn &drawn, int x, int y,
                                                     const ExpectedPixel &expected) const;

private:
  std::vector<fp::ir::Output> m_results;
};

} // namespace arbiter::differential
