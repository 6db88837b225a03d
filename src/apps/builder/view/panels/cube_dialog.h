#pragma once
#include <QDialog>
#include <array>

#include "apps/builder/model/workbench.h"

class QLineEdit;
class QPushButton;

namespace arbiter::builder {

/// Returns the filter of a dialog that opens images.
[[nodiscard]] QString imageFilter();

/// Selects the six images of a cube map. A file for one face also sets the faces whose files beside
/// it have matching names (px, nx, ...; posx, negx, ...; right, left, ...).
class CubeDialog : public QDialog {
public:
  CubeDialog(Workbench &bench, int unit, QWidget *parent = nullptr);

  /// Returns "cube px.png nx.png py.png ny.png pz.png nz.png".
  [[nodiscard]] QString source() const;

private:
  void pick(std::size_t face);
  void setFace(std::size_t face, const QString &path);
  void check();

  Workbench &m_bench;
  std::array<QLineEdit *, 6> m_names = {};
  QPushButton *m_ok;
};

/// Returns the files of the six faces (+x, -x, +y, -y, +z, -z) with names that match one of them;
/// "" for a face without a file. All are empty if the name has no face.
[[nodiscard]] std::array<QString, 6> facesLike(const QString &path);

} // namespace arbiter::builder
