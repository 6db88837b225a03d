#include "apps/builder/view/editor/code_editor.h"

#include <QFontDatabase>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QTextBlock>

#include "apps/builder/view/editor/completer.h"
#include "apps/builder/view/editor/gutter.h"
#include "apps/builder/view/editor/highlighter.h"
#include "apps/builder/view/theme.h"

namespace arbiter::builder {

namespace {

/// Returns the text of a text document, with \n between lines.
QString plain(const QTextDocument &document) {
  QString text = document.toRawText(); // toPlainText() replaces some spaces
  for (QChar &c : text)
    if (c == QChar::ParagraphSeparator || c == QChar::LineSeparator || c == QChar(0xfdd0) ||
        c == QChar(0xfdd1))
      c = u'\n';
  return text;
}

} // namespace

CodeEditor::CodeEditor(Workbench &bench, QWidget *parent) : QPlainTextEdit(parent), m_bench(bench) {
  QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  font.setPointSizeF(std::max(10.0, font.pointSizeF()));
  setFont(font);
  setLineWrapMode(NoWrap);
  setTabChangesFocus(false);
  setAccessibleName(tr("Program text"));
  setUndoRedoEnabled(false); // the document provides undo
  m_gutter = new Gutter(*this);
  m_completer = new Completer(*this);
  m_highlighter = new Highlighter(document());
  refreshColors();
  setPlainText(bench.document().text());
  connect(document(), &QTextDocument::contentsChange, this, &CodeEditor::contentsChange);
  connect(&bench.document(), &Document::edited, this, &CodeEditor::documentEdited);
  connect(&bench, &Workbench::problemsChanged, this, &CodeEditor::showMarks);
  connect(&bench, &Workbench::reportChanged, m_gutter, qOverload<>(&QWidget::update));
  connect(this, &QPlainTextEdit::blockCountChanged, this,
          [this] { setViewportMargins(gutterWidth(), 0, 0, 0); });
  connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect &rect, int dy) {
    if (dy)
      m_gutter->scroll(0, dy);
    else
      m_gutter->update(0, rect.y(), m_gutter->width(), rect.height());
  });
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, [this] {
    showMarks();
    m_gutter->update();
    const LineColumn place = placeOf(text(), textCursor().position());
    Q_EMIT placeChanged(place.line, place.column);
  });
  setViewportMargins(gutterWidth(), 0, 0, 0);
}

void CodeEditor::refreshColors() {
  QPalette palette = this->palette();
  palette.setColor(QPalette::Base, colors().background);
  palette.setColor(QPalette::Text, colors().text);
  setPalette(palette);
  m_highlighter->refresh();
  showMarks();
}

int CodeEditor::gutterWidth() const {
  return 24 + fontMetrics().horizontalAdvance(QStringLiteral("9999")) +
         fontMetrics().horizontalAdvance(QStringLiteral("T+9 n4"));
}

void CodeEditor::resizeEvent(QResizeEvent *event) {
  QPlainTextEdit::resizeEvent(event);
  const QRect area = contentsRect();
  m_gutter->setGeometry(area.left(), area.top(), gutterWidth(), area.height());
}

/// Sends a change of the editor's text to the document, whatever caused it.
void CodeEditor::contentsChange() {
  if (m_applying)
    return;
  const Edit edit = difference(text(), plain(*document()));
  if (edit.isEmpty())
    return;
  m_applying = true;
  m_bench.document().replace(edit.at, edit.removed.size(), edit.added, Origin::Typing);
  m_applying = false;
}

void CodeEditor::documentEdited(const Edit &edit, Origin origin) {
  if (m_applying)
    return;
  m_applying = true;
  QTextCursor cursor(document());
  cursor.setPosition(int(edit.at));
  cursor.setPosition(int(edit.at + edit.removed.size()), QTextCursor::KeepAnchor);
  cursor.insertText(edit.added);
  m_applying = false;
  if (plain(*document()) != text()) { // a text document changes some characters
    m_applying = true;
    setPlainText(text());
    m_applying = false;
  }
  if (origin == Origin::History) {
    QTextCursor place = textCursor();
    place.setPosition(int(edit.at + edit.added.size()));
    setTextCursor(place);
  }
}

