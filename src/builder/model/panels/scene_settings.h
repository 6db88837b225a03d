#pragma once
#include <QList>
#include <QString>
#include <QStringList>

#include "builder/model/text/edit.h"

namespace arbiter::builder {

/// A number with its name behind a word: "yaw 30".
struct ArgumentValue {
  QString name;
  double value = 0, low = 0, high = 1;
  bool operator==(const ArgumentValue &) const = default;
};

/// What a document's `#@` lines say of its mesh, camera, state and passes. Words that are not said
/// are empty; numbers that are not have their defaults.
struct SceneSettings {
  int width = 512, height = 512; ///< pixels
  double rate = 60;              ///< frames a second
  QString mesh;                  ///< all that follows the word
  QString shape;                 ///< the only shape's word; empty where several are joined
  QList<ArgumentValue> shapeArguments;
  QString camera; ///< "none", "orbit"
  QList<ArgumentValue> cameraArguments;
  QString blend, depth, cull, stencil;
  bool depthWrite = true, colourWrite = true, keep = false;
  QList<double> clear{0, 0, 0, 0};
  QString vertex;   ///< a file's name
  QStringList then; ///< files' names
  bool operator==(const SceneSettings &) const = default;
};

[[nodiscard]] SceneSettings sceneOf(const QString &text);

/// The words that may follow "mesh", "camera", "blend", "depth", "cull" or "stencil".
[[nodiscard]] QStringList wordsFor(const QString &setting);

/// The edit that makes one number of the camera or the only shape another: its digits alone where
/// it is written, else its name and itself behind the others. Empty where there is no such number.
[[nodiscard]] Edit setArgument(const QString &text, const QString &setting, const QString &name,
                               double value);
/// The edits, each in the text that the ones before it left, that turn an orbiting camera by
/// degrees and change its distance by a factor; none where the document has no such camera.
[[nodiscard]] QList<Edit> turnCamera(const QString &text, double yaw, double pitch,
                                     double distance);

} // namespace arbiter::builder
