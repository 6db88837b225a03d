#include "apps/builder/model/language/gauges.h"

#include <QJsonArray>

#include "fp_compiler/resources.h"

namespace arbiter::builder {

namespace {

void addGauges(const QJsonObject &counts, QList<Gauge> &gauges) {
  for (const fp::ResourceRow &row : fp::resourceRows()) {
    const QString name = QString::fromLatin1(row.name);
    if (!counts.contains(name))
      continue;
    const QJsonValue count = counts[name];
    gauges.append({name,
                   QString::fromLatin1(row.title),
                   count[u"used"].toInt(),
                   count[u"limit"].toInt(),
                   count[u"native_used"].toInt(),
                   count[u"native_limit"].toInt(),
                   {}});
  }
}

QString placeText(const QJsonValue &place) {
  return QStringLiteral("%1 line %2").arg(place[u"opcode"].toString()).arg(place[u"line"].toInt());
}

void addReasons(const QJsonArray &reasons, QList<Gauge> &gauges) {
  constexpr qsizetype kMax = 12;
  for (const QJsonValue reason : reasons)
    for (Gauge &gauge : gauges)
      if (gauge.name == reason[u"resource"].toString() && gauge.reasons.size() < kMax)
        gauge.reasons.append(QStringLiteral("%1: %2")
                                 .arg(reason[u"amount"].toInt())
                                 .arg(reason[u"text"].toString()));
}

void addLines(const QJsonArray &instructions, QMap<int, LineCost> &lines) {
  for (const QJsonValue instruction : instructions) {
    LineCost &cost = lines[instruction[u"end_line"].toInt(1)];
    cost.slotCount += instruction[u"slots"].toDouble();
    cost.textures += instruction[u"textures"].toInt();
    cost.node = std::max(cost.node, instruction[u"node"].toInt());
    cost.gone = cost.gone && instruction[u"gone"].toBool();
  }
}

void addNodes(const QJsonArray &nodes, QList<NodeLine> &lines) {
  for (const QJsonValue node : nodes) {
    NodeLine line{{}, node[u"pairs"].toInt(), node[u"reason"].toString()};
    for (const QJsonValue texture : node[u"textures"].toArray())
      line.textures.append(placeText(texture));
    lines.append(line);
  }
}

} // namespace

Report Report::of(const QJsonObject &file) {
  Report report;
  report.status = file[u"status"].toString();
  report.profile = file[u"profile"].toString();
  const QJsonValue native = file[u"native"];
  addGauges(file[u"counts"].toObject(), report.gauges);
  addReasons(native[u"reasons"].toArray(), report.gauges);
  addLines(native[u"instructions"].toArray(), report.lines);
  addNodes(native[u"nodes"].toArray(), report.nodes);
  report.cycles = native[u"cycles"][u"cycles"].toDouble();
  report.bound = native[u"cycles"][u"bound"].toString();
  return report;
}

void Report::follow(const Edit &edit, const QString &text) {
  const int gone = int(edit.removed.count(u'\n')), come = int(edit.added.count(u'\n'));
  if (gone == 0 && come == 0)
    return;
  const int first = placeOf(text, edit.at).line;
  const bool whole = edit.at == 0 || text[edit.at - 1] == u'\n'; // the line moves with its text
  QMap<int, LineCost> moved;
  for (auto cost = lines.constBegin(); cost != lines.constEnd(); ++cost) {
    const int line = cost.key();
    if (line < first || (line == first && !whole))
      moved.insert(line, *cost);
    else if (line >= first + gone && !moved.contains(line + come - gone))
      moved.insert(line + come - gone, *cost);
  }
  lines = moved;
}

} // namespace arbiter::builder
