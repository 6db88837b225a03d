#pragma once
#include <QImage>
#include <QWidget>
#include <optional>

namespace arbiter::builder {

/// Shows a picture, whole pixels at whole zooms. The one place that knows how pixels lie in the
/// widget: everything else speaks of the picture's own pixels, from the left and, as GL counts,
/// from the bottom.
class PictureView : public QWidget {
  Q_OBJECT
public:
  explicit PictureView(QWidget *parent = nullptr);

  void setPicture(const QImage &image);
  [[nodiscard]] const QImage &picture() const { return m_image; }
  /// A second picture: left of the split is A, right of it the picture. Null: none.
  void setOther(const QImage &image);
  void setSplit(double split);
  [[nodiscard]] double split() const { return m_split; }
  /// Shows how A and the picture differ in place of both.
  void setDifference(bool on);
  /// While held, A alone.
  void setShowsOther(bool on);

  /// Device pixels a picture's pixel; 0: as large as fits.
  void setZoom(double zoom);
  [[nodiscard]] double zoom() const;
  void zoomBy(int steps);
  /// A mark at a pixel.
  void setMark(std::optional<QPoint> pixel);
  /// An amber frame: what is shown is not the newest.
  void setStale(bool stale);

  /// The pixel at a place of the widget; nothing outside the picture.
  [[nodiscard]] std::optional<QPoint> pixelAt(QPointF place) const;
  /// The rectangle of a pixel in the widget.
  [[nodiscard]] QRectF rectOf(QPoint pixel) const;
  /// Its colour; transparent outside.
  [[nodiscard]] QColor colourAt(QPoint pixel) const;

  [[nodiscard]] QSize sizeHint() const override { return {520, 520}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {120, 120}; }

Q_SIGNALS:
  void pixelPicked(QPoint pixel);
  /// Under the mouse: when it moves, and when another picture comes.
  void pixelHovered(QPoint pixel, QColor colour);
  /// The mouse is over no pixel any more.
  void pixelLeft();
  /// For a camera: with the right button or Shift and an arrow key, in fractions of the widget; and
  /// closer, by the wheel meanwhile or with Ctrl, by a factor of the distance.
  void dragged(QPointF delta, double distance);
  void dragEnded();
  void splitChanged(double split);

protected:
  void paintEvent(QPaintEvent *event) override;
  void mousePressEvent(QMouseEvent *event) override;
  void mouseMoveEvent(QMouseEvent *event) override;
  void mouseReleaseEvent(QMouseEvent *event) override;
  void wheelEvent(QWheelEvent *event) override;
  void leaveEvent(QEvent *event) override;
  void keyPressEvent(QKeyEvent *event) override;

private:
  [[nodiscard]] QRectF target() const;
  [[nodiscard]] QImage shown() const;
  bool turnByKey(int key);
  void tellHovered();
  void paintMark(QPainter &painter);
  void paintSplit(QPainter &painter);

  QImage m_image, m_other, m_differenceImage;
  double m_zoom = 0;
  double m_split = 0.5;
  bool m_difference = false, m_showsOther = false, m_stale = false;
  std::optional<QPoint> m_mark;
  QPointF m_pan, m_last;
  std::optional<QPointF> m_hover; ///< where the mouse is
  bool m_toldHovered = false;
};

} // namespace arbiter::builder
