#include "apps/builder/view/window/screenshot.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTimer>
#include <cstdio>
#include <utility>

#include "apps/builder/model/attach/attachment.h"
#include "apps/builder/view/panels/attach_panel.h"
#include "apps/builder/view/picture/picture_view.h"
#include "apps/builder/view/window/main_window.h"
#include "util/text/exit_codes.h"

namespace arbiter::builder {

namespace {

constexpr int kTickMilliseconds = 50;
constexpr qint64 kPatience = 30000;
constexpr qint64 kSettle = 700; ///< for requests that follow a picture: advice, thumbnails

/// Reduces the picture to 32 shades a channel without alpha, so that it compresses well.
QImage withFewColors(const QImage &image) {
  QImage few = image.convertToFormat(QImage::Format_RGB888);
  for (int y = 0; y < few.height(); ++y) {
    uchar *const row = few.scanLine(y);
    for (int x = 0; x < 3 * few.width(); ++x)
      row[x] = uchar((row[x] * 31 + 127) / 255 * 255 / 31);
  }
  return few;
}

/// Does the steps one after the other, each when the one before is done, then takes the picture.
class Photographer : public QObject {
public:
  Photographer(MainWindow &window, Shot shot)
      : QObject(&window), m_window(window), m_bench(window.bench()), m_shot(std::move(shot)) {
    m_since.start();
    connect(&m_timer, &QTimer::timeout, this, [this] { tick(); });
    m_timer.start(kTickMilliseconds);
  }

private:
  void tick() {
    const bool late = m_since.elapsed() > kPatience;
    if (!late && !isDone()) {
      m_settled.invalidate();
      return;
    }
    if (!m_settled.isValid())
      m_settled.start();
    if (!late && m_settled.elapsed() < kSettle)
      return;
    m_timer.stop();
    take(late);
  }

  /// Starts the next step if possible. Returns true if all are done.
  bool isDone() {
    return isDrawn() && isEdited() && isAttached() && isTraced() && isWatched() && isTold();
  }

  [[nodiscard]] bool isDrawn() const {
    const PictureState state = m_bench.pictureState();
    return m_bench.document().text().isEmpty() || state == PictureState::Newest ||
           state == PictureState::Wrong || state == PictureState::Held;
  }
  [[nodiscard]] bool isTold() const {
    return !m_bench.report().gauges.isEmpty() || !m_bench.problems().isEmpty() ||
           m_bench.document().text().isEmpty();
  }

  bool isEdited() {
    if (m_shot.edit.isEmpty() || m_bench.picture().isNull())
      return m_shot.edit.isEmpty();
    const QStringList parts = std::exchange(m_shot.edit, {}).split(QStringLiteral("=>"));
    const qsizetype at = m_bench.document().text().indexOf(parts[0]);
    if (parts.size() == 2 && at >= 0)
      m_bench.document().replace(at, parts[0].size(), parts[1], Origin::Tool,
                                 QStringLiteral("edit"));
    return false; // the step's result has not come yet
  }

  bool isAttached() {
    Attachment &attachment = m_window.attachment();
    if (m_shot.process == 0)
      return true;
    if (!attachment.isAttached())
      m_window.attachPanel().attachTo(m_shot.process);
    return attachment.isAttached() && !attachment.picture().isNull() &&
           !attachment.programs().isEmpty() && !attachment.ownText().isEmpty();
  }

  bool isTraced() {
    if (m_shot.pixel.isEmpty())
      return true;
    if (!m_isTraced && (m_shot.process != 0 || !m_bench.picture().isNull())) {
      m_isTraced = true;
      const QPoint pixel(m_shot.pixel.section(u',', 0, 0).toInt(),
                         m_shot.pixel.section(u',', 1).toInt());
      if (m_shot.process != 0)
        Q_EMIT m_window.attachPanel().picture().pixelPicked(pixel);
      else
        m_bench.debugPixel(pixel);
    }
    return !m_bench.trace().rows().isEmpty();
  }

  bool isWatched() {
    if (m_shot.watched == 0 || m_isWatched)
      return m_shot.watched == 0 || m_bench.isPinned();
    m_isWatched = true;
    m_bench.trace().runToLine(m_shot.watched);
    m_bench.watchRow(m_bench.trace().current());
    return false;
  }

  void take(bool late) {
    QImage image = m_window.grab().toImage();
    if (m_shot.small)
      image = withFewColors(image);
    // 0: the smallest file
    const bool written = image.save(m_shot.png, "PNG", m_shot.small ? 0 : -1);
    if (!written)
      std::fprintf(stderr, "arbiter-builder: %s cannot be written\n",
                   m_shot.png.toLocal8Bit().constData());
    else if (late)
      std::fprintf(stderr,
                   "arbiter-builder: not all was there after %d s: %s shows what was (%s)\n",
                   int(kPatience / 1000), m_shot.png.toLocal8Bit().constData(),
                   m_bench.statusText().toLocal8Bit().constData());
    QApplication::exit(written && !late ? kExitOk : kExitUsage);
  }

  MainWindow &m_window;
  Workbench &m_bench;
  Shot m_shot; ///< finished steps are removed
  bool m_isTraced = false, m_isWatched = false;
  QTimer m_timer;
  QElapsedTimer m_since, m_settled;
};

} // namespace

void takeScreenshot(MainWindow &window, const Shot &shot) { new Photographer(window, shot); }

} // namespace arbiter::builder
