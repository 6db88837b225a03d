// Tests keys and menus with the language server and the renderer.
#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTimer>

#include "apps/builder/testing/window_test.h"

namespace arbiter::builder {

using testing::kText;
using testing::runAction;
using testing::waitFor;
using testing::whenAsked;
using testing::Window;

TEST_F(Window, ANameIsRenamedEverywhereByF2) {
  open(kText);
  editor().goTo(text().indexOf(QStringLiteral("red.x;")));
  whenAsked([](QDialog &dialog) {
    auto *name = dialog.findChild<QLineEdit *>();
    name->setText(QStringLiteral("crimson"));
    dialog.accept();
  });
  runAction(*window, "Rename...");
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
  runAction(*window, "Go to definition");
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
  runAction(*window, "Fix this line");
  ASSERT_TRUE(waitFor([&] { return text() == kText; })) << text().toStdString();
}

TEST_F(Window, AnyActionIsFoundByItsName) {
  open(kText);
  whenAsked([](QDialog &dialog) {
    auto *search = dialog.findChild<QLineEdit *>();
    QTest::keyClicks(search, QStringLiteral("pause"));
    EXPECT_EQ(dialog.findChild<QListWidget *>()->count(), 1);
    QTest::keyClick(search, Qt::Key_Return);
  });
  runAction(*window, "Any action...");
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
  runAction(*window, "Go to name...");
  EXPECT_TRUE(waitFor([&] { return editor().textCursor().blockNumber() == 3; }));
}

/// Tab reaches every widget that takes the focus from the first one of its panel.
TEST_F(Window, TabReachesAllOfAPanel) {
  open(kText);
  window->activateWindow();
  for (const QString &name : window->panelNames()) {
    if (name == u"Program") // Tab is a character there; Escape, Shift+Tab and Alt+digits lead out
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
                           each->focusPolicy() == Qt::NoFocus || each->focusProxy() ||
                           each->window() != dock->window(); // a drop-down list
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
  runAction(*window, "Picture as its own window");
  EXPECT_TRUE(dock->isFloating());
  EXPECT_FALSE(bench().renderer().isPaused()) << "it is seen there";
  runAction(*window, "Picture as its own window");
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

/// Values are stored in the text: they are in the file, and there again when it is opened.
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
