#pragma once
#include <functional>
#include <memory>
#include <string>

#include "apps/scene/document.h"
#include "apps/tools/check/terminal.h"
#include "apps/tools/debug/drawn_by.h"
#include "apps/tools/debug/findings.h"
#include "apps/tools/debug/pixel/reader.h"
#include "apps/tools/debug/pixel/verdict.h"
#include "apps/tools/debug/pixel/vertices.h"
#include "apps/tools/debug/pixel/watch.h"
#include "apps/tools/debug/start.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/profile.h"

/// Debugs one draw of a document. The drawing process stays alive between pixels, so that a further
/// pixel costs only its own draws.
namespace arbiter::tools::debug {

struct SessionError {
  enum class Kind { Usage, Invalid, NoGl } kind = Kind::Usage;
  std::string message; ///< Invalid: rendered diagnostics, complete lines; else "name: reason"
};

struct SessionOptions {
  std::string path;
  std::string text;     ///< of the document, which an editor may not have saved
  int pass = 1;         ///< from 1
  int frame = 0;        ///< from 0
  std::string profile;  ///< a name or a file; empty: the document's, or the user's
  std::string numerics; ///< a name of fp::kNumericsNames; empty: the document's, or host
  Backend backend = Backend::Swrast;
  std::vector<std::string> textures; ///< values of --texture, in place of the document's
  /// Applies `textures` to the document, and returns a complaint or "". The drawing process applies
  /// them too. Empty: there are none.
  std::function<std::string(const std::vector<std::string> &, scene::Document &)> giveTextures;
  std::string library; ///< the layer; empty: found automatically
  Style style = {};    ///< of diagnostics in messages
};

/// A program's text and its compiled form.
struct CheckedText {
  std::string name;
  std::string text;
  fp::ir::Program program;
};
/// Compiles a program under the profile's limits. Fails with the compiler's diagnostics.
/// \param style of the diagnostics
[[nodiscard]] Result<CheckedText, SessionError>
checkText(std::string name, std::string text, const fp::FileProgram &program,
          const fp::hw::Profile &profile, fp::Numerics numerics, const Style &style);

/// Traces a pixel of a program under the arithmetic, beside which another is computed.
[[nodiscard]] Result<Trace, DebugError> traceOf(Drawer &drawer, const fp::ir::Program &program,
                                                std::string_view text, int x, int y,
                                                fp::Numerics numerics);

class Session {
public:
  [[nodiscard]] static Result<std::unique_ptr<Session>, SessionError>
  open(const SessionOptions &options);

  [[nodiscard]] const CheckedText &fragment() const { return m_fragment; }
  /// Returns the pass's vertex program, or null if fixed function transforms.
  [[nodiscard]] const CheckedText *vertex() const { return m_vertex ? &*m_vertex : nullptr; }
  /// Returns the profile that limits the programs.
  [[nodiscard]] const fp::hw::Profile &profile() const { return m_profile; }
  [[nodiscard]] const scene::Document &document() const { return m_document; }
  [[nodiscard]] Drawer &drawer() { return *m_drawer; }
  [[nodiscard]] fp::Numerics numerics() const { return m_numerics; }

  /// Traces a pixel with \p program in place of the document's. Pixels count from the lower left.
  [[nodiscard]] Result<Trace, DebugError> trace(const CheckedText &program, int x, int y) {
    return traceOf(*m_drawer, program.program, program.text, x, y, m_numerics);
  }
  [[nodiscard]] Result<Trace, DebugError> trace(int x, int y) { return trace(m_fragment, x, y); }
  [[nodiscard]] Result<Verdict, DebugError> verdict(const Trace &trace, int x, int y) {
    return judge(*m_drawer, m_fragment.program, trace, x, y);
  }
  /// Traces the vertices of the triangle that is visible in a pixel. Fails if the pass has no
  /// vertex program, or if traceTriangle() fails.
  [[nodiscard]] Result<TracedTriangle, DebugError> vertices(int x, int y);
  /// True if further pixels can be traced. After an error this tells a failure at one pixel from
  /// the end of the drawing process.
  [[nodiscard]] bool isAlive() const { return m_drawer->isAlive(); }
  /// Ends the drawing process.
  /// \returns a note about who drew, or ""
  [[nodiscard]] std::string end();
  /// Returns the watched value in each pixel of the picture, the lowest row first.
  [[nodiscard]] Result<std::vector<Vec4>, DebugError> watch(const Watch &watch);

private:
  Session() = default;

  std::optional<SessionError> read(const SessionOptions &options);
  std::optional<SessionError> readVertex(const Style &style);
  Result<std::vector<Vec4>, DebugError> watchOf(const Watch &watch, Fragments fragments);
  std::optional<SessionError> start(const SessionOptions &options);

  scene::Document m_document;
  fp::hw::Profile m_profile;
  CheckedText m_fragment;
  std::optional<CheckedText> m_vertex;
  scene::Pass m_pass;
  int m_frame = 0;
  fp::Numerics m_numerics = fp::Numerics::Host;
  std::optional<DrawnBy> m_drawnBy;
  std::unique_ptr<DrawClient> m_drawer;
};

/// Traces a pixel and compares the trace with the drawn picture.
[[nodiscard]] Result<Findings, DebugError> findingsOf(Drawer &drawer,
                                                      const fp::ir::Program &program,
                                                      std::string_view text, int x, int y,
                                                      fp::Numerics numerics);
[[nodiscard]] Result<Findings, DebugError> findingsOf(Session &session, int x, int y);

} // namespace arbiter::tools::debug
