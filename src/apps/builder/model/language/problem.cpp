#include "apps/builder/model/language/problem.h"

#include <QJsonObject>
#include <algorithm>

#include "apps/builder/model/text/edit.h"

namespace arbiter::builder {

namespace {

qsizetype offsetAt(const QString &text, const QJsonValue &position) {
  return offsetOf(text, position[u"line"].toInteger(), position[u"character"].toInteger());
}

Problem problemOf(const QJsonValue &diagnostic, const QString &text) {
  Problem problem;
  problem.severity = Severity(std::clamp(diagnostic[u"severity"].toInt(1), 1, 3));
  problem.code = diagnostic[u"code"].toString();
  const QString message = diagnostic[u"message"].toString();
  const qsizetype hint = message.indexOf(QStringLiteral("\nhint: "));
  problem.message = hint < 0 ? message : message.left(hint);
  if (hint >= 0)
    problem.hint = message.mid(hint + 7);
  problem.begin = offsetAt(text, diagnostic[u"range"][u"start"]);
  problem.end = std::max(problem.begin, offsetAt(text, diagnostic[u"range"][u"end"]));
  const LineColumn place = placeOf(text, problem.begin);
  problem.line = place.line;
  problem.column = place.column;
  return problem;
}

} // namespace

QList<Problem> problemsOf(const QJsonArray &diagnostics, const QString &text) {
  QList<Problem> all;
  for (const QJsonValue each : diagnostics)
    all.append(problemOf(each, text));
  std::stable_sort(all.begin(), all.end(), [](const Problem &a, const Problem &b) {
    return std::tuple(a.severity, a.begin) < std::tuple(b.severity, b.begin);
  });
  return all;
}

Problem problemOfControl(const QJsonValue &json, const QByteArray &bytes) {
  Problem problem;
  const QString severity = json[u"severity"].toString();
  problem.severity = severity == u"error"     ? Severity::Error
                     : severity == u"warning" ? Severity::Warning
                                              : Severity::Note;
  problem.code = json[u"id"].toString();
  problem.message = json[u"message"].toString();
  problem.hint = json[u"hint"].toString();
  problem.file = json[u"file"].toString();
  const auto offset = [&](QLatin1StringView key) {
    return QString::fromUtf8(bytes.left(json[key].toInteger())).size();
  };
  problem.begin = offset(QLatin1StringView("begin"));
  problem.end = std::max(problem.begin, offset(QLatin1StringView("end")));
  problem.line = json[u"line"].toInt(1);
  problem.column = json[u"column"].toInt(1);
  return problem;
}

qsizetype nextProblem(const QList<Problem> &problems, qsizetype from, bool forward) {
  qsizetype best = -1, round = -1;
  const auto before = [&](qsizetype a, qsizetype b) {
    return forward ? problems[a].begin < problems[b].begin : problems[a].begin > problems[b].begin;
  };
  for (qsizetype i = 0; i < problems.size(); ++i) {
    if (!problems[i].file.isEmpty())
      continue;
    const bool ahead = forward ? problems[i].begin > from : problems[i].begin < from;
    if (ahead && (best < 0 || before(i, best)))
      best = i;
    if (round < 0 || before(i, round))
      round = i;
  }
  return best >= 0 ? best : round;
}

} // namespace arbiter::builder
