#pragma once
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QTest>
#include <memory>
#include <stdexcept>

#include "apps/builder/testing/model_test.h"
#include "apps/builder/view/editor/code_editor.h"
#include "apps/builder/view/picture/picture_panel.h"
#include "apps/builder/view/picture/picture_view.h"
#include "apps/builder/view/window/main_window.h"

namespace arbiter::builder::testing {

inline const QString kText = QStringLiteral("!!ARBfp1.0\n"
                                            "#@ size 64 64\n"
                                            "#@ local[0].x \"red\" = 0.25 in 0..1\n"
                                            "PARAM red = program.local[0];\n"
                                            "MOV result.color, {0, 0, 0, 1};\n"
                                            "MOV result.color.x, red.x;\n"
                                            "END\n");

/// Runs the action of that name, as a menu or a key does.
inline void runAction(MainWindow &window, const char *name) {
  for (QAction *action : window.findChildren<QAction *>())
    if (action->text().remove(u'&') == QLatin1StringView(name))
      return action->trigger();
  FAIL() << "no action " << name;
}

/// Calls \p answer with the next dialog that opens.
inline void whenAsked(const std::function<void(QDialog &)> &answer) {
  auto *timer = new QTimer(qApp);
  QObject::connect(timer, &QTimer::timeout, timer, [timer, answer] {
    auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget());
    if (!dialog)
      return;
    timer->stop();
    timer->deleteLater();
    answer(*dialog);
  });
  timer->start(20);
}

/// Tests the window with a document and real processes.
class Window : public ::testing::Test {
protected:
  Window() {
    Places places = Places::standard();
    places.journals = m_folder.filePath(QStringLiteral("journals"));
    places.held = {};
    window = std::make_unique<MainWindow>(places);
    window->show();
    window->bench().start();
  }

  Workbench &bench() { return window->bench(); }
  Document &document() { return window->bench().document(); }
  CodeEditor &editor() { return window->editor(); }
  PictureView &picture() { return window->picture().view(); }
  [[nodiscard]] QColor middle() {
    const QImage &image = window->bench().picture();
    return image.isNull() ? QColor() : image.pixelColor(image.width() / 2, image.height() / 2);
  }
  bool drawsNewest() {
    return waitFor([&] { return window->bench().pictureState() == PictureState::Newest; });
  }
  void open(const QString &text) {
    window->openText(text);
    ASSERT_TRUE(drawsNewest()) << window->bench().statusText().toStdString();
  }
  /// Returns the widget of that name in the window; fails if there is none.
  template <typename Widget> Widget &find(const char *name) {
    auto *found = window->findChild<Widget *>(QString::fromLatin1(name));
    if (!found)
      throw std::runtime_error(std::string("no widget ") + name);
    return *found;
  }
  [[nodiscard]] QString text() { return document().text(); }
  [[nodiscard]] bool has(const char *piece) { return text().contains(QString::fromUtf8(piece)); }
  [[nodiscard]] int squiggles() {
    int count = 0;
    for (const auto &mark : editor().extraSelections())
      count += mark.format.underlineStyle() == QTextCharFormat::WaveUnderline;
    return count;
  }

  QTemporaryDir m_folder;
  std::unique_ptr<MainWindow> window;
};

} // namespace arbiter::builder::testing
