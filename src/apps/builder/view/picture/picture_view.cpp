#include "apps/builder/view/picture/picture_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "apps/builder/model/render/compare.h"
#include "apps/builder/view/theme.h"

namespace arbiter::builder {

namespace {
constexpr double kMaxZoom = 64;
constexpr double kCloser = 0.9; ///< for each step of the wheel
constexpr int kCheck = 8;       ///< side of the squares behind transparent pixels
} // namespace

PictureView::PictureView(QWidget *parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Picture"));
  setCursor(Qt::CrossCursor);
}

void PictureView::setPicture(const QImage &image) {
  m_image = image;
  if (m_difference)
    m_differenceImage = compare(m_other, m_image).difference;
  tellHovered();
  update();
}

void PictureView::tellHovered() {
  const auto pixel = m_hover ? pixelAt(*m_hover) : std::nullopt;
  if (pixel)
    Q_EMIT pixelHovered(*pixel, colorAt(*pixel));
  else if (m_toldHovered)
    Q_EMIT pixelLeft();
  m_toldHovered = pixel.has_value();
}

void PictureView::setOther(const QImage &image) {
  m_other = image;
  setPicture(m_image);
}

void PictureView::setSplit(double split) {
  m_split = std::clamp(split, 0.0, 1.0);
  update();
  Q_EMIT splitChanged(m_split);
}

void PictureView::setDifference(bool on) {
  m_difference = on;
  setPicture(m_image);
}

void PictureView::setShowsOther(bool on) {
  m_showsOther = on;
  update();
}

void PictureView::setZoom(double zoom) {
  m_zoom = std::clamp(zoom, 0.0, kMaxZoom);
  m_pan = {};
  tellHovered();
  update();
}

double PictureView::zoom() const {
  if (m_image.isNull())
    return 1;
  return target().width() * devicePixelRatioF() / m_image.width();
}

/// Zooms in whole factors and their inverses: 1/2, 1, 2, 3, ...
void PictureView::zoomBy(int steps) {
  const double now = zoom();
  const double next =
      now < 1 || (now <= 1 && steps < 0) ? now * std::pow(2.0, steps) : std::round(now) + steps;
  setZoom(std::max(1.0 / 16, next));
}

void PictureView::setMark(std::optional<QPoint> pixel) {
  m_mark = pixel;
  update();
}

void PictureView::setStale(bool stale) {
  m_stale = stale;
  update();
}

/// Returns the picture's rectangle. The zoom is in device pixels, so that 1:1 is sharp on any
/// screen.
QRectF PictureView::target() const {
  const QSizeF size = m_image.size();
  if (size.isEmpty())
    return {};
  const double ratio = devicePixelRatioF();
  double scale = m_zoom / ratio;
  if (m_zoom == 0) {
    const double fits = std::min((width() - 8) / size.width(), (height() - 8) / size.height());
    const double device = fits * ratio;
    scale = device >= 1 ? std::floor(device) / ratio : fits;
  }
  const QSizeF shown = size * scale;
  QPointF corner((width() - shown.width()) / 2, (height() - shown.height()) / 2);
  corner += m_pan;
  corner = {std::round(corner.x() * ratio) / ratio, std::round(corner.y() * ratio) / ratio};
  return {corner, shown};
}

std::optional<QPoint> PictureView::pixelAt(QPointF place) const {
  const QRectF area = target();
  if (area.isEmpty() || !area.contains(place))
    return std::nullopt;
  const int x = int((place.x() - area.left()) / area.width() * m_image.width());
  const int y = int((place.y() - area.top()) / area.height() * m_image.height());
  if (x >= m_image.width() || y >= m_image.height())
    return std::nullopt;
  return QPoint(x, m_image.height() - 1 - y);
}

QRectF PictureView::rectOf(QPoint pixel) const {
  const QRectF area = target();
  const double scale = area.width() / std::max(1, m_image.width());
  return {area.left() + pixel.x() * scale, area.top() + (m_image.height() - 1 - pixel.y()) * scale,
          scale, scale};
}

QColor PictureView::colorAt(QPoint pixel) const {
  const QPoint place(pixel.x(), m_image.height() - 1 - pixel.y());
  return m_image.valid(place) ? m_image.pixelColor(place) : QColor(Qt::transparent);
}

QImage PictureView::shown() const {
  if (m_other.isNull())
    return m_image;
  if (m_showsOther)
    return m_other;
  if (m_difference && !m_differenceImage.isNull())
    return m_differenceImage;
  return splitOf(m_other, m_image, m_split);
}

void PictureView::paintEvent(QPaintEvent *) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Window).darker(colors().dark ? 130 : 108));
  const QImage image = shown();
  const QRectF area = target();
  if (image.isNull() || area.isEmpty()) {
    painter.setPen(colors().dim);
    painter.drawText(rect(), Qt::AlignCenter, tr("no picture yet"));
    return;
  }
  if (image.hasAlphaChannel()) {
    painter.save();
    painter.setClipRect(area);
    painter.fillRect(area, QColor(0x80, 0x80, 0x80));
    for (double y = area.top(); y < area.bottom(); y += kCheck)
      for (double x = area.left() + (int((y - area.top()) / kCheck) % 2) * kCheck; x < area.right();
           x += 2 * kCheck)
        painter.fillRect(QRectF(x, y, kCheck, kCheck), QColor(0x98, 0x98, 0x98));
    painter.restore();
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform, zoom() < 1);
  painter.drawImage(area, image);
  if (m_stale) {
    painter.setPen(QPen(colors().amber, 3));
    painter.drawRect(area.adjusted(-2, -2, 2, 2));
  }
  paintSplit(painter);
  paintMark(painter);
}

