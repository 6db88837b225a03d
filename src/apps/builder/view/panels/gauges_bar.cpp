#include "apps/builder/view/panels/gauges_bar.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "apps/builder/view/theme.h"

namespace arbiter::builder {

namespace {

constexpr int kGap = 12, kBar = 34, kMargin = 4;

/// Shortens titles to fit above a text; the tool tip has the whole title.
QString shortTitle(const Gauge &gauge) {
  static const QHash<QString, QString> kShort = {
      {QStringLiteral("instructions"), QStringLiteral("instr")},
      {QStringLiteral("alu_instructions"), QStringLiteral("ALU")},
      {QStringLiteral("tex_instructions"), QStringLiteral("TEX")},
      {QStringLiteral("tex_indirections"), QStringLiteral("nodes")},
      {QStringLiteral("temporaries"), QStringLiteral("temps")},
      {QStringLiteral("parameters"), QStringLiteral("params")},
      {QStringLiteral("attribs"), QStringLiteral("attribs")},
      {QStringLiteral("address_registers"), QStringLiteral("addr")}};
  return kShort.value(gauge.name, gauge.title);
}

QColor colorOf(const Gauge &gauge) {
  if (gauge.over() || gauge.overNative())
    return colors().error;
  return gauge.nativeUsed * 10 >= gauge.nativeLimit * 9 && gauge.nativeUsed > 0 ? colors().amber
                                                                                : colors().good;
}

QString hint(const Gauge &gauge) {
  QString text = QObject::tr("%1: %2 of %3 on the card, %4 of %5 of the API")
                     .arg(gauge.title)
                     .arg(gauge.nativeUsed)
                     .arg(gauge.nativeLimit)
                     .arg(gauge.used)
                     .arg(gauge.limit);
  for (const QString &reason : gauge.reasons)
    text += QStringLiteral("\n") + reason;
  return text;
}

} // namespace

GaugesBar::GaugesBar(Workbench &bench, QWidget *parent) : QWidget(parent), m_bench(bench) {
  setAccessibleName(tr("Gauges"));
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  connect(&bench, &Workbench::reportChanged, this, [this] {
    QStringList all;
    for (const Gauge &gauge : m_bench.report().gauges)
      all << hint(gauge);
    setAccessibleDescription(all.join(u'\n'));
    updateGeometry();
    update();
  });
}

QString GaugesBar::text(const Gauge &gauge) {
  return QStringLiteral("%1 %2/%3")
      .arg(shortTitle(gauge))
      .arg(gauge.nativeUsed)
      .arg(gauge.nativeLimit);
}

/// Lays out the gauges in as many rows as needed.
QList<GaugesBar::Cell> GaugesBar::cells(int width) const {
  QList<Cell> all;
  const int height = fontMetrics().height() + 4;
  int x = kMargin, y = kMargin;
  const auto &gauges = m_bench.report().gauges;
  for (int i = 0; i < gauges.size(); ++i) {
    const int wide = fontMetrics().horizontalAdvance(text(gauges[i])) + 4 + kBar;
    if (x > kMargin && x + wide > width) {
      x = kMargin;
      y += height;
    }
    all.append({{x, y, wide, height}, i});
    x += wide + kGap;
  }
  return all;
}

int GaugesBar::heightForWidth(int width) const {
  const QList<Cell> all = cells(width);
  return (all.isEmpty() ? fontMetrics().height() + 4 + kMargin : all.last().box.bottom() + 1) +
         kMargin;
}

QSize GaugesBar::sizeHint() const { return {400, heightForWidth(std::max(width(), 200))}; }
QSize GaugesBar::minimumSizeHint() const { return {80, heightForWidth(std::max(width(), 200))}; }

void GaugesBar::paintEvent(QPaintEvent *) {
  QPainter painter(this);
  const auto &gauges = m_bench.report().gauges;
  if (gauges.isEmpty()) {
    painter.setPen(colors().dim);
    painter.drawText(rect().adjusted(kMargin, 0, 0, 0), Qt::AlignVCenter,
                     tr("gauges: no program that loads yet"));
    return;
  }
  for (const Cell &cell : cells(width())) {
    const Gauge &gauge = gauges[cell.gauge];
    const QColor color = colorOf(gauge);
    painter.setPen(gauge.over() || gauge.overNative() ? color : palette().color(QPalette::Text));
    painter.drawText(cell.box, Qt::AlignLeft | Qt::AlignVCenter, text(gauge));
    QRect bar(cell.box.right() - kBar + 1, cell.box.center().y() - 3, kBar, 7);
    painter.fillRect(bar, palette().color(QPalette::Button).darker(colors().dark ? 60 : 112));
    const double part =
        gauge.nativeLimit > 0 ? std::min(1.0, double(gauge.nativeUsed) / gauge.nativeLimit) : 0;
    bar.setWidth(int(part * kBar + 0.5));
    painter.fillRect(bar, color);
  }
}

bool GaugesBar::event(QEvent *event) {
  if (event->type() != QEvent::ToolTip)
    return QWidget::event(event);
  auto *help = static_cast<QHelpEvent *>(event);
  for (const Cell &cell : cells(width()))
    if (cell.box.contains(help->pos()))
      QToolTip::showText(help->globalPos(), hint(m_bench.report().gauges[cell.gauge]), this);
  return true;
}

} // namespace arbiter::builder
