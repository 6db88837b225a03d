#pragma once
#include <QPlainTextEdit>

#include "apps/builder/model/workbench.h"

class QHelpEvent;

namespace arbiter::builder {

class Completer;
class Gutter;
class Highlighter;

/// Displays the workbench's document and sends it what is typed. The document provides undo.
/// Changes by others appear in place, and never move the cursor or the focus.
class CodeEditor : public QPlainTextEdit {
  Q_OBJECT
public:
  explicit CodeEditor(Workbench &bench, QWidget *parent = nullptr);

  [[nodiscard]] const QString &text() const { return m_bench.document().text(); }
  [[nodiscard]] Workbench &bench() { return m_bench; }

  void complete();
  void goToDefinition();
  void renameName();
  void goTo(qsizetype offset);
  void goToProblem(bool forward);
  /// Applies the server's first fix for the problem at the cursor.
  void fixHere();
  void undoStep();
  void redoStep();
  /// Returns the word at the cursor, "" if there is none.
  [[nodiscard]] QString wordAtCursor() const;
  /// Marks the debugger's line, from 1; 0: none.
  void setTracedLine(int line);
  void refreshColors();

  [[nodiscard]] int gutterWidth() const;

Q_SIGNALS:
  void placeChanged(int line, int column);
  void lineClicked(int line);

protected:
  void keyPressEvent(QKeyEvent *event) override;
  void resizeEvent(QResizeEvent *event) override;
  bool event(QEvent *event) override;
  void focusOutEvent(QFocusEvent *event) override;
  void insertFromMimeData(const QMimeData *source) override;

private:
  void contentsChange();
  void documentEdited(const Edit &edit, Origin origin);
  void showMarks();
  void hover(QHelpEvent *event);
  void afterKey(const QString &typed);
  void indentLine();
  void applyEdits(const QJsonArray &edits, const QString &name);
  [[nodiscard]] qsizetype wordBegin() const;

  Workbench &m_bench;
  Highlighter *m_highlighter;
  Gutter *m_gutter;
  Completer *m_completer;
  bool m_applying = false; ///< an edit comes from the document
  int m_tracedLine = 0;
  friend class Gutter;
};

} // namespace arbiter::builder
