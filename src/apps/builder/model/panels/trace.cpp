#include "apps/builder/model/panels/trace.h"

#include <QJsonArray>
#include <algorithm>
#include <cmath>
#include <limits>

namespace arbiter::builder {

namespace {

constexpr QStringView kLetters = u"xyzw";

double numberOf(const QJsonValue &json) {
  if (json.isDouble())
    return json.toDouble();
  const QString text = json.toString();
  if (text == u"inf")
    return std::numeric_limits<double>::infinity();
  if (text == u"-inf")
    return -std::numeric_limits<double>::infinity();
  return std::numeric_limits<double>::quiet_NaN();
}

TraceOperand operandOf(const QJsonValue &json) {
  return {json[u"text"].toString(), TraceValue::of(json[u"value"]), json[u"unwritten"].toString()};
}

TraceRow rowOf(const QJsonValue &json) {
  TraceRow row;
  row.line = json[u"line"].toInt(1);
  row.text = json[u"text"].toString();
  row.opcode = json[u"opcode"].toString();
  row.destination = json[u"destination"].toString();
  row.name = json[u"register"].toString();
  row.mask = json[u"mask"].toString();
  row.value = TraceValue::of(json[u"value"]);
  row.second = TraceValue::of(json[u"second"]);
  row.error = json[u"error"].isUndefined() ? 0 : numberOf(json[u"error"]);
  for (const QJsonValue operand : json[u"operands"].toArray())
    row.operands.append(operandOf(operand));
  if (const QJsonValue texel = json[u"texel"]; texel.isObject()) {
    row.unit = texel[u"unit"].toInt(-1);
    row.texel = TraceValue::of(texel[u"value"]);
    row.coordinate = TraceValue::of(texel[u"coordinate"]);
  }
  for (const QJsonValue flag : json[u"flags"].toArray())
    row.flags.append(flag.toString());
  row.discarded = json[u"discarded"].toBool();
  return row;
}

void addNamed(const QJsonArray &named, QList<std::pair<QString, TraceValue>> &all) {
  for (const QJsonValue each : named)
    all.append({each[u"name"].toString(), TraceValue::of(each[u"value"])});
}

} // namespace

TraceValue TraceValue::of(const QJsonValue &json) {
  TraceValue value;
  const QJsonArray array = json.toArray();
  value.known = array.size() == 4;
  for (int c = 0; c < 4 && value.known; ++c)
    value.value[std::size_t(c)] = numberOf(array[c]);
  return value;
}

QString TraceValue::text(const QString &mask) const {
  if (!known)
    return {};
  QStringList parts;
  for (int c = 0; c < 4; ++c)
    if (mask.isEmpty() || mask.contains(kLetters[c]))
      parts << QString::number(value[std::size_t(c)], 'g', 5);
  return parts.join(QStringLiteral("  "));
}

QColor TraceValue::color() const {
  std::array<float, 3> rgb = {};
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = std::isfinite(value[c]) ? float(std::clamp(value[c], 0.0, 1.0)) : 0.0F;
  return QColor::fromRgbF(rgb[0], rgb[1], rgb[2]);
}

bool Trace::take(const QJsonObject &json) {
  // The trace is the document itself, or a member beside the pixel's verdict.
  const QJsonObject trace = json[u"trace"].isObject() ? json[u"trace"].toObject() : json;
  if (!trace[u"rows"].isArray())
    return false;
  m_rows.clear();
  for (const QJsonValue row : trace[u"rows"].toArray())
    m_rows.append(rowOf(row));
  m_inputs.clear();
  addNamed(trace[u"attributes"].toArray(), m_inputs);
  addNamed(trace[u"parameters"].toArray(), m_inputs);
  m_numerics = trace[u"numerics"].toString();
  m_secondNumerics = trace[u"second_numerics"].toString();
  m_discarded = trace[u"discarded"].toBool();
  const QJsonArray verdicts = json[u"verdicts"].toArray();
  const QJsonValue verdict = verdicts.isEmpty() ? json[u"verdict"] : QJsonValue(verdicts.first());
  m_verdict = verdict[u"line"].toString();
  m_equal = verdict[u"equal"].toBool();
  m_current = m_rows.isEmpty() ? -1 : std::clamp<int>(m_current, 0, int(m_rows.size()) - 1);
  Q_EMIT changed();
  Q_EMIT moved(m_current);
  return true;
}

void Trace::clear() {
  m_rows.clear();
  m_inputs.clear();
  m_verdict.clear();
  m_current = -1;
  Q_EMIT changed();
}

QList<std::pair<QString, TraceValue>> Trace::registers() const {
  QList<std::pair<QString, TraceValue>> all;
  for (int i = m_current; i >= 0; --i) {
    const TraceRow &row = m_rows[i];
    const bool seen = std::any_of(all.cbegin(), all.cend(),
                                  [&](const auto &each) { return each.first == row.name; });
    if (!row.name.isEmpty() && row.value.known && !seen)
      all.append({row.name, row.value});
  }
  return all;
}

void Trace::moveTo(int row) {
  if (m_rows.isEmpty())
    return;
  row = std::clamp<int>(row, 0, int(m_rows.size()) - 1);
  if (row == m_current)
    return;
  m_current = row;
  Q_EMIT moved(row);
}

void Trace::runToLine(int line) {
  for (int i = 0; i < m_rows.size(); ++i)
    if (m_rows[i].line >= line)
      return moveTo(i);
}

bool Trace::nextFlag(const QString &flag) {
  for (int i = 1; i <= m_rows.size(); ++i) {
    const int row = int((m_current + i) % m_rows.size());
    if (m_rows[row].flags.contains(flag)) {
      moveTo(row);
      return true;
    }
  }
  return false;
}

} // namespace arbiter::builder
