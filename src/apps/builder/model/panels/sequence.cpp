#include "apps/builder/model/panels/sequence.h"

#include <QDir>
#include <QSaveFile>
#include <cmath>

#include "apps/builder/model/render/control_renderer.h"

namespace arbiter::builder {

namespace {

constexpr int kSequenceMilliseconds = 60000;

/// Writes a picture completely or not at all, even if the disk is full.
bool writePicture(const QString &file, const QImage &image) {
  QSaveFile png(file);
  return png.open(QIODevice::WriteOnly) && image.save(&png, "PNG") && png.commit();
}

} // namespace

SequenceExport::SequenceExport(QString arbiter, QObject *parent)
    : QObject(parent), m_arbiter(std::move(arbiter)) {
  m_patience.setSingleShot(true);
  m_patience.setInterval(kSequenceMilliseconds);
  connect(&m_patience, &QTimer::timeout, this, [this] {
    end(tr("the renderer gave no frame for %1 s").arg(m_patience.interval() / 1000.0));
  });
}

QString SequenceExport::fileOf(const SequenceRequest &request, int frame) {
  return QStringLiteral("%1/%2-%3.png")
      .arg(request.folder, request.name)
      .arg(frame, 4, 10, QLatin1Char('0'));
}

void SequenceExport::start(const Scene &scene, const RenderOptions &options,
                           const SequenceRequest &request) {
  m_request = request;
  m_written = 0;
  if (!QDir().mkpath(request.folder))
    return end(tr("%1: this folder cannot be made").arg(request.folder));
  const RendererSession::Factory factory = [this](QObject *parent) -> Renderer * {
    return new ControlRenderer(m_arbiter, parent);
  };
  m_session = std::make_unique<RendererSession>(QList{factory}, QString());
  connect(m_session.get(), &RendererSession::drew, this, &SequenceExport::take);
  connect(m_session.get(), &RendererSession::answered, this, &SequenceExport::answered);
  connect(m_session.get(), &RendererSession::restarted, this, &SequenceExport::end);
  connect(m_session.get(), &RendererSession::held, this,
          [this](qint64, const QString &why) { end(why); });
  m_session->setOptions(options);
  m_session->setPaused(true); // time only advances by setTime()
  m_session->want(scene);
  m_patience.start();
}

void SequenceExport::answered(const SceneAnswer &answer) {
  if (answer.ok)
    return;
  for (const Problem &problem : answer.problems)
    if (problem.severity == Severity::Error)
      return end(tr("the document is wrong: %1").arg(problem.message));
  end(tr("the document cannot be drawn"));
}

/// Writes the frame that was requested, then requests the next one.
void SequenceExport::take(const Frame &frame) {
  const int number = int(std::lround(frame.time * m_request.rate));
  const int wanted = m_request.first + m_written;
  if (number == wanted) {
    const QString file = fileOf(m_request, number);
    if (!writePicture(file, frame.image))
      return end(tr("%1 cannot be written").arg(file));
    ++m_written;
    Q_EMIT progressed(m_written, m_request.frames);
    if (!m_session) // a receiver of the signal has cancelled
      return;
    if (m_written >= m_request.frames)
      return end({});
  } else if (number > wanted) {
    return end(tr("the renderer left out frame %1").arg(wanted));
  }
  m_patience.start();
  m_session->step((m_request.first + m_written - number) / m_request.rate);
}

void SequenceExport::cancel() {
  if (isRunning())
    end({});
}

void SequenceExport::end(const QString &complaint) {
  m_patience.stop();
  if (m_session) {
    m_session->disconnect(this);
    m_session.release()->deleteLater(); // one of its signals may have led here
  }
  Q_EMIT finished(complaint);
}

} // namespace arbiter::builder
