// The editor's requests to the language server.
#include <QHelpEvent>
#include <QInputDialog>
#include <QTextBlock>
#include <QTextDocument>
#include <QToolTip>

#include "apps/builder/view/editor/code_editor.h"
#include "apps/builder/view/editor/completer.h"

namespace arbiter::builder {

namespace {

qsizetype offsetAt(const QString &text, const QJsonValue &position) {
  return offsetOf(text, position[u"line"].toInteger(), position[u"character"].toInteger());
}

/// Converts Markdown to rich text for a tool tip.
QString richText(const QString &markdown) {
  QTextDocument document;
  document.setMarkdown(markdown);
  return document.toHtml();
}

} // namespace

void CodeEditor::complete() {
  const qsizetype begin = wordBegin();
  m_bench.language().request(QStringLiteral("textDocument/completion"), textCursor().position(), {},
                             [this, begin](const QJsonValue &result) {
                               const QJsonArray items =
                                   result.isArray() ? result.toArray() : result[u"items"].toArray();
                               if (hasFocus() && wordBegin() == begin)
                                 m_completer->show(items, begin);
                             });
}

void CodeEditor::goToDefinition() {
  m_bench.language().request(QStringLiteral("textDocument/definition"), textCursor().position(), {},
                             [this](const QJsonValue &result) {
                               const QJsonValue range = result[u"range"];
                               if (range.isObject())
                                 goTo(offsetAt(text(), range[u"start"]));
                             });
}

void CodeEditor::renameName() {
  const QString old = wordAtCursor();
  if (old.isEmpty())
    return;
  bool ok = false;
  const QString name = QInputDialog::getText(this, tr("Rename"), tr("New name of %1:").arg(old),
                                             QLineEdit::Normal, old, &ok);
  if (!ok || name == old)
    return;
  m_bench.language().request(
      QStringLiteral("textDocument/rename"), textCursor().position(), {{"newName", name}},
      [this, old, name](const QJsonValue &result) {
        const QJsonObject changes = result[u"changes"].toObject();
        if (changes.isEmpty()) {
          Q_EMIT m_bench.notice(
              tr("%1 cannot become %2: the name is reserved or taken").arg(old, name));
          return;
        }
        applyEdits(changes.begin().value().toArray(), tr("rename %1").arg(old));
      });
}

/// Applies the protocol's TextEdit[]. All refer to the present text, so that the last one is
/// applied first.
void CodeEditor::applyEdits(const QJsonArray &edits, const QString &name) {
  QList<Edit> all;
  for (const QJsonValue each : edits) {
    const qsizetype begin = offsetAt(text(), each[u"range"][u"start"]);
    const qsizetype end = offsetAt(text(), each[u"range"][u"end"]);
    all.append({begin, text().mid(begin, end - begin), each[u"newText"].toString()});
  }
  std::sort(all.begin(), all.end(), [](const Edit &a, const Edit &b) { return a.at > b.at; });
  if (!all.isEmpty())
    m_bench.document().apply(all, name);
}

void CodeEditor::fixHere() {
  const LineColumn place = placeOf(text(), textCursor().position());
  const QJsonObject here{{"line", place.line - 1}, {"character", 0}};
  const QJsonObject end{{"line", place.line}, {"character", 0}};
  m_bench.language().request(QStringLiteral("textDocument/codeAction"), -1,
                             {{"range", QJsonObject{{"start", here}, {"end", end}}},
                              {"context", QJsonObject{{"diagnostics", QJsonArray()}}}},
                             [this](const QJsonValue &result) {
                               const QJsonValue action = result[0];
                               const QJsonObject changes = action[u"edit"][u"changes"].toObject();
                               if (changes.isEmpty())
                                 Q_EMIT m_bench.notice(tr("no fix is known for this line"));
                               else
                                 applyEdits(changes.begin().value().toArray(),
                                            action[u"title"].toString());
                             });
}

void CodeEditor::hover(QHelpEvent *event) {
  const QPoint inViewport = viewport()->mapFromGlobal(event->globalPos());
  const int at = cursorForPosition(inViewport).position();
  const QPoint global = event->globalPos();
  QString problems;
  for (const Problem &problem : m_bench.problems())
    if (problem.file.isEmpty() && problem.begin <= at && at <= problem.end)
      problems += QStringLiteral("**%1**\n\n%2\n\n").arg(problem.message, problem.hint);
  m_bench.language().request(QStringLiteral("textDocument/hover"), at, {},
                             [this, global, problems](const QJsonValue &result) {
                               const QString text =
                                   problems + result[u"contents"][u"value"].toString();
                               if (!text.trimmed().isEmpty())
                                 QToolTip::showText(global, richText(text), this);
                             });
}

} // namespace arbiter::builder
