#pragma once
#include <QWidget>

#include "apps/builder/model/workbench.h"

namespace arbiter::builder {

/// Shows a bar for each resource above the text: how much of the card's native limit the program
/// uses. The tool tip has the API's limits and the reasons.
class GaugesBar : public QWidget {
public:
  explicit GaugesBar(Workbench &bench, QWidget *parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;

protected:
  void paintEvent(QPaintEvent *event) override;
  bool event(QEvent *event) override;

private:
  struct Cell {
    QRect box;
    int gauge = 0;
  };
  [[nodiscard]] QList<Cell> cells(int width) const;
  [[nodiscard]] static QString text(const Gauge &gauge);

  Workbench &m_bench;
};

} // namespace arbiter::builder
