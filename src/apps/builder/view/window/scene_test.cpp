// A change by mouse or widget is a line of the text, and one undo step.
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QProcess>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>
#include <QWheelEvent>

#include "apps/builder/model/panels/textures.h"
#include "apps/builder/testing/window_test.h"
#include "apps/builder/view/panels/beside.h"
#include "apps/builder/view/panels/cube_dialog.h"
#include "apps/builder/view/panels/number_box.h"
#include "apps/builder/view/window/export_dialog.h"

namespace arbiter::builder {

using testing::kText;
using testing::waitFor;
using testing::Window;

namespace {

const QString kSphere = QStringLiteral("!!ARBfp1.0\n"
                                       "#@ size 64 64, mesh sphere, camera orbit distance 3\n"
                                       "MOV result.color, fragment.texcoord[0];\n"
                                       "END\n");

/// Types a number and Return.
void type(NumberBox &box, const char *number) {
  box.selectAll();
  QTest::keyClicks(&box, QString::fromLatin1(number));
  QTest::keyClick(&box, Qt::Key_Return);
}

void choose(QComboBox &box, const char *word) {
  const int at = box.findText(QString::fromLatin1(word));
  ASSERT_GE(at, 0) << word;
  box.setCurrentIndex(at);
  Q_EMIT box.activated(at);
  Q_EMIT box.textActivated(box.itemText(at));
}

QByteArray bytesOf(const QImage &image) {
  return QByteArray(reinterpret_cast<const char *>(image.constBits()), image.sizeInBytes());
}

void writeImage(const QString &file, QColor color) {
  QImage image(4, 4, QImage::Format_RGB32);
  image.fill(color);
  ASSERT_TRUE(image.save(file, "PNG"));
}

} // namespace

TEST_F(Window, ThePanelOfTheSceneWritesItsLines) {
  open(kSphere);
  window->showPanel(QStringLiteral("Scene"));
  type(find<NumberBox>("scene-width"), "96");
  EXPECT_TRUE(has("#@ size 96 64, mesh sphere")) << text().toStdString();
  document().undo();
  EXPECT_EQ(text(), kSphere) << "one step";
  choose(find<QComboBox>("scene-mesh"), "torus");
  EXPECT_TRUE(has("mesh torus, camera")) << text().toStdString();
  type(find<NumberBox>("scene-mesh-tube"), "0.5");
  EXPECT_TRUE(has("mesh torus tube 0.5, camera"));
  type(find<NumberBox>("scene-camera-yaw"), "30");
  EXPECT_TRUE(has("camera orbit distance 3 yaw 30\n"));
  choose(find<QComboBox>("scene-blend"), "add");
  choose(find<QComboBox>("scene-depth"), "lequal");
  EXPECT_TRUE(has("#@ blend add\n"));
  EXPECT_TRUE(has("#@ depth lequal\n"));
  find<QCheckBox>("scene-depth-write").click();
  EXPECT_TRUE(has("#@ depth lequal write off\n"));
  find<QCheckBox>("scene-keep").click();
  EXPECT_TRUE(has("#@ keep\n"));
  find<QCheckBox>("scene-keep").click();
  EXPECT_FALSE(has("keep"));
  choose(find<QComboBox>("scene-blend"), "not said");
  EXPECT_FALSE(has("blend"));
  ASSERT_TRUE(drawsNewest()) << bench().statusText().toStdString();
  EXPECT_TRUE(bench().problems().isEmpty());
  auto &words = find<QLineEdit>("scene-mesh-words");
  words.setText(QStringLiteral("cube and sphere at 2 0 0"));
  Q_EMIT words.editingFinished();
  EXPECT_TRUE(has("mesh cube and sphere at 2 0 0, camera"));
  while (document().canUndo())
    document().undo();
  EXPECT_EQ(text(), kSphere);
}

TEST_F(Window, PassesAreAddedAndTakenAway) {
  QTemporaryDir folder;
  const QString main = folder.filePath(QStringLiteral("main.fp"));
  for (const char *name : {"main.fp", "ink.fp"}) {
    QFile file(folder.filePath(QString::fromLatin1(name)));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QString(kSphere)
                   .replace(QStringLiteral("MOV"), QStringLiteral("#@ then ink.fp\nMOV"))
                   .toLatin1());
  }
  window->openPath(main);
  auto &list = find<QListWidget>("scene-passes");
  ASSERT_EQ(list.count(), 2);
  EXPECT_TRUE(list.item(1)->text().contains(QStringLiteral("ink.fp")));
  EXPECT_FALSE(find<QPushButton>("scene-remove").isEnabled());
  list.setCurrentRow(1);
  find<QPushButton>("scene-remove").click();
  EXPECT_FALSE(has("then"));
  EXPECT_EQ(find<QListWidget>("scene-passes").count(), 1);
  document().undo();
  auto &again = find<QListWidget>("scene-passes");
  ASSERT_EQ(again.count(), 2);
  again.setCurrentRow(1);
  find<QPushButton>("scene-open").click();
  EXPECT_EQ(bench().file().name(), QStringLiteral("ink.fp"));
}

