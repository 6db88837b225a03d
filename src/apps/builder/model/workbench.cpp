#include "apps/builder/model/workbench.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QUrl>
#include <algorithm>
#include <utility>

#include "apps/builder/model/panels/scene_settings.h"
#include "apps/builder/model/panels/textures.h"
#include "apps/builder/model/render/control_renderer.h"
#include "apps/builder/model/render/draw_renderer.h"

namespace arbiter::builder {

namespace {

constexpr qint64 kKeptDraws = 256;

QList<RendererSession::Factory> factoriesOf(const QString &arbiter) {
  return {[arbiter](QObject *parent) -> Renderer * { return new ControlRenderer(arbiter, parent); },
          [arbiter](QObject *parent) -> Renderer * { return new DrawRenderer(arbiter, parent); }};
}

QString firstThatExists(const QStringList &paths) {
  for (const QString &path : paths)
    if (QFileInfo::exists(path))
      return QFileInfo(path).absoluteFilePath();
  return {};
}

/// Returns the state folder of the XDG base directory specification; Qt 6.4 has no name for it.
QString stateFolder() {
  const QString home = qEnvironmentVariable("XDG_STATE_HOME");
  return (home.startsWith(u'/') ? home : QDir::homePath() + QStringLiteral("/.local/state")) +
         QStringLiteral("/arbiter-builder");
}

/// Returns a warning of the window's own: to GL the text is valid, and a checker with the unit's
/// number is drawn.
Problem problemOf(const UnsetUnit &unset, const QString &text) {
  Problem problem;
  problem.severity = Severity::Warning;
  problem.code = QStringLiteral("unset_texture");
  problem.message =
      QObject::tr("texture[%1] has no image: a checker with its number stands in for one")
          .arg(unset.unit);
  problem.hint =
      QObject::tr("choose one in Textures, or write #@ texture %1 = checker").arg(unset.unit);
  problem.begin = unset.begin;
  problem.end = unset.end;
  const LineColumn place = placeOf(text, unset.begin);
  problem.line = place.line;
  problem.column = place.column;
  return problem;
}

} // namespace

Places Places::standard() {
  const QString here = QCoreApplication::applicationDirPath();
  const QString state = stateFolder();
  Places places;
  places.arbiter = qEnvironmentVariable("ARBITER_COMMAND");
  if (places.arbiter.isEmpty())
    places.arbiter = firstThatExists(
        {here + QStringLiteral("/arbiter"), here + QStringLiteral("/../../tools/arbiter")});
  if (places.arbiter.isEmpty())
    places.arbiter = QStringLiteral("arbiter");
  places.journals = state + QStringLiteral("/journals");
  places.held = state + QStringLiteral("/held");
  places.gallery = qEnvironmentVariable("ARBITER_GALLERY");
  if (places.gallery.isEmpty())
    places.gallery = firstThatExists({here + QStringLiteral("/../share/arbiter/gallery"),
                                      QStringLiteral(ARBITER_GALLERY_SOURCE)});
  return places;
}

Workbench::Workbench(Places places, QObject *parent)
    : QObject(parent), m_places(std::move(places)), m_file(m_places.journals),
      m_lsp(m_places.arbiter), m_session(factoriesOf(m_places.arbiter), m_places.held),
      m_other(factoriesOf(m_places.arbiter), {}), m_parameters(m_file.document()),
      m_debugTool(m_places.arbiter), m_watchTool(m_places.arbiter) {
  m_redraw.setSingleShot(true);
  m_redraw.setInterval(0);
  connect(&m_redraw, &QTimer::timeout, this, &Workbench::draw);
  connect(&document(), &Document::edited, this,
          [this](const Edit &edit) { m_report.follow(edit, document().text()); });
  connect(&document(), &Document::edited, this, &Workbench::edited);
  connect(&m_file, &OpenFile::pathChanged, this, &Workbench::edited);
  connect(&m_file, &OpenFile::complaint, this, &Workbench::notice);
  connect(&m_parameters, &Parameters::dragged, this, &Workbench::sliderMoved);
  connect(&m_lsp, &LspClient::diagnosed, this, &Workbench::diagnosed);
  connect(&m_lsp, &LspClient::troubled, this, &Workbench::notice);
  connect(&m_session, &RendererSession::answered, this, &Workbench::answered);
  connect(&m_session, &RendererSession::drew, this, [this](const Frame &frame) {
    m_frame = frame;
    m_frame.revision = m_revisionOf.value(frame.revision, -1);
    m_stepIsAsked = false;
    Q_EMIT pictureChanged();
    followTime();
  });
  connect(&m_session, &RendererSession::busy, this, [this](double milliseconds) {
    m_busy = milliseconds;
    Q_EMIT statusChanged();
  });
  connect(&m_session, &RendererSession::held, this, [this](qint64, const QString &why) {
    m_why = why;
    setState(PictureState::Held);
  });
  connect(&m_session, &RendererSession::restarted, this,
          [this](const QString &why) { Q_EMIT notice(tr("%1; it is started anew").arg(why)); });
  connect(&m_other, &RendererSession::drew, this, &Workbench::takeOther);
  connect(&m_together, &QTimer::timeout, this, &Workbench::stepTogether);
  connect(&m_session, &RendererSession::restarted, this, [this] { m_stepIsAsked = false; });
  connect(&m_other, &RendererSession::restarted, this, [this] { m_otherIsAsked = false; });
  connect(&m_other, &RendererSession::held, this, [this] { letGo(); }); // B need not wait
}

void Workbench::start() {
  m_lsp.start();
  edited();
}

QString Workbench::uri() const {
  return m_file.path().isEmpty() ? QStringLiteral("untitled:untitled")
                                 : QUrl::fromLocalFile(m_file.path()).toString(QUrl::FullyEncoded);
}

void Workbench::edited() {
  m_lsp.setText(uri(), document().text(), document().revision());
  m_redraw.start();
}

Scene Workbench::scene() const {
  Scene scene;
  scene.text = m_parameters.liveText();
  if (m_turn)
    for (const Edit &edit :
         builder::turnCamera(scene.text, m_turn->yaw, m_turn->pitch, m_turn->distance))
      scene.text.replace(edit.at, edit.removed.size(), edit.added);
  scene.name = m_file.path().isEmpty() ? QStringLiteral("untitled.fp") : m_file.name();
  scene.folder = m_file.folder();
  return scene;
}

void Workbench::draw() {
  Scene wanted = scene();
  if (wanted.text.trimmed().isEmpty())
    return;
  wanted.revision = ++m_drawNumber;
  m_revisionOf.insert(m_drawNumber, document().revision());
  m_revisionOf.remove(m_drawNumber - kKeptDraws);
  if (m_pictureState != PictureState::Wrong)
    setState(PictureState::Waiting);
  m_session.want(wanted);
  if (m_otherOptions)
    m_other.want(wanted);
}

/// Handles a moving slider. `arbiter render` takes the value alone; for other renderers, and on
/// release, the text gets it.
void Workbench::sliderMoved(int line, int component, double) {
  const ParameterLine &moved = m_parameters.lines()[line];
  LiveValue live;
  live.kind = moved.space;
  live.index = moved.index;
  if (languageOf(document().text()) == fp::ir::Language::ArbVertex)
    live.stage = QStringLiteral("vertex");
  live.value[std::size_t(moved.components[component].index)] = m_parameters.value(line, component);
  const bool animated = !moved.animation.isEmpty();
  if (animated || m_otherOptions || !m_session.setParameter(live))
    m_redraw.start();
}

bool Workbench::turnCamera(double yaw, double pitch, double distance) {
  const SceneSettings settings = sceneOf(document().text());
  if (settings.camera != u"orbit")
    return false;
  double lowest = -90, highest = 90; // limits of the pitch relative to the text's
  for (const ArgumentValue &each : settings.cameraArguments)
    if (each.name == u"pitch") {
      lowest -= each.value;
      highest -= each.value;
    }
  Turn turn = m_turn.value_or(Turn{});
  turn.yaw += yaw;
  turn.pitch = std::clamp(turn.pitch + pitch, lowest, highest);
  turn.distance = std::clamp(turn.distance * distance, 1e-3, 1e3);
  m_turn = turn;
  m_redraw.start();
  return true;
}

void Workbench::releaseCamera() {
  if (!m_turn)
    return;
  const Turn turn = *std::exchange(m_turn, std::nullopt);
  const QList<Edit> edits =
      builder::turnCamera(document().text(), turn.yaw, turn.pitch, turn.distance);
  if (!edits.isEmpty())
    document().apply(edits, tr("turn the camera"));
}

void Workbench::diagnosed(qint64 revision, const QList<Problem> &problems) {
  m_ofLanguage = problems;
  mergeProblems();
  m_lsp.request(QStringLiteral("arbiter/report"), -1, {}, [this, revision](const QJsonValue &json) {
    if (!json.isObject() || revision != document().revision())
      return;
    Report report = Report::of(json.toObject());
    if (report.gauges.isEmpty() && !m_report.gauges.isEmpty())
      return; // the text is invalid: the gauges keep the last valid one
    m_report = report;
    Q_EMIT reportChanged();
  });
}

void Workbench::answered(const SceneAnswer &answer) {
  m_busy = 0;
  if (answer.superseded)
    return;
  m_ofRenderer = answer.problems;
  const bool newest = answer.revision == m_drawNumber;
  if (answer.ok)
    setState(newest ? PictureState::Newest : PictureState::Waiting);
  else if (newest)
    setState(PictureState::Wrong);
  mergeProblems();
  if (answer.ok && newest && m_pixel && !m_parameters.isHeld())
    debugPixel(*m_pixel);
}

void Workbench::setState(PictureState state) {
  m_pictureState = state;
  Q_EMIT statusChanged();
}

/// Merges the problems, so that those of the language server are listed once; the renderer adds
/// those that only drawing finds.
void Workbench::mergeProblems() {
  const bool isBegun = !document().text().trimmed().isEmpty(); // an empty text has no problems
  QList<Problem> all = isBegun ? m_ofLanguage : QList<Problem>();
  for (const Problem &problem : m_ofRenderer) {
    const bool said = std::any_of(all.cbegin(), all.cend(), [&](const Problem &other) {
      return other.message == problem.message && other.begin == problem.begin;
    });
    if (!said)
      all.append(problem);
  }
  for (const UnsetUnit &unset : unsetUnits(document().text()))
    all.append(problemOf(unset, document().text()));
  m_problems = all;
  Q_EMIT problemsChanged();
}

QString Workbench::statusText() const {
  const qint64 newest = m_file.document().revision();
  switch (m_pictureState) {
  case PictureState::None:
    return tr("nothing is drawn yet");
  case PictureState::Newest:
    return tr("revision %1 is drawn, %2 ms").arg(newest).arg(m_frame.milliseconds, 0, 'f', 1);
  case PictureState::Waiting:
    return m_busy > 0 ? tr("revision %1 is being compiled, %2 s so far")
                            .arg(newest)
                            .arg(m_busy / 1000, 0, 'f', 1)
                      : tr("revision %1 is on its way").arg(newest);
  case PictureState::Wrong:
    return m_frame.image.isNull()
               ? tr("revision %1 is wrong").arg(newest)
               : tr("revision %1 is wrong; revision %2 is drawn").arg(newest).arg(m_frame.revision);
  case PictureState::Held:
    return m_why;
  }
  return {};
}

void Workbench::setProfile(const QString &profile) {
  RenderOptions options = m_session.options();
  options.profile = profile;
  m_lsp.setProfile(profile);
  m_session.setOptions(options);
}

void Workbench::setNumerics(const QString &numerics) {
  RenderOptions options = m_session.options();
  options.numerics = numerics;
  m_session.setOptions(options);
}

void Workbench::setBackend(const QString &backend) {
  RenderOptions options = m_session.options();
  options.backend = backend;
  m_session.setOptions(options);
}

} // namespace arbiter::builder
