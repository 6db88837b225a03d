#pragma once
#include <QList>
#include <QString>
#include <QStringList>

#include "apps/builder/model/text/edit.h"

namespace arbiter::builder {

/// A texture of a `#@` line.
struct TextureLine {
  int unit = 0;
  QString source; ///< as written: "twirl 512 512 radius 0.47 turn 4.5"
  QString filter, wrap;
  bool isFile = false;
  bool hasSides = false;        ///< an image with two sides, from which another generator may begin
  int line = 1;                 ///< in the text, from 1
  qsizetype begin = 0, end = 0; ///< of the whole clause, in UTF-16 units
};

/// Returns the texture lines of a text.
[[nodiscard]] QList<TextureLine> texturesOf(const QString &text);

/// A generator's name and meaning.
struct GeneratorWord {
  QString word;
  QString meaning;
};
/// Returns the generators that need no file and no other image.
[[nodiscard]] QList<GeneratorWord> generators();

/// Sets the source of a unit, in its line, or in a new line behind the panel's last. Filter and
/// wrap stay.
[[nodiscard]] Edit setTexture(const QString &text, int unit, const QString &source);

/// Sampling parameters of a unit. The edit replaces the present word, or inserts one behind the
/// image. It is empty if the text has no line for the unit.
enum class Sampler { Filter, Wrap };
[[nodiscard]] QStringList samplerWords(Sampler kind);
[[nodiscard]] Edit setSampler(const QString &text, int unit, Sampler kind, const QString &word);

/// A texture unit that a fragment program samples but its panel does not set. It samples a checker
/// with the unit's number.
struct UnsetUnit {
  int unit = 0;
  qsizetype begin = 0, end = 0; ///< of the first "texture[2]"
};
[[nodiscard]] QList<UnsetUnit> unsetUnits(const QString &text);

/// Returns a document that draws only the image of that source, for a thumbnail.
[[nodiscard]] QString thumbnailDocument(const QString &source, int side);

} // namespace arbiter::builder
