#include "apps/tools/report/section.h"

#include <algorithm>

#include "apps/tools/capture_tables.h"
#include "apps/tools/check/source_text.h"
#include "apps/tools/check/why.h"
#include "apps/tools/language.h"
#include "apps/tools/page/html.h"
#include "apps/tools/report/gauges.h"
#include "apps/tools/report/line_costs.h"
#include "apps/tools/report/source_table.h"
#include "fp_compiler/front/words/limit_words.h"
#include "fp_compiler/resources.h"

namespace arbiter::tools {

namespace {

using fp::hw::NativeReport;
using fp::hw::Reason;

constexpr std::size_t kMaxLinks = 24;

/// Writes one program's section.
class Section {
public:
  Section(const ProgramSet &set, std::size_t index)
      : m_set(set), m_program(set.programs[index]), m_file(m_program.file), m_index(index),
        m_source(m_file.text) {}

  [[nodiscard]] std::string html() const;
  [[nodiscard]] std::string links(const std::vector<std::uint32_t> &instructions) const;

private:
  [[nodiscard]] std::string summary() const;
  [[nodiscard]] std::string headline() const;
  [[nodiscard]] std::string reasons() const;
  [[nodiscard]] std::string reasonsOf(const fp::ResourceRow &row) const;
  [[nodiscard]] std::string nodes() const;
  [[nodiscard]] std::string chain() const;
  [[nodiscard]] std::string cycles() const;
  [[nodiscard]] std::string captured() const;
  [[nodiscard]] const NativeReport *native() const {
    return m_file.counted() ? &m_file.native() : nullptr;
  }

