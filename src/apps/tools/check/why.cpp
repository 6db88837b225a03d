#include "apps/tools/check/why.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "apps/tools/check/json.h"
#include "fp_compiler/resources.h"

namespace arbiter::tools {

namespace {

/// Limits of the output without --why, which fits on a screen and shows the main causes.
constexpr std::size_t kReasons = 8;
constexpr std::size_t kInstructions = 3;
constexpr std::size_t kStatementBytes = 60;

std::string counted(std::size_t count, const char *one, const char *many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

template <typename... Values> std::string format(const char *pattern, Values... values) {
  char text[160];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

/// Wraps the text into lines of at most kWidth columns, indented by four.
std::string wrapped(std::string_view text) {
  constexpr std::size_t kWidth = 96;
  std::string lines;
  std::size_t column = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (column == 0 || column + 1 + end > kWidth) {
      lines += column == 0 ? "    " : "\n    ";
      column = 4 + end;
    } else {
      lines += ' ';
      column += 1 + end;
    }
    lines += text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return column == 0 ? lines : lines + "\n";
}

} // namespace

std::string decimal(double number) {
  const double tenths = std::round(number * 10) / 10;
  return format(tenths == std::floor(tenths) ? "%.0f" : "%.1f", tenths);
}

std::uint32_t dependentReads(const CheckedFile &file) {
  const fp::ir::Program &program = *file.result.program;
  const auto samples = std::count_if(
      file.native().chain.begin(), file.native().chain.end(), [&](std::uint32_t index) {
        return index < program.code.size() && info(program.code[index].op).has(fp::ir::Texture);
      });
  return std::uint32_t(std::max<std::ptrdiff_t>(samples - 1, 0));
}

Why::Why(const CheckedFile &file, const Style &style, bool all)
    : m_file(file), m_report(file.native()), m_source(file.text), m_style(style), m_all(all) {}

/// Returns a line such as "  14 | TEX r0, fragment.texcoord[0], texture[0], 2D".
std::string Why::place(std::uint32_t instruction) const {
  const auto &code = m_file.result.program->code;
  if (instruction >= code.size())
    return {};
  const fp::Span span = code[instruction].span;
  const std::string text = span.begin < span.end ? m_source.statement(span, kStatementBytes)
                                                 : info(code[instruction].op).mnemonic;
  return painted(format("%5u %s ", m_source.at(span.begin).line, m_style.blocks ? "│" : "|"),
                 Color::Dim, m_style) +
         text;
}

std::string Why::lines(const std::vector<std::uint32_t> &instructions) const {
  std::string text;
  const std::size_t shown =
      m_all || instructions.size() <= kInstructions + 1 ? instructions.size() : kInstructions;
  for (std::size_t i = 0; i < shown; ++i)
    text += "        " + place(instructions[i]) + "\n";
  if (shown < instructions.size())
    text += "              and " + std::to_string(instructions.size() - shown) + " more (--why)\n";
  return text;
}

std::string Why::reasons(const fp::ResourceRow &row) const {
  std::string text;
  std::size_t count = 0;
  for (const fp::hw::Reason &reason : m_report.reasons) {
    if (reason.resource != row.member)
      continue;
    if (++count <= kReasons || m_all)
      text += format("%8u  ", reason.amount) + reason.text + "\n" + lines(reason.instructions);
  }
  if (count > kReasons && !m_all)
    text += "          and " + counted(count - kReasons, "reason", "reasons") + " more (--why)\n";
  return text;
}

std::string Why::headline() const {
  if (isNvparse(m_file.language))
    return "  native: the limits are those of the card's combiners and texture shaders\n";
  if (m_file.language == fp::ir::Language::AtiFragment)
    return "  native: the limits are those of the language; what loads fits\n";
  if (m_report.model == fp::NativeModel::Documented)
    return "  native: documented, not modelled: the card's limits, the counts of the API\n";
  std::string text;
  const auto add = [&](const std::string &part) { text += (text.empty() ? "" : ", ") + part; };
  if (!m_report.nodes.empty())
    add(counted(m_report.nodes.size(), "texture node", "texture nodes"));
  if (const std::uint32_t reads = dependentReads(m_file); reads != 0)
    add(counted(reads, "dependent read", "dependent reads"));
  if (!m_report.cycles.bound.empty())
    add("about " + decimal(m_report.cycles.cycles) + " cycles a pixel, bound by " +
        m_report.cycles.bound);
  return "  native: modelled (" + name(m_report.model) + ")" + (text.empty() ? "" : ": " + text) +
         "\n";
}

std::string Why::chain() const {
  if (m_report.chain.empty())
    return {};
  const auto &code = m_file.result.program->code;
  std::string text = "  the longest chain of dependent reads (" +
                     counted(dependentReads(m_file), "read", "reads") + "):\n";
  for (const std::uint32_t index : m_report.chain) {
    const bool sample = index < code.size() && info(code[index].op).has(fp::ir::Texture);
    const bool node = sample && !m_report.nodes.empty() && index < m_report.costs.size();
    const char *mark = m_style.blocks ? (sample ? "◆" : "│") : (sample ? "*" : "|");
    if (!m_report.nodes.empty())
      text += node ? format("    node %-2u ", m_report.costs[index].node + 1) : "            ";
    else
      text += "    ";
    text += std::string(mark) + " " + place(index) + "\n";
  }
  return text;
}

std::string Why::nodes() const {
  if (m_report.nodes.empty())
    return {};
  std::string text = "  texture nodes:\n";
  for (std::size_t i = 0; i < m_report.nodes.size(); ++i) {
    const fp::hw::NodeReport &node = m_report.nodes[i];
    text += format("%5zu   ", i + 1) + std::to_string(node.textures.size()) + " TEX, " +
            counted(node.pairs, "ALU pair", "ALU pairs") +
            (node.reason.empty() ? "" : ": " + node.reason) + "\n" + lines(node.textures);
  }
  return text;
}

std::string Why::cycles() const {
  const fp::hw::CycleEstimate &estimate = m_report.cycles;
  if (estimate.bound.empty())
    return {};
  std::string units;
  for (const fp::hw::CycleEstimate::Unit &unit : estimate.units)
    units += (units.empty() ? "" : ", ") + unit.name + " " + decimal(unit.cycles);
  std::string text = "  cycles: about " + decimal(estimate.cycles) + " a pixel in one pipe" +
                     (units.empty() ? "" : " (" + units + ")") + ", bound by " + estimate.bound +
                     "\n";
  return text + wrapped(estimate.limits);
}

std::string Why::costs() const {
  if (m_report.costs.empty())
    return {};
  const bool nodes = !m_report.nodes.empty();
  std::string text =
      std::string("  each instruction:\n   slots  TEX") + (nodes ? "  node\n" : "\n");
  for (std::size_t i = 0; i < m_report.costs.size(); ++i) {
    const fp::hw::InstructionCost &cost = m_report.costs[i];
    text +=
        cost.gone ? "       -    -" : format("%8s%5u", decimal(cost.slots).c_str(), cost.textures);
    if (nodes)
      text += cost.gone ? "     -" : format("%6u", cost.node + 1);
    text += " " + place(std::uint32_t(i)) + (cost.gone ? "  (nothing is left of it)" : "") + "\n";
  }
  return text;
}

} // namespace arbiter::tools
