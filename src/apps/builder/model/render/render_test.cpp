#include <QFile>
#include <QPointer>
#include <csignal>
#include <sys/socket.h>
#include <unistd.h>

#include "apps/builder/model/render/compare.h"
#include "apps/builder/model/render/control_client.h"
#include "apps/builder/model/render/control_renderer.h"
#include "apps/builder/model/render/draw_renderer.h"
#include "apps/builder/model/render/session.h"
#include "apps/builder/model/render/work_folder.h"
#include "apps/builder/testing/model_test.h"

namespace arbiter::builder {

using testing::serve;
using testing::waitFor;

namespace {

QString fakeArbiter() { return qEnvironmentVariable("FAKE_ARBITER"); }

QList<RendererSession::Factory> fake() {
  return {[](QObject *parent) -> Renderer * { return new ControlRenderer(fakeArbiter(), parent); }};
}

Scene scene(const QString &text, qint64 revision) {
  return {text, QStringLiteral("a.fp"), {}, {}, revision};
}

/// A renderer session that records its signals.
class Session {
public:
  explicit Session(const QString &memory = {}) : session(fake(), memory) {
    QObject::connect(&session, &RendererSession::drew, [this](const Frame &frame) {
      last = frame;
      ++frames;
    });
    QObject::connect(&session, &RendererSession::answered,
                     [this](const SceneAnswer &answer) { answers << answer; });
    QObject::connect(&session, &RendererSession::held,
                     [this](qint64 revision, const QString &) { held = revision; });
  }
  bool draws(qint64 revision) {
    return waitFor([&] { return last.revision == revision; });
  }

