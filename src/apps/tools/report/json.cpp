#include "apps/tools/report/json.h"

#include <GL/arbiter.h>

#include "apps/tools/check/json.h"
#include "apps/tools/check/source_text.h"
#include "apps/tools/language.h"
#include "apps/tools/report/line_costs.h"
#include "apps/tools/report/slots.h"

namespace arbiter::tools {

namespace {

void writeSummary(JsonWriter &json, const ProgramSet &set) {
  const auto count = [&](FileStatus status, Verdict verdict) {
    json.key(name(status)).value(std::uint64_t(set.count(verdict)));
  };
  json.key("summary").beginObject();
  json.key("programs").value(std::uint64_t(set.programs.size()));
  count(FileStatus::Valid, Verdict::Fits);
  count(FileStatus::OverNative, Verdict::Over);
  count(FileStatus::Invalid, Verdict::Invalid);
  count(FileStatus::Unreadable, Verdict::Unreadable);
  json.endObject();
}

void writeHistograms(JsonWriter &json, const ProgramSet &set) {
  json.key("histograms").beginArray();
  for (const SlotHistogram &each : slotHistograms(set)) {
    json.beginObject().key("language").value(languageRow(each.language).header + 2);
    json.key("resource").value(each.resource).key("limit").value(each.histogram.limit);
    json.key("bins").beginArray();
    for (const Histogram::Bin &bin : each.histogram.bins) {
      const bool open = each.histogram.open && &bin == &each.histogram.bins.back();
      json.beginObject().key("first").value(bin.first).key("last");
      (open ? json.null() : json.value(bin.last)).key("programs").value(bin.programs).endObject();
    }
    json.endArray().endObject();
  }
  json.endArray();
}

/// Writes the costs of lines on which instructions begin. Requires a model.
void writeLines(JsonWriter &json, const CheckedFile &file) {
  json.key("lines").beginArray();
  const std::vector<LineCost> lines =
      lineCosts(SourceText(file.text), *file.result.program, file.native());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const LineCost &line = lines[i];
    if (line.instructions == 0)
      continue;
    json.beginObject().key("line").value(std::uint64_t(i + 1));
    json.key("instructions").value(line.instructions).key("gone").value(line.gone);
    json.key("slots").value(line.slots).key("textures").value(line.textures);
    json.key("first_node").value(line.firstNode).key("last_node").value(line.lastNode);
    json.endObject();
  }
  json.endArray();
}

void writeCaptured(JsonWriter &json, const CapturedProgram &program) {
  json.key("capture").beginObject();
  json.key("hash").value(program.hash).key("edited").value(program.edited);
  json.key("replaced").value(program.replaced).key("loads").value(program.loads);
  json.key("frames").value(program.frames).key("draws").value(program.draws).endObject();
}

void writeProgram(JsonWriter &json, const ProgramSet &set, const ReportedProgram &program) {
  json.beginObject();
  json.key("name").value(program.file.title());
  json.key("refused").value(program.refused);
  if (program.captured >= 0)
    writeCaptured(json, set.capture.programs[std::size_t(program.captured)]);
  if (program.file.counted())
    writeLines(json, program.file);
  json.key("check");
  writeFile(json, program.file);
  json.endObject();
}

} // namespace

std::string reportJson(const ProgramSet &set) {
  JsonWriter json;
  json.beginObject().key("schema").value(ARBITER_REPORT_SCHEMA);
  json.key("profile").beginObject().key("name").value(set.profile.name);
  json.key("description").value(set.profile.description).endObject();
  json.key("source").value(set.source).key("captured").value(set.fromCapture);
  writeSummary(json, set);
  writeHistograms(json, set);
  json.key("programs").beginArray();
  for (const ReportedProgram &program : set.programs)
    writeProgram(json, set, program);
  json.endArray().key("faults").beginArray();
  for (const std::string &fault : set.faults)
    json.value(fault);
  json.endArray().endObject();
  return json.take();
}

} // namespace arbiter::tools
