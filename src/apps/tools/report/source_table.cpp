#include "apps/tools/report/source_table.h"

#include <algorithm>

#include "apps/tools/check/why.h"
#include "apps/tools/page/html.h"
#include "apps/tools/report/line_costs.h"

namespace arbiter::tools {

namespace {

using fp::Diagnostic;
using fp::Severity;

/// Returns a cell such as "1.5", "gone" or "1 (2 gone)". A bar shows its share of the most
/// expensive line.
std::string slotsCell(const LineCost &cost, double dearest) {
  if (cost.instructions == 0)
    return "<td></td>";
  if (cost.gone == cost.instructions)
    return "<td>gone</td>";
  std::string html = "<td";
  if (cost.slots > 0)
    html += " style=\"--c:" + decimal(100 * cost.slots / dearest) + "%\"";
  html += ">";
  if (cost.slots > 0 || cost.textures == 0) // a sample takes no slot, so that 0 is not shown
    html += decimal(cost.slots);
  if (cost.gone != 0)
    html += " (" + number(cost.gone) + " gone)";
  return html + "</td>";
}

std::string nodeCell(const LineCost &cost) {
  if (cost.instructions == cost.gone)
    return "<td></td>";
  std::string html = number(cost.firstNode + 1);
  if (cost.lastNode != cost.firstNode)
    html += "\xE2\x80\x93" + number(cost.lastNode + 1);
  return cell(html);
}

/// The columns between a line's number and its text.
struct Columns {
  bool costs = false, nodes = false;
  double dearest = 0; ///< slots of the most expensive line

  [[nodiscard]] std::string head() const;
  [[nodiscard]] std::string cells(const LineCost &cost) const;
  [[nodiscard]] int count() const { return 1 + (costs ? 2 : 0) + (nodes ? 1 : 0); }
};

std::string Columns::head() const {
  std::string html = costs ? "<table class=\"source priced\">" : "<table class=source>";
  html += "<thead><tr><th scope=col>line</th>";
  html += costs ? "<th scope=col>slots</th><th scope=col>TEX</th>" : "";
  html += nodes ? "<th scope=col>node</th>" : "";
  return html + "<th scope=col>source</th></tr></thead><tbody>\n";
}

std::string Columns::cells(const LineCost &cost) const {
  std::string html;
  if (costs)
    html += slotsCell(cost, dearest) + cell(cost.textures ? number(cost.textures) : std::string());
  if (nodes)
    html += nodeCell(cost);
  return html;
}

/// Returns a row below the line: carets under the bytes, the message, the hint.
std::string diagnosticRow(const Diagnostic &diagnostic, std::string_view line, std::uint32_t column,
                          const Columns &columns) {
  const std::size_t room = line.size() - std::min<std::size_t>(line.size(), column - 1);
  const std::size_t wide = std::min<std::size_t>(diagnostic.span.end - diagnostic.span.begin, room);
  const bool error = diagnostic.severity == Severity::Error;
  std::string html = std::string("<tr class=\"diagnostic ") + (error ? "bad" : "over") + "\"><td";
  html += columns.costs ? " colspan=" + number(std::uint64_t(columns.count())) : "";
  html += "></td><td>" + caretIndent(line, column) + "^" +
          std::string(wide > 1 ? wide - 1 : 0, '~') + "\n" + severityName(diagnostic.severity) +
          ": " + escaped(diagnostic.message) + " [" + diagnostic.id + "]";
  if (!diagnostic.hint.empty())
    html += "\nhint: " + escaped(diagnostic.hint);
  return html + "</td></tr>\n";
}

} // namespace

std::string sourceTable(const CheckedFile &file, const std::string &prefix) {
  const SourceText source(file.text);
  std::vector<LineCost> costs;
  if (file.counted())
    costs = lineCosts(source, *file.result.program, file.native());
  Columns columns;
  columns.costs = !costs.empty();
  columns.nodes = columns.costs && !file.native().nodes.empty();
  for (const LineCost &cost : costs)
    columns.dearest = std::max(columns.dearest, cost.slots);

  std::vector<std::pair<fp::LineColumn, const Diagnostic *>> places;
  std::vector<std::string_view> lines = linesOf(file.text);
  for (const Diagnostic &diagnostic : file.result.diagnostics) {
    places.emplace_back(source.at(diagnostic.span.begin), &diagnostic);
    lines.resize(std::max<std::size_t>(lines.size(), places.back().first.line));
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const auto &a, const auto &b) { return a.first.line < b.first.line; });

  std::string html = columns.head();
  auto place = places.begin();
  const std::size_t first = file.hasSiblings ? source.at(file.part->begin).line - 1 : 0;
  if (file.hasSiblings)
    lines.resize(std::min<std::size_t>(lines.size(), source.at(file.part->end).line));
  for (std::size_t i = first; i < lines.size(); ++i) {
    const LineCost cost = i < costs.size() ? costs[i] : LineCost{};
    html += "<tr id=" + prefix + "-" + number(i + 1);
    html += cost.instructions != 0 && cost.gone == cost.instructions ? " class=gone>" : ">";
    html += cell(number(i + 1)) + columns.cells(cost) + cell(escaped(lines[i])) + "</tr>\n";
    for (; place != places.end() && place->first.line == i + 1; ++place)
      html += diagnosticRow(*place->second, lines[i], place->first.column, columns);
  }
  return html + "</tbody></table>\n";
}

} // namespace arbiter::tools
