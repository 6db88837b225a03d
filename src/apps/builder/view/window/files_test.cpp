// Tests the saving of documents and pictures: where, under which name, and the messages.
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QSettings>

#include "apps/builder/model/panels/companions.h"
#include "apps/builder/testing/window_test.h"

namespace arbiter::builder {

using testing::kText;
using testing::runAction;
using testing::waitFor;
using testing::whenAsked;
using testing::Window;

namespace {

void accept(QDialog &dialog) { dialog.accept(); }

} // namespace

TEST_F(Window, ANoticeHidesNoError) {
  open(kText);
  ASSERT_TRUE(bench().file().save(m_folder.filePath(QStringLiteral("a.fp"))));
  document().replace(text().indexOf(QStringLiteral("END")), 0, QStringLiteral("BAD x;\n"),
                     Origin::Tool, QStringLiteral("edit"));
  auto &state = find<QLabel>("status-state");
  ASSERT_TRUE(waitFor([&] { return state.text().contains(QStringLiteral("is wrong")); }));
  runAction(*window, "Save");
  const auto &notice = find<QLabel>("status-notice");
  EXPECT_TRUE(notice.text().endsWith(QStringLiteral("a.fp is saved")))
      << notice.text().toStdString();
  EXPECT_TRUE(notice.isVisible());
  EXPECT_TRUE(state.isVisible()) << "what is wrong is hidden by what is saved";
  EXPECT_GE(state.width(), state.fontMetrics().horizontalAdvance(state.text()))
      << "the notice took the room of the error";
}

/// A copy of an installed document is saved in the user's folder, under its name, with the files it
/// needs.
TEST_F(Window, ACopyIsSavedWhereItsUserIs) {
  ASSERT_TRUE(window->openNamed(QStringLiteral("gallery:skinning")));
  ASSERT_TRUE(drawsNewest()) << bench().statusText().toStdString();
  QTemporaryDir folder;
  const QDir home(folder.path());
  QSettings().setValue(QStringLiteral("folder"), folder.path());
  QString proposed;
  whenAsked([&](QDialog &dialog) {
    if (auto *files = qobject_cast<QFileDialog *>(&dialog))
      proposed = files->selectedFiles().value(0);
    accept(dialog);
  });
  runAction(*window, "Save");
  EXPECT_EQ(proposed, home.filePath(QStringLiteral("skinning.fp")));
  EXPECT_EQ(bench().file().path(), proposed);
  EXPECT_TRUE(home.exists(QStringLiteral("skinning.vp"))) << "the vertex program stayed behind";
  ASSERT_TRUE(drawsNewest()) << bench().statusText().toStdString();
  EXPECT_TRUE(bench().problems().isEmpty());
  QString exported;
  whenAsked([&](QDialog &dialog) {
    if (auto *files = qobject_cast<QFileDialog *>(&dialog))
      exported = files->selectedFiles().value(0);
    accept(dialog);
  });
  runAction(*window, "Export picture...");
  EXPECT_EQ(exported, home.filePath(QStringLiteral("skinning.png")));
  EXPECT_EQ(QImage(exported).size(), bench().picture().size());
}

TEST(Companions, AreWhatTheDocumentNamesAndLiesInItsFolder) {
  QTemporaryDir around, to;
  const QDir from(around.filePath(QStringLiteral("document")));
  const auto write = [](const QString &path, const char *text) {
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  };
  const char *const second = "!!ARBfp1.0\n#@ texture 0 = in/b.png\nEND\n";
  write(from.filePath(QStringLiteral("second.fp")), second);
  for (const char *name : {"a.png", "in/b.png", "m.obj", "../outside.png"})
    write(from.filePath(QString::fromLatin1(name)), name);
  const QString text = QStringLiteral("!!ARBfp1.0\n#@ texture 0 = normals of a.png\n"
                                      "#@ mesh plane and m.obj, then second.fp\n"
                                      "#@ texture 1 = ../outside.png\n"
                                      "#@ texture 2 = none.png\nEND\n");
  const QStringList names = companionsOf(text, QStringLiteral("a.fp"), from.path());
  EXPECT_EQ(
      QSet<QString>(names.cbegin(), names.cend()),
      (QSet<QString>{QStringLiteral("a.png"), QStringLiteral("in/b.png"), QStringLiteral("m.obj"),
                     QStringLiteral("second.fp"), QStringLiteral("none.png")}))
      << names.join(u' ').toStdString();
  write(to.filePath(QStringLiteral("a.png")), "the user's own");
  QStringList failed;
  const QStringList copied = copyCompanions(names, from.path(), to.path(), failed);
  EXPECT_EQ(copied.size(), 3) << copied.join(u' ').toStdString();
  EXPECT_TRUE(failed.isEmpty()) << failed.join(u' ').toStdString();
  EXPECT_TRUE(QFile::exists(to.filePath(QStringLiteral("in/b.png"))));
  QFile own(to.filePath(QStringLiteral("a.png")));
  ASSERT_TRUE(own.open(QIODevice::ReadOnly));
  EXPECT_EQ(own.readAll(), "the user's own") << "a file of the user's was written over";
}

} // namespace arbiter::builder
