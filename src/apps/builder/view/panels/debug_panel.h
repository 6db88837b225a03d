#pragma once
#include <QWidget>

#include "apps/builder/model/workbench.h"
#include "apps/builder/view/panels/table.h"

class QLabel;

namespace arbiter::builder {

/// Shows the trace of a pixel: a row for each instruction, with its inputs and outputs as numbers
/// and color, and the registers after the row. F10 and Shift+F10 step, F7 finds the next NaN.
class DebugPanel : public QWidget {
public:
  explicit DebugPanel(Workbench &bench);
  /// Sets the application's pixel that the trace is of; nothing: it is a pixel of the document.
  void setApplicationPixel(std::optional<QPoint> pixel) {
    if (m_applicationPixel == pixel)
      return;
    m_applicationPixel = pixel;
    fill();
  }

private:
  void fill();
  void showRow(int row);
  void fillRegisters();

  Workbench &m_bench;
  std::optional<QPoint> m_applicationPixel;
  QLabel *m_verdict;
  Table *m_rows;
  Table *m_registers;
};

} // namespace arbiter::builder