  RendererSession session;
  Frame last;
  int frames = 0;
  qint64 held = -1;
  QList<SceneAnswer> answers;
};

} // namespace

TEST(Session, ShowsWhatTheTextSaysTheTopRowFirst) {
  Session it;
  it.session.want(scene(QStringLiteral("colour 102030"), 1));
  ASSERT_TRUE(it.draws(1));
  EXPECT_EQ(it.last.image.size(), QSize(4, 2));
  EXPECT_EQ(it.last.image.pixelColor(0, 0), QColor(0x10, 0x20, 0x30));
  EXPECT_EQ(it.last.image.pixelColor(0, 1), QColor(Qt::white)) << "GL's first row is the lowest";
}

TEST(Session, TheRendererHasTheProfileAndNumericsOfTheDocumentUnlessOthersWereChosen) {
  Session it;
  it.session.want(scene(QStringLiteral("started with"), 1));
  ASSERT_TRUE(it.draws(1));
  EXPECT_EQ(it.last.image.pixelColor(0, 0), QColor(0, 0, 0));
  const QString named = QStringLiteral("started with\n#@ profile nv30, numerics fp24\n");
  it.session.want(scene(named, 2));
  ASSERT_TRUE(it.draws(2));
  EXPECT_EQ(it.last.image.pixelColor(0, 0), QColor(255, 255, 0));
  EXPECT_EQ(it.session.effectiveOptions().profile, QStringLiteral("nv30"));
  const qint64 process = it.session.processId();
  it.session.want(scene(named + QStringLiteral("# more\n"), 3));
  ASSERT_TRUE(it.draws(3));
  EXPECT_EQ(it.session.processId(), process) << "the same profile starts nothing anew";
  it.session.setOptions({QStringLiteral("i915"), {}, {}, false});
  it.session.want(scene(named, 4));
  ASSERT_TRUE(it.draws(4));
  EXPECT_EQ(it.last.image.pixelColor(0, 0), QColor(0, 255, 0)) << "the chosen one holds";
  it.session.setOptions({});
  it.session.want(scene(QStringLiteral("started with"), 5));
  ASSERT_TRUE(it.draws(5));
  EXPECT_EQ(it.last.image.pixelColor(0, 0), QColor(0, 0, 0));
  EXPECT_EQ(it.held, -1);
}

TEST(Session, AWrongTextKeepsTheLastPicture) {
  Session it;
  it.session.want(scene(QStringLiteral("colour 102030"), 1));
  ASSERT_TRUE(it.draws(1));
  it.session.want(scene(QString::fromUtf8("\xc3\xa4 wrong"), 2));
  ASSERT_TRUE(waitFor([&] { return it.answers.size() == 2; }));
  EXPECT_FALSE(it.answers[1].ok);
  ASSERT_EQ(it.answers[1].problems.size(), 1);
  EXPECT_EQ(it.answers[1].problems[0].begin, 2) << "bytes became UTF-16 units";
  EXPECT_EQ(it.answers[1].problems[0].hint, QStringLiteral("mend it"));
  EXPECT_EQ(it.session.lastGood().revision, 1);
}

TEST(Session, OfManyTextsTheNewestIsDrawnAndNoneIsWaitedFor) {
  Session it;
  it.session.want(scene(QStringLiteral("slow colour 000001"), 1));
  for (int i = 2; i <= 100; ++i)
    it.session.want(scene(QStringLiteral("colour 0000%1").arg(i, 2, 16, QChar(u'0')), i));
  ASSERT_TRUE(it.draws(100));
  EXPECT_EQ(it.frames, 2) << "those between were drawn";
}

TEST(Session, AKilledRendererComesBackWithTheNewestText) {
  Session it;
  it.session.want(scene(QStringLiteral("colour 000001"), 1));
  ASSERT_TRUE(it.draws(1));
  for (int i = 2; i < 22; ++i) {
    it.session.want(scene(QStringLiteral("colour 0000%1").arg(i, 2, 16, QChar(u'0')), i));
    serve(i % 7); // at any moment: before, during and after drawing
    if (const qint64 process = it.session.processId(); process > 0)
      ::kill(pid_t(process), SIGKILL);
  }
  ASSERT_TRUE(it.draws(21));
  EXPECT_EQ(it.held, -1) << "no text was at fault";
}

TEST(Session, ATextThatStopsTheRendererIsHeldAndStaysSo) {
  QTemporaryDir folder;
  const QString memory = folder.filePath(QStringLiteral("held"));
  {
    Session it(memory);
    it.session.want(scene(QStringLiteral("colour 000001"), 1));
    ASSERT_TRUE(it.draws(1));
    it.session.want(scene(QStringLiteral("crash"), 2));
    ASSERT_TRUE(waitFor([&] { return it.held == 2; }));
    EXPECT_EQ(it.session.state(), RendererSession::State::Held);
    it.session.want(scene(QStringLiteral("colour 000003"), 3));
    ASSERT_TRUE(it.draws(3)) << "a better text is drawn";
  }
  Session again(memory);
  again.session.want(scene(QStringLiteral("crash"), 1));
  EXPECT_EQ(again.held, 1) << "the file opens held";
  EXPECT_EQ(again.session.processId(), 0) << "and nothing was started for it";
  again.session.drawAnyway();
  EXPECT_TRUE(waitFor([&] { return again.session.restarts() > 0; }));
}

TEST(Session, ATextThatDoesNotEndIsStopped) {
  Session it;
  it.session.want(scene(QStringLiteral("colour 000001"), 1));
  ASSERT_TRUE(it.draws(1));
  it.session.setPatience(300);
  double busy = 0;
  QObject::connect(&it.session, &RendererSession::busy, [&](double ms) { busy = ms; });
  it.session.setPatience(700);
  it.session.want(scene(QStringLiteral("hang"), 2));
  ASSERT_TRUE(waitFor([&] { return it.held == 2; }));
  EXPECT_GE(busy, 300) << "nothing was said while it took long";
  it.session.setPatience(10000);
  it.session.want(scene(QStringLiteral("colour 000003"), 3));
  EXPECT_TRUE(it.draws(3));
}

TEST(Session, ASliderMovesThePictureWithoutAText) {
  Session it;
  it.session.want(scene(QStringLiteral("colour 000001"), 1));
  ASSERT_TRUE(it.draws(1));
  LiveValue value;
  value.value[0] = 1.0;
  ASSERT_TRUE(it.session.setParameter(value));
  ASSERT_TRUE(waitFor([&] { return it.last.image.pixelColor(3, 0) == QColor(255, 0, 0); }));
  EXPECT_EQ(it.answers.size(), 1);
}

TEST(Session, WhereThereIsNoRendererTheNextKindIsTaken) {
  bool second = false;
  const auto none = [](QObject *parent) -> Renderer * {
    return new ControlRenderer(QStringLiteral("/bin/false"), parent); // exit code 1: no such verb
  };
  const auto works = [&](QObject *parent) -> Renderer * {
    second = true;
    return new ControlRenderer(fakeArbiter(), parent);
  };
  RendererSession session({none, works}, {});
  Frame last;
  QObject::connect(&session, &RendererSession::drew, [&](const Frame &frame) { last = frame; });
  session.want(scene(QStringLiteral("colour 0a0b0c"), 5));
  ASSERT_TRUE(waitFor([&] { return last.revision == 5; }));
  EXPECT_TRUE(second);
}

TEST(ControlClient, SurvivesWhateverTheOtherSideSends) {
  const auto feed = [](const QByteArray &bytes) {
    int pair[2];
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair), 0);
    auto client = std::make_unique<ControlClient>(pair[0]);
    bool answered = false, closed = false;
    client->call(QStringLiteral("ping"), {},
                 [&](const QJsonObject &, const QJsonObject &) { answered = true; });
    QObject::connect(client.get(), &ControlClient::closed, [&] { closed = true; });
    qsizetype at = 0;
    while (at < bytes.size()) {
      const ssize_t sent = ::send(pair[1], bytes.constData() + at, std::size_t(bytes.size() - at),
                                  MSG_DONTWAIT | MSG_NOSIGNAL);
      if (sent < 0 && errno != EAGAIN)
        break;
      at += std::max<ssize_t>(sent, 0);
      QCoreApplication::processEvents();
    }
    ::close(pair[1]);
    EXPECT_TRUE(waitFor([&] { return closed; }));
    EXPECT_TRUE(answered) << "what waits is told that nothing comes";
  };
  feed("\n\n{}\n[]\n\"x\"\n{\"id\":1}\n{\"id\":99,\"result\":{}}\n{\"method\":5}\n");
  feed("\xff\xfe\0\n");
  feed(QByteArray(2000, '[') + '\n');
  feed(QByteArray((4 << 20) + 100, 'x'));
}

