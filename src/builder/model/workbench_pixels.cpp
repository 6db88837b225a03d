// What the workbench does with a picture: traces a pixel of it, compares it with another.
#include <QTemporaryFile>
#include <cmath>
#include <memory>

#include "builder/model/panels/scene_settings.h"
#include "builder/model/workbench.h"

namespace arbiter::builder {

/// `arbiter debug` of a pixel, of the frame that is shown, as it is drawn.
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
  Q_EMIT pictureChanged(); // its mark
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
                    m_otherOptions.reset();
                    m_pinned = image.convertToFormat(QImage::Format_RGBA8888);
                    m_pinnedName = what;
                    Q_EMIT pinnedChanged();
                  });
}

void Workbench::pin() {
  m_otherOptions.reset();
  m_pinned = m_frame.image;
  m_pinnedName = tr("revision %1").arg(m_frame.revision);
  Q_EMIT pinnedChanged();
}

void Workbench::unpin() {
  m_otherOptions.reset();
  m_pinned = {};
  Q_EMIT pinnedChanged();
}

/// Two renderers have two clocks: A is taken to B's time, a frame after the other.
void Workbench::followTime() {
  constexpr double kWithinAFrame = 1e-6; // against rounding down to the frame before
  if (!m_otherOptions || m_otherIsAsked || m_frame.time == m_otherTime)
    return;
  m_otherTime = m_frame.time;
  m_otherIsAsked = true;
  m_other.setTime(m_frame.time + kWithinAFrame);
}

void Workbench::compareWith(const RenderOptions &options) {
  m_otherOptions = options;
  m_other.setPaused(true);
  m_otherIsAsked = false;
  m_otherTime = -1;
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
