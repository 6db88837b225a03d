#pragma once
#include <QImage>
#include <QJsonObject>
#include <QList>
#include <QString>
#include <array>
#include <optional>

/// Programs, parameters and textures of an attached application (docs/write/control.md).
namespace arbiter::builder {

/// A process that listens.
struct ListeningProcess {
  qint64 process = 0;
  QString path; ///< of its socket
  QString name; ///< of its executable; empty where it is not known
};
/// Applications with the layer, of $XDG_RUNTIME_DIR/arbiter. \param why set where there can be none
[[nodiscard]] QList<ListeningProcess> listeningProcesses(QString *why = nullptr);

/// What one frame cost, by program.
struct MeasuredCost {
  qint64 draws = 0;
  std::optional<qint64> pixels; ///< none: the host cannot count them
  double milliseconds = 0;
};

struct AttachedProgram {
  QString id; ///< the name of the text's file
  QString target;
  bool effective = false, edited = false, replaced = false, enabled = true;
  bool underNativeLimits = true;
  qint64 draws = 0;
  qint64 rasterizerDraws = 0; ///< of `draws`
  double milliseconds = 0;    ///< since a client is there
  qint64 instructions = 0;    ///< native
  std::optional<MeasuredCost> measured;

  /// "rasterizer", "host", "both"; empty: it has drawn nothing.
  [[nodiscard]] QString drawer() const;
};
[[nodiscard]] AttachedProgram programOf(const QJsonObject &row);

struct AttachedParameter {
  QString name;
  QString kind; ///< "local", "env", "state", "constant"
  std::array<double, 4> value = {};
  bool held = false;

  [[nodiscard]] bool isSettable() const { return kind == u"local" || kind == u"env"; }
};
[[nodiscard]] AttachedParameter parameterOf(const QJsonObject &row);

struct AttachedTexture {
  qint64 name = 0, unit = 0, width = 0, height = 0;
  QString target, format;
  QImage image; ///< small; null: not come yet, or it cannot be read

  [[nodiscard]] bool isSame(const AttachedTexture &other) const {
    return name == other.name && unit == other.unit && target == other.target &&
           width == other.width && height == other.height && format == other.format;
  }
};
[[nodiscard]] AttachedTexture textureOf(const QJsonObject &row);
/// An answer of texture.get, the top row first; null where it has no image.
[[nodiscard]] QImage imageOf(const QJsonObject &answer);

/// The file of a program's text in a folder of replacements; empty where the id is none, so that no
/// process names a path.
[[nodiscard]] QString fileNameOf(const QString &id);

} // namespace arbiter::builder
