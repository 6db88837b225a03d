#pragma once
#include <string>
#include <vector>

#include "apps/tools/advise/advise.h"
#include "apps/tools/lsp/answers.h"

/// Offers edits at a position of a text: corrected names, and the adviser's fixes.
namespace arbiter::tools::lsp {

/// The parameters of the request codeAction.
struct ActionRequest {
  fp::Span span;
  std::vector<std::string> only; ///< requested kinds; empty: all
  bool showsDisabled = false;    ///< true if the client shows disabled actions with their reason

  [[nodiscard]] bool wants(std::string_view kind) const;
};

/// Returns a CodeAction[]. Quick fixes are the nearest name to an undeclared one, and each fix of
/// the adviser that touches the span. A refactor.rewrite makes all fixes one after the other;
/// resolveAction() computes its edit. Advice that only the application can follow is disabled.
[[nodiscard]] Json codeActions(const View &view, const std::vector<advise::Advice> &advice,
                               const ActionRequest &request);

/// Returns the WorkspaceEdit that makes every fix.
[[nodiscard]] Json everyFix(const Views &views);

/// Returns the adviser's results for the whole text, for arbiter/advice: {rule, message, range,
/// before, after, fix, exact, application, condition, edits, sketch}[]. Costs are {alu, tex, nodes,
/// fits}; edits are TextEdit[].
[[nodiscard]] Json adviceList(const View &view, const std::vector<advise::Advice> &advice);

} // namespace arbiter::tools::lsp
