#include "apps/builder/view/panels/parameters_panel.h"

#include <QBoxLayout>
#include <QColorDialog>
#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <cmath>

#include "apps/builder/view/panels/flow_row.h"
#include "apps/builder/view/panels/number_box.h"

namespace arbiter::builder {

namespace {

/// The number of steps of a slider.
constexpr int kSteps = 1000;
constexpr double kWide = 1e6; ///< numbers may exceed the slider's range

int stepOf(double value, const ParameterLine &line) {
  const double part = (value - line.low) / (line.high - line.low);
  return int(std::lround(std::clamp(part, 0.0, 1.0) * kSteps));
}

/// Returns the value of a step, rounded so that the text gets a short number.
double valueOf(int step, const ParameterLine &line) {
  const double value = line.low + (line.high - line.low) * step / kSteps;
  const double digit = std::pow(10.0, std::floor(std::log10((line.high - line.low) / kSteps)));
  return std::round(value / digit) * digit;
}

QColor colorOf(const Parameters &parameters, int line) {
  std::array<float, 3> rgb = {};
  for (int c = 0; c < 3; ++c)
    rgb[std::size_t(c)] = float(std::clamp(parameters.value(line, c), 0.0, 1.0));
  return QColor::fromRgbF(rgb[0], rgb[1], rgb[2]);
}

} // namespace

ParametersPanel::ParametersPanel(Workbench &bench) : m_bench(bench) {
  setWidgetResizable(true);
  setFrameShape(NoFrame);
  setAccessibleName(tr("Parameters"));
  connect(&bench.parameters(), &Parameters::linesChanged, this, [this] { read(); });
  connect(&bench, &Workbench::pictureChanged, this, [this] { followTime(); });
  build();
}

QList<ParametersPanel::Shape> ParametersPanel::shapes() const {
  QList<Shape> all;
  for (const ParameterLine &line : m_bench.parameters().lines()) {
    Shape shape{line.label, {}, line.color, line.fixed};
    for (const Component &component : line.components)
      shape.components << (component.at >= 0 ? component.index : -1);
    all << shape;
  }
  return all;
}

/// Updates the panel. If only numbers changed, the widgets stay, so that the focus stays too.
void ParametersPanel::read() {
  if (shapes() == m_shapes)
    showValues();
  else
    build();
}

void ParametersPanel::showValues() {
  for (const auto &refresh : m_refresh)
    refresh();
}

/// Moves the sliders of animated parameters. The number stays, as it is the text's start value.
void ParametersPanel::followTime() {
  if (!isVisible())
    return;
  for (const auto &follow : m_follow)
    follow();
}

void ParametersPanel::build() {
  m_shapes = shapes();
  m_refresh.clear();
  m_follow.clear();
  auto *inside = new QWidget;
  auto *layout = new QVBoxLayout(inside);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->setSpacing(2);
  const int count = int(m_bench.parameters().lines().size());
  for (int line = 0; line < count; ++line)
    addLine(line, layout);
  auto *more = new QPushButton(tr("&Add a parameter"));
  more->setObjectName(QStringLiteral("add-parameter"));
  connect(more, &QPushButton::clicked, this, [this] { m_bench.parameters().add(); });
  if (count == 0) {
    auto *hint = new QLabel(tr("No parameters yet. A line such as\n\n"
                               "#@ local[0].x \"amount\" = 0.5 in 0..1\n\n"
                               "in the text makes a slider here."));
    hint->setTextInteractionFlags(Qt::TextSelectableByMouse);
    hint->setWordWrap(true);
    layout->addWidget(hint);
  }
  layout->addSpacing(4);
  layout->addWidget(more, 0, Qt::AlignLeft);
  layout->addStretch();
  if (QWidget *old = takeWidget())
    old->deleteLater(); // one of its signals may have led here
  setWidget(inside);
  showValues();
}

QWidget *ParametersPanel::head(int line, QWidget *settings) {
  const ParameterLine &parameter = m_bench.parameters().lines()[line];
  auto *row = new QWidget;
  auto *layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 4, 0, 0);
  auto *label = new QLabel(parameter.label);
  QFont bold = label->font();
  bold.setBold(true);
  label->setFont(bold);
  layout->addWidget(label);
  auto *where = new QLabel(QStringLiteral("%1[%2]").arg(parameter.space).arg(parameter.index));
  where->setForegroundRole(QPalette::PlaceholderText);
  layout->addWidget(where);
  auto *animation = new QLabel;
  layout->addWidget(animation);
  m_refresh <<
      [this, animation, line] { animation->setText(m_bench.parameters().lines()[line].animation); };
  layout->addStretch();
  if (parameter.color)
    addColor(line, layout);
  if (settings) {
    auto *open = new QToolButton;
    open->setText(tr("Range..."));
    open->setAutoRaise(true);
    open->setCheckable(true);
    open->setFocusPolicy(Qt::StrongFocus);
    open->setToolTip(tr("Range and animation"));
    open->setAccessibleName(tr("Range and animation of %1").arg(parameter.label));
    open->setObjectName(QStringLiteral("settings-%1").arg(line));
    const QString key = parameter.label;
    connect(open, &QToolButton::toggled, this, [this, settings, key](bool on) {
      settings->setVisible(on);
      if (on)
        m_opened.insert(key);
      else
        m_opened.remove(key);
    });
    settings->setVisible(false);
    open->setChecked(m_opened.contains(key));
    layout->addWidget(open);
  }
  return row;
}