TEST(Compare, FindsTheWorstPixel) {
  QImage a(3, 2, QImage::Format_RGBA8888), b;
  a.fill(QColor(10, 20, 30));
  b = a;
  EXPECT_TRUE(compare(a, b).equal());
  b.setPixelColor(2, 1, QColor(10, 25, 30));
  b.setPixelColor(0, 0, QColor(11, 20, 30));
  const Comparison found = compare(a, b, 8);
  EXPECT_EQ(found.pixels, 2);
  EXPECT_EQ(found.worst, 5);
  EXPECT_EQ(found.worstAt, QPoint(2, 1));
  EXPECT_EQ(found.difference.pixelColor(2, 1), QColor(0, 40, 0));
  EXPECT_FALSE(compare(a, QImage()).comparable);
  const QImage split = splitOf(a, b, 0.5);
  EXPECT_EQ(split.pixelColor(0, 0), QColor(10, 20, 30));
  EXPECT_EQ(split.pixelColor(2, 1), QColor(10, 25, 30));
}

TEST(WorkFolder, HasTheTextAndWhatLiesBesideIt) {
  QTemporaryDir source, target;
  QFile image(source.filePath(QStringLiteral("photo.png")));
  ASSERT_TRUE(image.open(QIODevice::WriteOnly));
  image.write("png");
  image.close();
  QFile saved(source.filePath(QStringLiteral("a.fp")));
  ASSERT_TRUE(saved.open(QIODevice::WriteOnly));
  saved.write("saved");
  saved.close();
  Scene wanted{QStringLiteral("typed"), QStringLiteral("a.fp"), source.path(), {}, 1};
  const QString path = layOut(wanted, target.path());
  QFile typed(path);
  ASSERT_TRUE(typed.open(QIODevice::ReadOnly));
  EXPECT_EQ(typed.readAll(), "typed");
  EXPECT_TRUE(QFile::exists(target.filePath(QStringLiteral("photo.png"))));
  layOut(wanted, target.path()); // again, as the links exist already
  ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
  EXPECT_EQ(saved.readAll(), "saved") << "the user's file was written through a link";
}

} // namespace arbiter::builder
