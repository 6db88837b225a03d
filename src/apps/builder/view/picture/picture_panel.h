#pragma once
#include <QWidget>

#include "apps/builder/model/workbench.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace arbiter::builder {

class PictureView;

/// Shows the picture with its controls: zoom, pause, single steps; and above it the message about a
/// held text. An invisible picture is paused.
class PicturePanel : public QWidget {
public:
  explicit PicturePanel(Workbench &bench);

  [[nodiscard]] PictureView &view() { return *m_view; }
  void togglePause();
  void step();
  /// Sets the frame time above which a document starts paused.
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
  /// False if hidden behind a tab or in a minimised window; the animation then stops
  bool m_seen = true;
  double m_slow = 250;
  int m_judged = 0; ///< number of animated frames that were judged as quick or slow
};

} // namespace arbiter::builder
