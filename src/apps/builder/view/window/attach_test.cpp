#include <QComboBox>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>

#include "apps/builder/model/attach/attachment.h"
#include "apps/builder/testing/fake_application.h"
#include "apps/builder/testing/model_test.h"
#include "apps/builder/view/panels/attach_panel.h"
#include "apps/builder/view/picture/picture_view.h"
#include "apps/builder/view/window/main_window.h"

namespace arbiter::builder {

using testing::FakeApplication;
using testing::waitFor;

namespace {

/// Tests the panel in its window.
class AttachWindow : public ::testing::Test {
protected:
  void open() {
    Places places = Places::standard();
    places.journals = m_folder.filePath(QStringLiteral("journals"));
    places.held = {};
    window = std::make_unique<MainWindow>(places);
    window->resize(1280, 800);
    window->show();
    window->showPanel(QStringLiteral("Attach"));
    ASSERT_TRUE(waitFor([&] { return window->attachPanel().isVisible(); }));
    window->attachPanel().listProcesses();
  }
  template <typename Widget> Widget *find(const char *name) {
    auto *const found = window->attachPanel().findChild<Widget *>(QString::fromLatin1(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  Attachment &it() { return window->attachment(); }
  QPlainTextEdit &text() { return *find<QPlainTextEdit>("attached-text"); }
  void attach() {
    QTest::mouseClick(find<QPushButton>("attach"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] {
      return it().isAttached() && !text().toPlainText().isEmpty() && !it().parameters().isEmpty();
    }));
  }
  /// Returns the middle of the application's frame, as the panel shows it.
  [[nodiscard]] QColor middle() {
    const QImage &image = window->attachPanel().picture().picture();
    return image.isNull() ? QColor() : image.pixelColor(image.width() / 2, image.height() / 2);
  }
  bool shows(const QColor &color) {
    return waitFor([&] { return middle() == color; });
  }

  QTemporaryDir m_folder;
  std::unique_ptr<MainWindow> window;
};

} // namespace

TEST_F(AttachWindow, AProgramIsTypedIntoAndPutBack) {
  FakeApplication application;
  open();
  attach();
  EXPECT_EQ(text().toPlainText(), QString::fromLatin1(FakeApplication::kText));
  auto *programs = find<QTableWidget>("attached-programs");
  EXPECT_EQ(programs->rowCount(), 2);
  EXPECT_EQ(programs->item(0, 0)->text(), QStringLiteral("00112233.fp"));
  EXPECT_EQ(programs->item(0, 1)->text(), QStringLiteral("both"));
  ASSERT_TRUE(shows(QColor(0, 255, 0)));
  text().setFocus();
  text().moveCursor(QTextCursor::End);
  QTest::keyClicks(&text(), QStringLiteral("# red"));
  ASSERT_TRUE(waitFor([&] { return application.edit().ends_with("# red"); }));
  ASSERT_TRUE(shows(QColor(255, 0, 0)));
  QTest::keyClicks(&text(), QStringLiteral(" wrong"));
  auto *problems = find<QListWidget>("attached-problems");
  ASSERT_TRUE(waitFor([&] { return problems->isVisible() && problems->count() == 1; }));
  EXPECT_EQ(problems->item(0)->text(), QStringLiteral("2:1 it is wrong: mend it"));
  EXPECT_FALSE(text().extraSelections().isEmpty()) << "nothing is underlined";
  EXPECT_FALSE(application.edit().ends_with("wrong"));
  QTest::mouseClick(find<QPushButton>("put-back"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return application.edit().empty(); }));
  ASSERT_TRUE(
      waitFor([&] { return text().toPlainText() == QString::fromLatin1(FakeApplication::kText); }));
  ASSERT_TRUE(shows(QColor(0, 255, 0)));
  EXPECT_FALSE(problems->isVisible());
}

TEST_F(AttachWindow, ValuesAreTurnedWhileTheApplicationDraws) {
  FakeApplication application;
  open();
  attach();
  auto *number = find<QDoubleSpinBox>("attached-program.local[0]-0");
  ASSERT_NE(number, nullptr);
  EXPECT_DOUBLE_EQ(number->value(), 0.25);
  number->setValue(0.5);
  ASSERT_TRUE(waitFor([&] { return application.value() == 0.5; }));
  auto *table = find<QTableWidget>("attached-values");
  ASSERT_TRUE(waitFor([&] { return table->item(0, 5)->text() == QStringLiteral("held"); }));
  EXPECT_EQ(table->item(1, 5)->text(), QStringLiteral("state"));
  auto *textures = find<QListWidget>("attached-textures");
  ASSERT_TRUE(waitFor([&] { return textures->count() == 1; }));
  EXPECT_TRUE(textures->item(0)->text().contains(QStringLiteral("16x16, RGBA8")));
}

TEST_F(AttachWindow, DetachingLeavesNothing) {
  FakeApplication application;
  open();
  attach();
  text().setPlainText(QStringLiteral("red"));
  ASSERT_TRUE(waitFor([&] { return application.edit() == "red"; }));
  auto *button = find<QPushButton>("attach");
  QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return application.clients() == 0 && application.edit().empty(); }));
  EXPECT_TRUE(text().toPlainText().isEmpty());
  EXPECT_TRUE(text().isReadOnly());
  EXPECT_EQ(find<QTableWidget>("attached-programs")->rowCount(), 0);
  attach(); // again
  application.end();
  ASSERT_TRUE(waitFor([&] { return !it().isAttached(); })) << "an end is not noticed";
}