void CodeEditor::showMarks() {
  QList<QTextEdit::ExtraSelection> marks;
  const Colors &c = colors();
  const auto wholeLine = [&](QTextCursor cursor, const QColor &color) {
    QTextEdit::ExtraSelection line;
    cursor.clearSelection();
    line.cursor = cursor;
    line.format.setBackground(color);
    line.format.setProperty(QTextFormat::FullWidthSelection, true);
    marks.append(line);
  };
  wholeLine(textCursor(), c.line);
  if (m_tracedLine > 0)
    wholeLine(QTextCursor(document()->findBlockByNumber(m_tracedLine - 1)), c.traced);
  const int last = document()->characterCount() - 1;
  for (const Problem &problem : m_bench.problems()) {
    if (!problem.file.isEmpty() || problem.begin > last)
      continue;
    QTextEdit::ExtraSelection mark;
    mark.cursor = QTextCursor(document());
    mark.cursor.setPosition(int(problem.begin));
    mark.cursor.setPosition(std::min(int(problem.end), last), QTextCursor::KeepAnchor);
    if (!mark.cursor.hasSelection()) // an empty mark would be invisible
      mark.cursor.movePosition(QTextCursor::PreviousCharacter, QTextCursor::KeepAnchor);
    mark.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    mark.format.setUnderlineColor(problem.severity == Severity::Error     ? c.error
                                  : problem.severity == Severity::Warning ? c.warning
                                                                          : c.note);
    marks.append(mark);
  }
  setExtraSelections(marks);
  m_gutter->update();
}

void CodeEditor::setTracedLine(int line) {
  m_tracedLine = line;
  showMarks();
}

void CodeEditor::goTo(qsizetype offset) {
  QTextCursor cursor = textCursor();
  cursor.setPosition(int(std::min<qsizetype>(offset, document()->characterCount() - 1)));
  setTextCursor(cursor);
  ensureCursorVisible();
}

void CodeEditor::goToProblem(bool forward) {
  const qsizetype next = nextProblem(m_bench.problems(), textCursor().position(), forward);
  if (next >= 0)
    goTo(m_bench.problems()[next].begin);
}

QString CodeEditor::wordAtCursor() const {
  const QString &all = text();
  qsizetype begin = textCursor().position(), end = begin;
  while (begin > 0 && inWord(all[begin - 1]))
    --begin;
  while (end < all.size() && inWord(all[end]))
    ++end;
  return all.mid(begin, end - begin);
}

qsizetype CodeEditor::wordBegin() const {
  qsizetype begin = textCursor().position();
  while (begin > 0 && inWord(text()[begin - 1]))
    --begin;
  return begin;
}

void CodeEditor::undoStep() { m_bench.document().undo(); }
void CodeEditor::redoStep() { m_bench.document().redo(); }

/// Breaks the line and keeps its indentation.
void CodeEditor::indentLine() {
  const QString line = textCursor().block().text().left(textCursor().positionInBlock());
  qsizetype spaces = 0;
  while (spaces < line.size() && line[spaces].isSpace())
    ++spaces;
  textCursor().insertText(QStringLiteral("\n") + line.left(spaces));
  ensureCursorVisible();
}

void CodeEditor::keyPressEvent(QKeyEvent *event) {
  if (m_completer->takeKey(event->key()))
    return;
  if (event->matches(QKeySequence::Undo))
    return undoStep();
  if (event->matches(QKeySequence::Redo))
    return redoStep();
  const bool plainReturn = (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) &&
                           !(event->modifiers() & ~Qt::KeypadModifier);
  if (plainReturn)
    return indentLine();
  if (event->key() == Qt::Key_Backtab || event->key() == Qt::Key_Escape) {
    event->ignore(); // leaves the text by keyboard
    return;
  }
  QPlainTextEdit::keyPressEvent(event);
  afterKey(event->text());
}

void CodeEditor::afterKey(const QString &typed) {
  if (m_completer->isVisible())
    return m_completer->narrow();
  if (typed.isEmpty())
    return;
  const QChar c = typed.front();
  const qsizetype length = textCursor().position() - wordBegin();
  if (c == u'.' || c == u'[' || (c.isLetter() && length == 2))
    complete();
}

void CodeEditor::focusOutEvent(QFocusEvent *event) {
  m_completer->hide();
  QPlainTextEdit::focusOutEvent(event);
}

void CodeEditor::insertFromMimeData(const QMimeData *source) {
  if (source->hasText())
    textCursor().insertText(source->text());
}

bool CodeEditor::event(QEvent *event) {
  // The workbench provides undo; the text edit's own is off.
  if (event->type() == QEvent::ShortcutOverride) {
    auto *key = static_cast<QKeyEvent *>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return false;
    }
  }
  if (event->type() == QEvent::ToolTip) {
    hover(static_cast<QHelpEvent *>(event));
    return true;
  }
  return QPlainTextEdit::event(event);
}

} // namespace arbiter::builder
