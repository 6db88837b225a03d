#pragma once
#include <QImage>
#include <QWidget>
#include <optional>

namespace arbiter::builder {

/// Shows a picture in whole pixels at whole zooms. Only this class knows the position of pixels in
/// the widget. All others use the picture's own pixels, counted from the left and, as in GL, from
/// the bottom.
class PictureView : public QWidget {
  Q_OBJECT
public:
  explicit PictureView(QWidget *parent = nullptr);

  void setPicture(const QImage &image);
  [[nodiscard]] const QImage &picture() const { return m_image; }
  /// Sets a second picture: A is left of the split, the first picture right of it. Null: none.
  void setOther(const QImage &image);
  void setSplit(double split);
  [[nodiscard]] double split() const { return m_split; }
  /// Shows the difference between A and the picture in place of both.
  void setDifference(bool on);
  /// Shows only A while set.
  void setShowsOther(bool on);

  /// Sets the device pixels for each pixel of the picture; 0: as large as fits.
  void setZoom(double zoom);
  [[nodiscard]] double zoom() const;
  void zoomBy(int steps);
  /// Marks a pixel.
  void setMark(std::optional<QPoint> pixel);
  /// Shows an amber frame if the picture is not the newest.
  void setStale(bool stale);

  /// Returns the pixel at a place of the widget; nothing outside the picture.
  [[nodiscard]] std::optional<QPoint> pixelAt(QPointF place) const;
  /// Returns the rectangle of a pixel in the widget.
  [[nodiscard]] QRectF rectOf(QPoint pixel) const;
  /// Returns its color; transparent outside.
  [[nodiscard]] QColor colorAt(QPoint pixel) const;

  [[nodiscard]] QSize sizeHint() const override { return {520, 520}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {120, 120}; }

Q_SIGNALS:
  void pixelPicked(QPoint pixel);
  /// Reports the pixel under the mouse when the mouse moves or another picture comes.
  void pixelHovered(QPoint pixel, QColor color);
  /// Reports that the mouse has left the picture.
  void pixelLeft();
  /// Moves a camera: the right button or Shift and an arrow key turn it, in fractions of the
  /// widget. The wheel with them, or with Ctrl, scales the distance by a factor.
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
  std::optional<QPointF> m_hover; ///< the mouse position
  bool m_toldHovered = false;
};

} // namespace arbiter::builder
