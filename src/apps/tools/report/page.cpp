#include "apps/tools/report/page.h"

#include <algorithm>

#include "apps/tools/check/json.h"
#include "apps/tools/check/why.h"
#include "apps/tools/language.h"
#include "apps/tools/page/frame.h"
#include "apps/tools/page/html.h"
#include "apps/tools/report/gauges.h"
#include "apps/tools/report/section.h"
#include "apps/tools/report/slots.h"
#include "fp_compiler/resources.h"

namespace arbiter::tools {

namespace {

/// The number of reasons shown for one count, before "more".
constexpr std::size_t kMaxReasons = 6;

constexpr Column kPageColumns[] = {
    {"name", "program"},
    {"language", "language"},
    {"status", "status"},
    {"fullest", "fullest", true, "The native resource of which it takes the largest part"},
    {"instructions", "instr.", true, "Native instructions"},
    {"alu", "ALU", true, "Native ALU instructions, or slots"},
    {"tex", "TEX", true, "Texture instructions"},
    {"nodes", "nodes", true, "Texture indirections: nodes, phases"},
    {"temps", "temps", true, "Temporaries"},
    {"params", "params", true, "Parameters"},
    {"cycles", "cycles", true, "An estimate for a pixel in one pipe"},
    {"draws", "draws", true, "Draws while it was captured"},
};

std::span<const Column> columnsOf(const ProgramSet &set) {
  return std::span(kPageColumns).first(std::size(kPageColumns) - (set.fromCapture ? 0 : 1));
}

std::string emptyCells(int count) {
  std::string html;
  for (int i = 0; i < count; ++i)
    html += "<td class=n></td>";
  return html;
}

std::string fullestCell(const CheckedFile &file) {
  const Fullest fullest = fullestOf(file);
  if (!*fullest.title)
    return emptyCells(1);
  const std::string percent = decimal(100 * fullest.part());
  return "<td class=n data-v=" + percent + " title=\"" + fullest.title + " " +
         number(fullest.used) + " of " + number(fullest.limit) + "\">" +
         gaugeBar(fullest.used, fullest.limit) + "<span>" +
         number(std::uint64_t(100 * fullest.part())) + "%</span></td>";
}

std::string countCells(const CheckedFile &file) {
  using fp::ResourceCounts;
  std::string html = fullestCell(file);
  for (const auto member : {&ResourceCounts::instructions, &ResourceCounts::aluInstructions,
                            &ResourceCounts::texInstructions, &ResourceCounts::texIndirections,
                            &ResourceCounts::temporaries, &ResourceCounts::parameters}) {
    const std::uint32_t used = file.result.nativeCounts.*member;
    if (!fp::resourceRow(member).of(file.language))
      html += emptyCells(1);
    else if (used > file.limits.native.*member)
      html += "<td class=\"n over\"><b>" + number(used) + "</b></td>";
    else
      html += numberCell(used);
  }
  if (!file.counted() || file.native().cycles.bound.empty())
    return html + emptyCells(1);
  return html + "<td class=n>" + decimal(file.native().cycles.cycles) + "</td>";
}

/// Returns the name in the table. For a captured program it is the start of its hash, with the
/// file name's extension.
std::string shortName(const ProgramSet &set, std::size_t index) {
  const ReportedProgram &program = set.programs[index];
  if (program.captured < 0)
    return program.file.title();
  const CapturedProgram &captured = set.capture.programs[std::size_t(program.captured)];
  return captured.hash.substr(0, 12) + captured.target->extension;
}

std::string row(const ProgramSet &set, std::size_t index) {
  const ReportedProgram &program = set.programs[index];
  const CheckedFile &file = program.file;
  const bool read = program.verdict != Verdict::Unreadable;
  std::string html = std::string("<tr data-s=\"") + word(program.verdict) + "\"><td><a href=\"#" +
                     anchor(index) + "\">" + escaped(shortName(set, index)) + "</a></td>" +
                     cell(read ? languageTitle(file.language, file.source()) : "") +
                     cell(verdictMark(program.verdict));
  html += file.counted() ? countCells(file) : emptyCells(8);
  if (set.fromCapture)
    html += numberCell(set.capture.programs[std::size_t(program.captured)].draws);
  return html + "</tr>\n";
}

std::string tile(std::size_t count, const char *title, const char *kind, const char *status) {
  return std::string("<a class=\"tile ") + kind + "\" href=\"#status=" + status + "\"><b>" +
         number(count) + "</b> " + title + "</a>\n";
}

std::string summary(const ProgramSet &set) {
  const std::size_t fits = set.count(Verdict::Fits), over = set.count(Verdict::Over);
  const std::size_t unreadable = set.count(Verdict::Unreadable);
  std::string html = "<div class=tiles>" + tile(set.programs.size(), "programs", "", "");
  html += "<span class=tile><b>" + number(fits + over) + "</b> valid</span>\n";
  html += tile(fits, "\xE2\x9C\x93 fit", "ok", "fits") +
          tile(over, "\xE2\x96\xB2 do not fit", "over", "does%20not%20fit") +
          tile(set.count(Verdict::Invalid), "\xE2\x9C\x95 invalid", "bad", "invalid");
  if (unreadable != 0)
    html += tile(unreadable, "\xE2\x9C\x95 unreadable", "bad", "unreadable");
  return html + "</div>\n";
}

/// Returns the source of the counts for each language in the set.
std::string modelText(const ProgramSet &set) {
  std::string html;
  for (const LanguageRow &language : languageRows()) {
    const auto program =
        std::find_if(set.programs.begin(), set.programs.end(), [&](const auto &each) {
          return each.file.counted() && each.file.language == language.language;
        });
    if (program == set.programs.end())
      continue;
    html += std::string(" Native counts of ") + (language.header + 2) + " programs are ";
    if (program->file.native().model == fp::NativeModel::Documented)
      html += "the API's, held to documented limits: the chip is not modelled.";
    else
      html +=
          std::string("those of a model of the chip (") + name(program->file.native().model) + ").";
  }
  return html;
}

std::string captureText(const ProgramSet &set) {
  std::string html;
  for (const CapturedProcess &process : set.capture.processes) {
    html += "<p>Captured from process " + number(process.pid) + " <code>" +
            escaped(process.command) + "</code>: " + counted(process.contexts, "context") + ", " +
            counted(process.frames, "frame");
    html += process.complete ? "" : "; it was killed, so its last second may be missing";
    html += "</p>\n";
  }
  return html;
}

/// Returns the largest contributions to one count.
std::string largestReasons(const ProgramSet &set, std::size_t index,
                           const fp::ResourceRow &resource) {
  std::string html;
  std::size_t shown = 0, more = 0;
  for (const fp::hw::Reason &reason : set.programs[index].file.native().reasons) {
    if (reason.resource != resource.member)
      continue;
    if (shown == kMaxReasons) {
      ++more;
      continue;
    }
    ++shown;
    const std::string where = lineLinks(set, index, reason.instructions);
    html += std::string("<li>") + resource.title + ": " + number(reason.amount) + " " +
            escaped(reason.text) + (where.empty() ? "" : " (" + where + ")") + "</li>\n";
  }
  if (more != 0)
    html += "<li>and " + counted(more, "more reason") + ", <a href=\"#" + anchor(index) +
            "\">in its section</a></li>\n";
  return html;
}

/// Returns the reasons for counts over their limit. If there are none, and the API does not refuse
/// the program, returns the reasons for counts at their limit.
std::string misfitReasons(const ProgramSet &set, std::size_t index) {
  const CheckedFile &file = set.programs[index].file;
  std::string over, full;
  for (const fp::ResourceRow &resource : fp::resourceRows()) {
    const std::uint32_t used = file.result.nativeCounts.*resource.member;
    const std::uint32_t limit = file.limits.native.*resource.member;
    if (resource.of(file.language) && used >= limit)
      (used > limit ? over : full) += largestReasons(set, index, resource);
  }
  const std::string &html = over.empty() && !set.programs[index].refused ? full : over;
  return html.empty() ? html : "<ul>" + html + "</ul>";
}

std::string misfits(const ProgramSet &set) {
  if (set.count(Verdict::Over) == 0)
    return {};
  std::string html = "<h2>Programs that do not fit, and why</h2>\n<ul class=misfits>\n";
  for (std::size_t i = 0; i < set.programs.size(); ++i) {
    if (set.programs[i].verdict != Verdict::Over)
      continue;
    std::string what;
    for (const std::string &excess : excesses(set.programs[i]))
      what += (what.empty() ? "" : "; ") + excess;
    html += "<li><a href=\"#" + anchor(i) + "\">" + escaped(set.programs[i].file.title()) +
            "</a>: <span class=over>" + what + "</span>" + misfitReasons(set, i) + "</li>\n";
  }
  return html + "</ul>\n";
}

std::string histograms(const ProgramSet &set) {
  std::string html;
  for (const SlotHistogram &each : slotHistograms(set))
    html += drawing(each.histogram, each.what);
  return html.empty() ? html : "<h2>Native slots</h2>\n<div class=histograms>" + html + "</div>\n";
}

} // namespace

std::string reportPage(const ProgramSet &set) {
  std::string html = pageHead("Programs of " + set.source + " under " + set.profile.name);
  html += "<h1>Programs of " + escaped(set.source) + "</h1>\n<p>Profile <b>" +
          escaped(set.profile.name) + "</b>: " + escaped(set.profile.description) + "." +
          modelText(set) + "</p>\n" + captureText(set) + summary(set);
  for (const std::string &fault : set.faults)
    html += "<p class=bad>" + escaped(fault) + "</p>\n";
  html += "<h2>All programs</h2>\n" + sortableTable(columnsOf(set));
  for (std::size_t i = 0; i < set.programs.size(); ++i)
    html += row(set, i);
  html += kSortableTableEnd;
  html += histograms(set) + misfits(set);
  html += "<h2>Program by program</h2>\n<p hidden data-script><button type=button data-open=all>"
          "Open all that are shown</button> <button type=button data-open=\"\">Close all</button>"
          "</p>\n";
  for (std::size_t i = 0; i < set.programs.size(); ++i)
    html += programSection(set, i);
  return html + pageFoot();
}

} // namespace arbiter::tools
