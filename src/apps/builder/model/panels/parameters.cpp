#include "apps/builder/model/panels/parameters.h"

#include <QStringList>
#include <algorithm>
#include <cmath>

#include "apps/builder/model/panels/utf_map.h"
#include "apps/scene/animate.h"
#include "apps/scene/edit.h"

namespace arbiter::builder {

namespace {

QString animationText(const scene::Parameter &parameter) {
  if (!parameter.animation)
    return {};
  const auto &word = scene::rowOf(parameter.animation->kind.value).word;
  return QStringLiteral("%1 %2s")
      .arg(QString::fromUtf8(word.data(), qsizetype(word.size())))
      .arg(parameter.animation->period.value);
}

QList<Component> componentsOf(const scene::Parameter &parameter, const UtfMap &map) {
  QList<Component> all;
  std::size_t number = 0;
  for (int c = 0; c < 4; ++c) {
    if (!parameter.mask[std::size_t(c)] || number >= parameter.values.size())
      continue;
    const scene::Number &written = parameter.values[number++];
    Component component{written.value, -1, 0, c};
    if (written.written()) {
      component.at = map.unit(written.span.begin);
      component.length = map.unit(written.span.end) - component.at;
    }
    all.append(component);
  }
  return all;
}

/// Chooses a range for a slider without one in the text: round numbers, wide enough for the values.
void guessRange(ParameterLine &line) {
  double largest = 1;
  bool negative = false;
  for (const Component &component : line.components) {
    largest = std::max(largest, std::abs(component.value));
    negative = negative || component.value < 0;
  }
  line.high = largest > 1 ? 2 * largest : 1;
  line.low = negative ? -line.high : 0;
}

ParameterLine lineOf(const scene::Parameter &parameter, const UtfMap &map, const QString &text) {
  ParameterLine line;
  const auto &space = scene::rowOf(parameter.space).word;
  line.space = QString::fromUtf8(space.data(), qsizetype(space.size()));
  line.index = int(parameter.first);
  line.rows = int(parameter.count);
  line.label = QString::fromStdString(parameter.label.text);
  if (line.label.isEmpty())
    line.label = QStringLiteral("%1[%2]").arg(line.space).arg(line.index);
  line.fixed = parameter.kind.value != scene::ValueKind::Numbers;
  if (!line.fixed)
    line.components = componentsOf(parameter, map);
  line.hasRange = parameter.hasRange;
  line.low = parameter.low.value;
  line.high = parameter.high.value;
  if (!line.hasRange || !(line.low < line.high))
    guessRange(line);
  line.color = parameter.color && line.components.size() >= 3;
  line.animation = animationText(parameter);
  if (parameter.animation) {
    line.motion = line.animation.section(u' ', 0, 0);
    line.period = parameter.animation->period.value;
  }
  line.line = placeOf(text, map.unit(parameter.span.begin)).line;
  return line;
}

} // namespace

Parameters::Parameters(Document &document, QObject *parent)
    : QObject(parent), m_document(document) {
  connect(&m_document, &Document::edited, this, &Parameters::read);
  read();
}

void Parameters::read() {
  m_held.clear();
  const QString &text = m_document.text();
  const UtfMap map(text);
  const scene::Panel panel = scene::parsePanel(map.bytes());
  QList<ParameterLine> lines;
  for (const scene::Parameter &parameter : panel.parameters)
    lines.append(lineOf(parameter, map, text));
  m_lines = lines;
  m_parsed = panel.parameters;
  Q_EMIT linesChanged();
}

QString Parameters::numberText(double value) {
  return QString::fromStdString(scene::numberText(value));
}

void Parameters::drag(int line, int component, double value) {
  if (line < 0 || line >= m_lines.size() || component < 0 ||
      component >= m_lines[line].components.size() || m_lines[line].components[component].at < 0)
    return;
  const auto held = std::find_if(m_held.begin(), m_held.end(), [&](const Held &each) {
    return each.line == line && each.component == component;
  });
  if (held == m_held.end())
    m_held.append({line, component, value});
  else
    held->value = value;
  Q_EMIT dragged(line, component, value);
}

double Parameters::value(int line, int component) const {
  for (const Held &held : m_held)
    if (held.line == line && held.component == component)
      return held.value;
  return m_lines[line].components[component].value;
}

double Parameters::valueAt(int line, int component, double seconds) const {
  for (const Held &held : m_held)
    if (held.line == line && held.component == component)
      return held.value;
  const auto values = scene::valueAt(m_parsed[std::size_t(line)], seconds);
  return values[std::size_t(m_lines[line].components[component].index)];
}

/// Returns the edits from last to first, so that each one's place stays right.
QList<Edit> Parameters::heldEdits() const {
  QList<Edit> edits;
  for (const Held &held : m_held) {
    const Component &component = m_lines[held.line].components[held.component];
    const Edit edit{component.at, m_document.text().mid(component.at, component.length),
                    numberText(held.value)};
    if (edit.removed != edit.added)
      edits.append(edit);
  }
  std::sort(edits.begin(), edits.end(), [](const Edit &a, const Edit &b) { return a.at > b.at; });
  return edits;
}

void Parameters::release() {
  if (m_held.isEmpty())
    return;
  const QString name = tr("move %1").arg(m_lines[m_held.first().line].label);
  const QList<Edit> edits = heldEdits();
  m_held.clear();
  if (!edits.isEmpty())
    m_document.apply(edits, name);
}

void Parameters::set(int line, const QList<double> &values) {
  if (line < 0 || line >= m_lines.size())
    return;
  for (int c = 0; c < std::min(values.size(), m_lines[line].components.size()); ++c)
    drag(line, c, values[c]);
  release();
}

QString Parameters::liveText() const {
  QString text = m_document.text();
  for (const Edit &edit : heldEdits())
    text.replace(edit.at, edit.removed.size(), edit.added);
  return text;
}

} // namespace arbiter::builder