void ParametersPanel::addColor(int line, QBoxLayout *layout) {
  auto *button = new QPushButton(tr("Colour..."));
  button->setAccessibleName(tr("Colour of %1").arg(m_bench.parameters().lines()[line].label));
  m_refresh << [this, button, line] {
    QPixmap swatch(24, 12);
    swatch.fill(colorOf(m_bench.parameters(), line));
    button->setIcon(swatch);
  };
  connect(button, &QPushButton::clicked, this, [this, line, button] {
    const QColor picked = QColorDialog::getColor(colorOf(m_bench.parameters(), line), button);
    if (picked.isValid())
      m_bench.parameters().set(line, {picked.redF(), picked.greenF(), picked.blueF()});
  });
  layout->addWidget(button);
}

/// Makes the widgets for range and animation; each change is an edit of the line.
QWidget *ParametersPanel::settingsRow(int line) {
  const QString label = m_bench.parameters().lines()[line].label;
  auto *row = new FlowRow;
  auto *low = new NumberBox(-kWide, kWide, tr("Low end of %1").arg(label));
  auto *high = new NumberBox(-kWide, kWide, tr("High end of %1").arg(label));
  auto *motion = new QComboBox;
  auto *period = new NumberBox(0.001, 86400, tr("Period of %1 in seconds").arg(label));
  low->setObjectName(QStringLiteral("low-%1").arg(line));
  high->setObjectName(QStringLiteral("high-%1").arg(line));
  motion->setObjectName(QStringLiteral("motion-%1").arg(line));
  period->setObjectName(QStringLiteral("period-%1").arg(line));
  motion->setAccessibleName(tr("Animation of %1").arg(label));
  motion->addItem(tr("still"));
  motion->addItems(m_bench.parameters().motionsOf(line));
  row->add({new QLabel(tr("from")), low, new QLabel(tr("to")), high});
  row->add({motion, new QLabel(tr("in")), period, new QLabel(tr("s"))});
  m_refresh << [this, line, low, high, motion, period] {
    const ParameterLine &now = m_bench.parameters().lines()[line];
    const QSignalBlocker a(low), b(high), c(period);
    low->setValue(now.low);
    high->setValue(now.high);
    motion->setCurrentIndex(std::max(0, motion->findText(now.motion)));
    period->setValue(now.period);
    period->setEnabled(!now.motion.isEmpty());
  };
  const auto range = [this, line, low, high] {
    if (low->value() < high->value())
      m_bench.parameters().setRange(line, low->value(), high->value());
    else
      showValues(); // restores the valid range
  };
  connect(low, &QDoubleSpinBox::valueChanged, this, range);
  connect(high, &QDoubleSpinBox::valueChanged, this, range);
  const auto move = [this, line, motion, period] {
    m_bench.parameters().setMotion(
        line, motion->currentIndex() == 0 ? QString() : motion->currentText(), period->value());
  };
  connect(motion, &QComboBox::activated, this, move);
  connect(period, &QDoubleSpinBox::valueChanged, this, move);
  return row;
}

