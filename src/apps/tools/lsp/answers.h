#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "apps/tools/lsp/document.h"
#include "fp_compiler/hw/profile.h"
#include "util/result.h"

/// Answers requests about a position in a text. Each function returns a result of the protocol and
/// changes nothing.
namespace arbiter::tools::lsp {

/// A program of a text, with its document, analysis and profile.
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
/// All views of a document, in text order.
using Views = std::vector<View>;

/// Returns a Diagnostic[]: the compiler's diagnostics with their hints. Those of the text's panel
/// come with its first program. For a valid program over the profile's native limits, adds the
/// reasons, at the instructions that cause them.
[[nodiscard]] Json diagnostics(const View &view);

/// Returns a Hover, or null.
[[nodiscard]] Json hover(const View &view, std::uint32_t offset);

/// Returns a CompletionItem[] of the words that are possible at the position.
[[nodiscard]] Json completion(const View &view, std::uint32_t offset);

/// Returns the Location of the declaration, or null.
[[nodiscard]] Json definition(const View &view, std::uint32_t offset);
/// Returns the Location[] of every use.
[[nodiscard]] Json references(const View &view, std::uint32_t offset, bool withDeclaration);
/// Returns a DocumentHighlight[] of every use in this text; reads and writes differ in kind.
[[nodiscard]] Json highlights(const View &view, std::uint32_t offset);

struct Refusal {
  std::string message;
};
/// Returns {range, placeholder} of the name at the position, or why it cannot be renamed.
[[nodiscard]] Result<Json, Refusal> prepareRename(const View &view, std::uint32_t offset);
/// Returns a WorkspaceEdit, or why the name cannot become `newName`.
[[nodiscard]] Result<Json, Refusal> rename(const View &view, std::uint32_t offset,
                                           const std::string &newName);

/// Returns a DocumentSymbol[] of the declarations, aliases and ATI passes.
[[nodiscard]] Json documentSymbols(const View &view);

/// Returns an InlayHint[] for the lines that overlap the span. A hint shows the line's cost on the
/// profile's card; the header line's hint shows the program's use of each resource.
[[nodiscard]] Json inlayHints(const View &view, fp::Span span);

/// Returns the legend of token types and modifiers.
[[nodiscard]] Json semanticLegend();
[[nodiscard]] Json semanticTokens(const Views &views);

} // namespace arbiter::tools::lsp