void PictureView::paintSplit(QPainter &painter) {
  if (m_other.isNull() || m_difference || m_showsOther)
    return;
  const QRectF area = target();
  const double x = area.left() + m_split * area.width();
  painter.setPen(QPen(Qt::white, 1));
  painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
  const auto letter = [&](const QString &text, double at) {
    const QRectF box(at, area.top() + 4, 18, 18);
    painter.fillRect(box, QColor(0, 0, 0, 170));
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, text);
  };
  letter(QStringLiteral("A"), x - 22);
  letter(QStringLiteral("B"), x + 4);
}

void PictureView::paintMark(QPainter &painter) {
  if (!m_mark)
    return;
  QRectF box = rectOf(*m_mark);
  if (box.width() < 7)
    box = QRectF(box.center() - QPointF(3.5, 3.5), QSizeF(7, 7));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::black, 3));
  painter.drawRect(box);
  painter.setPen(QPen(Qt::white, 1));
  painter.drawRect(box);
}

void PictureView::mousePressEvent(QMouseEvent *event) {
  setFocus();
  m_last = event->position();
  const auto pixel = pixelAt(event->position());
  if (event->button() == Qt::LeftButton && (event->modifiers() & Qt::ShiftModifier)) {
    const QRectF area = target();
    setSplit((event->position().x() - area.left()) / std::max(1.0, area.width()));
  } else if (event->button() == Qt::LeftButton && pixel) {
    Q_EMIT pixelPicked(*pixel);
  }
}

void PictureView::mouseMoveEvent(QMouseEvent *event) {
  const QPointF delta = event->position() - m_last;
  if (event->buttons() & Qt::MiddleButton) {
    m_pan += delta;
    update();
  } else if (event->buttons() & Qt::RightButton) {
    Q_EMIT dragged({delta.x() / std::max(1, width()), delta.y() / std::max(1, height())}, 1);
  } else if ((event->buttons() & Qt::LeftButton) && (event->modifiers() & Qt::ShiftModifier)) {
    const QRectF area = target();
    setSplit((event->position().x() - area.left()) / std::max(1.0, area.width()));
  }
  m_last = event->position();
  m_hover = event->position();
  tellHovered();
}

void PictureView::leaveEvent(QEvent *event) {
  QWidget::leaveEvent(event);
  m_hover.reset();
  tellHovered();
}

void PictureView::mouseReleaseEvent(QMouseEvent *event) {
  if (event->button() == Qt::RightButton)
    Q_EMIT dragEnded();
}

void PictureView::wheelEvent(QWheelEvent *event) {
  const double turns = event->angleDelta().y() / 120.0;
  if (turns == 0)
    return;
  const bool holds = event->buttons() & Qt::RightButton;
  if (!holds && !(event->modifiers() & Qt::ControlModifier))
    return zoomBy(turns > 0 ? 1 : -1);
  Q_EMIT dragged({}, std::pow(kCloser, turns));
  if (!holds)
    Q_EMIT dragEnded();
}

/// Turns the camera by Shift and an arrow key, and moves it closer or away by Shift and page keys.
bool PictureView::turnByKey(int key) {
  constexpr double kStep = 1.0 / 36; // five degrees
  QPointF by;
  double distance = 1;
  switch (key) {
  case Qt::Key_Left:
    by = {-kStep, 0};
    break;
  case Qt::Key_Right:
    by = {kStep, 0};
    break;
  case Qt::Key_Up:
    by = {0, -kStep};
    break;
  case Qt::Key_Down:
    by = {0, kStep};
    break;
  case Qt::Key_PageUp:
    distance = kCloser;
    break;
  case Qt::Key_PageDown:
    distance = 1 / kCloser;
    break;
  default:
    return false;
  }
  Q_EMIT dragged(by, distance);
  Q_EMIT dragEnded();
  return true;
}

/// Moves the marked pixel by arrow keys; zooms by plus, minus and 0.
void PictureView::keyPressEvent(QKeyEvent *event) {
  if ((event->modifiers() & Qt::ShiftModifier) && turnByKey(event->key()))
    return;
  QPoint by;
  switch (event->key()) {
  case Qt::Key_Left:
    by = {-1, 0};
    break;
  case Qt::Key_Right:
    by = {1, 0};
    break;
  case Qt::Key_Up:
    by = {0, 1};
    break;
  case Qt::Key_Down:
    by = {0, -1};
    break;
  case Qt::Key_Plus:
  case Qt::Key_Equal:
    return zoomBy(1);
  case Qt::Key_Minus:
    return zoomBy(-1);
  case Qt::Key_0:
    return setZoom(0);
  default:
    return QWidget::keyPressEvent(event);
  }
  if (m_image.isNull())
    return;
  const QPoint from = m_mark.value_or(QPoint(m_image.width() / 2, m_image.height() / 2));
  const QPoint to(std::clamp(from.x() + by.x(), 0, m_image.width() - 1),
                  std::clamp(from.y() + by.y(), 0, m_image.height() - 1));
  Q_EMIT pixelPicked(to);
}

} // namespace arbiter::builder
