#include "apps/tools/debug/trace/text.h"

#include <algorithm>
#include <cstdio>

#include "apps/tools/debug/trace/numbers.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::tools::debug {

namespace {

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

std::string lineNumber(std::uint32_t line) {
  char text[16];
  std::snprintf(text, sizeof text, "%5u", line);
  return text;
}

std::string_view nameOf(fp::Numerics numerics) { return fp::kNumericsNames[std::size_t(numerics)]; }

constexpr const char *kIndent = "         ";

std::string flagsText(const Row &row) {
  std::string text;
  for (const FlagName &each : kFlagNames)
    if (row.flags & each.flag)
      text += std::string(text.empty() ? "  [" : ", ") + each.name;
  return text.empty() ? text : text + "]";
}

std::string operandText(const Operand &operand, std::size_t width) {
  std::string text =
      kIndent + padded(operand.text, width) + "  " + vectorText(operand.value.first, operand.reads);
  if (operand.unwritten)
    text += "  (nothing has written " +
            std::string(operand.unwritten == operand.reads ? "it" : "all of it") + ": zero)";
  return text + "\n";
}

std::string texelText(const Texel &texel) {
  std::string text = std::string(kIndent) + "texture[" + std::to_string(texel.unit) + "] " +
                     fp::ir::targetText(texel.target) + " at " +
                     vectorText(texel.coordinate.first, fp::ir::coordinateMask(texel.target));
  if (texel.bias.first != 0)
    text += ", bias " + numberText(texel.bias.first);
  if (texel.lod)
    text += ", level of detail " + numberText(*texel.lod, 3);
  return text + ": " + vectorText(texel.value.first) + "\n";
}

/// Returns a line such as "=> offset.xy = (0.5, 0.25, -, -)   fp24 (..), error 1e-05".
std::string valueText(const Trace &trace, const Row &row) {
  std::string text =
      std::string("      => ") + row.destination + " = " + vectorText(row.value.first, row.mask);
  if (const float error = greatestError(row); error != 0)
    text += "   " + std::string(nameOf(trace.numerics.second)) + " " +
            vectorText(row.value.second, row.mask) + ", error " + numberText(error, 2);
  return text + flagsText(row) + "\n";
}

std::string kilText(const Trace &trace, const Row &row) {
  std::string text = std::string("      => ") + (row.discards.first ? "discarded" : "passed");
  if (row.discards.first != row.discards.second)
    text += std::string("   ") + std::string(nameOf(trace.numerics.second)) + " " +
            (row.discards.second ? "discarded" : "passed");
  return text + flagsText(row) + "\n";
}

std::string rowText(const Trace &trace, const Row &row, bool marked) {
  std::string text = (marked ? ">" : " ") + lineNumber(row.at.line) + "  " + row.text +
                     (row.isDiscarded ? "   (discarded before)" : "") + "\n";
  std::size_t width = 0;
  for (const Operand &operand : row.operands)
    width = std::max(width, operand.text.size());
  for (const Operand &operand : row.operands)
    if (operand.reads)
      text += operandText(operand, width);
  if (row.texel)
    text += texelText(*row.texel);
  return text + (row.mask ? valueText(trace, row) : kilText(trace, row));
}

std::string namedText(const std::vector<Named> &all) {
  std::string text;
  std::size_t width = 0;
  for (const Named &each : all)
    width = std::max(width, each.name.size());
  for (const Named &each : all)
    text += "  " + padded(each.name, width) + "  " + vectorText(each.value.first) + "\n";
  return text;
}

} // namespace

std::string inputsText(const Trace &trace) {
  return namedText(trace.attributes) + namedText(trace.parameters);
}

std::string rowsText(const Trace &trace, const TextOptions &options) {
  std::string text;
  for (std::size_t i = options.from; i < trace.rows.size() && i <= options.to; ++i)
    text += rowText(trace, trace.rows[i], options.marked == i);
  return text;
}

std::string resultsText(const Trace &trace) {
  std::string text;
  for (const Named &result : trace.results) {
    text += "  " + result.name + " = " + vectorText(result.value.first);
    if (result.name.starts_with("result.color"))
      text += "  " + colorText(result.value.first);
    if (result.value.first != result.value.second)
      text += "   " + std::string(nameOf(trace.numerics.second)) + " " +
              vectorText(result.value.second);
    const std::uint8_t missing = std::uint8_t(~result.mask & 0xF);
    if (missing && result.name != "result.depth")
      text += "  (nothing writes " + lettersOf(missing) + ")";
    text += "\n";
  }
  if (trace.isDiscarded.first)
    text += "  the fragment is discarded: this is what it would have been\n";
  return text;
}

} // namespace arbiter::tools::debug
