#include "tools/capture_page.h"

#include <cstdio>

#include "tools/capture_page_frame.h"
#include "tools/report.h"

namespace arbiter::tools {

namespace {

/// The length of the UTF-8 sequence at the front of `text` (RFC 3629); 0 where there is none.
std::size_t sequenceLength(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80)
    return 1;
  const std::size_t length = lead >= 0xF5   ? 0
                             : lead >= 0xF0 ? 4
                             : lead >= 0xE0 ? 3
                             : lead >= 0xC2 ? 2
                                            : 0;
  if (length == 0 || text.size() < length)
    return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80)
      return 0;
  const bool overlong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
  const bool outside = (lead == 0xED && byte(1) > 0x9F) || (lead == 0xF4 && byte(1) > 0x8F);
  return overlong || outside ? 0 : length;
}

std::string escaped(std::string_view text) {
  std::string html;
  while (!text.empty()) {
    const char c = text.front();
    const std::size_t length = sequenceLength(text);
    const bool control = (c >= 0 && c < 0x20 && c != '\n' && c != '\t') || c == 0x7F;
    if (length == 0 || control) {
      char code[8];
      std::snprintf(code, sizeof code, "\\x%02X", static_cast<unsigned char>(c));
      html += std::string("<i>") + code + "</i>";
    } else if (c == '&') {
      html += "&amp;";
    } else if (c == '<') {
      html += "&lt;";
    } else if (c == '>') {
      html += "&gt;";
    } else if (c == '"') {
      html += "&quot;";
    } else {
      html += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return html;
}

std::string number(std::uint64_t value) { return std::to_string(value); }
std::string cell(const std::string &html) { return "<td>" + html + "</td>"; }
std::string numberCell(std::uint64_t value) { return "<td class=n>" + number(value) + "</td>"; }

const char *verdict(const CapturedProgram &program) {
  if (!program.error.empty())
    return "refused";
  if (!program.counted)
    return "not compiled";
  return program.underNativeLimits ? "native" : "over native limits";
}

/// One row of the table of programs.
std::string summaryRow(const CapturedProgram &program) {
  const bool good = program.error.empty();
  std::string marks = program.edited ? " edited" : "";
  marks += program.replaced ? " replaced" : "";
  return "<tr><td><a href=\"#" + program.file() + "\"><code>" + program.hash.substr(0, 12) +
         "</code></a>" + marks + "</td>" + cell(program.target->word) + numberCell(program.loads) +
         numberCell(program.contexts.size()) + numberCell(program.processes.size()) +
         numberCell(program.frames) + numberCell(program.draws) +
         numberCell(program.counts.instructions) + numberCell(program.counts.aluInstructions) +
         numberCell(program.counts.texInstructions) + numberCell(program.counts.texIndirections) +
         (good ? "<td>" : "<td class=bad>") + verdict(program) + "</td></tr>\n";
}

/// The source, a line a row; the line of the error has a caret under its column.
std::string source(const CapturedProgram &program) {
  const bool marked = !program.error.empty() && program.errorPosition >= 0 && !program.edited;
  const fp::LineColumn place =
      marked ? fp::locate(program.text, std::uint32_t(program.errorPosition)) : fp::LineColumn{};
  std::string html = "<pre class=source>";
  std::string_view rest = program.text;
  for (std::uint32_t line = 1; !rest.empty() || (marked && line <= place.line); ++line) {
    // CR LF, LF and CR each end a line, as the compiler counts them.
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    html += "<span class=line data-n=\"" + number(line) + "\">" + escaped(rest.substr(0, end)) +
            "</span>\n";
    if (marked && line == place.line) {
      std::string indent;
      for (const char c : rest.substr(0, std::min<std::size_t>(place.column - 1, end)))
        indent += c == '\t' ? '\t' : ' ';
      html += "<span class=\"line caret\" data-n=\"\">" + indent + "^</span>\n";
    }
    const bool pair = rest.substr(end, 2) == "\r\n";
    rest.remove_prefix(std::min(end + (pair ? 2 : 1), rest.size()));
  }
  return html + "</pre>\n";
}

std::string countsTable(const CapturedProgram &program) {
  std::string html = "<table><tr><th>resource<th>used<th>native</tr>\n";
  for (const ResourceRow &row : resourceRows())
    if (row.of(program.target->language))
      html += "<tr>" + cell(row.title) + numberCell(program.counts.*row.member) +
              numberCell(program.nativeCounts.*row.member) + "</tr>\n";
  return html + "</table>\n";
}

std::string parameterTable(const CapturedProgram &program) {
  std::string html = "<table><tr><th>parameter at last use<th>x<th>y<th>z<th>w</tr>\n";
  for (const CapturedParameter &parameter : program.parameters) {
    html += "<tr>" + cell("<code>" + escaped(parameter.name) + "</code>");
    for (const double component : parameter.value) {
      char text[48];
      std::snprintf(text, sizeof text, "<td class=n>%.9g</td>", component);
      html += text;
    }
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string textureTable(const CapturedProgram &program) {
  std::string html = "<table><tr><th>unit<th>target<th>texture<th>size<th>format<th>enabled</tr>\n";
  for (const CapturedTexture &texture : program.textures) {
    std::string enabled;
    for (const std::string &name : texture.enabled)
      enabled += (enabled.empty() ? "" : " ") + name;
    html += "<tr>" + numberCell(texture.unit) + cell(escaped(texture.target)) +
            numberCell(texture.name) +
            cell(number(texture.width) + "&times;" + number(texture.height) + "&times;" +
                 number(texture.depth)) +
            cell(escaped(texture.format)) + cell(escaped(enabled)) + "</tr>\n";
  }
  return html + "</table>\n";
}

std::string details(const CapturedProgram &program) {
  std::string html = "<section id=\"" + program.file() + "\"><h2><code>" + program.file() +
                     "</code></h2>\n<p>" + program.target->word + " program, " +
                     number(program.text.size()) + " bytes, " + verdict(program);
  html += program.recorded ? "" : "; its process was killed before it wrote a record";
  html += program.edited ? "; the file was edited since the application loaded it" : "";
  if (!program.path.empty())
    html += "; drawn by " + escaped(program.path);
  html += ". <a href=\"" + program.file() + "\">text</a>";
  if (program.target->language != fp::ir::Language::AtiFragment)
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
  std::string html = kCapturePageHead;
  html += "<h1>" + number(index.programs.size()) + " captured programs</h1>\n";
  for (const CapturedProcess &process : index.processes) {
    html += "<p>process " + number(process.id) + " <code>" + escaped(process.command) +
            "</code>: " + number(process.contexts) + " contexts, " + number(process.frames) +
            " frames, profile " + escaped(process.profile);
    html += process.complete ? "" : "; it was killed, so its last second may be missing";
    html += "</p>\n";
  }
  for (const std::string &fault : index.faults)
    html += "<p class=bad>" + escaped(fault) + "</p>\n";
  html += kCapturePageColumns;
  for (const CapturedProgram &program : index.programs)
    html += summaryRow(program);
  html += "</tbody></table>\n";
  for (const CapturedProgram &program : index.programs)
    html += details(program);
  return html + kCapturePageFoot;
}

} // namespace arbiter::tools
