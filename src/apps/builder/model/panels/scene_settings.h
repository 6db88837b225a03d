#pragma once
#include <QList>
#include <QString>
#include <QStringList>

#include "apps/builder/model/text/edit.h"

namespace arbiter::builder {

/// A number with its name, as written behind a word: "yaw 30".
struct ArgumentValue {
  QString name;
  double value = 0, low = 0, high = 1;
  bool operator==(const ArgumentValue &) const = default;
};

/// The mesh, camera, state and passes in a document's `#@` lines. Words that are not written are
/// empty; numbers have their defaults.
struct SceneSettings {
  int width = 512, height = 512; ///< pixels
  double rate = 60;              ///< frames a second
  QString mesh;                  ///< the whole text behind the word
  QString shape;                 ///< the word of a single shape; empty if several are joined
  QList<ArgumentValue> shapeArguments;
  QString camera; ///< "none", "orbit"
  QList<ArgumentValue> cameraArguments;
  QString blend, depth, cull, stencil;
  bool depthWrite = true, colorWrite = true, keep = false;
  QList<double> clear{0, 0, 0, 0};
  QString vertex;   ///< a file's name
  QStringList then; ///< names of files
  bool operator==(const SceneSettings &) const = default;
};

[[nodiscard]] SceneSettings sceneOf(const QString &text);

/// Returns the words that may follow "mesh", "camera", "blend", "depth", "cull" or "stencil".
[[nodiscard]] QStringList wordsFor(const QString &setting);

/// Sets a number of the camera or of the only shape: replaces its digits if it is written, else
/// appends its name and value. Returns an empty edit if there is no such number.
[[nodiscard]] Edit setArgument(const QString &text, const QString &setting, const QString &name,
                               double value);
/// Returns the edits, each in the text left by the ones before, that turn an orbiting camera by
/// degrees and scale its distance by a factor. Returns none if the document has no such camera.
[[nodiscard]] QList<Edit> turnCamera(const QString &text, double yaw, double pitch,
                                     double distance);

} // namespace arbiter::builder
