#pragma once
#include <QScrollArea>

#include "builder/model/workbench.h"

class QVBoxLayout;

namespace arbiter::builder {

/// A slider a component of each `#@` parameter, with its number, its range and its animation; a
/// colour is picked. What is dragged is drawn at once and written when it is let go.
class ParametersPanel : public QScrollArea {
public:
  explicit ParametersPanel(Workbench &bench);

private:
  struct Shape {
    QString label;
    QList<int> components;
    double low = 0, high = 1;
    bool colour = false;
    QString animation;
    bool operator==(const Shape &) const = default;
  };
  void read();
  void build();
  void showValues();
  void addLine(int line, QVBoxLayout *layout);
  QWidget *sliderRow(int line, int component);
  QWidget *head(int line);
  [[nodiscard]] QList<Shape> shapes() const;

  Workbench &m_bench;
  QList<Shape> m_shapes;
  QList<std::function<void()>> m_refresh; ///< a widget's value, from the model
};

} // namespace arbiter::builder
