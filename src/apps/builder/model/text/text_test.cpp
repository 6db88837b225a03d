#include <QFile>
#include <random>
#include <sys/wait.h>
#include <unistd.h>

#include "apps/builder/model/text/merge.h"
#include "apps/builder/model/text/open_file.h"
#include "apps/builder/testing/model_test.h"

namespace arbiter::builder {

using testing::waitFor;

namespace {

void type(Document &document, const QString &text) {
  for (const QChar c : text)
    document.replace(document.text().size(), 0, c, Origin::Typing);
}

void write(const QString &path, const QByteArray &bytes) {
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(bytes);
}

QByteArray bytesOf(const QString &path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

TEST(Edit, DifferenceMakesTheOtherText) {
  std::mt19937 random(7);
  for (int turn = 0; turn < 500; ++turn) {
    QString a, b;
    for (QString *text : {&a, &b})
      for (unsigned i = random() % 8; i > 0; --i)
        *text += QString::fromUtf8(random() % 3 == 0 ? "\xf0\x9f\x8e\xa8" : &"ab\n"[random() % 3]);
    const Edit edit = difference(a, b);
    QString made = a;
    EXPECT_EQ(made.mid(edit.at, edit.removed.size()), edit.removed);
    made.replace(edit.at, edit.removed.size(), edit.added);
    EXPECT_EQ(made, b);
    EXPECT_FALSE(!edit.added.isEmpty() && edit.added.front().isLowSurrogate()) << "cut a character";
  }
}

TEST(Edit, PlacesAndOffsetsAreEachOthersInverse) {
  const QString text = QStringLiteral("MOV a, b;\n\nEND");
  for (qsizetype at = 0; at <= text.size(); ++at) {
    const LineColumn place = placeOf(text, at);
    EXPECT_EQ(offsetOf(text, place.line - 1, place.column - 1), at);
  }
  EXPECT_EQ(offsetOf(text, 0, 1000), 9) << "beyond a line's end is its end";
  EXPECT_EQ(offsetOf(text, 1000, 0), text.size());
}

TEST(Document, TypingIsUndoneByWords) {
  Document document;
  type(document, QStringLiteral("MOV temp"));
  document.undo();
  EXPECT_EQ(document.text(), QStringLiteral("MOV "));
  document.undo();
  document.undo();
  EXPECT_EQ(document.text(), QString());
  EXPECT_FALSE(document.canUndo());
  document.redo();
  document.redo();
  document.redo();
  EXPECT_EQ(document.text(), QStringLiteral("MOV temp"));
}

TEST(Document, AToolsChangeIsOneStepAmongTheOthers) {
  Document document;
  document.open(QStringLiteral("a = 1\n"));
  document.replace(4, 1, QStringLiteral("0.25"), Origin::Tool, QStringLiteral("move a"));
  type(document, QStringLiteral("b"));
  document.undo();
  EXPECT_EQ(document.text(), QStringLiteral("a = 0.25\n"));
  EXPECT_EQ(document.undoName(), QStringLiteral("move a"));
  document.undo();
  EXPECT_EQ(document.text(), QStringLiteral("a = 1\n"));
  EXPECT_FALSE(document.isModified());
}

TEST(Document, RandomEditsAreUndoneAndRedoneExactly) {
  std::mt19937 random(3);
  Document document;
  document.open(QStringLiteral("one\ntwo\nthree\n"));
  QStringList texts{document.text()};
  for (int turn = 0; turn < 300; ++turn) {
    const auto at = qsizetype(random() % std::size_t(document.text().size() + 1));
    document.replace(at, qsizetype(random() % 4), QString(int(random() % 3), u'x'), Origin::Tool,
                     QStringLiteral("edit"));
    if (document.text() != texts.last())
      texts << document.text();
  }
  for (qsizetype i = texts.size() - 2; i >= 0; --i) {
    document.undo();
    ASSERT_EQ(document.text(), texts[i]);
  }
  for (qsizetype i = 1; i < texts.size(); ++i) {
    document.redo();
    ASSERT_EQ(document.text(), texts[i]);
  }
}

TEST(Merge, TakesBothSidesAndFindsConflicts) {
  const QString base = QStringLiteral("a\nb\nc\nd\n");
  const Merge both =
      mergeTexts(base, QStringLiteral("A\nb\nc\nd\n"), QStringLiteral("a\nb\nc\nD\ne\n"));
  EXPECT_EQ(both.conflicts, 0);
  EXPECT_EQ(both.text, QStringLiteral("A\nb\nc\nD\ne\n"));
  const Merge conflict =
      mergeTexts(base, QStringLiteral("a\nX\nc\nd\n"), QStringLiteral("a\nY\nc\nd\n"));
  EXPECT_EQ(conflict.conflicts, 1);
  EXPECT_EQ(conflict.text, QStringLiteral("a\nX\nc\nd\n"));
  const Merge removed =
      mergeTexts(base, QStringLiteral("a\nc\nd\n"), QStringLiteral("a\nb\nc\nd\nz\n"));
  EXPECT_EQ(removed.text, QStringLiteral("a\nc\nd\nz\n"));
}

TEST(TextFile, KeepsLineEndsAndEncoding) {
  const TextFile dos = decodeText("!!ARBfp1.0\r\nEND\r\n");
  EXPECT_EQ(dos.text, QStringLiteral("!!ARBfp1.0\nEND\n"));
  EXPECT_EQ(encodeText(dos.text, dos.format), "!!ARBfp1.0\r\nEND\r\n");
  const TextFile latin = decodeText("# gr\xf6\xdf"
                                    "er\n");
  EXPECT_TRUE(latin.format.latin1);
  EXPECT_EQ(encodeText(latin.text, latin.format), "# gr\xf6\xdf"
                                                  "er\n");
  EXPECT_EQ(encodeText(QString::fromUtf8("\xe2\x82\xac"), latin.format), "\xe2\x82\xac")
      << "a letter that Latin-1 has not is not lost";
}

TEST(Journal, HasTheTextOfAProcessThatWasKilled) {
  QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("a.fp"));
  write(file, "base\n");
  const pid_t child = ::fork();
  if (child == 0) {
    OpenFile open(folder.filePath(QStringLiteral("journals")));
    if (!open.open(file))
      ::_exit(2);
    for (int i = 0; i < 200; ++i)
      open.document().replace(open.document().text().size(), 0, QString(u'k'), Origin::Typing);
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  const auto left = Journal::recoverable(folder.filePath(QStringLiteral("journals")));
  ASSERT_EQ(left.size(), 1);
  EXPECT_EQ(left[0].text, QStringLiteral("base\n") + QString(200, u'k'));
  OpenFile again(folder.filePath(QStringLiteral("journals")));
  again.recover(left[0]);
  EXPECT_EQ(again.document().text(), left[0].text);
  again.document().undo();
  EXPECT_EQ(again.document().text(), QStringLiteral("base\n")) << "the file's text is a step back";
}

TEST(Journal, PassesOverATornLineAndALivingProcess) {
  QTemporaryDir folder;
  Journal journal(folder.path());
  ASSERT_TRUE(journal.begin(QStringLiteral("/x.fp"), QStringLiteral("ab")).ok());
  ASSERT_TRUE(journal.record({2, {}, QStringLiteral("c")}));
  EXPECT_TRUE(Journal::recoverable(folder.path()).isEmpty()) << "it is still held";
  const QString copy = folder.filePath(QStringLiteral("dead.journal"));
  const QString living = QDir(folder.path()).entryList({QStringLiteral("*.journal")}).constFirst();
  write(copy, bytesOf(folder.filePath(living)) + "{\"at\":3,\"remo");
  const auto left = Journal::recoverable(folder.path());
  ASSERT_EQ(left.size(), 1);
  EXPECT_EQ(left[0].text, QStringLiteral("abc"));
}

TEST(Journal, HostileFilesAreNoFault) {
  QTemporaryDir folder;
  const QByteArray head = "{\"journal\":1,\"path\":\"/x\",\"text\":\"abc\"}\n";
  for (const QByteArray &rest :
       {QByteArray("{\"at\":-1,\"removed\":0}\n"), QByteArray("{\"at\":1,\"removed\":99}\n"),
        QByteArray("{\"at\":9e18,\"removed\":9e18}\n"), QByteArray("[]\n"),
        QByteArray("\0\xff\n", 3)}) {
    write(folder.filePath(QStringLiteral("h.journal")), head + rest);
    EXPECT_TRUE(Journal::recoverable(folder.path()).isEmpty()) << rest.constData();
  }
}

TEST(OpenFile, SavesAllOrNothingAndKeepsNoJournal) {
  QTemporaryDir folder;
  const QString journals = folder.filePath(QStringLiteral("j"));
  OpenFile open(journals);
  open.openText(QStringLiteral("x\n"));
  type(open.document(), QStringLiteral("y"));
  EXPECT_FALSE(QDir(journals).isEmpty());
  EXPECT_FALSE(open.save().ok()) << "it has no name yet";
  ASSERT_TRUE(open.save(folder.filePath(QStringLiteral("a.fp"))).ok());
  EXPECT_EQ(bytesOf(folder.filePath(QStringLiteral("a.fp"))), "x\ny");
  EXPECT_FALSE(open.document().isModified());
  EXPECT_TRUE(QDir(journals).isEmpty());
  const auto refused = open.save(folder.filePath(QStringLiteral("no/such/folder/a.fp")));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(bytesOf(folder.filePath(QStringLiteral("a.fp"))), "x\ny");
}

TEST(OpenFile, OutsideChangesAreMergedAsOneStep) {
  QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("a.fp"));
  write(file, "one\ntwo\nthree\nfour\nfive\n");
  OpenFile open(folder.filePath(QStringLiteral("j")));
  ASSERT_TRUE(open.open(file).ok());
  open.document().replace(0, 3, QStringLiteral("ONE"), Origin::Typing);
  // Most editors save this way: another file takes the name.
  write(file + QStringLiteral(".tmp"), "one\ntwo\nthree\nfour\nFIVE\n");
  ASSERT_EQ(::rename(qPrintable(file + QStringLiteral(".tmp")), qPrintable(file)), 0);
  ASSERT_TRUE(waitFor(
      [&] { return open.document().text() == QStringLiteral("ONE\ntwo\nthree\nfour\nFIVE\n"); }));
  // The watcher must not have lost the file with the first change.
  write(file, "one\ntwo\n3\nfour\nFIVE\n");
  ASSERT_TRUE(waitFor(
      [&] { return open.document().text() == QStringLiteral("ONE\ntwo\n3\nfour\nFIVE\n"); }));
  open.document().undo();
  EXPECT_EQ(open.document().text(), QStringLiteral("ONE\ntwo\nthree\nfour\nFIVE\n"));
}

TEST(OpenFile, AConflictAsksAndChangesNothing) {
  QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("a.fp"));
  write(file, "one\n");
  OpenFile open(folder.filePath(QStringLiteral("j")));
  ASSERT_TRUE(open.open(file).ok());
  open.document().become(QStringLiteral("mine\n"), Origin::Tool, QStringLiteral("edit"));
  QString theirs;
  QObject::connect(&open, &OpenFile::conflict, [&](const QString &text) { theirs = text; });
  write(file, "theirs\n");
  ASSERT_TRUE(waitFor([&] { return !theirs.isEmpty(); }));
  EXPECT_EQ(open.document().text(), QStringLiteral("mine\n"));
  open.takeTheirs(theirs);
  EXPECT_FALSE(open.document().isModified());
  open.document().undo();
  EXPECT_EQ(open.document().text(), QStringLiteral("mine\n"));
}

} // namespace arbiter::builder
