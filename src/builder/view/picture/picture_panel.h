#pragma once
#include <QWidget>

#include "builder/model/workbench.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace arbiter::builder {

class PictureView;

/// The picture with what rules it: zoom, pause, single steps; and above it what is said of a text
/// that is held.
class PicturePanel : public QWidget {
public:
  explicit PicturePanel(Workbench &bench);

  [[nodiscard]] PictureView &view() { return *m_view; }
  void togglePause();
  void step();

private:
  void showPicture();
  void showState();
  QWidget *buildBar();
  QWidget *buildBanner();

  Workbench &m_bench;
  PictureView *m_view;
  QLabel *m_facts, *m_pixel, *m_heldWhy;
  QToolButton *m_pause;
  QWidget *m_banner;
  QPointF m_camera; ///< yaw, pitch, from where the document has it
  bool m_turned = false;
};

} // namespace arbiter::builder
