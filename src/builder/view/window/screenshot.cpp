#include "builder/view/window/screenshot.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTimer>
#include <memory>

#include "builder/view/window/main_window.h"

namespace arbiter::builder {

namespace {

constexpr qint64 kPatience = 30000;
constexpr qint64 kSettle = 700; ///< for what is asked when a picture is there: advice, thumbnails

bool isSettled(Workbench &bench, bool traced) {
  const PictureState state = bench.pictureState();
  const bool drawn = bench.document().text().isEmpty() || state == PictureState::Newest ||
                     state == PictureState::Wrong || state == PictureState::Held;
  const bool told = !bench.report().gauges.isEmpty() || !bench.problems().isEmpty() ||
                    bench.document().text().isEmpty();
  return drawn && told && (!traced || !bench.trace().rows().isEmpty());
}

/// 32 shades a channel, and no alpha: what is nearly flat becomes flat, and packs well.
QImage withFewColours(const QImage &image) {
  QImage few = image.convertToFormat(QImage::Format_RGB888);
  for (int y = 0; y < few.height(); ++y) {
    uchar *const row = few.scanLine(y);
    for (int x = 0; x < 3 * few.width(); ++x)
      row[x] = uchar((row[x] * 31 + 127) / 255 * 255 / 31);
  }
  return few;
}

} // namespace

void takeScreenshot(MainWindow &window, const QString &png, const QString &pixel, bool small) {
  auto *timer = new QTimer(&window);
  auto since = std::make_shared<QElapsedTimer>();
  auto settled = std::make_shared<QElapsedTimer>();
  auto asked = std::make_shared<bool>(false);
  since->start();
  QObject::connect(timer, &QTimer::timeout, &window, [=, &window] {
    Workbench &bench = window.bench();
    if (!pixel.isEmpty() && !*asked && !bench.picture().isNull()) {
      *asked = true;
      bench.debugPixel({pixel.section(u',', 0, 0).toInt(), pixel.section(u',', 1).toInt()});
    }
    const bool late = since->elapsed() > kPatience;
    if (!late && !isSettled(bench, !pixel.isEmpty())) {
      settled->invalidate();
      return;
    }
    if (!settled->isValid())
      settled->start();
    if (!late && settled->elapsed() < kSettle)
      return;
    timer->stop();
    QImage image = window.grab().toImage();
    if (small)
      image = withFewColours(image);
    const bool written = image.save(png, "PNG", small ? 0 : -1); // 0: packed best
    QApplication::exit(written && !late ? 0 : 1);
  });
  timer->start(50);
}

} // namespace arbiter::builder
