#pragma once
#include <map>
#include <memory>
#include <string>

#include "apps/tools/debug/findings.h"
#include "apps/tools/debug/session.h"
#include "apps/tools/lsp/answers.h"

namespace arbiter::tools::lsp {

/// A client's request to trace one pixel of an open document.
struct TraceQuestion {
  int x = 0, y = 0; ///< from the lower left
  int pass = 1, frame = 0;
  debug::Backend backend = debug::Backend::Swrast;
  std::string profile; ///< the requested profile; empty: the document's or the user's
};

/// The last trace of each open document, with the process that drew it.
class Traces {
public:
  /// Returns the findings as JSON (debug/findings.h), or an error. Reuses the session if the text's
  /// version, the pass and the frame are the same.
  [[nodiscard]] Result<Json, Refusal> ask(const Document &document, const TraceQuestion &question);
  void forget(const std::string &uri) { m_traces.erase(uri); }
  /// Returns an InlayHint[] with the values after each instruction, for the lines that \p span
  /// overlaps. Empty if there is no trace of this version of the text.
  [[nodiscard]] Json hints(const Document &document, fp::Span span) const;
  /// Returns the values of the instruction at \p offset as Markdown, or "" without a trace.
  [[nodiscard]] std::string hover(const Document &document, std::uint32_t offset) const;

private:
  struct Traced {
    std::int64_t version = 0;
    TraceQuestion question;
    std::unique_ptr<debug::Session> session;
    debug::Findings findings;
    bool isOwn = true; ///< true if the document's own text is the pass's program
  };

  [[nodiscard]] const Traced *find(const Document &document) const;

  std::map<std::string, Traced> m_traces; ///< by URI
};

} // namespace arbiter::tools::lsp
