#include "tools/report.h"

#include <GL/arbiter.h>
#include <cstdio>

#include "tools/language.h"
#include "util/hash.h"
#include "util/json.h"

namespace arbiter::tools {

namespace {

using fp::ResourceCounts;

constexpr ResourceRow kRows[] = {
    {"instructions", "instructions", &ResourceCounts::instructions, true, true},
    {"alu_instructions", "ALU instructions", &ResourceCounts::aluInstructions, true, false},
    {"tex_instructions", "TEX instructions", &ResourceCounts::texInstructions, true, false},
    {"tex_indirections", "TEX indirections", &ResourceCounts::texIndirections, true, false},
    {"temporaries", "temporaries", &ResourceCounts::temporaries, true, true},
    {"parameters", "parameters", &ResourceCounts::parameters, true, true},
    {"attribs", "attribs", &ResourceCounts::attribs, true, true},
    {"address_registers", "address registers", &ResourceCounts::addressRegisters, false, true},
};
static_assert(sizeof(ResourceCounts) == std::size(kRows) * sizeof(std::uint32_t),
              "every resource has its row");

const char *statusName(FileStatus status) {
  switch (status) {
  case FileStatus::Valid:
    return "valid";
  case FileStatus::OverNative:
    return "over-native";
  case FileStatus::Invalid:
    return "invalid";
  case FileStatus::Unreadable:
    return "unreadable";
  }
  return "";
}

const char *severityName(fp::Severity severity) {
  switch (severity) {
  case fp::Severity::Error:
    return "error";
  case fp::Severity::Warning:
    return "warning";
  case fp::Severity::Note:
    return "note";
  }
  return "";
}

std::string countsTable(const CheckedFile &file, const fp::Limits &limits) {
  char line[128];
  std::snprintf(line, sizeof line, "  %-18s%9s%9s%9s%9s\n", "resource", "used", "limit", "native",
                "limit");
  std::string text = line;
  for (const ResourceRow &row : kRows) {
    if (!row.of(file.language))
      continue;
    const std::uint32_t used = file.result.counts.*row.member;
    const std::uint32_t nativeUsed = file.result.nativeCounts.*row.member;
    const char *mark = "";
    if (used > limits.api.*row.member)
      mark = "  over the API limit";
    else if (nativeUsed > limits.native.*row.member)
      mark = "  over the native limit";
    std::snprintf(line, sizeof line, "  %-18s%9u%9u%9u%9u%s\n", row.title, used,
                  limits.api.*row.member, nativeUsed, limits.native.*row.member, mark);
    text += line;
  }
  return text;
}

std::string verdict(const CheckedFile &file, const fp::hw::Profile &profile) {
  switch (file.status) {
  case FileStatus::Valid:
    return "valid, within the native limits of " + profile.name;
  case FileStatus::OverNative:
    return "valid, but over the native limits of " + profile.name;
  case FileStatus::Invalid:
    return "invalid";
  case FileStatus::Unreadable:
    return "unreadable";
  }
  return "";
}

void writeDiagnostic(JsonWriter &json, std::string_view text, const fp::Diagnostic &diagnostic) {
  const fp::LineColumn begin = fp::locate(text, diagnostic.span.begin);
  const fp::LineColumn end = fp::locate(text, diagnostic.span.end);
  json.beginObject();
  json.key("severity").value(severityName(diagnostic.severity));
  json.key("id").value(diagnostic.id);
  json.key("message").value(diagnostic.message);
  json.key("hint").value(diagnostic.hint);
  json.key("offset").value(diagnostic.span.begin);
  json.key("range").beginObject();
  json.key("begin").value(diagnostic.span.begin).key("end").value(diagnostic.span.end);
  json.key("line").value(begin.line).key("column").value(begin.column);
  json.key("end_line").value(end.line).key("end_column").value(end.column);
  json.endObject();
  json.endObject();
}

void writeFile(JsonWriter &json, const CheckedFile &file, const fp::Limits &limits) {
  json.beginObject();
  json.key("file").value(file.name);
  json.key("status").value(statusName(file.status));
  if (file.status == FileStatus::Unreadable) {
    json.key("fault").value(file.fault).endObject();
    return;
  }
  json.key("language").value(languageRow(file.language).header + 2);
  json.key("bytes").value(std::uint64_t(file.text.size()));
  json.key("hash").value(toHex(hashBytes(file.text)));
  json.key("error_position").value(int(file.result.errorPosition()));
  json.key("diagnostics").beginArray();
  for (const fp::Diagnostic &diagnostic : file.result.diagnostics)
    writeDiagnostic(json, file.text, diagnostic);
  json.endArray();
  if (file.status != FileStatus::Invalid) {
    json.key("under_native_limits").value(file.result.underNativeLimits);
    json.key("counts").beginObject();
    for (const ResourceRow &row : kRows) {
      if (!row.of(file.language))
        continue;
      json.key(row.name).beginObject();
      json.key("used").value(file.result.counts.*row.member);
      json.key("limit").value(limits.api.*row.member);
      json.key("native_used").value(file.result.nativeCounts.*row.member);
      json.key("native_limit").value(limits.native.*row.member);
      json.endObject();
    }
    json.endObject();
  }
  json.endObject();
}

} // namespace

std::span<const ResourceRow> resourceRows() { return kRows; }

std::string asText(const CheckedFile &file, const fp::hw::Profile &profile, bool brief) {
  std::string text;
  for (const fp::Diagnostic &diagnostic : file.result.diagnostics) {
    text += brief ? fp::renderLine(file.name, file.text, diagnostic)
                  : fp::render(file.name, file.text, diagnostic);
    if (text.back() != '\n')
      text += '\n';
  }
  if (brief)
    return text;
  text += file.name + ": " + verdict(file, profile) + "\n";
  if (file.status != FileStatus::Invalid)
    text += countsTable(file, limitsOf(profile, file.language));
  return text;
}

std::string asJson(std::span<const CheckedFile> files, const fp::hw::Profile &profile) {
  JsonWriter json;
  json.beginObject();
  json.key("schema").value(ARBITER_CHECK_SCHEMA);
  json.key("profile").beginObject();
  json.key("name").value(profile.name).key("description").value(profile.description);
  json.endObject();
  json.key("files").beginArray();
  for (const CheckedFile &file : files)
    writeFile(json, file, limitsOf(profile, file.language));
  json.endArray().endObject();
  return json.take();
}

} // namespace arbiter::tools