  const ProgramSet &m_set;
  const ReportedProgram &m_program;
  const CheckedFile &m_file;
  std::size_t m_index;
  SourceText m_source;
};

std::string Section::links(const std::vector<std::uint32_t> &instructions) const {
  if (!m_file.result.program || instructions.empty())
    return {};
  const auto lines = linesOfInstructions(m_source, *m_file.result.program, instructions);
  std::string html;
  std::size_t ranges = 0;
  for (std::size_t i = 0; i < lines.size(); ++ranges) {
    std::size_t end = i + 1; // consecutive lines become one link
    while (end < lines.size() && lines[end] == lines[end - 1] + 1)
      ++end;
    if (ranges == kMaxLinks)
      return html + " and " + counted(lines.size() - i, "more line");
    html += ranges ? ", " : lines.size() == 1 ? "line " : "lines ";
    html += "<a href=\"#" + anchor(m_index) + "-" + number(lines[i]) + "\">" + number(lines[i]);
    if (end > i + 1)
      html += "\xE2\x80\x93" + number(lines[end - 1]);
    html += "</a>";
    i = end;
  }
  return html;
}

std::string Section::summary() const {
  std::string html =
      "<summary><h3>" + escaped(m_file.title()) + "</h3> " + verdictMark(m_program.verdict);
  for (const std::string &excess : excesses(m_program))
    html += "; " + excess;
  return html + "</summary>\n";
}

std::string Section::headline() const {
  std::string html = "<p>" + languageTitle(m_file.language, m_file.source()) + ", " +
                     counted(m_file.source().size(), "byte");
  if (m_program.captured >= 0) {
    const CapturedProgram &captured = m_set.capture.programs[std::size_t(m_program.captured)];
    html += "; loaded " + counted(captured.loads, "time") + ", " + counted(captured.draws, "draw") +
            " in " + counted(captured.frames, "frame");
    html += captured.edited ? "; the file was edited since the application loaded it" : "";
    html += captured.replaced ? "; another text was drawn in its place" : "";
  }
  return html + "</p>\n";
}

std::string Section::reasonsOf(const fp::ResourceRow &row) const {
  std::string items;
  for (const Reason &reason : native()->reasons) {
    if (reason.resource != row.member)
      continue;
    const std::string where = links(reason.instructions);
    items += "<li><b>" + number(reason.amount) + "</b> " + escaped(reason.text) +
             (where.empty() ? "" : " <span class=faint>(" + where + ")</span>") + "</li>\n";
  }
  if (items.empty())
    return {};
  return std::string("<dt>") + row.title + ": " + number(native()->counts.*row.member) +
         "</dt><dd><ul>" + items + "</ul></dd>\n";
}

std::string Section::reasons() const {
  std::string html;
  for (const fp::ResourceRow &row : fp::resourceRows())
    if (row.of(m_file.language))
      html += reasonsOf(row);
  return html.empty() ? html : "<h4>Why</h4>\n<dl>" + html + "</dl>\n";
}

std::string Section::nodes() const {
  if (native()->nodes.empty())
    return {};
  std::string html = "<h4>Texture nodes</h4>\n<table><thead><tr><th scope=col class=n>node</th>"
                     "<th scope=col class=n>TEX</th><th scope=col class=n>ALU</th>"
                     "<th scope=col>begins because</th></tr></thead><tbody>\n";
  for (std::size_t i = 0; i < native()->nodes.size(); ++i) {
    const fp::hw::NodeReport &node = native()->nodes[i];
    const std::string where = links(node.textures);
    html += "<tr>" + numberCell(i + 1) + "<td class=n>" + number(node.textures.size()) +
            (where.empty() ? "" : " (" + where + ")") + "</td>" + numberCell(node.pairs) +
            cell(node.reason.empty() ? "it is the first" : escaped(node.reason)) + "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string Section::chain() const {
  if (native()->chain.empty())
    return {};
  const auto &code = m_file.result.program->code;
  std::string html = "<h4>Longest chain of dependent reads (" + number(dependentReads(m_file)) +
                     ")</h4>\n<ol class=chain>";
  for (const std::uint32_t i : native()->chain) {
    if (i >= code.size())
      continue;
    const bool sample = info(code[i].op).has(fp::ir::Texture);
    html += std::string(sample ? "<li class=sample>" : "<li>") + "<code>" +
            escaped(m_source.statement(code[i].span, 60)) + "</code> " + links({i});
    if (i < native()->costs.size() && !native()->costs[i].gone)
      html += ", node " + number(native()->costs[i].node + 1);
    html += "</li>\n";
  }
  return html + "</ol>\n";
}

std::string Section::cycles() const {
  const fp::hw::CycleEstimate &estimate = native()->cycles;
  if (estimate.bound.empty())
    return {};
  std::string html = "<h4>Cycles</h4>\n<p>About " + decimal(estimate.cycles) +
                     " a pixel in one pipe, bound by <b>" + escaped(estimate.bound) + "</b>";
  for (std::size_t i = 0; i < estimate.units.size(); ++i)
    html += (i == 0 ? " (" : ", ") + escaped(estimate.units[i].name) + " " +
            decimal(estimate.units[i].cycles);
  html += estimate.units.empty() ? "." : ").";
  if (!estimate.limits.empty())
    html += " <span class=faint>What it assumes and leaves out: " + escaped(estimate.limits) +
            ".</span>";
  return html + "</p>\n";
}

std::string Section::captured() const {
  if (m_program.captured < 0)
    return {};
  const CapturedProgram &program = m_set.capture.programs[std::size_t(m_program.captured)];
  std::string html;
  if (!program.parameters.empty())
    html += parameterTable(program);
  if (!program.textures.empty())
    html += textureTable(program);
  return html;
}

std::string Section::html() const {
  std::string html = "<details class=program id=" + anchor(m_index) + ">" + summary();
  if (m_program.verdict == Verdict::Unreadable)
    return html + "<p class=bad>" + escaped(m_file.fault) + "</p></details>\n";
  html += headline();
  if (m_file.counted())
    html += gaugeTable(m_file);
  if (native())
    html += reasons() + nodes() + chain() + cycles();
  html += "<h4>Source</h4>\n<div class=scroll tabindex=0 role=region aria-label=\"Source\">" +
          sourceTable(m_file, anchor(m_index)) + "</div>\n";
  if (native() && !native()->disassembly.empty())
    html += "<details><summary>Disassembly</summary><pre>" + escaped(native()->disassembly) +
            "</pre></details>\n";
  return html + captured() + "</details>\n";
}

} // namespace

std::string anchor(std::size_t program) { return "p" + number(program + 1); }

std::string verdictMark(Verdict verdict) {
  switch (verdict) {
  case Verdict::Fits:
    return "<span class=ok>\xE2\x9C\x93 fits</span>";
  case Verdict::Over:
    return "<span class=over>\xE2\x96\xB2 does not fit</span>";
  case Verdict::Invalid:
    return "<span class=bad>\xE2\x9C\x95 invalid</span>";
  case Verdict::Unreadable:
    return "<span class=bad>\xE2\x9C\x95 unreadable</span>";
  }
  return "";
}

std::string lineLinks(const ProgramSet &set, std::size_t index,
                      const std::vector<std::uint32_t> &instructions) {
  return Section(set, index).links(instructions);
}

std::vector<std::string> excesses(const ReportedProgram &program) {
  const CheckedFile &file = program.file;
  std::vector<std::string> texts;
  if (program.verdict != Verdict::Over)
    return texts;
  for (const fp::ResourceRow &row : fp::resourceRows()) {
    const std::uint32_t used = file.result.nativeCounts.*row.member;
    const std::uint32_t limit = file.limits.native.*row.member;
    const std::uint32_t apiUsed = file.result.counts.*row.member;
    const std::uint32_t apiLimit = file.limits.api.*row.member;
    const bool overApi = program.refused && apiUsed > apiLimit;
    if (!row.of(file.language) || (used <= limit && !overApi))
      continue;
    std::string text = row.title;
    if (used > limit)
      text += " " + number(used) + " of " + number(limit);
    if (overApi)
      text += " (by the API " + number(apiUsed) + " of " + number(apiLimit) + ")";
    texts.push_back(std::move(text));
  }
  if (!texts.empty())
    return texts;
  // Some options lower a limit. The counts do not show that, but the diagnostic does.
  if (program.refused && !file.result.diagnostics.empty())
    texts.push_back("refused: " +
                    escaped(std::string(fp::exceededLimit(file.result.diagnostics[0].message))));
  else
    texts.emplace_back("no count is over its limit, but the card cannot hold it");
  return texts;
}

std::string programSection(const ProgramSet &set, std::size_t index) {
  return Section(set, index).html();
}

} // namespace arbiter::tools
