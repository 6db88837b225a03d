#include "apps/builder/view/panels/compare_panel.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSlider>

#include "apps/builder/view/picture/picture_view.h"

namespace arbiter::builder {

ComparePanel::ComparePanel(Workbench &bench, PictureView &picture)
    : m_bench(bench), m_picture(picture) {
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  auto *row = new QHBoxLayout;
  m_with = new QComboBox;
  m_with->setAccessibleName(tr("What A is"));
  m_with->addItems({tr("A: nothing"), tr("A: the picture as it is now"),
                    tr("A: with fp24 arithmetic"), tr("A: by the host's shaders"),
                    tr("A: by the rasterizer"), tr("A: by the host alone, without the layer")});
  auto *difference = new QCheckBox(tr("&Difference, eight times as bright"));
  auto *split = new QSlider(Qt::Horizontal);
  split->setRange(0, 1000);
  split->setValue(500);
  split->setAccessibleName(tr("Split between A and B"));
  row->addWidget(m_with);
  row->addWidget(split, 1);
  row->addWidget(difference);
  m_figures = new QLabel;
  m_figures->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_figures->setWordWrap(true);
  layout->addLayout(row);
  layout->addWidget(m_figures);
  layout->addStretch();
  connect(m_with, &QComboBox::activated, this, [this](int index) { choose(index); });
  connect(difference, &QCheckBox::toggled, &picture, &PictureView::setDifference);
  connect(split, &QSlider::valueChanged, this,
          [this](int value) { m_picture.setSplit(value / 1000.0); });
  connect(&picture, &PictureView::splitChanged, this, [split](double value) {
    const QSignalBlocker block(split);
    split->setValue(int(value * 1000));
  });
  connect(&bench, &Workbench::pinnedChanged, this, [this] {
    m_picture.setOther(m_bench.pinned());
    showFigures();
  });
  connect(&bench, &Workbench::pictureChanged, this, [this] { showFigures(); });
  showFigures();
}

void ComparePanel::choose(int index) {
  RenderOptions options = m_bench.renderer().options();
  switch (index) {
  case 0:
    return m_bench.unpin();
  case 1:
    return m_bench.pin();
  case 2:
    options.numerics = QStringLiteral("fp24");
    break;
  case 3:
    options.backend = QStringLiteral("host");
    break;
  case 4:
    options.backend = QStringLiteral("swrast");
    break;
  default:
    options = {};
    options.bare = true;
  }
  m_bench.compareWith(options);
}

void ComparePanel::showFigures() {
  if (!m_bench.isPinned()) {
    m_figures->setText(
        tr("Choose what the picture is compared with. Shift and the left button move "
           "the split; Ctrl+B, held, shows A alone."));
    return;
  }
  const Comparison figures = compare(m_bench.pinned(), m_bench.picture());
  if (!figures.comparable)
    m_figures->setText(tr("A and B have different sizes"));
  else if (figures.equal())
    m_figures->setText(tr("A (%1) and B are equal in every pixel").arg(m_bench.pinnedName()));
  else
    m_figures->setText(
        tr("A (%1) and B differ in %2 of %3 pixels, at most by %4/255, at pixel %5, %6")
            .arg(m_bench.pinnedName())
            .arg(figures.pixels)
            .arg(qint64(m_bench.picture().width()) * m_bench.picture().height())
            .arg(figures.worst)
            .arg(figures.worstAt.x())
            .arg(m_bench.picture().height() - 1 - figures.worstAt.y()));
}

} // namespace arbiter::builder
