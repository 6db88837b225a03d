#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/hw/profile.h"
#include "tools/lsp/document.h"
#include "util/result.h"

/// What an editor asks about a place in a text, each as the protocol's result. Nothing here changes
/// anything.
namespace arbiter::tools::lsp {

/// A program of a text with all that is known of it.
struct View {
  const Document &document;
  const Analysis &analysis;
  const fp::hw::Profile &profile;

  [[nodiscard]] Json range(fp::Span span) const { return document.map().range(span); }
  [[nodiscard]] std::string_view source() const { return analysis.program.in(document.text()); }
  [[nodiscard]] fp::Span headerLine() const {
    return document.map().line(document.map().lineOf(analysis.program.span.begin));
  }
};
/// The views of a document, in text order.
using Views = std::vector<View>;

/// Diagnostic[]: what the compiler says, with its hints, and of the text's panel with the first of
/// its programs; of a program that loads also the reasons that it is over the profile's native
/// limits, at the instructions that make it so.
[[nodiscard]] Json diagnostics(const View &view);

/// Hover, or null.
[[nodiscard]] Json hover(const View &view, std::uint32_t offset);

/// CompletionItem[]: what may stand here.
[[nodiscard]] Json completion(const View &view, std::uint32_t offset);

/// Location of the declaration, or null.
[[nodiscard]] Json definition(const View &view, std::uint32_t offset);
/// Location[] of every use.
[[nodiscard]] Json references(const View &view, std::uint32_t offset, bool withDeclaration);
/// DocumentHighlight[]: the same in this text, reads and writes apart.
[[nodiscard]] Json highlights(const View &view, std::uint32_t offset);

struct Refusal {
  std::string message;
};
/// {range, placeholder} of the name here, or why it cannot be renamed.
[[nodiscard]] Result<Json, Refusal> prepareRename(const View &view, std::uint32_t offset);
/// WorkspaceEdit, or why the name cannot become this one.
[[nodiscard]] Result<Json, Refusal> rename(const View &view, std::uint32_t offset,
                                           const std::string &newName);

/// DocumentSymbol[]: declarations, aliases, ATI's passes.
[[nodiscard]] Json documentSymbols(const View &view);

/// InlayHint[] of the lines that overlap the span: what each costs on the profile's card, and at
/// the header what the program takes of each resource.
[[nodiscard]] Json inlayHints(const View &view, fp::Span span);

/// The words of the legend, and a text's tokens in them.
[[nodiscard]] Json semanticLegend();
[[nodiscard]] Json semanticTokens(const Views &views);

} // namespace arbiter::tools::lsp
