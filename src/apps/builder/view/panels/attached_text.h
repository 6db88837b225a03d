#pragma once
#include <QPlainTextEdit>
#include <QWidget>

#include "apps/builder/model/attach/attachment.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace arbiter::builder {

class Highlighter;

/// Edits the text of an application's program. A valid text is drawn with at once. Errors are
/// underlined, and the last valid text stays in use.
class AttachedText : public QWidget {
public:
  explicit AttachedText(Attachment &attachment);

  [[nodiscard]] QPlainTextEdit &editor() { return *m_editor; }
  /// Marks the debugger's line, from 1; 0: none.
  void setTracedLine(int line);

private:
  void take(const QString &text);
  void edited();
  void showVerdict();
  void showMarks();

  Attachment &m_attachment;
  QPlainTextEdit *m_editor;
  QListWidget *m_problems;
  QLabel *m_state;
  QPushButton *m_putBack;
  QString m_sent;
  int m_tracedLine = 0;
};

} // namespace arbiter::builder
