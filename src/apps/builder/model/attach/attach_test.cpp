#include <QDir>
#include <QFile>

#include "apps/builder/model/attach/attachment.h"
#include "apps/builder/testing/fake_application.h"
#include "apps/builder/testing/model_test.h"

namespace arbiter::builder {

using testing::FakeApplication;
using testing::waitFor;

namespace {

const QString kProgram = QString::fromLatin1(FakeApplication::kProgram);

/// An attachment to the fake application, which records its signals.
class Attached : public ::testing::Test {
protected:
  Attached() : it(QStringLiteral("/bin/false")) {
    QObject::connect(&it, &Attachment::textCame, [this](const QString &text) { texts << text; });
    QObject::connect(&it, &Attachment::troubled, [this](const QString &why) { troubles << why; });
    QObject::connect(&it, &Attachment::judged, [this] { ++judged; });
    const QList<ListeningProcess> all = listeningProcesses();
    EXPECT_EQ(all.size(), 1);
    if (!all.isEmpty())
      it.attach(all[0]);
  }
  void chooseProgram() {
    it.select(kProgram);
    ASSERT_TRUE(waitFor([&] { return !texts.isEmpty() && !it.parameters().isEmpty(); }));
  }

  FakeApplication application;
  Attachment it;
  QStringList texts, troubles;
  int judged = 0;
};

} // namespace

TEST_F(Attached, ShowsWhatTheApplicationHas) {
  ASSERT_TRUE(waitFor([&] { return !it.programs().isEmpty() && !it.picture().isNull(); }));
  const AttachedProgram &program = it.programs()[0];
  EXPECT_EQ(program.id, kProgram);
  EXPECT_EQ(program.drawer(), QStringLiteral("both"));
  EXPECT_EQ(program.draws, 10);
  EXPECT_EQ(it.picture().size(), QSize(4, 2));
  EXPECT_EQ(it.picture().pixelColor(0, 0), QColor(0, 255, 0)) << "a window's alpha is not seen";
  ASSERT_TRUE(
      waitFor([&] { return !it.textures().isEmpty() && !it.textures()[0].image.isNull(); }));
  EXPECT_EQ(it.textures()[0].image.pixelColor(0, 1), QColor(255, 0, 0))
      << "GL's first row is lowest";
  it.measure();
  ASSERT_TRUE(waitFor([&] { return it.programs()[0].measured.has_value(); }));
  EXPECT_EQ(it.programs()[0].measured->pixels, 8);
}

TEST_F(Attached, ATextIsEditedLiveAndPutBack) {
  chooseProgram();
  EXPECT_EQ(texts.last(), QString::fromLatin1(FakeApplication::kText));
  it.setText(QStringLiteral("red"));
  ASSERT_TRUE(waitFor([&] { return application.edit() == "red"; }));
  it.setText(QString::fromUtf8("\xc3\xa4 wrong"));
  ASSERT_TRUE(waitFor([&] { return !it.isRight(); }));
  EXPECT_EQ(application.edit(), "red") << "a wrong text changes nothing";
  ASSERT_EQ(it.problems().size(), 1);
  EXPECT_EQ(it.problems()[0].begin, 2) << "bytes became UTF-16 units";
  EXPECT_EQ(it.problems()[0].hint, QStringLiteral("mend it"));
  it.refresh();
  ASSERT_TRUE(waitFor([&] { return it.picture().pixelColor(0, 0) == QColor(255, 0, 0); }));
  it.putBack();
  ASSERT_TRUE(waitFor([&] { return application.edit().empty() && it.isRight(); }));
  EXPECT_EQ(texts.last(), QString::fromLatin1(FakeApplication::kText));
}

TEST_F(Attached, OfManyTextsTheNewestIsSent) {
  chooseProgram();
  application.setDelay(100);
  for (int i = 0; i < 100; ++i)
    it.setText(QStringLiteral("text %1").arg(i));
  ASSERT_TRUE(waitFor([&] { return application.edit() == "text 99"; }));
  EXPECT_EQ(application.count("program.set"), 2) << "those between were sent";
}

TEST_F(Attached, AValueIsHeldAndLetGo) {
  chooseProgram();
  EXPECT_TRUE(it.parameters()[0].isSettable());
  EXPECT_FALSE(it.parameters()[1].isSettable());
  it.setParameter(QStringLiteral("program.local[0]"), {0.75, 0, 0, 1});
  ASSERT_TRUE(waitFor([&] { return application.value() == 0.75; }));
  it.refresh();
  ASSERT_TRUE(waitFor([&] { return !it.parameters().isEmpty() && it.parameters()[0].held; }));
  it.letGo(QStringLiteral("program.local[0]"));
  ASSERT_TRUE(waitFor([&] { return application.value() == 0.25; }));
}

TEST_F(Attached, DetachingUndoesAll) {
  chooseProgram();
  it.setText(QStringLiteral("red"));
  ASSERT_TRUE(waitFor([&] { return application.edit() == "red"; }));
  it.detach();
  EXPECT_FALSE(it.isAttached());
  EXPECT_TRUE(it.programs().isEmpty());
  ASSERT_TRUE(waitFor([&] { return application.clients() == 0 && application.edit().empty(); }));
  EXPECT_TRUE(troubles.isEmpty()) << troubles.join(u'\n').toStdString();
}

TEST_F(Attached, AnApplicationThatEndsIsSaid) {
  chooseProgram();
  application.end();
  ASSERT_TRUE(waitFor([&] { return !it.isAttached(); }));
  ASSERT_FALSE(troubles.isEmpty());
  EXPECT_TRUE(troubles.last().contains(QStringLiteral("has ended")));
  EXPECT_TRUE(listeningProcesses().isEmpty());
}

TEST_F(Attached, AFolderOfReplacementsHasTheTextsAndNoOtherNames) {
  chooseProgram();
  it.setText(QStringLiteral("red"));
  ASSERT_TRUE(waitFor([&] { return application.edit() == "red"; }));
  QTemporaryDir folder;
  int programs = -1;
  QObject::connect(&it, &Attachment::exported, [&](const QString &, int n) { programs = n; });
  it.exportTo(folder.filePath(QStringLiteral("patches")));
  ASSERT_TRUE(waitFor([&] { return programs >= 0; }));
  EXPECT_EQ(programs, 1) << "an id that names a path is none";
  const QDir made(folder.filePath(QStringLiteral("patches")));
  EXPECT_EQ(made.entryList(QDir::Files), QStringList{kProgram});
  QFile file(made.filePath(kProgram));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(file.readAll(), "red");
}

TEST(AttachedFiles, AnIdIsAHashAndNoPath) {
  EXPECT_EQ(fileNameOf(QStringLiteral("0af.vp")), QStringLiteral("0af.vp"));
  for (const char *const bad :
       {"", "../x.fp", "a/b.fp", "0af", "0AF.fp", ".fp", "0af.fp\n", "0af.so"})
    EXPECT_EQ(fileNameOf(QString::fromLatin1(bad)), QString()) << bad;
}

} // namespace arbiter::builder
