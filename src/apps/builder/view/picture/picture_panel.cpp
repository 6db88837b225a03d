#include "apps/builder/view/picture/picture_panel.h"

#include <QBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "apps/builder/view/picture/picture_view.h"
#include "apps/builder/view/theme.h"

namespace arbiter::builder {

namespace {

QToolButton *button(const QString &text, const QString &hint) {
  auto *made = new QToolButton;
  made->setText(text);
  made->setToolTip(hint);
  made->setAccessibleName(hint);
  made->setFocusPolicy(Qt::StrongFocus);
  made->setAutoRaise(true);
  return made;
}

} // namespace

PicturePanel::PicturePanel(Workbench &bench) : m_bench(bench) {
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  m_view = new PictureView;
  layout->addWidget(buildBar());
  layout->addWidget(buildBanner());
  layout->addWidget(m_view, 1);
  connect(&bench, &Workbench::pictureChanged, this, [this] { showPicture(); });
  connect(&bench, &Workbench::statusChanged, this, [this] { showState(); });
  connect(&bench.file(), &OpenFile::pathChanged, this, [this] { m_judged = 0; });
  connect(m_view, &PictureView::pixelPicked, this,
          [this](QPoint pixel) { m_bench.debugPixel(pixel); });
  connect(m_view, &PictureView::pixelHovered, this, [this](QPoint pixel, const QColor &color) {
    m_pixel->setText(
        tr("%1, %2  #%3")
            .arg(pixel.x())
            .arg(pixel.y())
            .arg(QString::number(color.rgba() & 0xffffffU, 16).rightJustified(6, u'0')));
  });
  connect(m_view, &PictureView::pixelLeft, m_pixel, &QLabel::clear);
  connect(m_view, &PictureView::dragged, this, [this](QPointF delta, double distance) {
    constexpr double kTurn = 180; // degrees from one side to the other
    if (!m_bench.turnCamera(-delta.x() * kTurn, delta.y() * kTurn, distance))
      Q_EMIT m_bench.notice(
          tr("nothing turns: the document has no orbiting camera (Scene, Camera)"));
  });
  connect(m_view, &PictureView::dragEnded, this, [this] { m_bench.releaseCamera(); });
  showState();
}

QWidget *PicturePanel::buildBar() {
  auto *bar = new QWidget;
  auto *layout = new QHBoxLayout(bar);
  layout->setContentsMargins(6, 2, 6, 2);
  m_facts = new QLabel;
  m_facts->setMinimumWidth( // the label changes with each frame and must not move other widgets
      fontMetrics().horizontalAdvance(QStringLiteral("8192\u00d78192  1000.0 ms")));
  m_pixel = new QLabel;
  m_pixel->setObjectName(QStringLiteral("picture-pixel"));
  m_pixel->setForegroundRole(QPalette::PlaceholderText);
  auto *smaller = button(QStringLiteral("\u2212"), tr("Smaller"));
  auto *fit = button(tr("fit"), tr("As large as fits"));
  auto *real = button(QStringLiteral("1:1"), tr("One pixel a pixel of the screen"));
  auto *larger = button(QStringLiteral("+"), tr("Larger"));
  m_pause = button(tr("Pause"), tr("Pause (Ctrl+P)"));
  m_pause->setCheckable(true);
  auto *one = button(tr("Step"), tr("One frame (Ctrl+.)"));
  layout->addWidget(m_facts);
  layout->addWidget(m_pixel, 1);
  for (QToolButton *each : {smaller, fit, real, larger, m_pause, one})
    layout->addWidget(each);
  connect(smaller, &QToolButton::clicked, m_view, [this] { m_view->zoomBy(-1); });
  connect(larger, &QToolButton::clicked, m_view, [this] { m_view->zoomBy(1); });
  connect(fit, &QToolButton::clicked, m_view, [this] { m_view->setZoom(0); });
  connect(real, &QToolButton::clicked, m_view, [this] { m_view->setZoom(1); });
  connect(m_pause, &QToolButton::toggled, this, [this] { applyPause(); });
  connect(one, &QToolButton::clicked, this, [this] { step(); });
  return bar;
}

QWidget *PicturePanel::buildBanner() {
  m_banner = new QWidget;
  m_banner->setAutoFillBackground(true);
  auto *layout = new QHBoxLayout(m_banner);
  m_heldWhy = new QLabel;
  m_heldWhy->setWordWrap(true);
  auto *draw = new QPushButton(tr("&Draw anyway"));
  auto *last = new QPushButton(tr("&Last good text"));
  layout->addWidget(m_heldWhy, 1);
  layout->addWidget(draw);
  layout->addWidget(last);
  connect(draw, &QPushButton::clicked, this, [this] { m_bench.renderer().drawAnyway(); });
  connect(last, &QPushButton::clicked, this, [this] {
    if (const auto good = m_bench.renderer().lastGoodScene())
      m_bench.document().become(good->text, Origin::Tool, tr("last good text"));
  });
  m_banner->hide();
  return m_banner;
}

void PicturePanel::togglePause() { m_pause->toggle(); }

void PicturePanel::applyPause() { m_bench.renderer().setPaused(m_pause->isChecked() || !m_seen); }

void PicturePanel::showEvent(QShowEvent *event) {
  QWidget::showEvent(event);
  m_seen = true;
  applyPause();
}

void PicturePanel::hideEvent(QHideEvent *event) {
  QWidget::hideEvent(event);
  m_seen = false;
  applyPause();
}

/// Pauses a document that was just opened if it would keep a core busy; Ctrl+P continues.
void PicturePanel::judgeSpeed(const Frame &frame) {
  constexpr int kFrames = 3; // the first ones have more work
  if (m_judged >= kFrames || frame.time <= 0 || m_pause->isChecked())
    return;
  if (++m_judged < kFrames || frame.milliseconds < m_slow)
    return;
  m_pause->setChecked(true);
  Q_EMIT m_bench.notice(tr("a frame takes %1 ms: the animation is paused (Ctrl+P, Ctrl+.)")
                            .arg(frame.milliseconds, 0, 'f', 0));
}

void PicturePanel::step() {
  constexpr double kSeconds = 1.0 / 60;
  m_bench.renderer().step(kSeconds);
}

void PicturePanel::showPicture() {
  const Frame &frame = m_bench.frame();
  judgeSpeed(frame);
  m_view->setPicture(frame.image);
  m_view->setMark(m_bench.debuggedPixel());
  if (!frame.image.isNull())
    m_facts->setText(tr("%1\u00d7%2  %3 ms")
                         .arg(frame.image.width())
                         .arg(frame.image.height())
                         .arg(frame.milliseconds, 0, 'f', 1));
}

void PicturePanel::showState() {
  const PictureState state = m_bench.pictureState();
  m_view->setStale(state == PictureState::Wrong || state == PictureState::Held);
  m_banner->setVisible(state == PictureState::Held);
  QPalette amber = palette();
  amber.setColor(QPalette::Window, colors().traced);
  m_banner->setPalette(amber);
  m_heldWhy->setText(m_bench.statusText());
}

} // namespace arbiter::builder
