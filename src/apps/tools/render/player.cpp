#include "apps/tools/render/player.h"

#include <algorithm>
#include <numbers>
#include <tuple>
#include <utility>

#include "apps/tools/language.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/profile.h"
#include "fp_compiler/resources.h"
#include "util/flags.h"

namespace arbiter::tools {

namespace {

using control::Json;
using Clock = std::chrono::steady_clock;

/// Checks a program under the limits of the layer in this process.
fp::CheckResult check(const scene::ProgramFile &file) {
  fp::CompileOptions options;
  if (const auto profile = fp::hw::loadProfile(settings().profile))
    options.limits = limitsOf(profile.value(), file.language);
  options.policy = settings().enforceLimits ? fp::LimitPolicy::Enforce : fp::LimitPolicy::Report;
  return fp::checkProgramIn(file.text, file.program(), options);
}

/// Returns a file's name relative to the document's folder, as clients know it.
std::string shortName(const scene::Document &document, std::size_t file) {
  const std::string &name = document.files[file].name;
  return name.starts_with(document.folder) ? name.substr(document.folder.size()) : name;
}

void addDiagnostic(const scene::Document &document, std::size_t file,
                   const fp::Diagnostic &diagnostic, Json &rows) {
  const fp::LineColumn at = fp::locate(document.files[file].text, diagnostic.span.begin);
  rows.push_back({{"file", shortName(document, file)},
                  {"severity", fp::severityName(diagnostic.severity)},
                  {"id", diagnostic.id},
                  {"message", diagnostic.message},
                  {"hint", diagnostic.hint},
                  {"begin", diagnostic.span.begin},
                  {"end", diagnostic.span.end},
                  {"line", at.line},
                  {"column", at.column}});
}

/// Adds an error of GL or of a generator to the diagnostics.
void addError(const scene::Document &document, const RenderError &error, Json &rows) {
  fp::Diagnostic diagnostic;
  diagnostic.id = "draw";
  diagnostic.message = error.message.substr(0, error.message.find('\n'));
  diagnostic.span = error.span;
  const std::size_t file = std::min(error.file, document.files.size() - 1);
  if (error.kind == RenderError::Kind::Program && error.position >= 0)
    diagnostic.span.begin = diagnostic.span.end =
        document.files[file].place.begin + std::uint32_t(error.position);
  addDiagnostic(document, file, diagnostic, rows);
}

Json countsJson(const fp::ResourceCounts &counts) {
  Json object = Json::object();
  for (const fp::ResourceRow &row : fp::resourceRows())
    object[row.name] = counts.*row.member;
  return object;
}

/// Adds diagnostics and counts of every file.
/// \returns true if there are no errors
bool checkAll(const scene::Document &document, Json &diagnostics, Json &programs) {
  bool ok = true;
  for (std::size_t i = 0; i < document.files.size(); ++i) {
    const scene::ProgramFile &file = document.files[i];
    const fp::CheckResult result = check(file);
    for (const auto &found : {file.panel.diagnostics, result.diagnostics})
      for (const fp::Diagnostic &diagnostic : found)
        addDiagnostic(document, i, diagnostic, diagnostics);
    ok = ok && result.ok() && file.panel.ok();
    programs.push_back(
        {{"file", shortName(document, i)},
         {"target", file.language == fp::ir::Language::ArbVertex ? "vertex" : "fragment"},
         {"counts", countsJson(result.counts)},
         {"native_counts", countsJson(result.nativeCounts)},
         {"under_native_limits", result.underNativeLimits}});
  }
  return ok;
}

bool isAnimatedDocument(const scene::Document &document) {
  const auto moves = [](const scene::ProgramFile &file) {
    return std::any_of(file.panel.parameters.begin(), file.panel.parameters.end(),
                       [](const scene::Parameter &each) { return each.animation.has_value(); });
  };
  return document.hasFeedback() || std::any_of(document.files.begin(), document.files.end(), moves);
}

/// Returns a camera's argument by its name.
scene::Number &argumentOf(scene::CameraSpec &camera, std::string_view name) {
  const auto rows = scene::rowOf(camera.kind.value).arguments();
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const scene::ArgumentRow &row) { return row.word == name; });
  return camera.arguments.numbers[std::size_t(found - rows.begin())];
}

/// Sets one component of a parameter and stops its animation.
void setComponent(scene::Panel &panel, const Player::ParameterValue &given, std::size_t component) {
  const float value = *given.value[component];
  for (scene::Parameter &each : panel.parameters) {
    if (each.space != given.space || each.first != given.index || !each.mask[component] ||
        each.kind.value != scene::ValueKind::Numbers)
      continue;
    const auto place = std::size_t(
        std::count(each.mask.begin(), each.mask.begin() + std::ptrdiff_t(component), true));
    if (place >= each.values.size())
      each.values.resize(place + 1);
    each.values[place].value = value;
    each.animation.reset();
    return;
  }
  scene::Parameter added;
  added.space = given.space;
  added.first = given.index;
  added.mask = {};
  added.mask[component] = true;
  added.kind.value = scene::ValueKind::Numbers;
  added.values.emplace_back().value = value;
  panel.parameters.push_back(std::move(added));
}

} // namespace

