#include "apps/tools/capture_page.h"

#include <algorithm>

#include "apps/tools/capture_tables.h"
#include "apps/tools/page/frame.h"
#include "apps/tools/page/html.h"
#include "fp_compiler/resources.h"

namespace arbiter::tools {

namespace {

constexpr Column kColumns[] = {
    {"program", "program"},
    {"target", "target"},
    {"loads", "loads", true},
    {"contexts", "contexts", true},
    {"processes", "processes", true},
    {"frames", "frames", true},
    {"draws", "draws", true},
    {"instructions", "instructions", true},
    {"alu", "ALU", true},
    {"tex", "TEX", true},
    {"nodes", "indirections", true},
    {"status", "verdict"},
};

const char *verdict(const CapturedProgram &program) {
  if (!program.error.empty())
    return "refused";
  if (!program.counted)
    return "not compiled";
  return program.underNativeLimits ? "native" : "over native limits";
}

/// Returns one row of the table of programs.
std::string summaryRow(const CapturedProgram &program) {
  const bool good = program.error.empty();
  std::string marks = program.edited ? " edited" : "";
  marks += program.replaced ? " replaced" : "";
  return std::string("<tr data-s=\"") + verdict(program) + "\"><td><a href=\"#" + program.file() +
         "\"><code>" + program.hash.substr(0, 12) + "</code></a>" + marks + "</td>" +
         cell(program.target->word) + numberCell(program.loads) +
         numberCell(program.contextCount()) + numberCell(program.processes.size()) +
         numberCell(program.frames) + numberCell(program.draws) +
         numberCell(program.counts.instructions) + numberCell(program.counts.aluInstructions) +
         numberCell(program.counts.texInstructions) + numberCell(program.counts.texIndirections) +
         (good ? "<td>" : "<td class=bad>") + verdict(program) + "</td></tr>\n";
}

/// Returns the source, one line per row; a caret marks the column of the error.
std::string source(const CapturedProgram &program) {
  const bool marked = !program.error.empty() && program.errorPosition >= 0 && !program.edited;
  const fp::LineColumn place =
      marked ? fp::locate(program.text, std::uint32_t(program.errorPosition)) : fp::LineColumn{};
  std::vector<std::string_view> lines = linesOf(program.text);
  if (marked) // an error of the whole program may lie after the last line
    lines.resize(std::max<std::size_t>(lines.size(), place.line));
  std::string html = "<pre class=source>";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    html += "<span class=line data-n=\"" + number(i + 1) + "\">" + escaped(lines[i]) + "</span>\n";
    if (marked && i + 1 == place.line)
      html += "<span class=\"line caret\" data-n=\"\">" + caretIndent(lines[i], place.column) +
              "^</span>\n";
  }
  return html + "</pre>\n";
}

std::string countsTable(const CapturedProgram &program) {
  std::string html = "<table><tr><th>resource</th><th>used</th><th>native</th></tr>\n";
  for (const fp::ResourceRow &row : fp::resourceRows())
    if (row.of(program.target->language))
      html += "<tr>" + cell(row.title) + numberCell(program.counts.*row.member) +
              numberCell(program.nativeCounts.*row.member) + "</tr>\n";
  return html + "</table>\n";
}

std::string details(const CapturedProgram &program) {
  std::string html = "<section id=\"" + program.file() + "\"><h2><code>" + program.file() +
                     "</code></h2>\n<p>" + program.target->word + " program, " +
                     number(program.text.size()) + " bytes, " + verdict(program);
  html += program.recorded ? "" : "; its process was killed before it wrote a record";
  html += program.edited ? "; the file was edited since the application loaded it" : "";
  if (const std::string path = program.path(); !path.empty())
    html += "; drawn by " + escaped(path);
  html += ". <a href=\"" + program.file() + "\">text</a>";
  if (program.target->language != fp::ir::Language::AtiFragment &&
      !isNvparse(program.target->language))
    html += " <a href=\"" + program.file() + ".shader_test\">shader_test</a>";
  html += "</p>\n";
  if (!program.options.empty()) {
    html += "<p>options:";
    for (const std::string &option : program.options)
      html += " <code>" + escaped(option) + "</code>";
    html += "</p>\n";
  }
  if (!program.error.empty())
    html += "<pre class=bad>" + escaped(program.error) + "</pre>\n";
  if (!program.warning.empty())
    html += "<pre>" + escaped(program.warning) + "</pre>\n";
  html += source(program);
  if (program.counted)
    html += countsTable(program);
  if (!program.parameters.empty())
    html += parameterTable(program);
  if (!program.textures.empty())
    html += textureTable(program);
  if (!program.glsl.empty())
    html += "<details><summary>GLSL</summary><pre>" + escaped(program.glsl) + "</pre></details>\n";
  return html + "</section>\n";
}

} // namespace

std::string indexPage(const CaptureIndex &index) {
  std::string html = pageHead("Captured programs");
  html += "<h1>" + counted(index.programs.size(), "captured program") + "</h1>\n";
  for (const CapturedProcess &process : index.processes) {
    html += "<p>process " + number(process.pid) + " <code>" + escaped(process.command) +
            "</code>: " + number(process.contexts) + " contexts, " + number(process.frames) +
            " frames, profile " + escaped(process.profile);
    html += "</p>\n";
  }
  for (const std::string &missing : whatIsMissing(index))
    html += "<p class=bad>" + escaped(missing) + "</p>\n";
  for (const std::string &fault : index.faults)
    html += "<p class=bad>" + escaped(fault) + "</p>\n";
  html += sortableTable(kColumns);
  for (const CapturedProgram &program : index.programs)
    html += summaryRow(program);
  html += kSortableTableEnd;
  for (const CapturedProgram &program : index.programs)
    html += details(program);
  return html + pageFoot();
}

} // namespace arbiter::tools
