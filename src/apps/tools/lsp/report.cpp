#include "apps/tools/check/json.h"
#include "apps/tools/language.h"
#include "apps/tools/lsp/server.h"
#include "fp_compiler/doubts/doubts.h"
#include "util/json.h"

namespace arbiter::tools::lsp {

/// Answers arbiter/report for an editor's gauges, like `arbiter check --json`: the counts, the
/// limits, and reasons for the native counts. The program is the one at the position, or the first
/// fragment program.
Server::Reply Server::reportOf(Document &document, const Json &params) {
  CheckedFile file;
  file.name = document.uri();
  file.text = document.text();
  const fp::hw::Profile &profile = profileOf(document);
  const Json *const position = member(params, {"position"});
  const auto offset = position ? document.map().offset(*position) : std::nullopt;
  const Analysis &analysis = document.analysis(
      profile, offset.value_or(chooseProgram("auto", document.text()).span.begin));
  file.language = analysis.language;
  if (analysis.program.in(file.text).size() != file.text.size()) {
    file.part = analysis.program.span;
    file.hasSiblings = document.analyses(profile).size() > 1;
  }
  file.profile = &profile;
  file.limits = limitsOf(profile, file.language);
  file.result =
      fp::checkProgramIn(file.text, analysis.program, {file.limits, fp::LimitPolicy::Enforce});
  fp::addDoubts(file.text, analysis.program, file.result);
  if (!file.result.ok())
    file.status = FileStatus::Invalid;
  else if (!file.result.underNativeLimits)
    file.status = FileStatus::OverNative;
  JsonWriter json;
  writeFile(json, file, &profile);
  return Json::parse(json.take(), nullptr, false);
}

} // namespace arbiter::tools::lsp
