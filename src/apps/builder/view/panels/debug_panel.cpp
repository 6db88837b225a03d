#include "apps/builder/view/panels/debug_panel.h"

#include <QBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSplitter>

#include "apps/builder/view/theme.h"

namespace arbiter::builder {

namespace {

enum Column { kLine, kText, kReads, kWrites, kSecond, kError, kColor, kFlags, kColumns };

QIcon swatch(const TraceValue &value) {
  QPixmap pixmap(28, 12);
  pixmap.fill(value.color());
  return pixmap;
}

QString readsText(const TraceRow &row) {
  QStringList parts;
  for (const TraceOperand &operand : row.operands)
    parts << QStringLiteral("%1 = (%2)").arg(operand.text, operand.value.text());
  if (row.unit >= 0)
    parts << QObject::tr("texel of unit %1 = (%2)").arg(row.unit).arg(row.texel.text());
  return parts.join(QStringLiteral("; "));
}

} // namespace

DebugPanel::DebugPanel(Workbench &bench) : m_bench(bench) {
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  m_verdict = new QLabel(tr("Click a pixel of the picture, or press Ctrl+D, to see how its colour "
                            "comes about."));
  m_verdict->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_verdict->setWordWrap(true);
  m_rows = new Table({tr("Line"), tr("Instruction"), tr("Reads"), tr("Writes"), tr("fp24"),
                      tr("Error"), tr("Colour"), tr("Marks")});
  m_rows->setAccessibleName(tr("Trace"));
  m_registers = new Table({tr("Register"), tr("Value"), tr("Colour")});
  m_registers->setAccessibleName(tr("Registers"));
  for (Table *table : {m_rows, m_registers}) {
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setMaximumSectionSize(300); // the tool tip has the rest
    table->setIconSize({28, 12});
  }
  m_registers->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  auto *split = new QSplitter;
  split->addWidget(m_rows);
  split->addWidget(m_registers);
  split->setStretchFactor(0, 3);
  split->setStretchFactor(1, 1);
  split->setSizes({800, 300});
  layout->addWidget(m_verdict);
  layout->addWidget(split, 1);
  Trace &trace = bench.trace();
  connect(&trace, &Trace::changed, this, [this] { fill(); });
  connect(&trace, &Trace::moved, this, [this](int row) { showRow(row); });
  connect(m_rows, &QTableWidget::currentCellChanged, this,
          [this](int row) { m_bench.trace().moveTo(row); });
  connect(m_rows, &QTableWidget::cellActivated, this, [this](int row) {
    if (!m_applicationPixel)
      m_bench.watchRow(row);
  });
  m_rows->setToolTip(tr("Return shows the register that a row wrote over the whole picture, as A"));
  connect(&bench, &Workbench::traceFailed, this,
          [this](const QString &why) { m_verdict->setText(why); });
}

void DebugPanel::fill() {
  const Trace &trace = m_bench.trace();
  const QSignalBlocker block(m_rows);
  m_rows->horizontalHeaderItem(kWrites)->setText(
      trace.numerics().isEmpty() ? tr("Writes") : tr("Writes (%1)").arg(trace.numerics()));
  if (!trace.secondNumerics().isEmpty())
    m_rows->horizontalHeaderItem(kSecond)->setText(trace.secondNumerics());
  QString head;
  if (const auto pixel = m_applicationPixel ? m_applicationPixel : m_bench.debuggedPixel())
    head = tr("Pixel %1, %2: ").arg(pixel->x()).arg(pixel->y());
  m_verdict->setText(head + (trace.isDiscarded() ? tr("discarded by KIL. ") : QString()) +
                     trace.verdict());
  m_rows->setRowCount(int(trace.rows().size()));
  for (int i = 0; i < trace.rows().size(); ++i) {
    const TraceRow &row = trace.rows()[i];
    m_rows->put(i, kLine, QString::number(row.line));
    m_rows->put(i, kText, row.text);
    m_rows->put(i, kReads, readsText(row))->setToolTip(readsText(row));
    const QString written =
        row.destination.isEmpty()
            ? QString()
            : QStringLiteral("%1 = (%2)").arg(row.destination, row.value.text(row.mask));
    m_rows->put(i, kWrites, written);
    m_rows->put(i, kSecond, row.second.text(row.mask));
    m_rows->put(i, kError, row.error > 0 ? QString::number(row.error, 'g', 3) : QString());
    auto *color = m_rows->put(i, kColor, {});
    if (row.value.known)
      color->setIcon(swatch(row.value));
    auto *flags = m_rows->put(i, kFlags, row.flags.join(u' '));
    flags->setForeground(colors().error);
  }
  showRow(trace.current());
}

void DebugPanel::showRow(int row) {
  const QSignalBlocker block(m_rows);
  if (row >= 0 && row < m_rows->rowCount()) {
    m_rows->setCurrentCell(row, kText);
    m_rows->scrollToItem(m_rows->item(row, kLine));
  }
  fillRegisters();
}

void DebugPanel::fillRegisters() {
  const Trace &trace = m_bench.trace();
  const auto registers = trace.registers();
  const auto &inputs = trace.inputs();
  m_registers->setRowCount(int(registers.size() + inputs.size()));
  int at = 0;
  for (const auto *all : {&registers, &inputs})
    for (const auto &[name, value] : *all) {
      m_registers->put(at, 0, name);
      m_registers->put(at, 1, value.text());
      m_registers->put(at, 2, {})->setIcon(swatch(value));
      ++at;
    }
}

} // namespace arbiter::builder
