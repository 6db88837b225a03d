// Operations on the workbench's picture: tracing a pixel, comparing with another picture.
#include <QTemporaryFile>
#include <cmath>
#include <memory>

#include "apps/builder/model/panels/scene_settings.h"
#include "apps/builder/model/workbench.h"

namespace arbiter::builder {

/// Returns the arguments of `arbiter debug` for a pixel of the displayed frame, with the options it
/// is drawn with.
QStringList Workbench::debugWords(QPoint pixel) const {
  const double rate = sceneOf(m_file.document().text()).rate;
  QStringList words{
      QStringLiteral("debug"),   QStringLiteral("@"),
      QStringLiteral("--pixel"), QStringLiteral("%1,%2").arg(pixel.x()).arg(pixel.y()),
      QStringLiteral("--frame"), QString::number(std::lround(m_frame.time * rate))};
  const RenderOptions &options = m_session.options();
  if (!options.profile.isEmpty())
    words << QStringLiteral("--profile") << options.profile;
  if (!options.numerics.isEmpty())
    words << QStringLiteral("--numerics") << options.numerics;
  return words;
}

void Workbench::debugPixel(QPoint pixel) {
  m_pixel = pixel;
  const QStringList words = debugWords(pixel) << QStringLiteral("--json");
  m_debugTool.run(words, scene(), [this](const ToolResult &result) {
    if (result.finished && m_trace.take(result.json()))
      return;
    Q_EMIT traceFailed(result.complaint.isEmpty()
                           ? tr("the debugger ended with code %1").arg(result.code)
                           : result.complaint);
  });
  Q_EMIT pictureChanged(); // the picture's mark has changed
}

void Workbench::watchRow(int row) {
  if (row < 0 || row >= m_trace.rows().size() || !m_pixel)
    return;
  const TraceRow &traced = m_trace.rows()[row];
  const QString what = QStringLiteral("%1@%2").arg(traced.destination).arg(traced.line);
  auto file = std::make_shared<QTemporaryFile>();
  if (traced.destination.isEmpty() || !file->open())
    return;
  m_watchTool.run(debugWords(*m_pixel) << QStringLiteral("--watch") << what << QStringLiteral("-o")
                                       << file->fileName(),
                  scene(), [this, file, what](const ToolResult &result) {
                    QImage image;
                    if (!image.load(file->fileName(), "PNG"))
                      return Q_EMIT notice(
                          tr("%1 cannot be shown: %2").arg(what, result.complaint));
                    endFollowing();
                    m_pinned = image.convertToFormat(QImage::Format_RGBA8888);
                    m_pinnedName = what;
                    Q_EMIT pinnedChanged();
                  });
}

void Workbench::pin() {
  endFollowing();
  m_pinned = m_frame.image;
  m_pinnedName = tr("revision %1").arg(m_frame.revision);
  Q_EMIT pinnedChanged();
}

void Workbench::unpin() {
  endFollowing();
  m_pinned = {};
  Q_EMIT pinnedChanged();
}

/// Stops drawing A; its last picture stays.
void Workbench::endFollowing() {
  m_otherOptions.reset();
  letGo();
}

/// Stops B from waiting for A.
void Workbench::letGo() {
  m_otherSteps = 0;
  m_together.stop();
  m_session.setHeldBack(false);
}

/// Takes a frame of A. With feedback it is shown once it has as many steps as B's.
void Workbench::takeOther(const Frame &frame) {
  m_otherIsAsked = false;
  if (!m_otherOptions) // A is an earlier picture now
    return;
  m_otherSteps = frame.steps;
  if (m_otherSteps == m_frame.steps) {
    m_pinned = frame.image;
    Q_EMIT pinnedChanged();
  }
  followTime();
}

/// Sets A's time to B's, one frame after the other, as the two renderers have separate clocks.
void Workbench::followTime() {
  constexpr double kWithinAFrame = 1e-6; // against rounding down to the previous frame
  if (!m_otherOptions)
    return;
  if (m_frame.steps > 0)
    return followSteps();
  letGo();
  if (m_otherIsAsked || m_frame.time == m_otherTime)
    return;
  m_otherTime = m_frame.time;
  m_otherIsAsked = true;
  m_other.setTime(m_frame.time + kWithinAFrame);
}

/// Brings A to as many steps as B, while B waits. With feedback a picture depends on the number of
/// frames before it, not on a time.
void Workbench::followSteps() {
  constexpr int kMilliseconds = 16;
  if (m_otherSteps == 0)
    return;
  m_session.setHeldBack(true);
  m_since.start();
  if (!m_together.isActive())
    m_together.start(kMilliseconds);
  if (m_otherIsAsked || m_otherSteps == m_frame.steps)
    return;
  m_otherIsAsked = true;
  m_other.setSteps(m_frame.steps);
}

/// Requests B's next frame once A has the present one. A requested frame may never come (its
/// process ended, or the document changed); it is then requested again.
void Workbench::stepTogether() {
  constexpr qint64 kPatience = 3000;
  if (m_since.elapsed() > kPatience) {
    m_otherIsAsked = m_stepIsAsked = false;
    followSteps();
  }
  if (m_session.isPaused() || m_otherIsAsked || m_otherSteps != m_frame.steps || m_stepIsAsked)
    return;
  m_stepIsAsked = true;
  m_session.step(1 / sceneOf(document().text()).rate);
}

void Workbench::compareWith(const RenderOptions &options) {
  m_otherOptions = options;
  m_other.setPaused(true);
  m_otherIsAsked = false;
  m_otherTime = -1;
  letGo();
  m_other.setOptions(options);
  QStringList parts;
  for (const QString &part : {options.profile, options.numerics, options.backend})
    if (!part.isEmpty())
      parts << part;
  if (options.bare)
    parts << tr("the host alone");
  m_pinnedName = parts.join(u' ');
  Scene wanted = scene();
  wanted.revision = ++m_drawNumber;
  m_revisionOf.insert(m_drawNumber, document().revision());
  m_other.want(wanted);
}

} // namespace arbiter::builder