scene::Document Player::assembled(const Text &text) const {
  const auto read = [&](const std::string &path) -> Result<std::string, scene::DocumentError> {
    const std::string name = path.starts_with(m_folder) ? path.substr(m_folder.size()) : path;
    if (const auto found = text.files.find(name); found != text.files.end())
      return found->second;
    return scene::readText(path);
  };
  return scene::assemble(m_folder + text.name, text.text, read);
}

void Player::applyCamera(scene::Document &document) const {
  if (!m_orbit)
    return;
  constexpr double kDegrees = 180 / std::numbers::pi;
  for (scene::ProgramFile &file : document.files) {
    if (!file.panel.camera || file.panel.camera->kind.value != scene::CameraKind::Orbit)
      continue;
    scene::CameraSpec &camera = *file.panel.camera;
    argumentOf(camera, "yaw").value += m_orbit->yaw * kDegrees;
    scene::Number &pitch = argumentOf(camera, "pitch");
    pitch.value = std::clamp(pitch.value + m_orbit->pitch * kDegrees, -90.0, 90.0);
    scene::Number &distance = argumentOf(camera, "distance");
    distance.value = std::clamp(distance.value * m_orbit->distance, 0.01, 1000.0);
  }
}

/// Replaces the drawn document. On failure the previous one stays.
bool Player::build(std::unique_ptr<scene::Document> document, RenderError &error) {
  if (m_width > 0) {
    document->files.front().panel.width.value = m_width;
    document->files.front().panel.height.value = m_height;
  }
  applyCamera(*document);
  if (!m_canvas.use(document->width(), document->height())) {
    error.message = "GL has no framebuffer object of this size";
    return false;
  }
  auto made = Renderer::make(*document);
  if (!made) {
    error = made.error();
    return false;
  }
  m_renderer = std::move(made.value());
  m_document = std::move(document);
  m_animated = isAnimatedDocument(*m_document);
  m_steps = 0;
  return true;
}

bool Player::approachStep(int step, Clock::time_point until) {
  if (step <= m_steps) {
    auto made = Renderer::make(*m_document);
    if (!made)
      return false;
    m_renderer = std::move(made.value());
    m_steps = 0;
  }
  while (m_steps + 1 < step && Clock::now() < until) {
    m_frame = m_steps;
    (void)draw(nullptr);
  }
  m_frame = m_steps;
  return true;
}

Json Player::set(const Text &text) {
  const Clock::time_point begin = Clock::now();
  Json answer = Json::object({{"ok", false}, {"revision", text.revision}, {"superseded", false}});
  Json &diagnostics = answer["diagnostics"] = Json::array();
  Json programs = Json::array();
  auto document = std::make_unique<scene::Document>(assembled(text));
  if (!checkAll(*document, diagnostics, programs))
    return answer;
  RenderError error;
  const scene::Document copy = *document;
  if (!build(std::move(document), error)) {
    addError(copy, error, diagnostics);
    if (m_document)
      (void)m_canvas.use(m_document->width(), m_document->height());
    return answer;
  }
  m_text = text;
  m_revision = text.revision;
  answer["ok"] = true;
  answer["programs"] = std::move(programs);
  answer["size"] = Json::array({width(), height()});
  answer["animated"] = m_animated;
  if (m_document->hasFeedback())
    m_frame = 0;
  const std::chrono::duration<double, std::milli> took = Clock::now() - begin;
  answer["milliseconds"] = took.count();
  return answer;
}

double Player::framesPerSecond() const { return m_document ? m_document->panel().rate.value : 60; }

bool Player::setParameter(const ParameterValue &value) {
  if (!m_document || value.pass >= m_document->passes.size())
    return false;
  const scene::Pass &pass = m_document->passes[value.pass];
  const int file = value.vertex ? pass.vertex : pass.fragment;
  if (file < 0)
    return false;
  for (std::size_t i = 0; i < value.value.size(); ++i)
    if (value.value[i])
      setComponent(m_document->files[std::size_t(file)].panel, value, i);
  m_animated = isAnimatedDocument(*m_document);
  return true;
}

bool Player::setSize(int width, int height) {
  const std::pair before = {m_width, m_height};
  m_width = width;
  m_height = height;
  if (!m_document)
    return true;
  RenderError error;
  if (build(std::make_unique<scene::Document>(assembled(m_text)), error))
    return true;
  std::tie(m_width, m_height) = before;
  (void)m_canvas.use(m_document->width(), m_document->height());
  return false;
}

void Player::setCamera(const std::optional<Orbit> &orbit) {
  m_orbit = orbit;
  if (!m_document)
    return;
  // Restore the text's cameras and then turn them; keep parameters that were set.
  const scene::Document fresh = assembled(m_text);
  for (std::size_t i = 0; i < m_document->files.size() && i < fresh.files.size(); ++i)
    m_document->files[i].panel.camera = fresh.files[i].panel.camera;
  applyCamera(*m_document);
}

void Player::setSeconds(double seconds) {
  if (m_document)
    m_frame = int(std::clamp(seconds * framesPerSecond(), 0.0, 1e9));
}

double Player::draw(std::uint8_t *pixels) {
  const Clock::time_point begin = Clock::now();
  (void)m_canvas.use(width(), height());
  m_renderer->draw(m_frame);
  ++m_steps;
  if (pixels)
    glReadPixels(0, 0, width(), height(), GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  else
    glFinish();
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

} // namespace arbiter::tools
