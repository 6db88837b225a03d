// Tests what is drawn, when, and the reports about pixels.
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>

#include "apps/builder/testing/window_test.h"

namespace arbiter::builder {

using testing::kText;
using testing::runAction;
using testing::serve;
using testing::waitFor;
using testing::Window;

/// The test clicks a pixel and steps through its instructions both ways; the verdict agrees with
/// the picture.
TEST_F(Window, APixelIsPickedAndStepped) {
  open(kText);
  QTest::mouseClick(&picture(), Qt::LeftButton, {}, picture().rectOf({10, 50}).center().toPoint());
  Trace &trace = bench().trace();
  ASSERT_TRUE(waitFor([&] { return !trace.rows().isEmpty(); }));
  EXPECT_EQ(bench().debuggedPixel(), QPoint(10, 50));
  EXPECT_TRUE(trace.isEqual()) << trace.verdict().toStdString();
  ASSERT_EQ(trace.rows().size(), 2);
  trace.moveTo(0);
  runAction(*window, "Step forward");
  EXPECT_EQ(trace.current(), 1);
  EXPECT_EQ(trace.rows()[1].value.color().red(), 64) << "the vector as a colour";
  runAction(*window, "Step back");
  EXPECT_EQ(trace.current(), 0);
  editor().goTo(text().indexOf(QStringLiteral("MOV result.color.x")));
  runAction(*window, "Run to cursor");
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
  runAction(*window, "Next NaN");
  EXPECT_TRUE(trace.rows()[trace.current()].flags.contains(QStringLiteral("nan")))
      << "at line " << trace.rows()[trace.current()].line;
  // A register is listed once, with its mask, however it is spelled.
  trace.moveTo(int(trace.rows().size()) - 1);
  QStringList names;
  for (const auto &[name, value] : trace.registers())
    names << name;
  EXPECT_EQ(names, QStringList({QStringLiteral("result.color"), QStringLiteral("t")}))
      << names.join(u' ').toStdString();
  for (const auto *table : window->findChildren<QTableWidget *>())
    for (int row = 0; table->accessibleName() == QStringLiteral("Trace") && row < table->rowCount();
         ++row)
      EXPECT_TRUE(table->item(row, 3)->text().startsWith(trace.rows()[row].destination +
                                                         QStringLiteral(" = (")))
          << table->item(row, 3)->text().toStdString();
}

TEST_F(Window, ThePixelOfAPausedFrameIsThatFrames) {
  open(QString(kText).replace(QStringLiteral("in 0..1"), QStringLiteral("in 0..1 animate saw 2s")));
  ASSERT_TRUE(waitFor([&] { return bench().frame().time > 0.3; }));
  runAction(*window, "Pause");
  serve(200);
  const int red = middle().red();
  ASSERT_NE(red, 64);
  bench().debugPixel({32, 32});
  ASSERT_TRUE(waitFor([&] { return bench().trace().rows().size() == 2; }));
  EXPECT_EQ(bench().trace().rows()[1].value.color().red(), red);
  EXPECT_TRUE(bench().trace().isEqual()) << bench().trace().verdict().toStdString();
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
  runAction(*window, "Pause");
  serve(200); // for draws in progress
  const double paused = bench().frame().time;
  serve(300);
  EXPECT_EQ(bench().frame().time, paused);
  runAction(*window, "One frame");
  ASSERT_TRUE(waitFor([&] { return bench().frame().time > paused; }));
  EXPECT_NEAR(bench().frame().time, paused + 1.0 / 60, 1e-3);
  runAction(*window, "Pause");
  EXPECT_TRUE(waitFor([&] { return bench().frame().time > paused + 0.1; }));
}

TEST_F(Window, TheSliderMovesWithItsAnimation) {
  const QString moving =
      QString(kText).replace(QStringLiteral("in 0..1"), QStringLiteral("in 0..1 animate saw 4s"));
  open(moving);
  window->showPanel(QStringLiteral("Parameters"));
  auto &slider = find<QSlider>("slider-0-0");
  ASSERT_TRUE(waitFor([&] { return bench().frame().time > 0.4; }));
  runAction(*window, "Pause");
  serve(200); // for draws in progress
  EXPECT_GT(slider.value(), 340);
  EXPECT_NEAR(slider.value() * 255 / 1000.0, middle().red(), 1) << "not where the picture has it";
  EXPECT_EQ(find<QDoubleSpinBox>("number-0-0").value(), 0.25) << "it is where that begins";
  EXPECT_EQ(text(), moving) << "what moves by itself is no edit";
  slider.setSliderDown(true);
  slider.setValue(100);
  runAction(*window, "Pause");
  const double before = bench().frame().time;
  ASSERT_TRUE(waitFor([&] { return bench().frame().time > before + 0.2; }));
  EXPECT_EQ(slider.value(), 100) << "it moved under the hand that holds it";
  slider.setSliderDown(false);
  EXPECT_TRUE(has("= 0.1 in 0..1 animate saw 4s"));
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
  window->picture().setSlow(0); // any frame is slow
  QString said;
  QObject::connect(&bench(), &Workbench::notice, [&](const QString &text) { said = text; });
  open(QString(kText).replace(QStringLiteral("in 0..1"), QStringLiteral("in 0..1 animate saw 1s")));
  ASSERT_TRUE(waitFor([&] { return bench().renderer().isPaused(); }));
  EXPECT_TRUE(said.contains(QStringLiteral("paused"))) << said.toStdString();
}

/// A stays while B is edited.
TEST_F(Window, ThePinnedPictureStaysWhileTheTextChanges) {
  open(kText);
  runAction(*window, "Pin the picture as A");
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

/// In an animation A shows the same frame as B: with B's own settings there is no difference.
TEST_F(Window, BothSidesOfAComparisonAreOfOneTime) {
  open(QString(kText).replace(QStringLiteral("in 0..1"), QStringLiteral("in 0..1 animate saw 2s")));
  RenderOptions host;
  host.numerics = QStringLiteral("host");
  bench().compareWith(host);
  ASSERT_TRUE(waitFor([&] { return bench().isPinned() && bench().frame().time > 0.5; }));
  runAction(*window, "Pause");
  serve(300);
  const auto red = [](const QImage &image) { return image.pixelColor(32, 32).red(); };
  ASSERT_TRUE(waitFor([&] { return red(bench().pinned()) == middle().red(); }));
  serve(300);
  EXPECT_EQ(red(bench().pinned()), middle().red()) << "it stands still with B";
  for (int i = 0; i < 3; ++i)
    runAction(*window, "One frame");
  ASSERT_TRUE(waitFor([&] { return red(bench().pinned()) == middle().red(); }));
  bench().pin();
  const QImage kept = bench().pinned();
  EXPECT_EQ(red(kept), middle().red());
  runAction(*window, "Pause");
  serve(200);
  EXPECT_EQ(bench().pinned(), kept) << "what drew A before draws it no more";
}

/// With feedback a picture has no time: A has as many steps as B.
TEST_F(Window, BothSidesOfAComparisonFollowFromAsManyFrames) {
  open(QStringLiteral("!!ARBfp1.0\n#@ size 16 16\n"
                      "#@ texture 0 = feedback of constant r 0 g 0 b 0, nearest, edge\nTEMP t;\n"
                      "TEX t, fragment.texcoord[0], texture[0], 2D;\n"
                      "ADD result.color, t, {0.0039215687, 0, 0, 1};\nEND\n"));
  const auto red = [](const QImage &image) {
    return image.isNull() ? -1 : image.pixelColor(8, 8).red();
  };
  ASSERT_TRUE(waitFor([&] { return bench().frame().steps > 20; }));
  EXPECT_EQ(middle().red(), std::min(255, bench().frame().steps)) << "a frame adds one";
  RenderOptions host;
  host.numerics = QStringLiteral("host");
  int shown = 0, unlike = 0, last = 0;
  QObject::connect(&bench(), &Workbench::pinnedChanged, window.get(), [&] {
    ++shown;
    unlike += red(bench().pinned()) != middle().red();
    last = red(bench().pinned());
  });
  bench().compareWith(host);
  ASSERT_TRUE(waitFor([&] { return shown > 10; })) << "they do not go on together";
  EXPECT_EQ(unlike, 0) << "A is of another frame";
  EXPECT_GT(last, 25);
  runAction(*window, "Pause");
  serve(400);
  const int steps = bench().frame().steps;
  serve(300);
  EXPECT_EQ(bench().frame().steps, steps) << "it is paused";
  EXPECT_EQ(red(bench().pinned()), std::min(255, steps));
  runAction(*window, "One frame");
  ASSERT_TRUE(waitFor([&] { return red(bench().pinned()) == std::min(255, steps + 1); }));
  EXPECT_EQ(middle().red(), std::min(255, steps + 1));
  bench().unpin();
  runAction(*window, "Pause");
  ASSERT_TRUE(waitFor([&] { return bench().frame().steps > steps + 5; })) << "B goes on alone";
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

/// A unit without an image is reported, and visible: the picture has its number in white.
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
  const QImage number = bench().picture();
  int white = 0;
  for (int y = 0; y < number.height(); ++y)
    for (int x = 0; x < number.width(); ++x)
      white += number.pixelColor(x, y) == QColor(Qt::white);
  EXPECT_GT(white, 10);
  EXPECT_LT(white, 128);
  document().replace(11, 0, QStringLiteral("#@ texture 3 = constant r 1 g 0 b 0\n"), Origin::Tool,
                     QStringLiteral("edit"));
  EXPECT_TRUE(waitFor([&] { return bench().problems().isEmpty(); }));
  EXPECT_TRUE(waitFor([&] { return middle() == QColor(Qt::red); }));
}

} // namespace arbiter::builder
