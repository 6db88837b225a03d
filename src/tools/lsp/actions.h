#pragma once
#include <string>
#include <vector>

#include "tools/advise/advise.h"
#include "tools/lsp/answers.h"

/// What can be done about a place in a text: names that were meant, and the adviser's fixes.
namespace arbiter::tools::lsp {

/// What an editor asks codeAction for.
struct ActionRequest {
  fp::Span span;
  std::vector<std::string> only; ///< kinds; empty: all
  bool showsDisabled = false;    ///< the client shows actions that cannot be done, with the reason

  [[nodiscard]] bool wants(std::string_view kind) const;
};

/// CodeAction[]. quickfix: the name that an undeclared one is nearest to, and each fix of the
/// adviser's that touches the span. refactor.rewrite: all of its fixes, one after the other, whose
/// edit resolveAction() makes; and, disabled, what only the application could do.
[[nodiscard]] Json codeActions(const View &view, const std::vector<advise::Advice> &advice,
                               const ActionRequest &request);

/// The WorkspaceEdit that makes every fix.
[[nodiscard]] Json everyFix(const Views &views);

/// arbiter/advice: {rule, message, range, before, after, fix, exact, application, condition, edits,
/// sketch}[] of the whole text; costs are {alu, tex, nodes, fits}, edits TextEdit[].
[[nodiscard]] Json adviceList(const View &view, const std::vector<advise::Advice> &advice);

} // namespace arbiter::tools::lsp