QWidget *ParametersPanel::sliderRow(int line, int component) {
  Parameters &parameters = m_bench.parameters();
  const ParameterLine parameter = parameters.lines()[line];
  const QString letter = QStringLiteral("xyzw").mid(parameter.components[component].index, 1);
  auto *row = new QWidget;
  auto *layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(new QLabel(letter));
  auto *slider = new QSlider(Qt::Horizontal);
  slider->setRange(0, kSteps);
  slider->setPageStep(kSteps / 20);
  slider->setAccessibleName(QStringLiteral("%1.%2").arg(parameter.label, letter));
  slider->setObjectName(QStringLiteral("slider-%1-%2").arg(line).arg(component));
  slider->installEventFilter(this);
  auto *number = new NumberBox(-kWide, kWide, tr("%1.%2 as a number").arg(parameter.label, letter));
  number->setObjectName(QStringLiteral("number-%1-%2").arg(line).arg(component));
  layout->addWidget(slider, 1);
  layout->addWidget(number);
  const auto place = [this, slider, line, component] {
    const Parameters &all = m_bench.parameters();
    const ParameterLine &now = all.lines()[line];
    const QSignalBlocker block(slider);
    slider->setValue(stepOf(all.valueAt(line, component, m_bench.frame().time), now));
  };
  m_follow << [this, slider, line, place] {
    if (!m_bench.parameters().lines()[line].animation.isEmpty() && !slider->isSliderDown())
      place();
  };
  m_refresh << [this, slider, number, line, component, place] {
    const Parameters &all = m_bench.parameters();
    const ParameterLine &now = all.lines()[line];
    const QSignalBlocker block(number);
    slider->setToolTip(tr("%1 to %2").arg(now.low).arg(now.high));
    place();
    number->setValue(all.value(line, component));
  };
  connect(slider, &QSlider::valueChanged, this, [this, slider, number, line, component](int step) {
    Parameters &all = m_bench.parameters();
    all.drag(line, component, valueOf(step, all.lines()[line]));
    const QSignalBlocker block(number);
    number->setValue(all.value(line, component));
    if (!slider->isSliderDown()) // keys and the wheel make a step each
      all.release();
  });
  connect(slider, &QSlider::sliderReleased, this, [this] { m_bench.parameters().release(); });
  connect(number, &QDoubleSpinBox::valueChanged, this, [this, line, component](double value) {
    m_bench.parameters().drag(line, component, value);
    m_bench.parameters().release();
  });
  const bool written = parameter.components[component].at >= 0;
  slider->setEnabled(written);
  number->setEnabled(written);
  return row;
}

void ParametersPanel::addLine(int line, QVBoxLayout *layout) {
  const ParameterLine &parameter = m_bench.parameters().lines()[line];
  QWidget *settings = parameter.fixed ? nullptr : settingsRow(line);
  layout->addWidget(head(line, settings));
  if (parameter.fixed) {
    layout->addWidget(new QLabel(tr("made by its word in line %1").arg(parameter.line)));
    return;
  }
  for (int component = 0; component < parameter.components.size(); ++component)
    layout->addWidget(sliderRow(line, component));
  layout->addWidget(settings);
}

/// Ignores the wheel on a slider without the focus, so that scrolling the panel does not move it.
bool ParametersPanel::eventFilter(QObject *watched, QEvent *event) {
  if (event->type() != QEvent::Wheel || static_cast<QWidget *>(watched)->hasFocus())
    return QScrollArea::eventFilter(watched, event);
  event->ignore();
  return true;
}

} // namespace arbiter::builder
