#pragma once
#include <QDialog>
#include <array>

#include "builder/model/workbench.h"

class QLineEdit;
class QPushButton;

namespace arbiter::builder {

/// What a picker of images shows.
[[nodiscard]] QString imageFilter();

/// Picks the six images of a cube map. A file that is picked for one face fills the faces whose
/// files are named alike beside it (px, nx, ...; posx, negx, ...; right, left, ...).
class CubeDialog : public QDialog {
public:
  CubeDialog(Workbench &bench, int unit, QWidget *parent = nullptr);

  /// "cube px.png nx.png py.png ny.png pz.png nz.png"
  [[nodiscard]] QString source() const;

private:
  void pick(std::size_t face);
  void setFace(std::size_t face, const QString &path);
  void check();

  Workbench &m_bench;
  std::array<QLineEdit *, 6> m_names = {};
  QPushButton *m_ok;
};

/// The files of the six faces (+x, -x, +y, -y, +z, -z) that are named as one of them is; empty
/// where there is none. All are empty if the name says no face.
[[nodiscard]] std::array<QString, 6> facesLike(const QString &path);

} // namespace arbiter::builder