TEST_F(Window, TheMouseTurnsTheCameraAndTheTextHasIt) {
  open(kSphere);
  const QByteArray before = bytesOf(bench().picture());
  const QPoint middle = picture().rect().center();
  QTest::mousePress(&picture(), Qt::RightButton, {}, middle);
  const QPoint aside = middle + QPoint(picture().width() / 4, 0);
  QMouseEvent move(QEvent::MouseMove, aside, picture().mapToGlobal(QPointF(aside)), Qt::NoButton,
                   Qt::RightButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&picture(), &move);
  ASSERT_TRUE(waitFor([&] { return bytesOf(bench().picture()) != before; }))
      << "the picture does not follow";
  EXPECT_EQ(text(), kSphere) << "a camera that is held changed the text";
  const QByteArray turned = bytesOf(bench().picture());
  QTest::mouseRelease(&picture(), Qt::RightButton, {}, aside);
  EXPECT_TRUE(has("orbit distance 3 yaw -4")) << text().toStdString(); // about -45
  ASSERT_TRUE(drawsNewest());
  EXPECT_EQ(bytesOf(bench().picture()), turned) << "letting go turned it";
  document().undo();
  EXPECT_EQ(text(), kSphere) << "one step";
  QTest::keyClick(&picture(), Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_TRUE(has("yaw 5")) << text().toStdString();
  QTest::keyClick(&picture(), Qt::Key_PageUp, Qt::ShiftModifier);
  EXPECT_TRUE(has("distance 2.7 yaw 5"));
}

TEST_F(Window, ACameraThatIsNoneDoesNotTurn) {
  open(kText);
  QString said;
  QObject::connect(&bench(), &Workbench::notice, [&](const QString &text) { said = text; });
  QTest::keyClick(&picture(), Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(text(), kText);
  EXPECT_TRUE(said.contains(QStringLiteral("no orbiting camera")));
}

TEST_F(Window, RangeAndAnimationOfAParameter) {
  open(kText);
  window->showPanel(QStringLiteral("Parameters"));
  find<QToolButton>("settings-0").click();
  auto &high = find<NumberBox>("high-0");
  EXPECT_TRUE(high.isVisible());
  type(high, "2");
  EXPECT_TRUE(has("= 0.25 in 0..2\n")) << text().toStdString();
  EXPECT_TRUE(high.isVisible()) << "the row closed under the user";
  choose(find<QComboBox>("motion-0"), "saw");
  EXPECT_TRUE(has("in 0..2 animate saw 5s\n")) << text().toStdString();
  type(find<NumberBox>("period-0"), "2.5");
  EXPECT_TRUE(has("animate saw 2.5s\n"));
  ASSERT_TRUE(waitFor([&] { return bench().frame().number > 3; })) << "it does not move";
  choose(find<QComboBox>("motion-0"), "still");
  EXPECT_FALSE(has("animate"));
  type(find<NumberBox>("low-0"), "3");
  EXPECT_TRUE(has("in 0..2\n")) << "the low end is under the high one";
  find<QPushButton>("add-parameter").click();
  EXPECT_TRUE(has("#@ local[1].x \"value 1\" = 0.5 in 0..1\n"));
  EXPECT_NE(window->findChild<QSlider *>(QStringLiteral("slider-1-0")), nullptr);
  for (int step = 0; step < 5; ++step)
    document().undo();
  EXPECT_EQ(text(), kText);
}

TEST_F(Window, TheWheelPassesOverASliderWithoutTheFocus) {
  open(kText);
  window->showPanel(QStringLiteral("Parameters"));
  editor().setFocus();
  auto &slider = find<QSlider>("slider-0-0");
  QWheelEvent wheel(QPointF(5, 5), slider.mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&slider, &wheel);
  EXPECT_EQ(text(), kText);
  slider.setFocus();
  QTest::keyClick(&slider, Qt::Key_Right);
  EXPECT_NE(text(), kText) << "keys move it";
}

TEST_F(Window, ATextureIsPickedGeneratedAndSampled) {
  QTemporaryDir folder, elsewhere;
  const QString main = folder.filePath(QStringLiteral("main.fp"));
  QFile file(main);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(kText.toLatin1());
  file.close();
  window->openPath(main);
  ASSERT_TRUE(drawsNewest());
  find<QSpinBox>("texture-unit").setValue(2);
  const auto trigger = [&](const char *word) {
    for (QAction *action : find<QMenu>("texture-generators").actions())
      if (action->text().startsWith(QString::fromLatin1(word)))
        return action->trigger();
    FAIL() << word;
  };
  trigger("checker");
  EXPECT_TRUE(has("#@ texture 2 = checker 256 256\n")) << text().toStdString();
  choose(find<QComboBox>("texture-filter"), "nearest");
  choose(find<QComboBox>("texture-wrap"), "edge");
  EXPECT_TRUE(has("#@ texture 2 = checker 256 256, nearest, edge\n")) << text().toStdString();
  trigger("normals");
  EXPECT_TRUE(has("= normals strength 2 of checker 256 256, nearest, edge\n"));
  trigger("feedback");
  EXPECT_TRUE(has("= feedback of noise 256 256, nearest, edge\n")) << text().toStdString();
  writeImage(folder.filePath(QStringLiteral("a b.png")), Qt::red);
  writeImage(elsewhere.filePath(QStringLiteral("a b.png")), Qt::blue);
  EXPECT_EQ(nameBeside(nullptr, bench(), folder.filePath(QStringLiteral("a b.png"))),
            QStringLiteral("a b.png"));
  EXPECT_EQ(copyBeside(bench(), elsewhere.filePath(QStringLiteral("a b.png"))),
            QStringLiteral("a b-2.png"))
      << "the document's own file would be lost";
  EXPECT_TRUE(QFile::exists(folder.filePath(QStringLiteral("a b-2.png"))));
}

TEST_F(Window, UnitsHaveTheirImagesSmall) {
  open(QString(kText).replace(QStringLiteral("PARAM"),
                              QStringLiteral("#@ texture 1 = constant r 0 g 1 b 0\nPARAM")));
  auto *dock = window->findChild<QDockWidget *>(QStringLiteral("Textures"));
  auto *list = dock->widget()->findChild<QListWidget *>();
  ASSERT_EQ(list->count(), 1);
  EXPECT_TRUE(list->item(0)->text().startsWith(QStringLiteral("unit 1: constant r 0 g 1 b 0")));
  EXPECT_TRUE(waitFor([&] {
    return list->item(0)->icon().pixmap(64, 64).toImage().pixelColor(32, 32) == QColor(Qt::green);
  }));
}

TEST_F(Window, ACubeOfSixFilesIsPicked) {
  QTemporaryDir folder;
  const QString main = folder.filePath(QStringLiteral("main.fp"));
  QFile file(main);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("!!ARBfp1.0\n#@ size 32 32\nTEMP d;\nMAD d, fragment.texcoord[0], 0.1, {1,0,0,0};\n"
             "TEX result.color, d, texture[0], CUBE;\nEND\n");
  file.close();
  const QList<QColor> colors{Qt::red, Qt::green, Qt::blue, Qt::cyan, Qt::magenta, Qt::yellow};
  const QStringList faces{QStringLiteral("posx"), QStringLiteral("negx"), QStringLiteral("posy"),
                          QStringLiteral("negy"), QStringLiteral("posz"), QStringLiteral("negz")};
  for (int i = 0; i < 6; ++i)
    writeImage(folder.filePath(QStringLiteral("room_%1.png").arg(faces[i])), colors[i]);
  window->openPath(main);
  CubeDialog dialog(bench(), 0);
  auto *ok = dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
  EXPECT_FALSE(ok->isEnabled());
  auto *face = dialog.findChild<QLineEdit *>(QStringLiteral("face-3"));
  face->setText(QStringLiteral("room_negy.png"));
  Q_EMIT face->editingFinished();
  ASSERT_TRUE(ok->isEnabled()) << "the five that are named alike";
  EXPECT_EQ(dialog.source(), QStringLiteral("cube room_posx.png room_negx.png room_posy.png "
                                            "room_negy.png room_posz.png room_negz.png"));
  document().apply({setTexture(text(), 0, dialog.source())}, QStringLiteral("cube"));
  ASSERT_TRUE(drawsNewest()) << bench().statusText().toStdString();
  EXPECT_EQ(middle(), QColor(Qt::red));
  CubeDialog again(bench(), 0);
  EXPECT_EQ(again.source(), dialog.source()) << "it begins with what the unit has";
}

TEST_F(Window, ASequenceIsExportedFrameByFrame) {
  const QString moving =
      QString(kText).replace(QStringLiteral("in 0..1"), QStringLiteral("in 0..1 animate saw 1s"));
  open(moving);
  QTemporaryDir folder;
  ExportDialog dialog(bench(), m_folder.path());
  dialog.show();
  const auto child = [&](const char *name) {
    return dialog.findChild<QWidget *>(QString::fromLatin1(name));
  };
  auto *frames = qobject_cast<QSpinBox *>(child("export-frames"));
  auto *state = qobject_cast<QLabel *>(child("export-state"));
  EXPECT_EQ(frames->value(), 60) << "a second";
  qobject_cast<QDoubleSpinBox *>(child("export-seconds"))->setValue(0.1);
  EXPECT_EQ(frames->value(), 6);
  qobject_cast<QSpinBox *>(child("export-first"))->setValue(10);
  frames->setValue(3);
  const QString target = folder.filePath(QStringLiteral("new/frames"));
  qobject_cast<QLineEdit *>(child("export-folder"))->setText(target);
  qobject_cast<QLineEdit *>(child("export-name"))->setText(QStringLiteral("red"));
  auto *start = qobject_cast<QPushButton *>(child("export-start"));
  start->click();
  EXPECT_FALSE(start->isEnabled());
  ASSERT_TRUE(waitFor([&] { return start->isEnabled(); }));
  EXPECT_TRUE(state->text().startsWith(QStringLiteral("3 of 3"))) << state->text().toStdString();
  EXPECT_EQ(QDir(target).entryList(QDir::Files).join(u' '),
            QStringLiteral("red-0010.png red-0011.png red-0012.png"));
  // A script gets the same pictures.
  QFile document(folder.filePath(QStringLiteral("red.fp")));
  ASSERT_TRUE(document.open(QIODevice::WriteOnly));
  document.write(moving.toLatin1());
  document.close();
  const QString alone = folder.filePath(QStringLiteral("alone.png"));
  ASSERT_EQ(
      QProcess::execute(bench().places().arbiter,
                        {QStringLiteral("draw"), document.fileName(), QStringLiteral("--frame"),
                         QStringLiteral("12"), QStringLiteral("-o"), alone}),
      0);
  const QImage exported(target + QStringLiteral("/red-0012.png")), drawn(alone);
  EXPECT_EQ(exported.pixelColor(32, 32).name(QColor::HexArgb).toStdString(),
            drawn.pixelColor(32, 32).name(QColor::HexArgb).toStdString());
  EXPECT_EQ(bytesOf(exported.convertToFormat(QImage::Format_ARGB32)),
            bytesOf(drawn.convertToFormat(QImage::Format_ARGB32)))
      << "what a file says of its colours may differ, pixels may not";
  EXPECT_NE(QImage(target + QStringLiteral("/red-0010.png")),
            QImage(target + QStringLiteral("/red-0012.png")));
}

TEST_F(Window, ASequenceIsStoppedAndSaysWhatIsWrong) {
  open(kText);
  QTemporaryDir folder;
  SequenceExport sequence(bench().places().arbiter);
  QString complaint = QStringLiteral("still at it");
  QObject::connect(&sequence, &SequenceExport::finished,
                   [&](const QString &text) { complaint = text; });
  SequenceRequest request{folder.path(), QStringLiteral("a"), 0, 100000, 60};
  sequence.start(bench().scene(), {}, request);
  ASSERT_TRUE(waitFor([&] { return sequence.written() >= 2; }));
  sequence.cancel();
  EXPECT_FALSE(sequence.isRunning());
  EXPECT_EQ(complaint, QString()) << "who stops it knows";
  EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), sequence.written());
  Scene wrong = bench().scene();
  wrong.text.replace(QStringLiteral("MOV"), QStringLiteral("MVO"));
  sequence.start(wrong, {}, request);
  ASSERT_TRUE(waitFor([&] { return !sequence.isRunning(); }));
  EXPECT_TRUE(complaint.contains(QStringLiteral("wrong"))) << complaint.toStdString();
  request.folder = QStringLiteral("/proc/nowhere");
  sequence.start(bench().scene(), {}, request);
  EXPECT_TRUE(complaint.contains(QStringLiteral("cannot be made")));
}

} // namespace arbiter::builder
