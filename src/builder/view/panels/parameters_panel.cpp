#include "builder/view/panels/parameters_panel.h"

#include <QBoxLayout>
#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

namespace arbiter::builder {

namespace {

/// Steps of a slider from its low end to its high one.
constexpr int kSteps = 1000;
constexpr double kWide = 1e6; ///< numbers may leave the slider's range

int stepOf(double value, const ParameterLine &line) {
  const double part = (value - line.low) / (line.high - line.low);
  return int(std::lround(std::clamp(part, 0.0, 1.0) * kSteps));
}

/// Rounded to what a step can tell apart, so that the text gets a short number.
double valueOf(int step, const ParameterLine &line) {
  const double value = line.low + (line.high - line.low) * step / kSteps;
  const double digit = std::pow(10.0, std::floor(std::log10((line.high - line.low) / kSteps)));
  return std::round(value / digit) * digit;
}

QColor colourOf(const Parameters &parameters, int line) {
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
  build();
}

QList<ParametersPanel::Shape> ParametersPanel::shapes() const {
  QList<Shape> all;
  for (const ParameterLine &line : m_bench.parameters().lines()) {
    Shape shape{line.label, {}, line.low, line.high, line.colour, line.animation};
    for (const Component &component : line.components)
      shape.components << (component.at >= 0 ? component.index : -1);
    all << shape;
  }
  return all;
}

/// Widgets stay where only numbers changed: one that is used keeps the focus.
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

void ParametersPanel::build() {
  m_shapes = shapes();
  m_refresh.clear();
  auto *inside = new QWidget;
  auto *layout = new QVBoxLayout(inside);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->setSpacing(2);
  const int count = int(m_bench.parameters().lines().size());
  for (int line = 0; line < count; ++line)
    addLine(line, layout);
  if (count == 0) {
    auto *hint = new QLabel(tr("No parameters yet. A line such as\n\n"
                               "#@ local[0].x \"amount\" = 0.5 in 0..1\n\n"
                               "in the text makes a slider here."));
    hint->setTextInteractionFlags(Qt::TextSelectableByMouse);
    hint->setWordWrap(true);
    layout->addWidget(hint);
  }
  layout->addStretch();
  setWidget(inside);
}

QWidget *ParametersPanel::head(int line) {
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
  if (!parameter.animation.isEmpty())
    layout->addWidget(new QLabel(parameter.animation));
  layout->addStretch();
  if (parameter.colour) {
    auto *button = new QPushButton(tr("Colour..."));
    button->setAccessibleName(tr("Colour of %1").arg(parameter.label));
    const auto paint = [this, button, line] {
      QPixmap swatch(24, 12);
      swatch.fill(colourOf(m_bench.parameters(), line));
      button->setIcon(swatch);
    };
    paint();
    m_refresh << paint;
    connect(button, &QPushButton::clicked, this, [this, line, button] {
      const QColor picked = QColorDialog::getColor(colourOf(m_bench.parameters(), line), button);
      if (picked.isValid())
        m_bench.parameters().set(line, {picked.redF(), picked.greenF(), picked.blueF()});
    });
    layout->addWidget(button);
  }
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
  slider->setToolTip(tr("%1 to %2").arg(parameter.low).arg(parameter.high));
  auto *number = new QDoubleSpinBox;
  number->setRange(-kWide, kWide);
  number->setDecimals(4);
  number->setSingleStep((parameter.high - parameter.low) / 100);
  number->setKeyboardTracking(false);
  number->setAccessibleName(tr("%1.%2 as a number").arg(parameter.label, letter));
  layout->addWidget(slider, 1);
  layout->addWidget(number);
  const auto show = [this, slider, number, line, component] {
    const Parameters &all = m_bench.parameters();
    const QSignalBlocker a(slider), b(number);
    slider->setValue(stepOf(all.value(line, component), all.lines()[line]));
    number->setValue(all.value(line, component));
  };
  show();
  m_refresh << show;
  connect(slider, &QSlider::valueChanged, this, [this, slider, number, line, component](int step) {
    Parameters &all = m_bench.parameters();
    all.drag(line, component, valueOf(step, all.lines()[line]));
    const QSignalBlocker block(number);
    number->setValue(all.value(line, component));
    if (!slider->isSliderDown()) // by keys or the wheel: a step each
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
  layout->addWidget(head(line));
  const ParameterLine &parameter = m_bench.parameters().lines()[line];
  if (parameter.fixed) {
    layout->addWidget(new QLabel(tr("made by its word in line %1").arg(parameter.line)));
    return;
  }
  for (int component = 0; component < parameter.components.size(); ++component)
    layout->addWidget(sliderRow(line, component));
}

} // namespace arbiter::builder
