#include "apps/builder/view/editor/completer.h"

#include <QJsonObject>
#include <QTextCursor>
#include <algorithm>

#include "apps/builder/view/editor/code_editor.h"

namespace arbiter::builder {

namespace {

constexpr int kMaxRows = 9;
constexpr int kInsertRole = Qt::UserRole;

} // namespace

Completer::Completer(CodeEditor &editor) : QListWidget(editor.viewport()), m_editor(editor) {
  setFocusPolicy(Qt::NoFocus);
  setFrameShape(QFrame::Box);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setUniformItemSizes(true);
  setAccessibleName(QObject::tr("Completions"));
  QObject::connect(this, &QListWidget::itemClicked, this, [this] { accept(); });
  hide();
}

QString Completer::typed() const {
  const qsizetype at = m_editor.textCursor().position();
  return at < m_wordBegin ? QString() : m_editor.text().mid(m_wordBegin, at - m_wordBegin);
}

void Completer::show(const QJsonArray &items, qsizetype wordBegin) {
  clear();
  m_wordBegin = wordBegin;
  for (const QJsonValue item : items) {
    const QString label = item[u"label"].toString();
    const QString detail = item[u"detail"].toString();
    auto *row =
        new QListWidgetItem(detail.isEmpty() ? label : label + QStringLiteral("   ") + detail);
    const QString edit = item[u"textEdit"][u"newText"].toString();
    const QString insert = item[u"insertText"].toString();
    row->setData(kInsertRole, !edit.isEmpty() ? edit : !insert.isEmpty() ? insert : label);
    row->setToolTip(item[u"documentation"].isObject() ? item[u"documentation"][u"value"].toString()
                                                      : item[u"documentation"].toString());
    addItem(row);
  }
  narrow();
}

void Completer::narrow() {
  const QString word = typed();
  if (m_editor.textCursor().position() < m_wordBegin)
    return hide();
  QListWidgetItem *first = nullptr;
  for (int i = 0; i < count(); ++i) {
    const bool fits = item(i)->data(kInsertRole).toString().startsWith(word, Qt::CaseInsensitive);
    item(i)->setHidden(!fits);
    if (fits && !first)
      first = item(i);
  }
  const bool whole = first && first->data(kInsertRole).toString() == word;
  if (!first || whole)
    return hide();
  if (!currentItem() || currentItem()->isHidden())
    setCurrentItem(first);
  place();
  QListWidget::show();
}

void Completer::place() {
  int rows = 0, width = 200;
  for (int i = 0; i < count(); ++i)
    if (!item(i)->isHidden()) {
      ++rows;
      width = std::max(width, fontMetrics().horizontalAdvance(item(i)->text()) + 40);
    }
  const QWidget *area = parentWidget();
  width = std::min(width, area->width() - 8);
  const int height = sizeHintForRow(0) * std::min(rows, kMaxRows) + 2 * frameWidth();
  QTextCursor begin = m_editor.textCursor();
  begin.setPosition(int(m_wordBegin));
  const QRect word = m_editor.cursorRect(begin);
  const bool below = word.bottom() + height < area->height() || word.top() < height;
  setGeometry(std::min(word.left(), std::max(0, area->width() - width - 4)),
              below ? word.bottom() + 2 : word.top() - height - 2, width, height);
}

void Completer::select(int by) {
  const int step = by < 0 ? -1 : 1;
  int row = currentRow();
  for (int left = std::abs(by); left > 0; --left) {
    int next = row + step;
    while (next >= 0 && next < count() && item(next)->isHidden())
      next += step;
    if (next < 0 || next >= count())
      break;
    row = next;
  }
  setCurrentRow(row);
}

bool Completer::takeKey(int key) {
  if (!isVisible())
    return false;
  switch (key) {
  case Qt::Key_Up:
    select(-1);
    return true;
  case Qt::Key_Down:
    select(1);
    return true;
  case Qt::Key_PageUp:
    select(-kMaxRows);
    return true;
  case Qt::Key_PageDown:
    select(kMaxRows);
    return true;
  case Qt::Key_Return:
  case Qt::Key_Enter:
  case Qt::Key_Tab:
    accept();
    return true;
  case Qt::Key_Escape:
    hide();
    return true;
  default:
    return false;
  }
}

void Completer::accept() {
  if (!currentItem())
    return hide();
  const QString text = currentItem()->data(kInsertRole).toString();
  hide();
  QTextCursor cursor = m_editor.textCursor();
  cursor.setPosition(int(m_wordBegin), QTextCursor::KeepAnchor);
  cursor.insertText(text);
  m_editor.setTextCursor(cursor);
}

} // namespace arbiter::builder
