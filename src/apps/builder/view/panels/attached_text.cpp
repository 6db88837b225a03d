#include "apps/builder/view/panels/attached_text.h"

#include <QBoxLayout>
#include <QFontDatabase>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTextBlock>
#include <algorithm>

#include "apps/builder/view/editor/highlighter.h"
#include "apps/builder/view/theme.h"

namespace arbiter::builder {

AttachedText::AttachedText(Attachment &attachment) : m_attachment(attachment) {
  m_editor = new QPlainTextEdit;
  m_editor->setObjectName(QStringLiteral("attached-text"));
  m_editor->setAccessibleName(tr("Text of the application's program"));
  m_editor->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  m_editor->setLineWrapMode(QPlainTextEdit::NoWrap);
  m_editor->setTabChangesFocus(true);
  new Highlighter(m_editor->document());
  m_problems = new QListWidget;
  m_problems->setObjectName(QStringLiteral("attached-problems"));
  m_problems->setAccessibleName(tr("Problems of the text"));
  m_problems->setMaximumHeight(m_problems->fontMetrics().height() * 4);
  m_problems->setWordWrap(true);
  m_problems->hide();
  m_state = new QLabel;
  m_state->setWordWrap(true);
  m_putBack = new QPushButton(tr("Put &back"));
  m_putBack->setObjectName(QStringLiteral("put-back"));
  m_putBack->setToolTip(tr("The application's own text again"));
  auto *row = new QHBoxLayout;
  row->addWidget(m_state, 1);
  row->addWidget(m_putBack);
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->addWidget(m_editor, 1);
  layout->addWidget(m_problems);
  layout->addLayout(row);
  connect(m_editor, &QPlainTextEdit::textChanged, this, [this] { edited(); });
  connect(m_putBack, &QPushButton::clicked, this, [this] { m_attachment.putBack(); });
  connect(m_problems, &QListWidget::itemActivated, this, [this] {
    const auto &problems = m_attachment.problems();
    const int at = m_problems->currentRow();
    if (at < 0 || at >= problems.size())
      return;
    QTextCursor cursor = m_editor->textCursor();
    cursor.setPosition(
        int(std::min(problems[at].begin, qsizetype(m_editor->document()->characterCount() - 1))));
    m_editor->setTextCursor(cursor);
    m_editor->setFocus();
  });
  connect(&attachment, &Attachment::textCame, this, [this](const QString &text) { take(text); });
  connect(&attachment, &Attachment::judged, this, [this] { showVerdict(); });
  connect(&attachment, &Attachment::attachedChanged, this, [this] {
    if (!m_attachment.isAttached())
      take({});
    showVerdict();
  });
  showVerdict();
}

void AttachedText::take(const QString &text) {
  m_sent = text;
  m_tracedLine = 0;
  if (m_editor->toPlainText() != text)
    m_editor->setPlainText(text); // another program has its own undo history
  m_sent = m_editor->toPlainText();
}

/// Sends the text if it changed; highlighting is no edit.
void AttachedText::edited() {
  const QString text = m_editor->toPlainText();
  if (text == m_sent || m_attachment.selected().isEmpty())
    return;
  m_sent = text;
  m_attachment.setText(text);
}

void AttachedText::showVerdict() {
  m_problems->clear();
  for (const Problem &problem : m_attachment.problems()) {
    QString line =
        QStringLiteral("%1:%2 %3").arg(problem.line).arg(problem.column).arg(problem.message);
    if (!problem.hint.isEmpty())
      line += QStringLiteral(": ") + problem.hint;
    m_problems->addItem(line);
  }
  m_problems->setVisible(m_problems->count() > 0);
  const bool chosen = m_attachment.isAttached() && !m_attachment.selected().isEmpty();
  m_putBack->setEnabled(chosen);
  m_editor->setReadOnly(!chosen);
  QPalette palette = this->palette();
  if (!m_attachment.isRight())
    palette.setColor(QPalette::WindowText, colors().error);
  m_state->setPalette(palette);
  m_state->setText(!chosen                  ? tr("choose a program")
                   : m_attachment.isRight() ? tr("the application draws with this text")
                                            : tr("the text is wrong; the last right one is drawn"));
  showMarks();
}

void AttachedText::setTracedLine(int line) {
  m_tracedLine = line;
  showMarks();
}

void AttachedText::showMarks() {
  QList<QTextEdit::ExtraSelection> marks;
  const int length = m_editor->document()->characterCount() - 1;
  if (const QTextBlock block = m_editor->document()->findBlockByNumber(m_tracedLine - 1);
      m_tracedLine > 0 && block.isValid()) {
    QTextEdit::ExtraSelection mark;
    mark.format.setBackground(colors().traced);
    mark.format.setProperty(QTextFormat::FullWidthSelection, true);
    mark.cursor = QTextCursor(block);
    marks << mark;
  }
  for (const Problem &problem : m_attachment.problems()) {
    QTextEdit::ExtraSelection mark;
    mark.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    mark.format.setUnderlineColor(problem.severity == Severity::Error ? colors().error
                                                                      : colors().warning);
    mark.cursor = QTextCursor(m_editor->document());
    mark.cursor.setPosition(std::min(int(problem.begin), length));
    mark.cursor.setPosition(std::min(int(std::max(problem.end, problem.begin + 1)), length),
                            QTextCursor::KeepAnchor);
    marks << mark;
  }
  m_editor->setExtraSelections(marks);
}

} // namespace arbiter::builder
