#include "apps/builder/model/text/document.h"

#include <algorithm>

namespace arbiter::builder {

namespace {

/// A pause of this many milliseconds ends an undo step of typing.
constexpr qint64 kPause = 1000;
/// The number of steps that are kept; the oldest are dropped.
constexpr qsizetype kMaxSteps = 10000;

bool isWord(QChar c) { return c.isLetterOrNumber() || c == u'_'; }

/// True if both are words or both are not: words and separators are undone separately.
bool sameKind(QStringView last, QStringView next) {
  return !last.isEmpty() && !next.isEmpty() && isWord(last.back()) == isWord(next.front()) &&
         !next.contains(u'\n') && !last.contains(u'\n');
}

} // namespace

void Document::open(const QString &text) {
  const Edit edit = difference(m_text, text);
  m_steps.clear();
  m_done = 0;
  m_open = false;
  m_saved = text;
  perform(edit, Origin::Outside);
  Q_EMIT stateChanged();
}

void Document::markSaved() { setSavedText(m_text); }

void Document::setSavedText(const QString &text) {
  m_saved = text;
  m_open = false;
  Q_EMIT stateChanged();
}

void Document::replace(qsizetype at, qsizetype length, const QString &added, Origin origin,
                       const QString &name) {
  at = std::clamp<qsizetype>(at, 0, m_text.size());
  length = std::clamp<qsizetype>(length, 0, m_text.size() - at);
  const Edit edit{at, m_text.mid(at, length), added};
  if (edit.removed == edit.added)
    return;
  record(edit, origin, name);
  perform(edit, origin);
  Q_EMIT stateChanged();
}

void Document::become(const QString &text, Origin origin, const QString &name) {
  const Edit edit = difference(m_text, text);
  if (!edit.isEmpty())
    replace(edit.at, edit.removed.size(), edit.added, origin, name);
}

void Document::apply(const QList<Edit> &edits, const QString &name) {
  m_open = false;
  m_steps.resize(m_done);
  Step step{{}, name};
  for (const Edit &wanted : edits) {
    const qsizetype at = std::clamp<qsizetype>(wanted.at, 0, m_text.size());
    const Edit edit{at, m_text.mid(at, wanted.removed.size()), wanted.added};
    step.edits.append(edit);
    perform(edit, Origin::Tool);
  }
  if (!step.edits.isEmpty()) {
    m_steps.append(step);
    m_done = m_steps.size();
  }
  Q_EMIT stateChanged();
}

void Document::undo() {
  if (!canUndo())
    return;
  m_open = false;
  const Step step = m_steps[--m_done];
  for (auto edit = step.edits.crbegin(); edit != step.edits.crend(); ++edit)
    perform(edit->inverse(), Origin::History);
  Q_EMIT stateChanged();
}

void Document::redo() {
  if (!canRedo())
    return;
  m_open = false;
  const Step step = m_steps[m_done++];
  for (const Edit &edit : step.edits)
    perform(edit, Origin::History);
  Q_EMIT stateChanged();
}

void Document::perform(const Edit &edit, Origin origin) {
  m_text.replace(edit.at, edit.removed.size(), edit.added);
  ++m_revision;
  Q_EMIT edited(edit, origin);
}

bool Document::joins(const Edit &edit) const {
  if (!m_open || m_sinceTyping.elapsed() > kPause || m_done == 0)
    return false;
  const Edit &last = m_steps[m_done - 1].edits.last();
  if (edit.removed.isEmpty() && last.removed.isEmpty())
    return edit.at == last.at + last.added.size() && sameKind(last.added, edit.added);
  if (edit.added.isEmpty() && last.added.isEmpty()) // backspace and delete
    return edit.at + edit.removed.size() == last.at || edit.at == last.at;
  return false;
}

void Document::record(const Edit &edit, Origin origin, const QString &name) {
  m_steps.resize(m_done);
  const bool typing = origin == Origin::Typing;
  if (typing && joins(edit)) {
    Edit &last = m_steps.last().edits.last();
    if (edit.added.isEmpty()) {
      const bool before = edit.at < last.at;
      last.removed = before ? edit.removed + last.removed : last.removed + edit.removed;
      last.at = edit.at;
    } else {
      last.added += edit.added;
    }
  } else {
    m_steps.append({{edit}, typing ? QStringLiteral("typing") : name});
    if (m_steps.size() > kMaxSteps)
      m_steps.removeFirst();
  }
  m_done = m_steps.size();
  m_open = typing;
  m_sinceTyping.restart();
}

} // namespace arbiter::builder
