#include "apps/builder/view/panels/flow_row.h"

#include <QHBoxLayout>
#include <QResizeEvent>

namespace arbiter::builder {

namespace {
constexpr int kBetween = 10; ///< between groups
constexpr int kLines = 4;
} // namespace

FlowRow::FlowRow() {
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void FlowRow::add(const QList<QWidget *> &group) {
  auto *box = new QWidget(this);
  auto *layout = new QHBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  for (QWidget *widget : group)
    layout->addWidget(widget);
  m_groups << box;
  updateGeometry();
}

int FlowRow::place(int width, bool move) const {
  int x = 0, y = 0, tallest = 0;
  for (QWidget *group : m_groups) {
    const QSize size = group->sizeHint();
    if (x > 0 && x + size.width() > width) {
      x = 0;
      y += tallest + kLines;
      tallest = 0;
    }
    if (move)
      group->setGeometry(x, y, std::min(size.width(), width), size.height());
    x += size.width() + kBetween;
    tallest = std::max(tallest, size.height());
  }
  return y + tallest;
}

QSize FlowRow::sizeHint() const {
  int width = 0;
  for (const QWidget *group : m_groups)
    width += group->sizeHint().width() + kBetween;
  return {width, place(width, false)};
}

QSize FlowRow::minimumSizeHint() const {
  QSize least(0, 0);
  for (const QWidget *group : m_groups)
    least = least.expandedTo(group->sizeHint());
  return least;
}

void FlowRow::resizeEvent(QResizeEvent *event) { place(event->size().width(), true); }

} // namespace arbiter::builder
