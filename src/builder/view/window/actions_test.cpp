// What keys and menus do, with the language server and the renderer at work.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QInputDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>

#include "builder/testing/window_test.h"

namespace arbiter::builder {

using testing::kText;
using testing::serve;
using testing::waitFor;
using testing::Window;

namespace {

/// As soon as a dialog is open, \p answer gets it.
void whenAsked(const std::function<void(QDialog &)> &answer) {
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

/// The action of that name, as a menu or a key runs it.
void run(MainWindow &window, const char *name) {
  for (QAction *action : window.findChildren<QAction *>())
    if (action->text().remove(u'&') == QLatin1StringView(name))
      return action->trigger();
  FAIL() << "no action " << name;
}

} // namespace

TEST_F(Window, ANameIsRenamedEverywhereByF2) {
  open(kText);
  editor().goTo(text().indexOf(QStringLiteral("red.x;")));
  whenAsked([](QDialog &dialog) {
    auto *name = dialog.findChild<QLineEdit *>();
    name->setText(QStringLiteral("crimson"));
    dialog.accept();
  });
  run(*window, "Rename...");
  ASSERT_TRUE(waitFor([&] { return has("PARAM crimson"); })) << text().toStdString();
  EXPECT_TRUE(has("crimson.x;"));
  ASSERT_TRUE(drawsNewest());
  EXPECT_EQ(middle().red(), 64);
  document().undo();
  EXPECT_EQ(text(), kText) << "one step";
}

TEST_F(Window, TheDefinitionIsGoneToByF12) {
  open(kText);
  editor().goTo(text().indexOf(QStringLiteral("red.x;")));
  run(*window, "Go to definition");
  ASSERT_TRUE(waitFor([&] { return editor().textCursor().blockNumber() == 3; }))
      << editor().textCursor().blockNumber();
}

TEST_F(Window, AFixIsTakenByAltReturn) {
  open(kText);
  document().replace(text().indexOf(QStringLiteral("red.x;")), 3, QStringLiteral("rde"),
                     Origin::Tool, QStringLiteral("edit"));
  ASSERT_TRUE(waitFor([&] { return !bench().problems().isEmpty(); }));
  EXPECT_TRUE(bench().problems()[0].hint.contains(QStringLiteral("red")));
  editor().goToProblem(true);
  run(*window, "Fix this line");
  ASSERT_TRUE(waitFor([&] { return text() == kText; })) << text().toStdString();
}

/// A pixel is clicked, its instructions stepped through both ways; the verdict is the picture's
/// own.
TEST_F(Window, APixelIsPickedAndStepped) {
  open(kText);
  QTest::mouseClick(&picture(), Qt::LeftButton, {}, picture().rectOf({10, 50}).center().toPoint());
  Trace &trace = bench().trace();
  ASSERT_TRUE(waitFor([&] { return !trace.rows().isEmpty(); }));
  EXPECT_EQ(bench().debuggedPixel(), QPoint(10, 50));
  EXPECT_TRUE(trace.isEqual()) << trace.verdict().toStdString();
  ASSERT_EQ(trace.rows().size(), 2);
  trace.moveTo(0);
  run(*window, "Step forward");
  EXPECT_EQ(trace.current(), 1);
  EXPECT_EQ(trace.rows()[1].value.color().red(), 64) << "the vector as a colour";
  run(*window, "Step back");
  EXPECT_EQ(trace.current(), 0);
  editor().goTo(text().indexOf(QStringLiteral("MOV result.color.x")));
  run(*window, "Run to cursor");
  EXPECT_EQ(trace.current(), 1);
  QTest::keyClick(&picture(), Qt::Key_Up);
  EXPECT_EQ(bench().debuggedPixel(), QPoint(10, 51));
}

TEST_F(Window, TheNextNaNIsFoundByF7) {
  QString nan = kText;
  nan.replace(QStringLiteral("MOV result.color.x, red.x;"),
              QStringLiteral("TEMP t;\nMOV t, red;\nRSQ t.y, -red.x;\nRCP t.z, t.w;\n"
                             "MUL t.z, t.z, t.w;\nMOV result.color.x, red.x;"));
  open(nan);
  bench().debugPixel({1, 1});
  Trace &trace = bench().trace();
  ASSERT_TRUE(waitFor([&] { return trace.rows().size() >= 6; }));
  trace.moveTo(0);
  run(*window, "Next NaN");
  EXPECT_TRUE(trace.rows()[trace.current()].flags.contains(QStringLiteral("nan")))
      << "at line " << trace.rows()[trace.current()].line;
}

TEST_F(Window, ARegisterIsSeenOverTheWholePicture) {
  open(kText);
  bench().debugPixel({3, 3});
  ASSERT_TRUE(waitFor([&] { return !bench().trace().rows().isEmpty(); }));
  bench().watchRow(0);
  ASSERT_TRUE(waitFor([&] { return bench().isPinned(); }));
  EXPECT_EQ(bench().pinned().size(), QSize(64, 64));
  EXPECT_EQ(bench().pinned().pixelColor(32, 32).red(), 0) << "before the second instruction";
  EXPECT_EQ(middle().red(), 64);
}

TEST_F(Window, AnAnimationPausesAndGoesFrameByFrame) {
  open(QString(kText).replace(QStringLiteral("in 0..1"), QStringLiteral("in 0..1 animate saw 1s")));
  ASSERT_TRUE(waitFor([&] { return bench().frame().time > 0.1; })) << "it does not move";
  run(*window, "Pause");
  serve(200); // what was under way
  const double paused = bench().frame().time;
  serve(300);
  EXPECT_EQ(bench().frame().time, paused);
  run(*window, "One frame");
  ASSERT_TRUE(waitFor([&] { return bench().frame().time > paused; }));
  EXPECT_NEAR(bench().frame().time, paused + 1.0 / 60, 1e-3);
  run(*window, "Pause");
  EXPECT_TRUE(waitFor([&] { return bench().frame().time > paused + 0.1; }));
}

TEST_F(Window, AnEditDoesNotRestartTheAnimation) {
  open(QString(kText).replace(QStringLiteral("in 0..1"), QStringLiteral("in 0..1 animate saw 9s")));
  ASSERT_TRUE(waitFor([&] { return bench().frame().time > 0.5; }));
  editor().goTo(text().size());
  QTest::keyClicks(&editor(), QStringLiteral("# a"));
  const qint64 newest = document().revision();
  ASSERT_TRUE(waitFor([&] { return bench().frame().revision == newest; }));
  EXPECT_GT(bench().frame().time, 0.5);
}

TEST_F(Window, WhatStandsStillOrIsHiddenDrawsNothing) {
  open(kText);
  serve(200);
  qint64 number = bench().frame().number;
  serve(400);
  EXPECT_EQ(bench().frame().number, number) << "a still document was drawn again";
  open(QString(kText).replace(QStringLiteral("in 0..1"), QStringLiteral("in 0..1 animate saw 1s")));
  ASSERT_TRUE(waitFor([&] { return bench().frame().time > 0.1; }));
  window->hide();
  serve(200);
  number = bench().frame().number;
  serve(400);
  EXPECT_EQ(bench().frame().number, number) << "what is not seen was drawn";
  window->show();
  EXPECT_TRUE(waitFor([&] { return bench().frame().number > number + 3; }));
}

TEST_F(Window, ASlowDocumentBeginsPaused) {
  window->picture().setSlow(0); // any is
  QString said;
  QObject::connect(&bench(), &Workbench::notice, [&](const QString &text) { said = text; });
  open(QString(kText).replace(QStringLiteral("in 0..1"), QStringLiteral("in 0..1 animate saw 1s")));
  ASSERT_TRUE(waitFor([&] { return bench().renderer().isPaused(); }));
  EXPECT_TRUE(said.contains(QStringLiteral("paused"))) << said.toStdString();
}

TEST_F(Window, AnyActionIsFoundByItsName) {
  open(kText);
  whenAsked([](QDialog &dialog) {
    auto *search = dialog.findChild<QLineEdit *>();
    QTest::keyClicks(search, QStringLiteral("pause"));
    EXPECT_EQ(dialog.findChild<QListWidget *>()->count(), 1);
    QTest::keyClick(search, Qt::Key_Return);
  });
  run(*window, "Any action...");
  EXPECT_TRUE(bench().renderer().isPaused());
  EXPECT_FALSE(bench().pictureState() == PictureState::Wrong);
}

TEST_F(Window, ANameIsGoneToByTypingIt) {
  open(kText);
  whenAsked([](QDialog &dialog) {
    auto *list = dialog.findChild<QListWidget *>();
    ASSERT_GT(list->count(), 0);
    EXPECT_TRUE(list->item(0)->text().startsWith(QStringLiteral("red")))
        << list->item(0)->text().toStdString();
    QTest::keyClick(dialog.findChild<QLineEdit *>(), Qt::Key_Return);
  });
  run(*window, "Go to name...");
  EXPECT_TRUE(waitFor([&] { return editor().textCursor().blockNumber() == 3; }));
}

/// Every widget that takes the focus by Tab is reached by Tab from the first one of its panel.
TEST_F(Window, TabReachesAllOfAPanel) {
  open(kText);
  window->activateWindow();
  for (const QString &name : window->panelNames()) {
    if (name == u"Program") // where Tab is a character; Escape, Shift+Tab and Alt+digits lead out
      continue;
    window->showPanel(name);
    auto *dock = window->findChild<QDockWidget *>(name);
    ASSERT_TRUE(waitFor([&] { return dock->widget()->isVisible(); }, 5000)) << name.toStdString();
    QList<QWidget *> expected;
    for (QWidget *each : dock->widget()->findChildren<QWidget *>())
      if ((each->focusPolicy() & Qt::TabFocus) && each->isVisible() && each->isEnabled() &&
          !each->focusProxy())
        expected << each;
    QSet<QWidget *> reached;
    QWidget *at = QApplication::focusWidget();
    ASSERT_NE(at, nullptr) << name.toStdString();
    for (int step = 0; step < 300 && at && !reached.contains(at); ++step) {
      reached.insert(at);
      QTest::keyClick(at, Qt::Key_Tab);
      at = QApplication::focusWidget();
    }
    for (QWidget *each : expected)
      EXPECT_TRUE(reached.contains(each))
          << name.toStdString() << ": " << each->metaObject()->className() << " "
          << each->objectName().toStdString() << " " << each->accessibleName().toStdString();
  }
}

TEST_F(Window, EveryWidgetThatIsUsedHasAName) {
  open(kText);
  for (const QString &name : window->panelNames()) {
    auto *dock = window->findChild<QDockWidget *>(name);
    for (QWidget *each : dock->widget()->findChildren<QWidget *>()) {
      const auto *button = qobject_cast<QAbstractButton *>(each);
      const bool isInner = each->objectName().startsWith(QStringLiteral("qt_")) ||
                           each->focusPolicy() == Qt::NoFocus || each->focusProxy();
      if (isInner || (button && !button->text().isEmpty()))
        continue;
      const bool says = !each->accessibleName().isEmpty() || !each->toolTip().isEmpty() ||
                        qobject_cast<QLabel *>(each);
      QWidget *parent = each->parentWidget();
      const bool inside = parent && !parent->accessibleName().isEmpty();
      const auto labels = dock->widget()->findChildren<QLabel *>();
      const bool labelled = std::any_of(labels.cbegin(), labels.cend(), [&](const QLabel *label) {
        return label->buddy() == each;
      });
      EXPECT_TRUE(says || inside || labelled)
          << name.toStdString() << ": " << each->metaObject()->className() << " "
          << each->objectName().toStdString();
    }
  }
}

TEST_F(Window, ThePictureIsAWindowOfItsOwnByF11) {
  open(kText);
  auto *dock = window->findChild<QDockWidget *>(QStringLiteral("Picture"));
  run(*window, "Picture as its own window");
  EXPECT_TRUE(dock->isFloating());
  EXPECT_FALSE(bench().renderer().isPaused()) << "it is seen there";
  run(*window, "Picture as its own window");
  EXPECT_FALSE(dock->isFloating());
}

TEST_F(Window, PanelsAreWhereTheyWereLeft) {
  auto *dock = window->findChild<QDockWidget *>(QStringLiteral("Textures"));
  window->addDockWidget(Qt::LeftDockWidgetArea, dock);
  window->close();
  Places places = bench().places();
  MainWindow again(places);
  auto *same = again.findChild<QDockWidget *>(QStringLiteral("Textures"));
  EXPECT_EQ(again.dockWidgetArea(same), Qt::RightDockWidgetArea);
  again.restoreLayout();
  EXPECT_EQ(again.dockWidgetArea(same), Qt::LeftDockWidgetArea);
}

/// A stays while B is typed.
TEST_F(Window, ThePinnedPictureStaysWhileTheTextChanges) {
  open(kText);
  run(*window, "Pin the picture as A");
  document().replace(text().indexOf(QStringLiteral("0.25")), 4, QStringLiteral("1"), Origin::Tool,
                     QStringLiteral("edit"));
  ASSERT_TRUE(waitFor([&] { return middle().red() == 255; }));
  EXPECT_EQ(bench().pinned().pixelColor(32, 32).red(), 64);
  const Comparison figures = compare(bench().pinned(), bench().picture());
  EXPECT_EQ(figures.pixels, 64 * 64);
  EXPECT_EQ(figures.worst, 191);
  RenderOptions fp24 = bench().renderer().options();
  fp24.numerics = QStringLiteral("fp24");
  bench().compareWith(fp24);
  ASSERT_TRUE(waitFor([&] {
    return bench().isPinned() && bench().pinned().pixelColor(32, 32).red() == 255;
  })) << "A is drawn by another process, with each change";
}

TEST_F(Window, TheBenchSaysHowLongAFrameTakes) {
  open(kText);
  window->showPanel(QStringLiteral("Bench"));
  auto &button = find<QPushButton>("bench-run");
  button.click();
  EXPECT_FALSE(button.isEnabled());
  auto *dock = window->findChild<QDockWidget *>(QStringLiteral("Bench"));
  auto *table = dock->widget()->findChild<QTableWidget *>();
  ASSERT_TRUE(waitFor([&] { return table->rowCount() == 1; }));
  EXPECT_GT(table->item(0, 3)->text().toDouble(), 0);
  EXPECT_TRUE(button.isEnabled());
}

TEST_F(Window, TheGaugesSayWhatTheProgramTakes) {
  open(kText);
  ASSERT_TRUE(waitFor([&] { return !bench().report().gauges.isEmpty(); }));
  document().replace(text().indexOf(QStringLiteral("END")), 0,
                     QStringLiteral("ADD result.color.y, red.x, red.x;\n"), Origin::Tool,
                     QStringLiteral("edit"));
  const auto instructions = [&] {
    for (const Gauge &gauge : bench().report().gauges)
      if (gauge.name.contains(QStringLiteral("alu")))
        return gauge.used;
    return -1;
  };
  const int before = instructions();
  EXPECT_TRUE(waitFor([&] { return instructions() > before; })) << before;
}

/// Nothing says why a picture is black, but this.
TEST_F(Window, AUnitWithoutAnImageIsSaid) {
  const QString sampling =
      QStringLiteral("!!ARBfp1.0\n#@ size 16 16\n# texture[7] is none\nTEMP t;\n"
                     "TEX result.color, fragment.texcoord[0], texture[ 3 ], 2D;\nEND\n");
  open(sampling);
  ASSERT_TRUE(waitFor([&] { return !bench().problems().isEmpty(); }));
  ASSERT_EQ(bench().problems().size(), 1);
  const Problem &problem = bench().problems()[0];
  EXPECT_EQ(problem.severity, Severity::Warning);
  EXPECT_TRUE(problem.message.startsWith(QStringLiteral("texture[3] has no image")));
  EXPECT_EQ(problem.line, 5);
  document().replace(11, 0, QStringLiteral("#@ texture 3 = constant r 1 g 0 b 0\n"), Origin::Tool,
                     QStringLiteral("edit"));
  ASSERT_TRUE(drawsNewest());
  EXPECT_TRUE(waitFor([&] { return bench().problems().isEmpty(); }));
  EXPECT_EQ(middle(), QColor(Qt::red));
}

/// Values are the text's own: they are in the file, and there again when it is opened.
TEST_F(Window, AValueIsKeptInTheFile) {
  QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("a.fp"));
  open(kText);
  ASSERT_TRUE(bench().file().save(file));
  bench().parameters().set(0, {0.75});
  ASSERT_TRUE(bench().file().save());
  open(QStringLiteral("!!ARBfp1.0\nMOV result.color, {1};\nEND\n"));
  window->openPath(file);
  EXPECT_EQ(bench().parameters().lines()[0].components[0].value, 0.75);
  ASSERT_TRUE(waitFor([&] { return middle().red() == 191; }));
}

} // namespace arbiter::builder
