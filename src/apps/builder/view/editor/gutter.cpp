#include "apps/builder/view/editor/gutter.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTextBlock>
#include <QToolTip>
#include <algorithm>

#include "apps/builder/view/editor/code_editor.h"
#include "apps/builder/view/theme.h"

namespace arbiter::builder {

namespace {

/// Returns a short text: "2 slots", "1 TEX n2".
QString costText(const LineCost &cost, bool nodes) {
  if (cost.gone)
    return QStringLiteral("\u2013"); // compiled away
  QString text = cost.textures > 0 ? QStringLiteral("T") : QString::number(cost.slotCount);
  if (cost.textures > 0 && cost.slotCount > 0)
    text += QStringLiteral("+%1").arg(cost.slotCount);
  return nodes ? text + QStringLiteral(" n%1").arg(cost.node + 1) : text;
}

QString costHint(const LineCost &cost) {
  if (cost.gone)
    return QObject::tr("compiled away: no slot");
  return QObject::tr("%1 ALU slots, %2 texture instructions, node %3")
      .arg(cost.slotCount)
      .arg(cost.textures)
      .arg(cost.node + 1);
}

} // namespace

Gutter::Gutter(CodeEditor &editor) : QWidget(&editor), m_editor(editor) {}

QSize Gutter::sizeHint() const { return {m_editor.gutterWidth(), 0}; }

int Gutter::lineAt(int y) const {
  for (QTextBlock block = m_editor.firstVisibleBlock(); block.isValid(); block = block.next()) {
    const QRectF box = m_editor.blockBoundingGeometry(block).translated(m_editor.contentOffset());
    if (y < box.bottom())
      return y >= box.top() ? block.blockNumber() + 1 : 0;
  }
  return 0;
}

void Gutter::paintEvent(QPaintEvent *event) {
  QPainter painter(this);
  const Colors &c = colors();
  painter.fillRect(event->rect(), c.line);
  const Report &report = m_editor.bench().report();
  const bool nodes = report.nodes.size() > 1;
  const int numbers = fontMetrics().horizontalAdvance(QStringLiteral("9999"));
  painter.setFont(m_editor.font());
  for (QTextBlock block = m_editor.firstVisibleBlock(); block.isValid(); block = block.next()) {
    const QRectF box = m_editor.blockBoundingGeometry(block).translated(m_editor.contentOffset());
    if (box.top() > event->rect().bottom())
      break;
    const int line = block.blockNumber() + 1;
    const bool here = m_editor.textCursor().blockNumber() + 1 == line;
    painter.setPen(here ? c.text : c.dim);
    painter.drawText(QRectF(10, box.top(), numbers, box.height()), Qt::AlignRight | Qt::AlignTop,
                     QString::number(line));
    if (const auto cost = report.lines.constFind(line); cost != report.lines.constEnd()) {
      painter.setPen(c.dim);
      painter.drawText(QRectF(numbers + 14, box.top(), width() - numbers - 20, box.height()),
                       Qt::AlignRight | Qt::AlignTop, costText(*cost, nodes));
    }
    for (const Problem &problem : m_editor.bench().problems()) {
      if (problem.line != line || !problem.file.isEmpty())
        continue;
      painter.setPen(Qt::NoPen);
      painter.setBrush(problem.severity == Severity::Error     ? c.error
                       : problem.severity == Severity::Warning ? c.warning
                                                               : c.note);
      painter.drawRoundedRect(QRectF(2, box.top() + 2, 5, m_editor.fontMetrics().height() - 4), 2,
                              2);
      break;
    }
  }
}

void Gutter::mousePressEvent(QMouseEvent *event) {
  if (const int line = lineAt(event->pos().y()); line > 0)
    Q_EMIT m_editor.lineClicked(line);
}

bool Gutter::event(QEvent *event) {
  if (event->type() != QEvent::ToolTip)
    return QWidget::event(event);
  auto *help = static_cast<QHelpEvent *>(event);
  const int line = lineAt(help->pos().y());
  QStringList parts;
  for (const Problem &problem : m_editor.bench().problems())
    if (problem.line == line)
      parts << problem.message;
  const auto &lines = m_editor.bench().report().lines;
  if (const auto cost = lines.constFind(line); cost != lines.constEnd())
    parts << costHint(*cost);
  QToolTip::showText(help->globalPos(), parts.join(u'\n'), this);
  return true;
}

} // namespace arbiter::builder
