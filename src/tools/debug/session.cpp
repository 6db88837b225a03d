#include "tools/debug/session.h"

#include "fp_compiler/back/assembly/assembly.h"
#include "tools/language.h"

namespace arbiter::tools::debug {

namespace {

using fp::Numerics;

SessionError usage(std::string message) { return {SessionError::Kind::Usage, std::move(message)}; }

/// What stands beside an arithmetic: fp24, and beside that the host's.
Numerics besides(Numerics numerics) {
  return numerics == Numerics::Fp24 ? Numerics::Host : Numerics::Fp24;
}

} // namespace

Result<CheckedText, SessionError> checkText(std::string name, std::string text,
                                            const fp::hw::Profile &profile) {
  const fp::ir::Language language = chooseLanguage("auto", text);
  fp::CheckResult result =
      fp::checkProgram(language, text, {limitsOf(profile, language), fp::LimitPolicy::Enforce});
  if (!result.ok())
    return SessionError{SessionError::Kind::Invalid,
                        fp::renderAll(name, text, result.diagnostics)};
  return CheckedText{std::move(name), std::move(text), std::move(*result.program)};
}

Result<std::unique_ptr<Session>, SessionError> Session::open(const SessionOptions &options) {
  auto checked = checkText(options.path, options.text, options.profile);
  if (!checked)
    return checked.error();
  if (checked.value().program.language == fp::ir::Language::ArbVertex)
    return usage(options.path + ": is a vertex program; a document is a fragment program, which "
                                "names its vertex program");
  std::unique_ptr<Session> session(new Session);
  session->m_fragment = std::move(checked).value();
  const std::string numerics = options.numerics.empty() ? "host" : options.numerics;
  session->m_numerics = fp::numericsNamed(numerics).value_or(Numerics::Host);
  if (session->m_numerics == Numerics::Fp24 && options.backend != Backend::Host)
    return usage("--numerics fp24 is drawn by the host alone: --against host");
  auto drawer = startDrawing({options.backend, numerics, options.library},
                             {{"path", options.path},
                              {"text", options.text},
                              {"pass", options.pass},
                              {"frame", options.frame}});
  if (!drawer)
    return SessionError{SessionError::Kind::NoGl, drawer.error().message};
  session->m_drawer = std::move(drawer).value();
  return session;
}

Result<Trace, DebugError> Session::trace(const CheckedText &program, int x, int y) {
  PixelReader reader(*m_drawer, program.program, x, y, m_numerics);
  if (auto error = reader.read())
    return *error;
  Trace trace =
      record(program.program, program.text, reader.inputs(), {m_numerics, besides(m_numerics)});
  if (reader.failure())
    return *reader.failure();
  return trace;
}

Result<std::vector<Vec4>, DebugError> Session::watch(const Watch &watch) {
  const auto program = watchProgram(m_fragment.program, m_fragment.text, watch);
  if (!program)
    return program.error();
  const auto [width, height] = m_drawer->size();
  return m_drawer->draw(fp::emitAssembly(program.value()), 1, {0, 0, width, height});
}

} // namespace arbiter::tools::debug
