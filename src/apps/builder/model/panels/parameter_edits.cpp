// Edits the rest of a parameter besides its value: range, animation, a new line.
#include <QStringList>
#include <algorithm>

#include "apps/builder/model/panels/clauses.h"
#include "apps/builder/model/panels/parameters.h"
#include "apps/builder/model/panels/utf_map.h"
#include "apps/scene/edit.h"
#include "apps/scene/panel/panel.h"

namespace arbiter::builder {

namespace {

/// A parameter's clause in the present text.
class Written {
public:
  Written(const QString &text, int line)
      : m_text(text), m_map(text), m_panel(scene::parsePanel(m_map.bytes())) {
    if (line >= 0 && std::size_t(line) < m_panel.parameters.size())
      m_parameter = &m_panel.parameters[std::size_t(line)];
  }

  [[nodiscard]] const scene::Parameter *parameter() const { return m_parameter; }
  [[nodiscard]] Edit number(const scene::Number &number, double value) const {
    return replaced(number.span.begin, number.span.end, Parameters::numberText(value));
  }
  [[nodiscard]] Edit behind(const QString &words) const {
    const qsizetype end = m_map.unit(m_parameter->span.end);
    return {end, {}, u' ' + words};
  }
  /// Replaces "animate WORD 5s"; an empty text also removes the blank before it.
  [[nodiscard]] Edit animation(const QString &words) const {
    const scene::Animation &animation = *m_parameter->animation;
    qsizetype end = m_map.unit(animation.period.written() ? animation.period.span.end
                                                          : animation.kind.span.end);
    if (animation.period.written() && end < m_text.size() && m_text[end] == u's')
      ++end;
    qsizetype begin =
        m_text.lastIndexOf(QStringLiteral("animate"), m_map.unit(animation.kind.span.begin));
    while (words.isEmpty() && begin > 0 && m_text[begin - 1].isSpace())
      --begin;
    return {begin, m_text.mid(begin, end - begin), words};
  }

private:
  [[nodiscard]] Edit replaced(std::uint32_t from, std::uint32_t to, const QString &added) const {
    const qsizetype begin = m_map.unit(from), end = m_map.unit(to);
    return {begin, m_text.mid(begin, end - begin), added};
  }

  const QString &m_text;
  UtfMap m_map;
  scene::Panel m_panel;
  const scene::Parameter *m_parameter = nullptr;
};

QString rangeText(double low, double high) {
  return QStringLiteral("in %1..%2").arg(Parameters::numberText(low), Parameters::numberText(high));
}

} // namespace

void Parameters::setRange(int line, double low, double high) {
  const Written written(m_document.text(), line);
  const scene::Parameter *parameter = written.parameter();
  if (!parameter || !(low < high))
    return;
  QList<Edit> edits; // the last one first
  if (!parameter->hasRange)
    edits = {written.behind(rangeText(low, high))};
  else
    edits = {written.number(parameter->high, high), written.number(parameter->low, low)};
  edits.removeIf([](const Edit &edit) { return edit.removed == edit.added; });
  if (!edits.isEmpty())
    m_document.apply(edits, tr("range of %1").arg(m_lines[line].label));
}

void Parameters::setMotion(int line, const QString &motion, double seconds) {
  const Written written(m_document.text(), line);
  const scene::Parameter *parameter = written.parameter();
  if (!parameter || (motion.isEmpty() && !parameter->animation))
    return;
  const QString words =
      motion.isEmpty()
          ? QString()
          : QStringLiteral("animate %1 %2s").arg(motion, numberText(std::max(0.001, seconds)));
  const Edit edit = parameter->animation ? written.animation(words) : written.behind(words);
  if (edit.removed != edit.added)
    m_document.apply({edit}, tr("animation of %1").arg(m_lines[line].label));
}

void Parameters::add() {
  int index = 0;
  for (const ParameterLine &line : m_lines)
    if (line.space == u"local")
      index = std::max(index, line.index + std::max(line.rows, 1));
  const QString words = QStringLiteral("local[%1].x \"value %1\" = 0.5 in 0..1").arg(index);
  m_document.apply({addClause(m_document.text(), words, {})}, tr("parameter local[%1]").arg(index));
}

QStringList Parameters::motionsOf(int line) const {
  QStringList words;
  for (const scene::WordRow &row : scene::wordsOf<scene::AnimationKind>())
    words << QString::fromUtf8(row.word.data(), qsizetype(row.word.size()));
  const bool turns = line >= 0 && line < m_lines.size() && m_lines[line].components.size() >= 3 &&
                     m_lines[line].components[2].index == 2;
  if (!turns)
    words.removeAll(QStringLiteral("turn"));
  return words;
}

} // namespace arbiter::builder
