#include "apps/tools/debug/session.h"

#include "apps/tools/check/rendered.h"
#include "apps/tools/language.h"
#include "apps/tools/profile_choice.h"
#include "fp_compiler/back/assembly/assembly.h"

namespace arbiter::tools::debug {

namespace {

using fp::Numerics;

SessionError usage(std::string message) { return {SessionError::Kind::Usage, std::move(message)}; }

/// Returns the arithmetic to compare with: fp24, or the host's if fp24 itself is traced.
Numerics besides(Numerics numerics) {
  return numerics == Numerics::Fp24 ? Numerics::Host : Numerics::Fp24;
}

std::string panelErrors(const scene::Document &document, const Style &style) {
  std::string text;
  for (const scene::ProgramFile &file : document.files)
    text += rendered(file.name, file.text, file.panel.diagnostics, style);
  return text;
}

} // namespace

Result<CheckedText, SessionError> checkText(std::string name, std::string text,
                                            const fp::FileProgram &program,
                                            const fp::hw::Profile &profile, Numerics numerics,
                                            const Style &style) {
  fp::CheckResult result = fp::checkProgramIn(
      text, program, {limitsOf(profile, program.language), fp::LimitPolicy::Enforce, numerics});
  if (!result.ok())
    return SessionError{SessionError::Kind::Invalid,
                        rendered(name, text, result.diagnostics, style)};
  // Values inside a program are read by cut programs: ARB assembly without branches. They cannot
  // express the instructions of NVIDIA's options.
  if (result.program->options.nv != fp::ir::NvOption::None)
    return SessionError{SessionError::Kind::Invalid,
                        name + ": a program under an option of NVIDIA's cannot be traced yet\n"};
  return CheckedText{std::move(name), std::move(text), std::move(*result.program)};
}

std::optional<SessionError> Session::read(const SessionOptions &options) {
  m_document = scene::assemble(options.path, options.text, scene::readText);
  if (!m_document.ok())
    return SessionError{SessionError::Kind::Invalid, panelErrors(m_document, options.style)};
  if (options.giveTextures)
    if (std::string fault = options.giveTextures(options.textures, m_document); !fault.empty())
      return usage(std::move(fault));
  const std::size_t passes = m_document.passes.size();
  if (options.pass < 1 || std::size_t(options.pass) > passes)
    return usage("--pass " + std::to_string(options.pass) + ": " + options.path + " has " +
                 (passes == 1 ? "one pass" : std::to_string(passes) + " passes"));
  const auto profile = fp::hw::loadProfile(profileName(options.profile, m_document));
  if (!profile)
    return usage(profile.error().message);
  m_profile = profile.value();
  const std::string &asked =
      options.numerics.empty() ? m_document.panel().numerics.text : options.numerics;
  m_numerics = fp::numericsNamed(asked).value_or(m_profile.numerics);
  const scene::Pass &pass = m_document.passes[std::size_t(options.pass) - 1];
  if (pass.fragment < 0)
    return usage(options.path + ": the pass has no fragment program to be looked into; a document "
                                "is a fragment program that names its vertex program");
  const scene::ProgramFile &file = m_document.files[std::size_t(pass.fragment)];
  auto checked =
      checkText(file.name, file.text, file.program(), m_profile, m_numerics, options.style);
  if (!checked)
    return checked.error();
  m_fragment = std::move(checked).value();
  m_pass = pass;
  m_frame = options.frame;
  return readVertex(options.style);
}

std::optional<SessionError> Session::readVertex(const Style &style) {
  if (m_pass.vertex < 0)
    return {};
  const scene::ProgramFile &file = m_document.files[std::size_t(m_pass.vertex)];
  auto checked = checkText(file.name, file.text, file.program(), m_profile, m_numerics, style);
  if (!checked)
    return checked.error();
  m_vertex = std::move(checked).value();
  return {};
}

std::optional<SessionError> Session::start(const SessionOptions &options) {
  const Backend backend = m_numerics == Numerics::Fp24 && options.backend == Backend::Swrast
                              ? Backend::Host // the rasterizer has no code for fp24
                              : options.backend;
  if (m_numerics != Numerics::Host && backend == Backend::Bare)
    return usage("--against bare: the host's own implementation has one arithmetic, its own");
  if (backend == Backend::Swrast)
    m_drawnBy.emplace();
  auto drawer = startDrawing({backend, std::string(fp::kNumericsNames[std::size_t(m_numerics)]),
                              options.library, m_drawnBy ? m_drawnBy->path() : std::string()},
                             {{"path", options.path},
                              {"text", options.text},
                              {"textures", options.textures},
                              {"pass", options.pass - 1},
                              {"frame", options.frame}});
  if (!drawer)
    return SessionError{drawer.error().isOfUsage ? SessionError::Kind::Usage
                                                 : SessionError::Kind::NoGl,
                        drawer.error().message};
  m_drawer = std::move(drawer).value();
  return {};
}

Result<std::unique_ptr<Session>, SessionError> Session::open(const SessionOptions &options) {
  std::unique_ptr<Session> session(new Session);
  if (auto error = session->read(options))
    return *error;
  if (auto error = session->start(options))
    return *error;
  return session;
}

Result<Trace, DebugError> traceOf(Drawer &drawer, const fp::ir::Program &program,
                                  std::string_view text, int x, int y, Numerics numerics) {
  PixelReader reader(drawer, program, x, y, numerics);
  if (auto error = reader.read())
    return *error;
  Trace trace = record(program, text, reader.inputs(), {numerics, besides(numerics)});
  if (reader.failure())
    return *reader.failure();
  return trace;
}

Result<Findings, DebugError> findingsOf(Drawer &drawer, const fp::ir::Program &program,
                                        std::string_view text, int x, int y, Numerics numerics) {
  auto trace = traceOf(drawer, program, text, x, y, numerics);
  if (!trace)
    return trace.error();
  auto verdict = judge(drawer, program, trace.value(), x, y);
  if (!verdict)
    return verdict.error();
  Findings findings;
  findings.x = x;
  findings.y = y;
  findings.width = drawer.size()[0];
  findings.height = drawer.size()[1];
  findings.trace = std::move(trace).value();
  findings.verdict = std::move(verdict).value();
  return findings;
}

Result<Findings, DebugError> findingsOf(Session &session, int x, int y) {
  const CheckedText &fragment = session.fragment();
  auto findings =
      findingsOf(session.drawer(), fragment.program, fragment.text, x, y, session.numerics());
  if (findings)
    findings.value().document = fragment.name;
  return findings;
}

Result<TracedTriangle, DebugError> Session::vertices(int x, int y) {
  if (!m_vertex)
    return DebugError{"--stage vertex: the pass has no vertex program; fixed function transforms"};
  return traceTriangle(
      {m_vertex->program, m_vertex->text, m_document, m_pass, m_document.secondsOf(m_frame)},
      *m_drawer, x, y);
}

std::string Session::end() {
  m_drawer->close();
  return m_drawnBy ? m_drawnBy->note() : std::string();
}

Result<std::vector<Vec4>, DebugError> Session::watch(const Watch &watch) {
  auto covered = watchOf(watch, Fragments::Covered);
  if (!covered || !decidesFragments(m_fragment.program))
    return covered;
  // A pixel shows its surviving fragment if there is one.
  auto surviving = watchOf(watch, Fragments::Surviving);
  if (!surviving)
    return surviving;
  for (std::size_t i = 0; i < covered.value().size(); ++i)
    if (surviving.value()[i] != uncovered())
      covered.value()[i] = surviving.value()[i];
  return covered;
}

Result<std::vector<Vec4>, DebugError> Session::watchOf(const Watch &watch, Fragments fragments) {
  const auto program = watchProgram(m_fragment.program, m_fragment.text, watch, fragments);
  if (!program)
    return program.error();
  const auto [width, height] = m_drawer->size();
  return m_drawer->draw(fp::emitAssembly(program.value()), 1, {0, 0, width, height});
}

} // namespace arbiter::tools::debug
