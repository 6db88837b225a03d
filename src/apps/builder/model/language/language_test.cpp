#include <QFile>
#include <csignal>
#include <tuple>

#include "apps/builder/model/language/gauges.h"
#include "apps/builder/model/language/lsp_client.h"
#include "apps/builder/testing/model_test.h"

namespace arbiter::builder {

using testing::waitFor;

namespace {

const QString kWrong = QStringLiteral("!!ARBfp1.0\nTEMP offset;\nMOV ofset, 1;\n"
                                      "MOV result.color, offset;\nEND\n");
const QString kRight = QStringLiteral("!!ARBfp1.0\nTEMP offset;\nMOV offset, 1;\n"
                                      "MOV result.color, offset;\nEND\n");

/// A language server with its diagnostics of the newest text.
class Server {
public:
  Server() : client(qEnvironmentVariable("ARBITER_COMMAND")) {
    QObject::connect(&client, &LspClient::diagnosed,
                     [this](qint64 revision, const QList<Problem> &found) {
                       told = revision;
                       problems = found;
                     });
    client.start();
  }
  void set(const QString &text, qint64 revision) {
    client.setText(QStringLiteral("untitled:a.fp"), text, revision);
  }
  bool tells(qint64 revision) {
    return waitFor([&] { return told == revision; });
  }

