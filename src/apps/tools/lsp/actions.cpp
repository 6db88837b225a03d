#include "apps/tools/lsp/actions.h"

#include <algorithm>

namespace arbiter::tools::lsp {

namespace {

constexpr const char *kQuickFix = "quickfix";
constexpr const char *kRewrite = "refactor.rewrite";

bool touches(fp::Span a, fp::Span b) { return a.begin <= b.end && b.begin <= a.end; }

Json textEdits(const View &view, const advise::Edits &edits) {
  Json all = Json::array();
  for (const advise::Edit &edit : edits)
    all.push_back({{"range", view.range(edit.span)}, {"newText", edit.text}});
  return all;
}

Json workspaceEdit(const View &view, Json edits) {
  Json changes = Json::object();
  changes[view.document.uri()] = std::move(edits);
  return Json{{"changes", std::move(changes)}};
}

Json costOf(const advise::Cost &cost) {
  return {{"alu", cost.alu}, {"tex", cost.tex}, {"nodes", cost.nodes}, {"fits", cost.fits}};
}

std::string titleOf(const View &view, const advise::Advice &advice) {
  return advice.message + " (" + view.profile.name + ": " +
         advise::changeText(advice.before, advice.after) + ")";
}

/// Returns the name that a compiler's hint suggests, or "".
std::string_view meantName(std::string_view hint) {
  constexpr std::string_view kBegin = "did you mean '", kEnd = "'?";
  if (!hint.starts_with(kBegin) || !hint.ends_with(kEnd))
    return {};
  return hint.substr(kBegin.size(), hint.size() - kBegin.size() - kEnd.size());
}

/// Returns the published diagnostic with that id, which the editor marks as fixed by the action.
Json publishedAt(const View &view, fp::Span span, std::string_view id) {
  const Json range = view.range(span);
  Json found = Json::array();
  for (const Json &each : diagnostics(view))
    if (each["code"] == id && each["range"] == range)
      found.push_back(each);
  return found;
}

void addSpellings(const View &view, const ActionRequest &request, Json &actions) {
  for (const fp::Diagnostic &each : view.analysis.inspection.check.diagnostics) {
    const std::string_view meant = meantName(each.hint);
    if (meant.empty() || !touches(each.span, request.span))
      continue;
    Json edit = {{"range", view.range(each.span)}, {"newText", std::string(meant)}};
    actions.push_back({{"title", "Change to '" + std::string(meant) + "'"},
                       {"kind", kQuickFix},
                       {"isPreferred", true},
                       {"diagnostics", publishedAt(view, each.span, each.id)},
                       {"edit", workspaceEdit(view, Json::array({std::move(edit)}))}});
  }
}

Json fixOf(const View &view, const advise::Advice &advice) {
  return {{"title", titleOf(view, advice)},
          {"kind", kQuickFix},
          {"edit", workspaceEdit(view, textEdits(view, advice.edits))}};
}

Json disabled(const View &view, const advise::Advice &advice) {
  const std::string reason = advice.application.empty()
                                 ? "holds only if " + advice.condition
                                 : "only if the application " + advice.application;
  return {{"title", titleOf(view, advice)}, {"kind", kRewrite}, {"disabled", {{"reason", reason}}}};
}

} // namespace

bool ActionRequest::wants(std::string_view kind) const {
  // A kind includes all its subkinds, which follow after a dot.
  return only.empty() || std::any_of(only.begin(), only.end(), [&](const std::string &each) {
           return each.empty() || kind == each || kind.starts_with(each + ".");
         });
}

Json codeActions(const View &view, const std::vector<advise::Advice> &advice,
                 const ActionRequest &request) {
  Json actions = Json::array();
  if (request.wants(kQuickFix))
    addSpellings(view, request, actions);
  bool near = false;
  for (const advise::Advice &each : advice) {
    if (!touches(each.span, request.span))
      continue;
    near = near || each.isFix();
    if (each.isFix() && request.wants(kQuickFix))
      actions.push_back(fixOf(view, each));
    if (!each.isFix() && request.showsDisabled && request.wants(kRewrite))
      actions.push_back(disabled(view, each));
  }
  if (near && request.wants(kRewrite))
    actions.push_back({{"title", "Make every fix that costs less on " + view.profile.name},
                       {"kind", kRewrite},
                       {"data", {{"uri", view.document.uri()}}}});
  return actions;
}

namespace {
/// Adds the TextEdit that makes every fix of one program, if there is any.
void addFixes(const View &view, Json &edits) {
  const std::string_view text = view.source();
  const std::uint32_t place = view.analysis.program.span.begin;
  const advise::Fixed fixed =
      advise::applyAll(text, {view.analysis.language, view.analysis.limits});
  // The edit leaves the common start and end of both texts, so that an editor keeps its positions
  // there.
  const std::size_t shorter = std::min(text.size(), fixed.text.size());
  std::size_t begin = 0, end = 0;
  while (begin < shorter && text[begin] == fixed.text[begin])
    ++begin;
  while (end < shorter - begin &&
         text[text.size() - 1 - end] == fixed.text[fixed.text.size() - 1 - end])
    ++end;
  const auto inside = [&](std::size_t at) {
    return at < text.size() && (std::uint8_t(text[at]) & 0xC0) == 0x80;
  };
  while (begin > 0 && inside(begin))
    --begin;
  while (end > 0 && inside(text.size() - end))
    --end;
  if (fixed.applied.empty())
    return;
  const fp::Span span = {place + std::uint32_t(begin), place + std::uint32_t(text.size() - end)};
  edits.push_back({{"range", view.range(span)},
                   {"newText", fixed.text.substr(begin, fixed.text.size() - end - begin)}});
}
} // namespace

Json everyFix(const Views &views) {
  Json edits = Json::array();
  for (const View &view : views)
    addFixes(view, edits);
  return workspaceEdit(views.front(), std::move(edits));
}

Json adviceList(const View &view, const std::vector<advise::Advice> &advice) {
  Json all = Json::array();
  for (const advise::Advice &each : advice)
    all.push_back({{"rule", each.rule},
                   {"message", each.message},
                   {"range", view.range(each.span)},
                   {"before", costOf(each.before)},
                   {"after", costOf(each.after)},
                   {"fix", each.isFix()},
                   {"exact", each.nearness == advise::Nearness::Exact},
                   {"application", each.application},
                   {"condition", each.condition},
                   {"edits", textEdits(view, each.edits)},
                   {"sketch", textEdits(view, each.sketch)}});
  return all;
}

} // namespace arbiter::tools::lsp