/// Tests with a real client: the program of tests/control, which draws yellow. Its process runs
/// under `arbiter run --control` (testing/attach_on_display.py).
TEST_F(AttachWindow, ARealClientIsTypedIntoTracedAndLeftAsItWas) {
  if (!qEnvironmentVariableIsSet("ATTACH_TO"))
    GTEST_SKIP() << "ATTACH_TO names no process";
  open();
  auto *process = find<QComboBox>("attached-process");
  const int at = process->findText(qEnvironmentVariable("ATTACH_TO"), Qt::MatchEndsWith);
  ASSERT_GE(at, 0);
  process->setCurrentIndex(at);
  attach();
  ASSERT_TRUE(shows(QColor(255, 255, 0)));
  const QString own = text().toPlainText();
  it().tracePixel({100, 60});
  Trace &trace = window->bench().trace();
  ASSERT_TRUE(waitFor([&] { return trace.rows().size() == 3; }));
  EXPECT_TRUE(window->tracesApplication());
  EXPECT_TRUE(trace.isEqual()) << trace.verdict().toStdString();
  EXPECT_EQ(trace.rows()[0].opcode, QStringLiteral("TEX"));
  it().measure();
  ASSERT_TRUE(waitFor([&] { return it().programs()[0].measured.has_value(); }));
  EXPECT_EQ(it().programs()[0].measured->pixels, 200 * 120);
  if (const QString png = qEnvironmentVariable("ATTACH_SCREENSHOT"); !png.isEmpty())
    window->grab().save(png, "PNG");
  text().setFocus();
  QTextCursor cursor = text().textCursor();
  cursor.setPosition(int(own.indexOf(QStringLiteral("END"))));
  text().setTextCursor(cursor);
  QTest::keyClicks(&text(), QStringLiteral("MOV result.color.x, 0; "));
  ASSERT_TRUE(shows(QColor(0, 255, 0))) << "the edit is not drawn with";
  ASSERT_TRUE(waitFor([&] { return it().isRight(); }));
  QTest::mouseClick(find<QPushButton>("attach"), Qt::LeftButton); // detaches
  ASSERT_TRUE(waitFor([&] { return !it().isAttached(); }));
  attach();
  EXPECT_EQ(text().toPlainText(), own);
  ASSERT_TRUE(shows(QColor(255, 255, 0))) << "the application is not as it was";
}

} // namespace arbiter::builder
