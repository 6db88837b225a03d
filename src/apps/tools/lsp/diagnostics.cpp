#include <algorithm>

#include "apps/scene/document.h"
#include "apps/tools/language.h"
#include "apps/tools/lsp/answers.h"
#include "apps/tools/lsp/uri.h"
#include "fp_compiler/resources.h"

namespace arbiter::tools::lsp {

namespace {

/// Limits the displayed reasons and places, because more would hide the text.
constexpr std::size_t kMaxReasons = 24;
constexpr std::size_t kMaxPlaces = 16;

enum Severity { kError = 1, kWarning = 2, kInformation = 3 };

Severity severityOf(fp::Severity severity) {
  switch (severity) {
  case fp::Severity::Error:
    return kError;
  case fp::Severity::Warning:
    return kWarning;
  case fp::Severity::Note:
    break;
  }
  return kInformation;
}

/// Extends a span to whole characters, because the lexer works on bytes and may point within one.
fp::Span wholeCharacters(std::string_view text, fp::Span span) {
  const auto within = [&](std::uint32_t at) {
    return at < text.size() && (std::uint8_t(text[at]) & 0xC0) == 0x80;
  };
  while (span.begin > 0 && within(span.begin))
    --span.begin;
  while (within(span.end))
    ++span.end;
  return span;
}

/// Returns a span that an editor can mark. An empty span becomes the character at it, or the last
/// one before it.
fp::Span visible(const Document &document, fp::Span span) {
  const std::string &text = document.text();
  const auto size = std::uint32_t(text.size());
  span.begin = std::min(span.begin, size);
  span.end = std::clamp(span.end, span.begin, size);
  if (span.begin != span.end)
    return wholeCharacters(text, span);
  if (span.begin < size && text[span.begin] != '\n' && text[span.begin] != '\r')
    return wholeCharacters(text, {span.begin, span.begin + 1});
  const std::size_t last = text.find_last_not_of(" \t\r\n", span.begin == 0 ? 0 : span.begin - 1);
  if (last == std::string::npos)
    return span;
  return wholeCharacters(text, {std::uint32_t(last), std::uint32_t(last) + 1});
}

Json made(const View &view, fp::Span span, Severity severity, std::string code,
          std::string message) {
  return {{"range", view.range(visible(view.document, span))},
          {"severity", int(severity)},
          {"code", std::move(code)},
          {"source", "arbiter"},
          {"message", std::move(message)}};
}

Json related(const View &view, fp::Span span, std::string message) {
  return {{"location", {{"uri", view.document.uri()}, {"range", view.range(span)}}},
          {"message", std::move(message)}};
}

Json ofCompiler(const View &view, const fp::Diagnostic &diagnostic) {
  std::string message = diagnostic.message;
  if (!diagnostic.hint.empty())
    message += "\nhint: " + diagnostic.hint;
  Json json = made(view, diagnostic.span, severityOf(diagnostic.severity), diagnostic.id,
                   std::move(message));
  const fp::Name *name = view.analysis.inspection.names.find(view.document.text(diagnostic.span));
  if (name && name->declared.end != 0 && !(name->declared == diagnostic.span))
    json["relatedInformation"] =
        Json::array({related(view, name->declared, std::string(name->text) + " is declared here")});
  return json;
}

/// Returns the header's line, which gets diagnostics of the whole program.
fp::Span header(const View &view) { return view.headerLine(); }

/// Returns why a resource is over its limit, at the first instruction that causes it. The other
/// instructions become related information. If there are many, the program's header is marked.
Json ofReason(const View &view, const fp::hw::Reason &reason, const std::string &over) {
  const auto &code = view.analysis.inspection.check.program->code;
  const auto spanOf = [&](std::uint32_t at) {
    return at < code.size() ? code[at].span : header(view);
  };
  const bool whole = reason.instructions.empty() || reason.instructions.size() > kMaxPlaces;
  Json json = made(view, whole ? header(view) : spanOf(reason.instructions[0]), kWarning,
                   "over_native", reason.text + ": " + std::to_string(reason.amount) + over);
  Json places = Json::array();
  for (std::size_t i = whole ? 0 : 1; i < std::min(reason.instructions.size(), kMaxPlaces); ++i)
    places.push_back(related(view, spanOf(reason.instructions[i]), reason.text));
  if (!places.empty())
    json["relatedInformation"] = std::move(places);
  return json;
}

/// Adds a warning that says why the card does not run the program itself.
void addLack(const View &view, std::string_view lack, Json &all) {
  all.push_back(made(view, header(view), kWarning, "over_native",
                     view.profile.name + ": " + std::string(lack)));
}

void addNative(const View &view, Json &all) {
  const fp::hw::NativeReport &native = view.analysis.native;
  std::size_t reasons = 0;
  for (const fp::ResourceRow &row : fp::resourceRows()) {
    const std::uint32_t used = native.counts.*row.member;
    const std::uint32_t limit = view.analysis.limits.native.*row.member;
    if (!row.of(view.analysis.language) || used <= limit)
      continue;
    all.push_back(made(view, header(view), kWarning, "over_native",
                       "over the native limit of " + view.profile.name + ": " +
                           std::to_string(used) + " of " + std::to_string(limit) + " " +
                           row.title));
    const std::string over = " of the " + std::to_string(used) + " " + row.title + ", where " +
                             view.profile.name + " has " + std::to_string(limit);
    for (const fp::hw::Reason &reason : native.reasons)
      if (reason.resource == row.member && reasons++ < kMaxReasons)
        all.push_back(ofReason(view, reason, over));
  }
}

} // namespace

Json diagnostics(const View &view) {
  Json all = Json::array();
  const fp::CheckResult &check = view.analysis.inspection.check;
  const bool programs = hasPrograms(view.analysis.limits, view.analysis.language);
  for (const fp::Diagnostic &diagnostic : check.diagnostics)
    if (programs || !isOfLimit(diagnostic))
      all.push_back(ofCompiler(view, diagnostic));
  if (view.analysis.isFirst)
    for (const fp::Diagnostic &diagnostic :
         scene::checkPanel(pathOf(view.document.uri()), view.document.text()))
      all.push_back(ofCompiler(view, diagnostic));
  const bool judged =
      view.analysis.language != fp::ir::Language::AtiFragment && !isNvparse(view.analysis.language);
  const std::string_view lack = lackOf(view.analysis.limits, view.analysis.language);
  if (judged && !lack.empty() && (check.ok() || !programs))
    addLack(view, lack, all);
  else if (judged && check.ok() && !view.analysis.native.fits)
    addNative(view, all);
  return all;
}

} // namespace arbiter::tools::lsp
