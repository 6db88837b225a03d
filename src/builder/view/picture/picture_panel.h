#pragma once
#include <QWidget>

#include "builder/model/workbench.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace arbiter::builder {

class PictureView;

/// The picture with what rules it: zoom, pause, single steps; and above it what is said of a text
/// that is held. What is not seen is paused.
class PicturePanel : public QWidget {
public:
  explicit PicturePanel(Workbench &bench);

  [[nodiscard]] PictureView &view() { return *m_view; }
  void togglePause();
  void step();
  /// A document that is opened, and whose frames take longer than this, begins paused.
  void setSlow(double milliseconds) { m_slow = milliseconds; }

protected:
  void showEvent(QShowEvent *event) override;
  void hideEvent(QHideEvent *event) override;

private:
  void applyPause();
  void judgeSpeed(const Frame &frame);
  void showPicture();
  void showState();
  QWidget *buildBar();
  QWidget *buildBanner();

  Workbench &m_bench;
  PictureView *m_view;
  QLabel *m_facts, *m_pixel, *m_heldWhy;
  QToolButton *m_pause;
  QWidget *m_banner;
  bool m_seen = true; ///< what is hidden, behind a tab or in a minimised window, does not move
  double m_slow = 250;
  int m_judged = 0; ///< moving frames of the document that were quick or slow
};

} // namespace arbiter::builder
