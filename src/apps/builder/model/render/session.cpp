#include "apps/builder/model/render/session.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <utility>

#include "apps/builder/model/text/text_file.h"
#include "apps/scene/document.h"

namespace arbiter::builder {

namespace {

constexpr int kFrameMilliseconds = 10000;
constexpr int kTickMilliseconds = 100;
constexpr qint64 kBusyMilliseconds = 300; ///< drawing that takes longer is reported
constexpr int kMaxBackOff = 2000;
constexpr qsizetype kMaxHeld = 1000;

QByteArray hashOf(const Scene &scene) {
  return QCryptographicHash::hash(scene.text.toUtf8(), QCryptographicHash::Sha256).toHex();
}

} // namespace

namespace {

/// Returns the options; those that the user did not set come from the document's panel.
RenderOptions optionsOf(const Scene &scene, RenderOptions options) {
  const scene::Panel panel = scene::parsePanel(scene.text.toStdString());
  QString folder = scene.folder;
  if (!folder.isEmpty() && !folder.endsWith(u'/'))
    folder += u'/';
  if (options.profile.isEmpty() && !options.bare)
    options.profile = QString::fromStdString(scene::profileOf(panel, folder.toStdString()));
  if (options.numerics.isEmpty() && !options.bare)
    options.numerics = QString::fromStdString(panel.numerics.text);
  return options;
}

} // namespace

RendererSession::RendererSession(QList<Factory> factories, const QString &memory, QObject *parent)
    : QObject(parent), m_factories(std::move(factories)), m_memory(memory) {
  m_patience.setSingleShot(true);
  m_patience.setInterval(kFrameMilliseconds);
  connect(&m_patience, &QTimer::timeout, this, &RendererSession::stop);
  m_tick.setInterval(kTickMilliseconds);
  connect(&m_tick, &QTimer::timeout, this, [this] {
    if (m_underWay && m_since.elapsed() > kBusyMilliseconds)
      Q_EMIT busy(double(m_since.elapsed()));
  });
  m_restart.setSingleShot(true);
  connect(&m_restart, &QTimer::timeout, this, [this] {
    startRenderer();
    sendNext();
  });
  QFile file(m_memory);
  if (!m_memory.isEmpty() && file.open(QIODevice::ReadOnly))
    for (const QByteArray &line : readAtMost(file, kMaxHeld * 65).split('\n'))
      if (line.size() == 64)
        m_held.insert(line);
}

RendererSession::~RendererSession() {
  if (m_renderer)
    m_renderer->disconnect(this);
}

void RendererSession::startRenderer() {
  if (m_renderer || m_factories.isEmpty())
    return;
  m_renderer = m_factories.first()(this);
  connect(m_renderer, &Renderer::drew, this, &RendererSession::takeFrame);
  connect(m_renderer, &Renderer::answered, this, &RendererSession::take);
  connect(m_renderer, &Renderer::benched, this, &RendererSession::benched);
  connect(m_renderer, &Renderer::ended, this, &RendererSession::ended);
  connect(m_renderer, &Renderer::unsupported, this, [this] {
    m_factories.removeFirst();
    m_renderer->disconnect(this);
    m_renderer->deleteLater();
    m_renderer = nullptr;
    if (!m_waiting)
      m_waiting = m_underWay;
    m_underWay.reset();
    startRenderer();
    sendNext();
  });
  m_renderer->start(m_started, m_folder);
  if (m_paused || m_heldBack)
    m_renderer->setPaused(true);
}

void RendererSession::want(const Scene &scene) {
  m_waiting = scene;
  sendNext();
}

void RendererSession::setOptions(const RenderOptions &options) {
  if (options == m_options)
    return;
  m_options = options;
  if (!m_waiting)
    m_waiting = m_underWay ? m_underWay : m_lastGoodScene;
  m_underWay.reset();
  dropRenderer();
  sendNext();
}

void RendererSession::dropRenderer() {
  if (!m_renderer)
    return;
  m_renderer->disconnect(this);
  m_renderer->kill();
  m_renderer->deleteLater();
  m_renderer = nullptr;
}

void RendererSession::sendNext() {
  if (m_underWay || !m_waiting || m_restart.isActive())
    return;
  const Scene scene = *m_waiting;
  if (m_held.contains(hashOf(scene))) {
    m_waiting.reset();
    return hold(scene, tr("this program stopped the renderer"));
  }
  // A renderer keeps its start options: the folder of the files, and the layer's profile and
  // numerics.
  const RenderOptions options = optionsOf(scene, m_options);
  if (scene.folder != m_folder || options != m_started)
    dropRenderer();
  m_folder = scene.folder;
  m_started = options;
  startRenderer();
  if (!m_renderer || m_underWay)
    return;
  m_underWay = scene;
  m_waiting.reset();
  setState(State::Drawing);
  m_since.start();
  m_patience.start();
  m_tick.start();
  m_renderer->draw(scene);
}

void RendererSession::takeFrame(const Frame &frame) {
  m_lastGood = frame;
  Q_EMIT drew(frame);
}

void RendererSession::take(const SceneAnswer &answer) {
  if (!m_underWay || answer.revision != m_underWay->revision)
    return;
  m_patience.stop();
  m_tick.stop();
  if (answer.ok) {
    m_lastGoodScene = m_underWay;
    m_suspect.clear();
    m_restarts = 0;
  }
  m_underWay.reset();
  setState(State::Idle);
  Q_EMIT answered(answer);
  sendNext();
}

void RendererSession::ended(const QString &why) {
  m_patience.stop();
  m_tick.stop();
  // If no process ever got ready or drew, GL is at fault, not the text.
  const bool drawsHere = m_lastGoodScene || (m_renderer && m_renderer->wasReady());
  if (m_renderer) {
    m_renderer->disconnect(this);
    m_renderer->deleteLater();
    m_renderer = nullptr;
  }
  const std::optional<Scene> scene = std::exchange(m_underWay, std::nullopt);
  if (scene) {
    const QByteArray hash = hashOf(*scene);
    // A single end may have another cause, such as an administrator or the kernel's lack of memory.
    if (drawsHere && hash == m_suspect)
      hold(*scene, tr("this program stopped the renderer (%1)").arg(why));
    else if (!m_waiting)
      m_waiting = scene;
    if (drawsHere)
      m_suspect = hash;
  }
  if (!m_waiting && m_state != State::Held)
    m_waiting = m_lastGoodScene;
  ++m_restarts;
  m_restart.start(m_restarts <= 2 ? 0 : std::min(kMaxBackOff, 50 << std::min(m_restarts, 5)));
  Q_EMIT restarted(why);
}

void RendererSession::stop() {
  if (!m_underWay)
    return;
  const Scene scene = *std::exchange(m_underWay, std::nullopt);
  m_patience.stop();
  m_tick.stop();
  dropRenderer();
  hold(scene,
       tr("this program did not draw in %1 s").arg(double(m_since.elapsed()) / 1000, 0, 'f', 1));
  sendNext();
}

void RendererSession::hold(const Scene &scene, const QString &why) {
  m_held.insert(hashOf(scene));
  remember();
  if (m_waiting && m_waiting->revision > scene.revision)
    return; // the text has changed meanwhile
  setState(State::Held);
  Q_EMIT held(scene.revision, why);
  m_lastHeld = scene;
}

void RendererSession::drawAnyway() {
  if (m_state != State::Held || !m_lastHeld)
    return;
  m_held.remove(hashOf(*m_lastHeld));
  m_suspect.clear();
  remember();
  setState(State::Idle);
  want(*m_lastHeld);
}

void RendererSession::remember() {
  if (m_memory.isEmpty())
    return;
  QDir().mkpath(QFileInfo(m_memory).absolutePath());
  QSaveFile file(m_memory);
  if (!file.open(QIODevice::WriteOnly))
    return;
  qsizetype count = 0;
  for (const QByteArray &hash : m_held)
    if (++count <= kMaxHeld)
      file.write(hash + '\n');
  file.commit();
}

bool RendererSession::setParameter(const LiveValue &value) {
  return m_renderer && m_renderer->setParameter(value);
}

void RendererSession::setPaused(bool paused) {
  m_paused = paused;
  if (m_renderer)
    m_renderer->setPaused(m_paused || m_heldBack);
}

void RendererSession::setHeldBack(bool heldBack) {
  if (std::exchange(m_heldBack, heldBack) != heldBack)
    setPaused(m_paused);
}

void RendererSession::step(double seconds) {
  if (m_renderer)
    m_renderer->step(seconds);
}

void RendererSession::setTime(double seconds) {
  if (m_renderer)
    m_renderer->setTime(seconds);
}

void RendererSession::setSteps(int steps) {
  if (m_renderer)
    m_renderer->setSteps(steps);
}

bool RendererSession::bench(int frames) { return m_renderer && m_renderer->bench(frames); }

} // namespace arbiter::builder
