#pragma once
#include <QWidget>

#include "builder/model/workbench.h"

class QComboBox;
class QLabel;

namespace arbiter::builder {

class PictureView;

/// A beside B: the picture against an earlier one, or against the same text drawn in another way.
class ComparePanel : public QWidget {
public:
  ComparePanel(Workbench &bench, PictureView &picture);

private:
  void choose(int index);
  void showFigures();

  Workbench &m_bench;
  PictureView &m_picture;
  QComboBox *m_with;
  QLabel *m_figures;
};

} // namespace arbiter::builder
