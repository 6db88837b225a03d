#pragma once
#include <QTimer>
#include <QWidget>

#include "builder/model/workbench.h"

class QLabel;
class QStatusBar;

namespace arbiter::builder {

/// The line at the bottom: how the picture stands to the text, and beside it what has just happened
/// (a notice, for some seconds), which never takes the first one's place; then what is drawn with,
/// and where the cursor is. Texts that are too long end in dots, and are whole in their tool tips.
class StatusLine : public QObject {
public:
  StatusLine(QStatusBar &bar, Workbench &bench);

  /// How the picture stands, as the workbench has it now.
  void showState();
  void notice(const QString &text);
  [[nodiscard]] QString lastNotice() const { return m_lastNotice; }
  void setPlace(int line, int column);

private:
  Workbench &m_bench;
  QLabel *m_state, *m_notice, *m_place, *m_choice;
  QTimer m_fade;
  QString m_lastNotice;
};

} // namespace arbiter::builder
