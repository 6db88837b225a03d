#include "apps/builder/view/panels/attached_values.h"

#include <QBoxLayout>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalBlocker>

#include "apps/builder/view/panels/table.h"

namespace arbiter::builder {

namespace {

constexpr int kFirstComponent = 1, kState = 5;
constexpr double kMax = 1e9;

/// Edits a program's number, of any magnitude, in steps that fit it.
class Number : public QDoubleSpinBox {
public:
  Number() {
    setRange(-kMax, kMax);
    setDecimals(5);
    setStepType(AdaptiveDecimalStepType);
    setFrame(false);
    setFocusPolicy(Qt::StrongFocus);
  }
  [[nodiscard]] QString textFromValue(double value) const override {
    return locale().toString(value, 'g', 6);
  }
};

} // namespace

AttachedValues::AttachedValues(Attachment &attachment) : m_attachment(attachment) {
  m_table = new Table({tr("Parameter"), QStringLiteral("x"), QStringLiteral("y"),
                       QStringLiteral("z"), QStringLiteral("w"), tr("Whose")});
  m_table->setObjectName(QStringLiteral("attached-values"));
  m_table->setAccessibleName(tr("Parameters of the application's program"));
  m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 12);
  m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  m_letGo = new QPushButton(tr("Let &go"));
  m_letGo->setToolTip(tr("The application's own value again"));
  auto *row = new QHBoxLayout;
  row->addStretch();
  row->addWidget(m_letGo);
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->addWidget(m_table, 1);
  layout->addLayout(row);
  connect(&attachment, &Attachment::parametersChanged, this, [this] { showValues(); });
  connect(&attachment, &Attachment::attachedChanged, this, [this] { showValues(); });
  connect(m_letGo, &QPushButton::clicked, this, [this] {
    const int at = m_table->currentRow();
    if (at >= 0 && at < m_names.size())
      m_attachment.letGo(m_names[at]);
  });
}

void AttachedValues::build() {
  const QList<AttachedParameter> &parameters = m_attachment.parameters();
  m_table->setRowCount(0);
  m_table->setRowCount(int(parameters.size()));
  m_names.clear();
  for (int row = 0; row < parameters.size(); ++row) {
    const AttachedParameter &parameter = parameters[row];
    m_names << parameter.name;
    m_table->put(row, 0, parameter.name)->setToolTip(parameter.name);
    m_table->put(row, kState, {});
    for (int c = 0; c < 4; ++c) {
      if (!parameter.isSettable()) {
        m_table->put(row, kFirstComponent + c, {});
        continue;
      }
      auto *number = new Number;
      number->setObjectName(QStringLiteral("attached-%1-%2").arg(parameter.name).arg(c));
      number->setAccessibleName(
          QStringLiteral("%1.%2").arg(parameter.name).arg(QLatin1Char("xyzw"[c])));
      connect(number, &QDoubleSpinBox::valueChanged, this,
              [this, row, c](double value) { setComponent(row, c, value); });
      m_table->setCellWidget(row, kFirstComponent + c, number);
    }
  }
}

/// Shows the application's values, except for one that is being typed.
void AttachedValues::showValues() {
  const QList<AttachedParameter> &parameters = m_attachment.parameters();
  QStringList names;
  for (const AttachedParameter &parameter : parameters)
    names << parameter.name;
  if (names != m_names)
    build();
  for (int row = 0; row < parameters.size(); ++row) {
    const AttachedParameter &parameter = parameters[row];
    for (int c = 0; c < 4; ++c) {
      const double value = parameter.value[std::size_t(c)];
      if (auto *number =
              qobject_cast<QDoubleSpinBox *>(m_table->cellWidget(row, kFirstComponent + c))) {
        const QSignalBlocker block(number);
        if (!number->hasFocus())
          number->setValue(value);
      } else if (QTableWidgetItem *cell = m_table->item(row, kFirstComponent + c)) {
        cell->setText(QString::number(value, 'g', 6));
      }
    }
    m_table->item(row, kState)
        ->setText(parameter.held           ? tr("held")
                  : parameter.isSettable() ? tr("application")
                                           : parameter.kind);
  }
  m_letGo->setEnabled(m_attachment.isAttached());
}

void AttachedValues::setComponent(int row, int component, double value) {
  const QList<AttachedParameter> &parameters = m_attachment.parameters();
  if (row >= parameters.size() || parameters[row].name != m_names.value(row))
    return;
  std::array<double, 4> values = parameters[row].value;
  for (int c = 0; c < 4; ++c)
    if (const auto *number =
            qobject_cast<QDoubleSpinBox *>(m_table->cellWidget(row, kFirstComponent + c)))
      values[std::size_t(c)] = number->value();
  values[std::size_t(component)] = value;
  m_attachment.setParameter(m_names[row], values);
}

} // namespace arbiter::builder
