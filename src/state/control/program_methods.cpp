// program.*: the texts of the process, and what replaces them.
#include <algorithm>
#include <map>

#include "control/base64.h"
#include "fp_compiler/file_programs.h"
#include "fp_compiler/resources.h"
#include "state/control/known_programs.h"
#include "state/control/methods.h"
#include "state/programs/program_edits.h"
#include "state/programs/program_load.h"
#include "state/programs/replacement.h"
#include "state/raster_draw/raster_context.h"
#include "util/json.h"

namespace arbiter::state::control {

namespace {

using wire::Json;

Json countsJson(const fp::ResourceCounts &counts) {
  Json object = Json::object();
  for (const fp::ResourceRow &row : fp::resourceRows())
    object[row.name] = counts.*row.member;
  return object;
}

void addCounts(Json &object, const fp::ResourceCounts &api, const fp::ResourceCounts &native,
               bool underNative) {
  object["counts"] = countsJson(api);
  object["native_counts"] = countsJson(native);
  object["under_native_limits"] = underNative;
}

Json rowJson(Call &call, const KnownProgram &program,
             const std::map<std::string, ProgramTally> &tallies) {
  const CompiledProgram &compiled = *program.compiled;
  std::string edit;
  const bool edited = ProgramEdits::instance().text(program.id, edit);
  Json row = Json::object({{"id", program.id},
                           {"target", infoOf(program.target).word},
                           {"objects", program.objects},
                           {"bound", program.bound},
                           {"effective", program.effective},
                           {"edited", edited},
                           {"replaced", compiled.replaced() && !edited},
                           {"enabled", !ProgramEdits::instance().isOff(program.id)},
                           {"revision", call.session.revisionOf(program.id)},
                           {"bytes", compiled.text.size()}});
  addCounts(row, compiled.counts, compiled.nativeCounts, compiled.underNativeLimits);
  const auto tally = tallies.find(program.id);
  row["draws"] = tally == tallies.end() ? 0 : tally->second.draws;
  row["rasterizer_draws"] = tally == tallies.end() ? 0 : tally->second.rasterized;
  row["milliseconds"] = tally == tallies.end() ? 0.0 : double(tally->second.nanoseconds) * 1e-6;
  return row;
}

wire::Fault unknown(const std::string &id) {
  return {wire::kUnknownName, "there is no program " + id.substr(0, 80), {}};
}

Json diagnosticsJson(std::string_view text, const std::vector<fp::Diagnostic> &diagnostics) {
  Json rows = Json::array();
  for (const fp::Diagnostic &each : diagnostics) {
    const fp::LineColumn at = fp::locate(text, each.span.begin);
    rows.push_back({{"severity", fp::severityName(each.severity)},
                    {"id", each.id},
                    {"message", each.message},
                    {"hint", each.hint},
                    {"begin", each.span.begin},
                    {"end", each.span.end},
                    {"line", at.line},
                    {"column", at.column}});
  }
  return rows;
}

} // namespace

wire::Answer programList(Call &call) {
  const auto tallies = call.session.tallies().all();
  Json rows = Json::array();
  for (const auto &[id, program] : knownPrograms(call.session, call.context))
    rows.push_back(rowJson(call, program, tallies));
  return Json::object({{"programs", std::move(rows)}});
}

wire::Answer programGet(Call &call) {
  const std::string id = call.params.text("id");
  if (!call.params.ok())
    return call.params.fault();
  const std::optional<KnownProgram> program = findProgram(call.session, call.context, id);
  if (!program)
    return unknown(id);
  Json row = rowJson(call, *program, call.session.tallies().all());
  const std::string &text = program->compiled->text;
  row["text"] = text;
  if (!isUtf8(text)) // JSON holds no other bytes
    row["text_base64"] =
        wire::toBase64({reinterpret_cast<const std::uint8_t *>(text.data()), text.size()});
  row["edit"] = nullptr;
  if (program->compiled->replaced())
    row["edit"] = program->compiled->replacement;
  return row;
}

wire::Answer programSet(Call &call) {
  const std::string id = call.params.text("id");
  const std::string text = call.params.text("text");
  const std::int64_t revision = call.params.integer("revision", 1, std::int64_t(1) << 53);
  if (!call.params.ok())
    return call.params.fault();
  const std::optional<KnownProgram> program = findProgram(call.session, call.context, id);
  if (!program)
    return unknown(id);
  std::int64_t &last = call.session.revisionOf(id);
  if (revision <= last)
    return wire::Fault{wire::kOldRevision, "revision " + std::to_string(last) + " is there already",
                       Json::object({{"revision", last}})};
  last = revision;
  const fp::FileProgram meant = fp::programOf(text, infoOf(program->target).language);
  const fp::CheckResult result =
      fp::checkProgramIn(text, meant, compileOptions(call.context.row(program->target)));
  Json answer = Json::object({{"ok", result.ok()},
                              {"revision", revision},
                              {"diagnostics", diagnosticsJson(text, result.diagnostics)}});
  if (!result.ok())
    return answer;
  addCounts(answer, result.counts, result.nativeCounts, result.underNativeLimits);
  ProgramEdits::instance().setText(id, text);
  refreshReplacements(call.context);
  return answer;
}

wire::Answer programReset(Call &call) {
  std::size_t count = 0;
  if (call.params.has("id")) {
    const std::string id = call.params.text("id");
    if (!call.params.ok())
      return call.params.fault();
    count = ProgramEdits::instance().resetText(id) ? 1 : 0;
  } else {
    count = ProgramEdits::instance().resetTexts();
  }
  refreshReplacements(call.context);
  return Json::object({{"count", count}});
}

wire::Answer programEnable(Call &call) {
  const std::string id = call.params.text("id");
  const bool enabled = call.params.truth("enabled");
  if (!call.params.ok())
    return call.params.fault();
  if (!findProgram(call.session, call.context, id))
    return unknown(id);
  ProgramEdits::instance().setEnabled(id, enabled);
  refreshReplacements(call.context);
  return Json::object();
}

} // namespace arbiter::state::control
