#include "apps/tools/check/json.h"

#include <GL/arbiter.h>

#include "apps/tools/advise/show.h"
#include "apps/tools/check/source_text.h"
#include "apps/tools/language.h"
#include "fp_compiler/resources.h"
#include "util/hash.h"

namespace arbiter::tools {

namespace {

std::string hexOf(std::string_view bytes) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    text += {kDigits[byte >> 4], kDigits[byte & 15]};
  }
  return text;
}

/// Writes a span's bytes, lines and columns as members of the open object.
void writeSpan(JsonWriter &json, const SourceText &source, fp::Span span) {
  const fp::LineColumn begin = source.at(span.begin);
  const fp::LineColumn end = source.at(span.end);
  json.key("begin").value(span.begin).key("end").value(span.end);
  json.key("line").value(begin.line).key("column").value(begin.column);
  json.key("end_line").value(end.line).key("end_column").value(end.column);
}

void writeDiagnostic(JsonWriter &json, const SourceText &source, const fp::Diagnostic &diagnostic) {
  json.beginObject();
  json.key("severity").value(fp::severityName(diagnostic.severity));
  json.key("id").value(diagnostic.id);
  json.key("message").value(diagnostic.message);
  json.key("hint").value(diagnostic.hint);
  writeSpan(json, source, diagnostic.span);
  json.endObject();
}

void writeCounts(JsonWriter &json, const CheckedFile &file) {
  json.key("under_native_limits").value(file.result.underNativeLimits);
  json.key("counts").beginObject();
  for (const fp::ResourceRow &row : fp::resourceRows()) {
    if (!row.of(file.language))
      continue;
    json.key(row.name).beginObject();
    json.key("used").value(file.result.counts.*row.member);
    json.key("limit").value(file.limits.api.*row.member);
    json.key("native_used").value(file.result.nativeCounts.*row.member);
    json.key("native_limit").value(file.limits.native.*row.member);
    json.endObject();
  }
  json.endObject();
}

/// Writes the "native" object of one file.
class NativeWriter {
public:
  NativeWriter(JsonWriter &json, const CheckedFile &file, const SourceText &source)
      : m_json(json), m_report(file.native()), m_code(file.result.program->code), m_source(source) {
  }

  void write() {
    m_json.beginObject();
    m_json.key("model").value(name(m_report.model));
    m_json.key("fits").value(m_report.fits);
    m_json.key("reasons").beginArray();
    for (const fp::hw::Reason &reason : m_report.reasons)
      writeReason(reason);
    m_json.endArray();
    m_json.key("instructions").beginArray();
    for (std::size_t i = 0; i < m_report.costs.size() && i < m_code.size(); ++i)
      writeCost(std::uint32_t(i), m_report.costs[i]);
    m_json.endArray();
    m_json.key("nodes").beginArray();
    for (const fp::hw::NodeReport &node : m_report.nodes)
      writeNode(node);
    m_json.endArray();
    writePlaces("chain", m_report.chain);
    writeCycles(m_report.cycles);
    m_json.endObject();
  }

private:
  /// Writes an instruction's index, opcode and span as members of the open object.
  void writePlace(std::uint32_t index) {
    m_json.key("index").value(index);
    m_json.key("opcode").value(info(m_code[index].op).mnemonic);
    writeSpan(m_json, m_source, m_code[index].span);
  }

  void writePlaces(const char *key, const std::vector<std::uint32_t> &instructions) {
    m_json.key(key).beginArray();
    for (const std::uint32_t index : instructions) {
      if (index >= m_code.size())
        continue;
      m_json.beginObject();
      writePlace(index);
      m_json.endObject();
    }
    m_json.endArray();
  }

  void writeReason(const fp::hw::Reason &reason) {
    m_json.beginObject();
    m_json.key("resource").value(fp::resourceRow(reason.resource).name);
    m_json.key("amount").value(reason.amount);
    m_json.key("text").value(reason.text);
    writePlaces("instructions", reason.instructions);
    m_json.endObject();
  }

