#pragma once
#include <QPlainTextEdit>
#include <QWidget>

#include "builder/model/attach/attachment.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace arbiter::builder {

class Highlighter;

/// The text of an application's program: what is typed is drawn with at once, if it is right; what
/// is wrong is underlined, and the last right text is drawn on.
class AttachedText : public QWidget {
public:
  explicit AttachedText(Attachment &attachment);

  [[nodiscard]] QPlainTextEdit &editor() { return *m_editor; }
  /// Marks the line that the debugger is at, from 1; 0: none.
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
