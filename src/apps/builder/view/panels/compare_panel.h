#pragma once
#include <QWidget>

#include "apps/builder/model/workbench.h"

class QComboBox;
class QLabel;

namespace arbiter::builder {

class PictureView;

/// Compares pictures A and B: the present picture with an earlier one, or with the same text drawn
/// with other options.
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
