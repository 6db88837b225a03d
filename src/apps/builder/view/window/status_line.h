#pragma once
#include <QTimer>
#include <QWidget>

#include "apps/builder/model/workbench.h"

class QLabel;
class QStatusBar;

namespace arbiter::builder {

/// The bottom line: the picture's state, a recent notice for some seconds beside it, the drawing
/// options, and the cursor's place. Long texts end in dots, and are complete in their tool tips.
class StatusLine : public QObject {
public:
  StatusLine(QStatusBar &bar, Workbench &bench);

  /// Shows the picture's present state.
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
