#include "apps/builder/view/window/status_line.h"

#include <QLabel>
#include <QPainter>
#include <QStatusBar>

#include "apps/builder/view/theme.h"
#include "util/flags.h"

namespace arbiter::builder {

namespace {

constexpr int kNoticeMilliseconds = 8000;

/// A label that shortens text without room by dots.
class Elided : public QLabel {
public:
  explicit Elided(const char *name) {
    setObjectName(QLatin1StringView(name));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setTextFormat(Qt::PlainText);
  }
  [[nodiscard]] QSize minimumSizeHint() const override { return {0, QLabel::sizeHint().height()}; }

protected:
  void paintEvent(QPaintEvent *) override {
    QPainter painter(this);
    painter.setPen(palette().color(foregroundRole()));
    painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(text(), Qt::ElideRight, width()));
  }
};

void say(QLabel &label, const QString &text) {
  label.setText(text);
  label.setToolTip(text);
}

} // namespace

StatusLine::StatusLine(QStatusBar &bar, Workbench &bench) : QObject(&bar), m_bench(bench) {
  m_state = new Elided("status-state");
  m_notice = new Elided("status-notice");
  m_notice->setForegroundRole(QPalette::PlaceholderText);
  m_choice = new QLabel;
  m_place = new QLabel(QStringLiteral("1:1"));
  // QStatusBar::showMessage() would hide the state.
  bar.addWidget(m_state);
  bar.addWidget(m_notice, 1);
  bar.addPermanentWidget(m_choice);
  bar.addPermanentWidget(m_place);
  m_fade.setSingleShot(true);
  m_fade.setInterval(kNoticeMilliseconds);
  connect(&m_fade, &QTimer::timeout, this, [this] { say(*m_notice, {}); });
  showState();
}

void StatusLine::showState() {
  say(*m_state, m_bench.statusText());
  QPalette palette = m_state->parentWidget()->palette();
  const PictureState state = m_bench.pictureState();
  if (state == PictureState::Wrong || state == PictureState::Held)
    palette.setColor(QPalette::WindowText, colors().error);
  m_state->setPalette(palette);
  const RenderOptions &options = m_bench.renderer().effectiveOptions();
  m_choice->setText(QStringList{
      options.profile.isEmpty() ? QString::fromStdString(settings().profile) : options.profile,
      options.numerics.isEmpty() ? QStringLiteral("host") : options.numerics,
      options.backend.isEmpty() ? QStringLiteral("auto") : options.backend}
                        .join(QStringLiteral(" · ")));
}

void StatusLine::notice(const QString &text) {
  m_lastNotice = text;
  say(*m_notice, text);
  m_fade.start();
}

void StatusLine::setPlace(int line, int column) {
  m_place->setText(QStringLiteral("%1:%2").arg(line).arg(column));
}

} // namespace arbiter::builder
