#pragma once
#include <QImage>
#include <QJsonObject>
#include <QList>
#include <QString>
#include <array>
#include <optional>

/// Data of an attached application: programs, parameters and textures (docs/write/control.md).
namespace arbiter::builder {

/// A process that listens at a socket.
struct ListeningProcess {
  qint64 process = 0;
  QString path; ///< of its socket
  QString name; ///< of its executable; empty: unknown
};
/// Returns the applications with the layer in $XDG_RUNTIME_DIR/arbiter. \param why set if there can
/// be none
[[nodiscard]] QList<ListeningProcess> listeningProcesses(QString *why = nullptr);

/// The cost of one frame for one program.
struct MeasuredCost {
  qint64 draws = 0;
  std::optional<qint64> pixels; ///< none: the host cannot count pixels
  double milliseconds = 0;
};

struct AttachedProgram {
  QString id; ///< the name of the text's file
  QString target;
  bool effective = false, edited = false, replaced = false, enabled = true;
  bool underNativeLimits = true;
  qint64 draws = 0;
  qint64 rasterizerDraws = 0; ///< of `draws`
  double milliseconds = 0;    ///< since a client is attached
  qint64 instructions = 0;    ///< native
  std::optional<MeasuredCost> measured;

  /// Returns "rasterizer", "host" or "both"; empty: it has drawn nothing.
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
  QImage image; ///< small; null: not received yet, or unreadable

  [[nodiscard]] bool isSame(const AttachedTexture &other) const {
    return name == other.name && unit == other.unit && target == other.target &&
           width == other.width && height == other.height && format == other.format;
  }
};
[[nodiscard]] AttachedTexture textureOf(const QJsonObject &row);
/// Returns the image of an answer to texture.get, the top row first; null if it has none.
[[nodiscard]] QImage imageOf(const QJsonObject &answer);

/// Returns the file name of a program's text in a folder of replacements. Returns "" if the id is
/// invalid, so that no process can name a path.
[[nodiscard]] QString fileNameOf(const QString &id);

} // namespace arbiter::builder
