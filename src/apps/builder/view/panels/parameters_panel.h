#pragma once
#include <QScrollArea>
#include <QSet>
#include <functional>

#include "apps/builder/model/workbench.h"

class QBoxLayout;
class QVBoxLayout;

namespace arbiter::builder {

/// Shows a slider and a number for each component of each `#@` parameter, or a color picker. A row
/// below has its range and animation. A dragged value is drawn at once, and written when it is
/// released.
class ParametersPanel : public QScrollArea {
public:
  explicit ParametersPanel(Workbench &bench);

protected:
  bool eventFilter(QObject *watched, QEvent *event) override;

private:
  struct Shape {
    QString label;
    QList<int> components;
    bool color = false, fixed = false;
    bool operator==(const Shape &) const = default;
  };
  void read();
  void build();
  void showValues();
  void followTime();
  void addLine(int line, QVBoxLayout *layout);
  QWidget *sliderRow(int line, int component);
  QWidget *head(int line, QWidget *settings);
  QWidget *settingsRow(int line);
  void addColor(int line, QBoxLayout *layout);
  [[nodiscard]] QList<Shape> shapes() const;

  Workbench &m_bench;
  QList<Shape> m_shapes;
  QList<std::function<void()>> m_refresh; ///< update a widget's value from the model
  QList<std::function<void()>> m_follow;  ///< move a slider to the animated value
  QSet<QString> m_opened;                 ///< labels of parameters whose settings are open
};

} // namespace arbiter::builder
