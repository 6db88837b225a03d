#pragma once
#include <QWidget>

#include "builder/model/workbench.h"
#include "builder/view/panels/table.h"

class QLabel;

namespace arbiter::builder {

/// The trace of a pixel: a row an instruction, with what it read and wrote as numbers and colour;
/// beside it the registers after the row. F10 and Shift+F10 step, F7 finds the next NaN.
class DebugPanel : public QWidget {
public:
  explicit DebugPanel(Workbench &bench);
  /// The trace is of this pixel of an application; nothing: of one of the document's.
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
