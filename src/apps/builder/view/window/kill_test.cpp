// Kills or stops processes while someone types.
#include <QProcess>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <sys/wait.h>
#include <unistd.h>

#include "apps/builder/testing/typist.h"
#include "apps/builder/testing/window_test.h"

namespace arbiter::builder {

using testing::kText;
using testing::serve;
using testing::Typist;
using testing::waitFor;
using testing::Window;

namespace {

constexpr int kKeyMilliseconds = 15; ///< faster than anyone types

/// Returns how often the renderer is killed. docs/design/builder_answers.md has the figures of 50.
int kills() { return std::max(1, qEnvironmentVariableIntValue("ARBITER_TEST_KILLS")); }

/// Returns the limit in milliseconds for a new process's picture: 1 s is promised. Unless many
/// kills were requested, it is longer, as other tests may run on the machine.
double limit() { return kills() >= 50 ? 1000 : 10000; }

} // namespace

/// The renderer is killed between keys, at different moments: before, during and after drawing.
TEST_F(Window, ARendererKilledWhileTypingLosesNoCharacterAndDrawsAgain) {
  open(kText);
  editor().setFocus();
  editor().goTo(kText.indexOf(QStringLiteral("PARAM")));
  Typist typist(editor(), kKeyMilliseconds);
  std::vector<double> back;
  const int count = qEnvironmentVariableIsSet("ARBITER_TEST_KILLS") ? kills() : 5;
  for (int kill = 0; kill < count; ++kill) {
    serve(40 + 17 * (kill % 9));
    const qint64 process = bench().renderer().processId();
    ASSERT_GT(process, 0) << "kill " << kill;
    bool drawn = false;
    const auto connection =
        QObject::connect(&bench().renderer(), &RendererSession::drew, [&](const Frame &) {
          drawn = drawn || bench().renderer().processId() != process;
        });
    const qsizetype before = typist.typed().size();
    QElapsedTimer since;
    since.start();
    ASSERT_EQ(::kill(pid_t(process), SIGKILL), 0);
    ASSERT_TRUE(waitFor([&] { return drawn; })) << "kill " << kill;
    back.push_back(double(since.nsecsElapsed()) / 1e6);
    QObject::disconnect(connection);
    EXPECT_GT(typist.typed().size(), before) << "no key came through meanwhile";
    EXPECT_EQ(middle().red(), 64);
  }
  typist.stop();
  QString expected = kText;
  expected.insert(kText.indexOf(QStringLiteral("PARAM")), typist.typed());
  EXPECT_EQ(text(), expected);
  EXPECT_EQ(editor().toPlainText(), expected);
  EXPECT_TRUE(drawsNewest());
  EXPECT_EQ(bench().renderer().state(), RendererSession::State::Idle) << "no text was at fault";
  std::sort(back.begin(), back.end());
  std::printf("renderer killed %d times: a picture after %.0f ms (median), %.0f ms (worst); "
              "%d characters typed, the slowest key took %.1f ms\n",
              count, back[back.size() / 2], back.back(), int(typist.typed().size()),
              typist.slowest());
  EXPECT_LE(back.back(), limit());
}

/// The window does not wait for a renderer that never answers, and another one draws the next text.
TEST_F(Window, ARendererThatIsStoppedIsReplaced) {
  open(kText);
  bench().renderer().setPatience(1500);
  editor().setFocus();
  editor().goTo(kText.indexOf(QStringLiteral("PARAM")));
  const qint64 process = bench().renderer().processId();
  ASSERT_EQ(::kill(pid_t(process), SIGSTOP), 0);
  {
    Typist typist(editor(), kKeyMilliseconds);
    ASSERT_TRUE(waitFor([&] { return bench().renderer().processId() != process; }));
    typist.stop();
    QString expected = kText;
    expected.insert(kText.indexOf(QStringLiteral("PARAM")), typist.typed());
    EXPECT_EQ(text(), expected);
    EXPECT_GT(typist.typed().size(), 5);
    EXPECT_LT(typist.slowest(), 1000) << "a key waited for the renderer";
  }
  // The new one is not stopped, however slow this machine is.
  bench().renderer().setPatience(60000);
  QTest::keyClick(&editor(), ' ');
  ASSERT_TRUE(drawsNewest()) << bench().statusText().toStdString();
  EXPECT_EQ(middle().red(), 64);
  EXPECT_NE(::kill(pid_t(process), 0), 0) << "the stopped process is still there";
}

/// The editor itself is killed at any key: the journal has everything that it reported as typed.
TEST(Editor, KilledWhileTypingKeepsEveryCharacterInTheJournal) {
  for (int turn = 0; turn < 2; ++turn) {
    QTemporaryDir folder;
    QProcess child;
    child.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    child.start(QCoreApplication::applicationFilePath(),
                {QStringLiteral("--type-into"), folder.path()});
    ASSERT_TRUE(child.waitForStarted(30000));
    qsizetype typed = 0;
    const qsizetype wanted = 20 + 31 * turn;
    while (typed < wanted) { // a line for each character, written when its key is handled
      ASSERT_TRUE(child.waitForReadyRead(60000)) << "the typist says nothing";
      typed += child.readAllStandardOutput().count('\n');
    }
    ::kill(pid_t(child.processId()), SIGKILL);
    ASSERT_TRUE(child.waitForFinished(30000));
    typed += child.readAllStandardOutput().count('\n');
    const QList<Recovered> left = Journal::recoverable(folder.path());
    ASSERT_EQ(left.size(), 1);
    const QString all = Typist::text(typed);
    EXPECT_TRUE(left[0].text.startsWith(all))
        << left[0].text.size() << " of " << typed << " characters";
    EXPECT_LE(left[0].text.size(), typed + 20) << "more than was typed, and not said yet";
    Journal::discard(left[0]);
    EXPECT_TRUE(Journal::recoverable(folder.path()).isEmpty());
  }
}

} // namespace arbiter::builder
