// Measures how long the window takes, in milliseconds: from its start to the first picture, from a
// key to the squiggle, from a key to the new pixels, from a slider to the new pixels. Pixels count
// when the picture's widget has painted them.
//   QT_QPA_PLATFORM=offscreen ARBITER_COMMAND=.../arbiter builder_latency [TURNS]
#include <QApplication>
#include <QElapsedTimer>
#include <QPaintEvent>
#include <QSlider>
#include <QStandardPaths>
#include <QTest>
#include <algorithm>
#include <cstdio>

#include "apps/builder/testing/model_test.h"
#include "apps/builder/view/editor/code_editor.h"
#include "apps/builder/view/picture/picture_panel.h"
#include "apps/builder/view/picture/picture_view.h"
#include "apps/builder/view/theme.h"
#include "apps/builder/view/window/main_window.h"

namespace arbiter::builder {

namespace {

using testing::serve;
using testing::waitFor;

/// Returns a long program whose red is the parameter's, and whose green is `tone`.
QString program(int instructions) {
  QString text = QStringLiteral("!!ARBfp1.0\n#@ size 512 512, profile nv30\n"
                                "#@ local[0].x \"red\" = 0.25 in 0..1\n"
                                "PARAM red = program.local[0];\nPARAM tone = {0, 0.5, 0, 1};\n"
                                "TEMP t;\nMOV t, fragment.texcoord[0];\n");
  for (int i = 0; i < instructions - 4; ++i)
    text += QStringLiteral("MAD t, t, 0.99, fragment.texcoord[0].yxwz;\n");
  return text +
         QStringLiteral("MUL t, t, 0.0;\nADD t, t, tone;\nADD result.color, t, red.x;\nEND\n");
}

void print(const char *what, std::vector<double> times) {
  std::sort(times.begin(), times.end());
  if (times.empty())
    return;
  const auto at = [&](double part) {
    return times[std::min(times.size() - 1, std::size_t(part * double(times.size())))];
  };
  std::printf("%-24s median %7.1f  p99 %7.1f  worst %7.1f  (%zu)\n", what, at(0.5), at(0.99),
              times.back(), times.size());
  std::fflush(stdout);
}

/// Waits until the widget has painted a picture of that color.
class Painted : public QObject {
public:
  explicit Painted(PictureView &view) : m_view(view) { view.installEventFilter(this); }
  bool waits(const std::function<bool(QColor)> &wanted) {
    m_wanted = wanted;
    m_seen = false;
    return waitFor([this] { return m_seen; });
  }
  bool eventFilter(QObject *, QEvent *event) override {
    if (event->type() == QEvent::Paint && m_wanted && !m_view.picture().isNull()) {
      const QImage &image = m_view.picture();
      if (m_wanted(image.pixelColor(image.width() / 2, image.height() / 2)))
        m_seen = true;
    }
    return false;
  }

private:
  PictureView &m_view;
  std::function<bool(QColor)> m_wanted;
  bool m_seen = false;
};

/// Measures all. Returns what did not come in the time that tests wait; null: everything came.
const char *measure(int turns) {
  QTemporaryDir folder;
  QElapsedTimer since;
  since.start();
  Places places = Places::standard();
  places.journals = folder.filePath(QStringLiteral("journals"));
  places.held = {};
  MainWindow window(places);
  window.openText(program(96));
  window.bench().start();
  window.show();
  Painted painted(window.picture().view());
  if (!painted.waits([](QColor) { return true; }))
    return "a first picture";
  print("start to first picture", {double(since.nsecsElapsed()) / 1e6});
  CodeEditor &editor = window.editor();
  Workbench &bench = window.bench();
  std::vector<double> squiggle, pixels, slider;
  const auto millisecondsOf = [&] { return double(since.nsecsElapsed()) / 1e6; };
  waitFor([&] { return bench.pictureState() == PictureState::Newest; });
  const qsizetype digit = bench.document().text().indexOf(QStringLiteral("0, 0.5, 0, 1")) + 6;
  for (int turn = 0; turn < turns; ++turn) {
    serve(30);
    editor.goTo(digit);
    const int before = bench.picture().pixelColor(256, 256).green();
    since.restart();
    bench.document().closeStep();
    editor.textCursor().deletePreviousChar(); // leaves "0."; then another digit
    const char key = char('2' + turn % 7);
    QTest::keyClick(&editor, key);
    if (!painted.waits([&](QColor c) { return c.green() != before; }))
      return "the pixels of a key";
    pixels.push_back(millisecondsOf());
    waitFor([&] { return bench.pictureState() == PictureState::Newest; });
  }
  print("key to pixels", pixels);
  for (int turn = 0; turn < turns; ++turn) {
    serve(30);
    editor.goTo(bench.document().text().indexOf(QStringLiteral("MUL t")) + 3);
    since.restart();
    QTest::keyClick(&editor, 'X');
    waitFor([&] { return !bench.problems().isEmpty(); });
    squiggle.push_back(millisecondsOf());
    QTest::keyClick(&editor, Qt::Key_Backspace);
    waitFor([&] { return bench.problems().isEmpty(); });
  }
  print("key to squiggle", squiggle);
  waitFor([&] { return bench.pictureState() == PictureState::Newest; });
  auto *red = window.findChild<QSlider *>(QStringLiteral("slider-0-0"));
  red->setSliderDown(true);
  for (int turn = 0; turn < turns; ++turn) {
    serve(30);
    const int before = bench.picture().pixelColor(256, 256).red();
    since.restart();
    red->setValue(turn % 2 ? 200 : 900);
    if (!painted.waits([&](QColor c) { return c.red() != before; }))
      return "the pixels of a slider";
    slider.push_back(millisecondsOf());
  }
  print("slider to pixels", slider);
  return nullptr;
}

} // namespace

} // namespace arbiter::builder

int main(int argc, char **argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
    qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  QStandardPaths::setTestModeEnabled(true);
  arbiter::builder::applyScheme(application, arbiter::builder::Scheme::Light);
  const char *const missing = arbiter::builder::measure(
      argc > 1 ? std::max(1, QString::fromLocal8Bit(argv[1]).toInt()) : 50);
  if (missing)
    std::fprintf(stderr, "builder_latency: never came: %s\n", missing);
  return missing ? 1 : 0;
}
