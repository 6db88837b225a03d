#include "apps/tools/debug/pixel/verdict.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "apps/tools/debug/pixel/cut.h"
#include "apps/tools/debug/trace/numbers.h"
#include "fp_compiler/back/assembly/assembly.h"
#include "util/numbers/same_bits.h"

namespace arbiter::tools::debug {

namespace {

/// Longer programs are bisected, because drawing a row compiles a program.
constexpr std::size_t kMaxRowsDrawn = 256;

const Named *colorOf(const Trace &trace) {
  for (const Named &result : trace.results)
    if (result.name == "result.color" || result.name == "result.color[0]")
      return &result;
  return nullptr;
}

std::array<std::uint8_t, 4> bytesOf(const Vec4 &color) {
  std::array<std::uint8_t, 4> bytes = {};
  std::transform(color.begin(), color.end(), bytes.begin(), byteOf);
  return bytes;
}

/// Returns the greatest difference in components of \p mask; a host may leave any values in others.
int stepsBetween(const Vec4 &a, const Vec4 &b, std::uint8_t mask) {
  int steps = 0;
  for (std::size_t c = 0; c < 4; ++c)
    if (mask >> c & 1)
      steps = std::max(steps, std::abs(int(byteOf(a[c])) - int(byteOf(b[c]))));
  return steps;
}

bool isSameBits(const Vec4 &a, const Vec4 &b, std::uint8_t mask) {
  for (std::size_t c = 0; c < 4; ++c)
    if ((mask >> c & 1) && !sameBits(a[c], b[c]) && !(std::isnan(a[c]) && std::isnan(b[c])))
      return false;
  return true;
}

/// Returns the value of a row to compare; KIL's is its operand.
Vec4 valueOf(const Row &row) { return row.mask ? row.value.first : row.operands[0].value.first; }
std::uint8_t maskOf(const Row &row) { return row.mask ? row.mask : 0xF; }

class Search {
public:
  Search(Drawer &drawer, const Program &program, const Trace &trace, int x, int y,
         Fragments fragments, const Tolerance &tolerance)
      : m_drawer(drawer), m_program(program), m_trace(trace), m_x(x), m_y(y),
        m_fragments(fragments), m_tolerance(tolerance) {}

  /// Compares every row, a few per draw, until one differs.
  Result<std::optional<Difference>, DebugError> eachRow() {
    for (std::size_t from = 0; from < m_trace.rows.size(); from += kMaxTargets) {
      std::vector<std::size_t> rows(std::min(kMaxTargets, m_trace.rows.size() - from));
      std::iota(rows.begin(), rows.end(), from);
      auto found = among(rows);
      if (!found || found.value())
        return found;
    }
    return std::optional<Difference>();
  }

  /// Bisects: finds a row that differs after a row that does not.
  Result<std::optional<Difference>, DebugError> halved() {
    std::optional<Difference> nearest;
    std::size_t low = 0, high = m_trace.rows.size();
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      auto found = among({middle});
      if (!found)
        return found;
      if (found.value()) {
        nearest = found.value();
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return nearest;
  }

private:
  Result<std::optional<Difference>, DebugError> among(const std::vector<std::size_t> &rows) {
    const auto drawn = drawRows(m_drawer, m_program, rows, m_x, m_y, m_fragments);
    if (!drawn)
      return drawn.error();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Row &row = m_trace.rows[rows[i]];
      const Vec4 mine = valueOf(row), other = drawn.value()[i];
      const std::uint8_t components = differing(mine, other, maskOf(row), m_tolerance);
      if (components)
        return std::optional(Difference{rows[i], rows[i], {mine, other}, components, {}});
    }
    return std::optional<Difference>();
  }

