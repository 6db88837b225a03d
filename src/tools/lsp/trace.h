#pragma once
#include <map>
#include <memory>
#include <string>

#include "tools/debug/findings.h"
#include "tools/debug/session.h"
#include "tools/lsp/answers.h"

namespace arbiter::tools::lsp {

/// What a client asks of one pixel of an open document.
struct TraceQuestion {
  int x = 0, y = 0; ///< from the lower left
  int pass = 1, frame = 0;
  debug::Backend backend = debug::Backend::Swrast;
  std::string profile; ///< that was asked for; empty: by the document, or the user
};

/// The traces of open documents: the last one of each, and the process that drew it.
class Traces {
public:
  /// The findings as JSON (debug/findings.h), or why there are none. A session of the same version
  /// of the text, pass and frame is used again.
  [[nodiscard]] Result<Json, Refusal> ask(const Document &document, const TraceQuestion &question);
  void forget(const std::string &uri) { m_traces.erase(uri); }
  /// InlayHint[]: the values after each instruction of the lines that \p span lies in, while a
  /// trace of this version of the text is set.
  [[nodiscard]] Json hints(const Document &document, fp::Span span) const;
  /// Markdown of the values of the instruction at \p offset; empty where there is no trace.
  [[nodiscard]] std::string hover(const Document &document, std::uint32_t offset) const;

private:
  struct Traced {
    std::int64_t version = 0;
    TraceQuestion question;
    std::unique_ptr<debug::Session> session;
    debug::Findings findings;
    bool isOwn = true; ///< the pass's program is the document's own text
  };

  [[nodiscard]] const Traced *find(const Document &document) const;

  std::map<std::string, Traced> m_traces; ///< by URI
};

} // namespace arbiter::tools::lsp
