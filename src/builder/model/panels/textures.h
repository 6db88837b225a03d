#pragma once
#include <QList>
#include <QString>
#include <QStringList>

#include "builder/model/text/edit.h"

namespace arbiter::builder {

/// One texture of a `#@` line.
struct TextureLine {
  int unit = 0;
  QString source; ///< as the text has it: "twirl 512 512 radius 0.47 turn 4.5"
  QString filter, wrap;
  bool isFile = false;
  bool hasSides = false;        ///< an image with two sides, which another generator may begin from
  int line = 1;                 ///< in the text, from 1
  qsizetype begin = 0, end = 0; ///< of the whole clause, in UTF-16 units
};

/// The texture lines of a text.
[[nodiscard]] QList<TextureLine> texturesOf(const QString &text);

/// A generator's name, and what it makes.
struct GeneratorWord {
  QString word;
  QString meaning;
};
/// Those that stand by themselves: that need no file and no other image.
[[nodiscard]] QList<GeneratorWord> generators();

/// The edit that gives a unit another source, in the text's line for the unit, or in a new line
/// behind the panel's last. Filter and wrap stay.
[[nodiscard]] Edit setTexture(const QString &text, int unit, const QString &source);

/// What a unit's texels are read by. The edit writes the word in the place of the one that stands
/// there, or behind the image. Empty if the text has no line for the unit.
enum class Sampler { Filter, Wrap };
[[nodiscard]] QStringList samplerWords(Sampler kind);
[[nodiscard]] Edit setSampler(const QString &text, int unit, Sampler kind, const QString &word);

/// A texture image unit that a fragment program samples and its panel gives no image: it samples a
/// checker with the unit's number.
struct UnsetUnit {
  int unit = 0;
  qsizetype begin = 0, end = 0; ///< of "texture[2]", where it stands first
};
[[nodiscard]] QList<UnsetUnit> unsetUnits(const QString &text);

/// A document that draws nothing but the image of that source: for a thumbnail.
[[nodiscard]] QString thumbnailDocument(const QString &source, int side);

} // namespace arbiter::builder