  LspClient client;
  qint64 told = -1;
  QList<Problem> problems;
};

} // namespace

TEST(LspMessages, AreCutWhereTheirHeadersSay) {
  LspMessages messages;
  const QByteArray one = LspMessages::frame({{"a", 1}}), two = LspMessages::frame({{"b", 2}});
  QList<QJsonObject> all;
  for (const char c : one + two)
    all += messages.take(QByteArray(1, c));
  ASSERT_EQ(all.size(), 2);
  EXPECT_EQ(all[1][u"b"].toInt(), 2);
  for (const QByteArray &bad :
       {QByteArray("Content-Length: -5\r\n\r\n"), QByteArray("X: y\r\n\r\n"),
        QByteArray("Content-Length: 99999999999\r\n\r\n"), QByteArray(5000, 'x')}) {
    LspMessages broken;
    EXPECT_TRUE(broken.take(bad).isEmpty());
    EXPECT_TRUE(broken.broken()) << bad.left(40).constData();
  }
}

TEST(Problems, WhateverTheirShape) {
  const QJsonArray json{5, QJsonObject{}, QJsonObject{{"range", 7}, {"severity", 99}},
                        QJsonObject{{"range", QJsonObject{{"start", QJsonObject{{"line", -3}}}}}}};
  const QList<Problem> problems = problemsOf(json, QStringLiteral("abc"));
  EXPECT_EQ(problems.size(), 4);
  EXPECT_EQ(nextProblem({}, 0, true), -1);
  QList<Problem> two(2);
  two[0].begin = 5;
  two[1].begin = 9;
  EXPECT_EQ(nextProblem(two, 5, true), 1);
  EXPECT_EQ(nextProblem(two, 9, true), 0) << "round at the end";
  EXPECT_EQ(nextProblem(two, 5, false), 1);
}

TEST(LspClient, SaysWhereATextIsWrongAndWhatToDo) {
  Server server;
  server.set(kWrong, 1);
  ASSERT_TRUE(server.tells(1));
  ASSERT_FALSE(server.problems.isEmpty());
  const Problem &problem = server.problems[0];
  EXPECT_EQ(problem.line, 3);
  EXPECT_EQ(kWrong.mid(problem.begin, problem.end - problem.begin), QStringLiteral("ofset"));
  EXPECT_TRUE((problem.message + problem.hint).contains(QStringLiteral("offset")));
  server.set(kRight, 2);
  ASSERT_TRUE(server.tells(2));
  EXPECT_TRUE(server.problems.isEmpty());
}

TEST(LspClient, AnswersWhatIsAskedOfAPlace) {
  Server server;
  server.set(kRight, 1);
  ASSERT_TRUE(server.tells(1));
  QJsonValue hover, completion, definition, report;
  server.client.request(QStringLiteral("textDocument/hover"), kRight.indexOf(u"MOV"), {},
                        [&](const QJsonValue &result) { hover = result; });
  server.client.request(QStringLiteral("textDocument/completion"), kRight.indexOf(u"MOV") + 2, {},
                        [&](const QJsonValue &result) { completion = result; });
  server.client.request(QStringLiteral("textDocument/definition"), kRight.indexOf(u"offset, 1"), {},
                        [&](const QJsonValue &result) { definition = result; });
  server.client.request(QStringLiteral("arbiter/report"), -1, {},
                        [&](const QJsonValue &result) { report = result; });
  ASSERT_TRUE(waitFor([&] { return report.isObject(); }));
  EXPECT_TRUE(hover[u"contents"][u"value"].toString().contains(QStringLiteral("MOV")));
  EXPECT_GT(completion.toArray().size(), 10);
  EXPECT_EQ(definition[u"range"][u"start"][u"line"].toInt(), 1);
  const Report gauges = Report::of(report.toObject());
  ASSERT_FALSE(gauges.gauges.isEmpty());
  EXPECT_EQ(gauges.status, QStringLiteral("valid"));
  EXPECT_EQ(gauges.gauges[0].title, QStringLiteral("instructions"));
  EXPECT_TRUE(gauges.lines.contains(4)) << "the MOV of the result costs a slot";
}

/// Makes the edit in the text and moves the costs.
void make(const Edit &edit, QString &text, Report &report) {
  text.replace(edit.at, edit.removed.size(), edit.added);
  report.follow(edit, text);
}

TEST(Report, CostsStayWithTheirLinesWhileATextIsEdited) {
  const QString before = QStringLiteral("!!ARBfp1.0\nTEMP a;\nMUL a, a, a;\nSUB a, a, a;\nEND\n");
  for (const auto &[at, removed, added] :
       {std::tuple("MUL", "", "wrong\n"), std::tuple("\nMUL", "", "\nwrong"),
        std::tuple("TEMP", "TEMP a;\n", ""), std::tuple(";\nSUB", "", "; # more\n\n"),
        std::tuple("MUL", "MUL a, a, a;\nSUB", "x"), std::tuple("a, a;\nEND", "", "b,")}) {
    QString text = before;
    Report report;
    report.lines[3].slotCount = 3;
    report.lines[4].slotCount = 4;
    const Edit edit{before.indexOf(QLatin1String(at)), QLatin1String(removed),
                    QLatin1String(added)};
    make(edit, text, report);
    const QStringList lines = text.split(u'\n');
    for (auto cost = report.lines.constBegin(); cost != report.lines.constEnd(); ++cost)
      if (removed[0] != 'M') {
        EXPECT_TRUE(lines[cost.key() - 1].contains(cost->slotCount == 3 ? u"MUL" : u"SUB"))
            << at << " " << cost.key();
      }
    make(edit.inverse(), text, report);
    EXPECT_EQ(text, before);
    EXPECT_EQ(report.lines[4].slotCount, 4) << at;
    if (removed[0] != 'M') {
      EXPECT_EQ(report.lines[3].slotCount, 3) << at;
    }
  }
}

TEST(LspClient, OfABurstOfEditsTheNewestIsTold) {
  Server server;
  for (int i = 1; i <= 300; ++i)
    server.set(i % 2 ? kWrong : kRight, i);
  ASSERT_TRUE(server.tells(300));
  EXPECT_TRUE(server.problems.isEmpty());
}

TEST(LspClient, AServerThatIsKilledIsStartedAnew) {
  Server server;
  server.set(kRight, 1);
  ASSERT_TRUE(server.tells(1));
  ::kill(pid_t(server.client.processId()), SIGKILL);
  server.set(kWrong, 2);
  ASSERT_TRUE(server.tells(2));
  EXPECT_FALSE(server.problems.isEmpty());
}

TEST(LspClient, AServerThatStandsStillIsReplaced) {
  Server server;
  server.client.setPatience(500);
  server.set(kRight, 1);
  ASSERT_TRUE(waitFor([&] { return server.client.isReady(); }));
  ASSERT_TRUE(server.tells(1));
  ::kill(pid_t(server.client.processId()), SIGSTOP);
  server.client.setPatience(1000);
  server.set(kWrong, 2);
  EXPECT_TRUE(server.tells(2));
}

TEST(LspClient, WithoutAServerTheReasonIsSaid) {
  LspClient client(QStringLiteral("/no/such/arbiter"));
  QString said;
  QObject::connect(&client, &LspClient::troubled, [&](const QString &text) { said = text; });
  client.start();
  ASSERT_TRUE(waitFor([&] { return !said.isEmpty(); }));
  EXPECT_TRUE(said.contains(QStringLiteral("/no/such/arbiter")));
}

} // namespace arbiter::builder
