#pragma once
#include <QWidget>

namespace arbiter::builder {

/// Lays out groups of small widgets side by side, on as many lines as the width requires.
class FlowRow : public QWidget {
public:
  FlowRow();

  /// Adds widgets that stay side by side.
  void add(const QList<QWidget *> &group);

  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override { return place(width, false); }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

protected:
  void resizeEvent(QResizeEvent *event) override;

private:
  /// Computes the layout; \p move applies it. \returns the height
  int place(int width, bool move) const;

  QList<QWidget *> m_groups;
};

} // namespace arbiter::builder
