#include <QAction>
#include <QDockWidget>
#include <QListWidget>
#include <QMouseEvent>
#include <QSlider>
#include <QTest>

#include "apps/builder/testing/window_test.h"
#include "apps/builder/view/theme.h"

namespace arbiter::builder {

using testing::kText;
using testing::waitFor;
using testing::Window;

/// The test types a mistake, sees it marked while the picture stays, corrects it, moves the slider,
/// sees the pixels change, and undoes it.
TEST_F(Window, TypeBreakMendSlide) {
  open(kText);
  EXPECT_EQ(middle().red(), 64);
  editor().setFocus();
  editor().goTo(kText.indexOf(QStringLiteral("red.x;")) + 3);
  QTest::keyClicks(&editor(), QStringLiteral("d"));
  EXPECT_TRUE(document().text().contains(QStringLiteral("redd.x")));
  ASSERT_TRUE(waitFor([&] { return squiggles() > 0; }));
  ASSERT_TRUE(waitFor([&] { return window->bench().pictureState() == PictureState::Wrong; }));
  EXPECT_EQ(middle().red(), 64) << "the last good picture is gone";
  EXPECT_EQ(editor().textCursor().position(), kText.indexOf(QStringLiteral("red.x;")) + 4);
  QTest::keyClick(&editor(), Qt::Key_Backspace);
  ASSERT_TRUE(waitFor([&] { return squiggles() == 0; }));
  ASSERT_TRUE(drawsNewest());
  auto *slider = window->findChild<QSlider *>(QStringLiteral("slider-0-0"));
  ASSERT_NE(slider, nullptr);
  slider->setSliderDown(true);
  slider->setValue(1000);
  ASSERT_TRUE(waitFor([&] { return middle().red() == 255; }));
  EXPECT_EQ(document().text(), kText) << "a slider that is held changed the text";
  slider->setSliderDown(false);
  EXPECT_TRUE(document().text().contains(QStringLiteral("= 1 in 0..1")));
  document().undo();
  ASSERT_TRUE(waitFor([&] { return middle().red() == 64; }));
  EXPECT_EQ(document().text(), kText);
}

TEST_F(Window, WhatOthersChangeIsShownAndTheCursorStays) {
  open(kText);
  editor().goTo(20);
  document().replace(kText.size(), 0, QString::fromUtf8("# \xf0\x9f\x8e\xa8\xc2\xa0x\n"),
                     Origin::Outside, QStringLiteral("outside"));
  EXPECT_EQ(editor().textCursor().position(), 20);
  QTest::keyClicks(&editor(), QStringLiteral(" "));
  EXPECT_TRUE(document().text().endsWith(QString::fromUtf8("# \xf0\x9f\x8e\xa8\xc2\xa0x\n")))
      << "a space that does not break became another";
  document().undo();
  document().undo();
  EXPECT_EQ(document().text(), kText);
  EXPECT_EQ(editor().toPlainText(), kText);
}

TEST_F(Window, CompletionIsTakenByKeys) {
  open(kText);
  window->activateWindow();
  editor().setFocus();
  editor().goTo(kText.indexOf(QStringLiteral("END")));
  QTest::keyClicks(&editor(), QStringLiteral("RSQ"));
  auto *list = editor().findChild<QListWidget *>();
  ASSERT_NE(list, nullptr);
  QTest::keyClick(&editor(), Qt::Key_Backspace);
  editor().complete();
  ASSERT_TRUE(waitFor([&] { return list->isVisible() && list->currentItem(); }));
  EXPECT_TRUE(list->currentItem()->text().startsWith(QStringLiteral("RS")));
  QTest::keyClick(&editor(), Qt::Key_Return);
  EXPECT_TRUE(document().text().contains(QStringLiteral("RSQ"))) << document().text().toStdString();
}

TEST_F(Window, ProblemsAreListedAndGoneTo) {
  open(kText);
  document().replace(kText.indexOf(QStringLiteral("END")), 0, QStringLiteral("BAD x;\n"),
                     Origin::Tool, QStringLiteral("edit"));
  ASSERT_TRUE(waitFor([&] { return !window->bench().problems().isEmpty(); }));
  editor().goTo(0);
  editor().goToProblem(true);
  EXPECT_EQ(editor().textCursor().blockNumber() + 1, window->bench().problems()[0].line);
  auto *dock = window->findChild<QDockWidget *>(QStringLiteral("Problems"));
  EXPECT_EQ(dock->windowTitle(),
            QStringLiteral("Problems %1").arg(window->bench().problems().size()));
}

TEST_F(Window, EveryPanelIsReachedByKeysAndKeepsItsPlace) {
  open(kText);
  EXPECT_EQ(window->findChildren<QDockWidget *>().size(), MainWindow::panelNames().size());
  for (const QString &name : MainWindow::panelNames()) {
    window->showPanel(name);
    auto *dock = window->findChild<QDockWidget *>(name);
    ASSERT_NE(dock, nullptr);
    EXPECT_TRUE(waitFor([&] { return dock->widget()->isVisible(); }, 5000)) << name.toStdString();
  }
  QStringList keys;
  for (QAction *action : window->findChildren<QAction *>())
    if (!action->shortcut().isEmpty()) {
      EXPECT_FALSE(keys.contains(action->shortcut().toString()))
          << action->shortcut().toString().toStdString() << " has two meanings";
      keys << action->shortcut().toString();
    }
  EXPECT_GT(keys.size(), 25);
}

TEST(PictureView, APixelOfTheWidgetIsAPixelOfThePicture) {
  PictureView view;
  QImage image(8, 4, QImage::Format_RGBA8888);
  image.fill(Qt::black);
  image.setPixelColor(5, 0, Qt::red); // the top row, which is y 3 in GL
  view.setPicture(image);
  for (const QSize size : {QSize(100, 100), QSize(333, 217), QSize(41, 90)})
    for (const double zoom : {0.0, 1.0, 3.0}) {
      view.resize(size);
      view.setZoom(zoom);
      for (int x = 0; x < 8; ++x)
        for (int y = 0; y < 4; ++y) {
          const QRectF box = view.rectOf({x, y});
          EXPECT_EQ(view.pixelAt(box.center()), QPoint(x, y));
          EXPECT_EQ(view.pixelAt(box.topLeft() + QPointF(0.01, 0.01)), QPoint(x, y));
        }
      EXPECT_EQ(view.pixelAt({-1, -1}), std::nullopt);
    }
  EXPECT_EQ(view.colorAt({5, 3}), QColor(Qt::red));
  QPoint picked(-1, -1);
  QObject::connect(&view, &PictureView::pixelPicked, [&](QPoint pixel) { picked = pixel; });
  view.show();
  QTest::mouseClick(&view, Qt::LeftButton, {}, view.rectOf({5, 3}).center().toPoint());
  EXPECT_EQ(picked, QPoint(5, 3));
  QTest::keyClick(&view, Qt::Key_Left);
  EXPECT_EQ(picked, QPoint(3, 2)) << "without a mark, from the middle";
}

TEST(PictureView, TheColorUnderTheMouseIsThePicturesAsItMoves) {
  PictureView view;
  view.resize(100, 100);
  QImage image(4, 4, QImage::Format_RGBA8888);
  image.fill(Qt::red);
  view.setPicture(image);
  QColor told;
  bool left = false;
  QObject::connect(&view, &PictureView::pixelHovered,
                   [&](QPoint, const QColor &color) { told = color; });
  QObject::connect(&view, &PictureView::pixelLeft, [&] { left = true; });
  const auto move = [&](QPointF to) {
    QMouseEvent event(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, Qt::NoButton,
                      Qt::NoModifier);
    QCoreApplication::sendEvent(&view, &event);
  };
  move(view.rectOf({1, 2}).center());
  EXPECT_EQ(told, QColor(Qt::red));
  image.fill(Qt::blue);
  view.setPicture(image);
  EXPECT_EQ(told, QColor(Qt::blue)) << "the mouse stands still, and the picture does not";
  EXPECT_FALSE(left);
  move({1, 1});
  EXPECT_TRUE(left) << "no pixel is under the mouse";
  told = QColor();
  view.setPicture(image);
  EXPECT_FALSE(told.isValid());
}

TEST(Theme, TextsHaveTheContrastOfTheGuideline) {
  for (const Scheme scheme : {Scheme::Light, Scheme::Dark}) {
    applyScheme(*qApp, scheme);
    const Colors &c = colors();
    for (const QColor &text :
         {c.text, c.dim, c.error, c.warning, c.note, c.opcode, c.keyword, c.option, c.binding,
          c.name, c.parameter, c.number, c.comment, c.panel})
      for (const QColor &ground : {c.background, c.line, c.traced})
        EXPECT_GE(contrast(text, ground), 4.5)
            << text.name().toStdString() << " on " << ground.name().toStdString();
    const QPalette palette = qApp->palette();
    for (const QColor &text : {c.text, c.dim, c.error, c.warning, c.note, c.good, c.amber,
                               palette.color(QPalette::PlaceholderText)})
      EXPECT_GE(contrast(text, palette.color(QPalette::Window)), 4.5)
          << text.name().toStdString() << " on the window's ground";
    EXPECT_GE(
        contrast(palette.color(QPalette::HighlightedText), palette.color(QPalette::Highlight)),
        4.5);
    EXPECT_GE(contrast(palette.color(QPalette::ButtonText), palette.color(QPalette::Button)), 4.5);
  }
  applyScheme(*qApp, Scheme::Light);
}

} // namespace arbiter::builder