  Drawer &m_drawer;
  const Program &m_program;
  const Trace &m_trace;
  const int m_x, m_y;
  const Fragments m_fragments;
  const Tolerance m_tolerance;
};

/// Returns the picture's pixel, and also the fragment's color if the depth test hides it, or if
/// blending or a later draw changed it. A difference of one step is ignored, because hosts may
/// round either way.
std::string drawnText(const Verdict &verdict) {
  std::string picture = hexColor(verdict.picture);
  if (verdict.isHidden)
    return picture + " (the depth test hides the fragment " + colorText(*verdict.drawn) + ")";
  for (std::size_t c = 0; c < 4; ++c)
    if (std::abs(int(verdict.picture[c]) - int(byteOf((*verdict.drawn)[c]))) > 1)
      return picture + " (the fragment " + colorText(*verdict.drawn) + ")";
  return picture;
}

/// Returns a program's colors in one pixel. Draws the whole 2x2 quad, because the trace's inputs
/// were drawn so too.
Result<std::vector<Vec4>, DebugError> drawPixel(Drawer &drawer, const std::string &text,
                                                std::size_t targets, int x, int y) {
  const auto [width, height] = drawer.size();
  const int left = x & ~1, bottom = y & ~1;
  const Region quad{left, bottom, std::min(2, width - left), std::min(2, height - bottom)};
  const auto pixels = std::size_t(quad.width * quad.height);
  const auto drawn = drawer.draw(text, targets, quad);
  if (!drawn)
    return drawn.error();
  if (drawn.value().size() != targets * pixels)
    return DebugError{drawer.name() + " drew another number of pixels than was asked for"};
  std::vector<Vec4> values;
  for (std::size_t t = 0; t < targets; ++t)
    values.push_back(
        drawn.value()[t * pixels + std::size_t((y - bottom) * quad.width + (x - left))]);
  return values;
}

/// Returns a verdict with the interpreter's color, the drawn fragment and the picture.
Result<Verdict, DebugError> compareColors(Drawer &drawer, const Program &program,
                                          const Trace &trace, int x, int y) {
  Verdict verdict;
  verdict.drawer = drawer.name();
  verdict.isDiscarded = trace.isDiscarded.first;
  const Region pixel{x, y, 1, 1};
  const auto picture = drawer.picture(pixel);
  if (!picture)
    return picture.error();
  if (!picture.value().empty())
    verdict.picture = picture.value()[0];
  const auto fragment = drawPixel(drawer, "", 1, x, y);
  if (!fragment)
    return fragment.error();
  if (fragment.value()[0] != uncovered())
    verdict.drawn = fragment.value()[0];
  else if (writesDepth(program)) {
    // A draw without the program's depth tells a hidden fragment from a discarded one.
    const auto kept = drawPixel(drawer, fp::emitAssembly(withoutDepth(program)), 1, x, y);
    if (!kept)
      return kept.error();
    verdict.isHidden = kept.value()[0] != uncovered();
    if (verdict.isHidden)
      verdict.drawn = kept.value()[0];
  }
  const Named *const color = colorOf(trace);
  if (!color || !verdict.drawn || verdict.isDiscarded)
    return verdict;
  verdict.interpreter = bytesOf(color->value.first);
  verdict.steps = stepsBetween(color->value.first, *verdict.drawn, color->mask);
  verdict.bitsEqual = isSameBits(color->value.first, *verdict.drawn, color->mask);
  return verdict;
}

} // namespace

Result<std::vector<Vec4>, DebugError> drawRows(Drawer &drawer, const Program &program,
                                               const std::vector<std::size_t> &rows, int x, int y,
                                               Fragments fragments) {
  std::vector<Probe> probes;
  probes.reserve(rows.size());
  for (const std::size_t row : rows)
    probes.push_back({Probe::Kind::Value, row});
  return drawPixel(drawer, fp::emitAssembly(cutProgram(program, probes, fragments)), probes.size(),
                   x, y);
}

Result<Verdict, DebugError> judge(Drawer &drawer, const Program &program, const Trace &trace, int x,
                                  int y, const Tolerance &tolerance) {
  auto verdict = compareColors(drawer, program, trace, x, y);
  // An ATI shader cannot be cut, because assembly cannot express it.
  if (!verdict || verdict.value().isEqual() || program.language != fp::ir::Language::ArbFragment)
    return verdict;
  const bool survives =
      decidesFragments(program) && verdict.value().drawn && !verdict.value().isHidden;
  Search search(drawer, program, trace, x, y, survives ? Fragments::Surviving : Fragments::Covered,
                tolerance);
  verdict.value().bisected = trace.rows.size() > kMaxRowsDrawn;
  const auto first = verdict.value().bisected ? search.halved() : search.eachRow();
  if (!first)
    return first.error();
  verdict.value().first = first.value();
  return verdict;
}

std::string verdictLine(const Verdict &verdict, const Trace &trace) {
  std::string line = verdict.drawer;
  if (!verdict.drawn && verdict.isDiscarded)
    return line + " discarded the fragment: equal";
  if (verdict.isEqual())
    return line + " drew " + drawnText(verdict) + ": equal" +
           (verdict.bitsEqual ? ", to the bit" : " in 8 bits");
  if (verdict.isDiscarded != !verdict.drawn)
    line += verdict.drawn ? " drew " + drawnText(verdict) + ", the interpreter discards"
                          : " discarded the fragment, the interpreter does not";
  else
    line += " differs by " + std::to_string(verdict.steps) + "/255";
  if (!verdict.first)
    return line + "; no instruction differs by more than rounding";
  const Row &row = trace.rows[verdict.first->row];
  return line + ", first at line " + std::to_string(row.at.line) + ": " + row.text;
}

} // namespace arbiter::tools::debug
