#pragma once
#include <QWidget>

namespace arbiter::builder {

/// Groups of small widgets side by side, on as many lines as the width asks for.
class FlowRow : public QWidget {
public:
  FlowRow();

  /// Widgets that stay beside each other.
  void add(const QList<QWidget *> &group);

  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override { return place(width, false); }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

protected:
  void resizeEvent(QResizeEvent *event) override;

private:
  /// \returns the height; \p move puts the groups there
  int place(int width, bool move) const;

  QList<QWidget *> m_groups;
};

} // namespace arbiter::builder