  void writeCost(std::uint32_t index, const fp::hw::InstructionCost &cost) {
    m_json.beginObject();
    writePlace(index);
    m_json.key("slots").value(cost.slots).key("textures").value(cost.textures);
    m_json.key("node").value(cost.node).key("gone").value(cost.gone);
    m_json.endObject();
  }

  void writeNode(const fp::hw::NodeReport &node) {
    m_json.beginObject();
    writePlaces("textures", node.textures);
    m_json.key("pairs").value(node.pairs).key("reason").value(node.reason);
    m_json.endObject();
  }

  void writeCycles(const fp::hw::CycleEstimate &cycles) {
    m_json.key("cycles");
    if (cycles.bound.empty()) {
      m_json.null();
      return;
    }
    m_json.beginObject();
    m_json.key("cycles").value(cycles.cycles).key("bound").value(cycles.bound);
    m_json.key("units").beginObject();
    for (const fp::hw::CycleEstimate::Unit &unit : cycles.units)
      m_json.key(unit.name).value(unit.cycles);
    m_json.endObject();
    m_json.key("limits").value(cycles.limits);
    m_json.endObject();
  }

  JsonWriter &m_json;
  const fp::hw::NativeReport &m_report;
  const std::vector<fp::ir::Instruction> &m_code;
  const SourceText &m_source;
};

/// Returns the error's position in the program's own text, as GL reports it.
int errorPositionOf(const CheckedFile &file) {
  const int position = file.result.errorPosition();
  return position < 0 ? position : position - int(file.program().span.begin);
}

} // namespace

std::string name(fp::NativeModel model) {
  const auto &names = fp::hw::choices()[std::size_t(fp::hw::Choice::FragmentModel)].names;
  return std::string(names[std::size_t(model)]);
}

void writeHead(JsonWriter &json, const fp::hw::Profile &profile) {
  json.key("schema").value(ARBITER_CHECK_SCHEMA);
  json.key("profile").beginObject();
  json.key("name").value(profile.name).key("description").value(profile.description);
  json.endObject();
}

void writeDiagnostics(JsonWriter &json, std::string_view text,
                      const std::vector<fp::Diagnostic> &diagnostics) {
  const SourceText source(text);
  json.key("diagnostics").beginArray();
  for (const fp::Diagnostic &diagnostic : diagnostics)
    writeDiagnostic(json, source, diagnostic);
  json.endArray();
}

void writeFile(JsonWriter &json, const CheckedFile &file, const fp::hw::Profile *profile) {
  json.beginObject();
  json.key("file").value(file.name);
  if (!isUtf8(file.name)) // a script must find files whose names JSON cannot represent
    json.key("file_hex").value(hexOf(file.name));
  if (profile != nullptr)
    json.key("profile").value(profile->name);
  json.key("status").value(name(file.status));
  if (file.status == FileStatus::Unreadable) {
    json.key("fault").value(file.fault).endObject();
    return;
  }
  if (!file.lack().empty())
    json.key("why").value(file.lack());
  const SourceText source(file.text);
  json.key("language").value(languageTitle(file.language, file.source()));
  if (file.part) {
    json.key("begin").value(file.part->begin).key("end").value(file.part->end);
    json.key("line").value(source.at(file.part->begin).line);
  }
  json.key("bytes").value(std::uint64_t(file.source().size()));
  json.key("hash").value(toHex(hashBytes(file.source())));
  json.key("error_position").value(errorPositionOf(file));
  writeDiagnostics(json, file.text, file.result.diagnostics);
  if (file.counted())
    writeCounts(json, file);
  if (file.counted()) {
    json.key("native");
    NativeWriter(json, file, source).write();
  }
  if (file.fixed) {
    json.key("fixed");
    advise::writeFixed(json, *file.fixed);
  }
  if (file.advice) {
    json.key("advice");
    advise::writeAdvice(json, file.text, *file.advice);
  }
  json.endObject();
}

} // namespace arbiter::tools
