#include "apps/tools/debug/pixel/watch.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>

#include "apps/tools/debug/pixel/cut.h"
#include "apps/tools/debug/pixel/drawer.h"
#include "apps/tools/debug/trace/numbers.h"
#include "apps/tools/language.h"
#include "fp_compiler/file_programs.h"
#include "fp_compiler/hw/profile.h"

namespace arbiter::tools::debug {

namespace {

DebugError misspelt(std::string_view text) {
  return {"--watch " + std::string(text) + ": expected REGISTER@LINE, as in 'offset.x@12'"};
}

/// True if the text can only be an operand, without a comment or a second statement.
bool isOperandText(std::string_view text) {
  return !text.empty() &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                "0123456789_$.[]+-{}, ") == std::string_view::npos;
}

/// Returns the last instruction that begins at or before the line.
std::optional<std::size_t> lastRow(const Program &program, std::string_view text,
                                   std::uint32_t line) {
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < program.code.size(); ++i)
    if (fp::locate(text, program.code[i].span.begin).line <= line)
      last = i;
  return last;
}

/// Returns the text with one more instruction after \p row, which reads the register.
std::string longerText(const Program &program, std::string_view text, std::size_t row,
                       const std::string &reg) {
  std::size_t end = program.code[row].span.end;
  if (text[end - 1] != ';')
    end = std::min(text.find(';', end), text.size() - 1) + 1;
  return std::string(text.substr(0, end)) + "\nTEMP watchedByArbiter;\nMOV watchedByArbiter, " +
         reg + ";\n" + std::string(text.substr(end));
}

/// Returns the last row up to \p row whose destination has that name in the text.
std::optional<std::size_t> writes(const Program &program, std::string_view text, std::size_t row,
                                  const std::string &name) {
  for (std::size_t i = row + 1; i-- > 0;) {
    const fp::ir::Destination &dst = program.code[i].dst;
    if (fp::ir::info(program.code[i].op).has(fp::ir::Kills) || dst.file != fp::ir::File::Output)
      continue;
    const std::string_view spelt = text.substr(dst.span.begin, dst.span.end - dst.span.begin);
    if (spelt == name || (spelt.starts_with(name) && spelt[name.size()] == '.'))
      return i;
  }
  return {};
}

} // namespace

Result<Watch, DebugError> parseWatch(std::string_view text) {
  const std::size_t mark = text.rfind('@');
  if (mark == std::string_view::npos || !isOperandText(text.substr(0, mark)))
    return misspelt(text);
  Watch watch;
  watch.reg = text.substr(0, mark);
  const char *const begin = text.data() + mark + 1, *const end = text.data() + text.size();
  const auto read = std::from_chars(begin, end, watch.line);
  if (read.ec != std::errc() || read.ptr != end)
    return misspelt(text);
  return watch;
}

Result<Program, DebugError> watchProgram(const Program &program, std::string_view text,
                                         const Watch &watch, Fragments fragments) {
  const std::string option = "--watch " + watch.reg + "@" + std::to_string(watch.line) + ": ";
  const auto row = lastRow(program, text, watch.line);
  if (!row)
    return DebugError{option + "no instruction stands at or before line " +
                      std::to_string(watch.line)};
  if (const auto at = writes(program, text, *row, watch.reg))
    return cutProgram(program, {{Probe::Kind::Value, *at}}, fragments);
  const fp::hw::Profile *const widest = fp::hw::findBuiltin("host");
  const std::string longer = longerText(program, text, *row, watch.reg);
  const fp::CheckResult checked =
      fp::checkProgramIn(longer, fp::programOf(longer, program.language),
                         {limitsOf(*widest, program.language), fp::LimitPolicy::Report});
  if (checked.ok())
    return cutProgram(*checked.program, {{Probe::Kind::Value, *row + 1}}, fragments);
  const fp::Diagnostic &first = checked.diagnostics.front();
  return DebugError{option + first.message + (first.hint.empty() ? "" : " (" + first.hint + ")")};
}

Extent extentOf(const std::vector<fp::ir::Vec4> &values) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  Extent extent{0, {kNan, kNan, kNan, kNan}, {kNan, kNan, kNan, kNan}};
  for (const fp::ir::Vec4 &value : values) {
    if (value == uncovered())
      continue;
    ++extent.covered;
    for (std::size_t c = 0; c < 4; ++c) {
      extent.least[c] = std::fmin(extent.least[c], value[c]); // of a NaN and a number the number
      extent.greatest[c] = std::fmax(extent.greatest[c], value[c]);
    }
  }
  return extent;
}

std::vector<std::uint8_t> picturedValues(const std::vector<fp::ir::Vec4> &values, float low,
                                         float high) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(values.size() * 4);
  for (const fp::ir::Vec4 &value : values) {
    if (value == uncovered()) {
      bytes.insert(bytes.end(), {0, 0, 0, 0});
    } else if (std::any_of(value.begin(), value.begin() + 3,
                           [](float each) { return std::isnan(each); })) {
      bytes.insert(bytes.end(), {255, 0, 255, 255});
    } else {
      std::transform(value.begin(), value.begin() + 3, std::back_inserter(bytes),
                     [&](float each) { return byteOf((each - low) / (high - low)); });
      bytes.push_back(255);
    }
  }
  return bytes;
}

} // namespace arbiter::tools::debug
