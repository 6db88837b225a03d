#pragma once
#include <QJsonObject>
#include <QList>
#include <QMap>
#include <QString>

#include "builder/model/text/edit.h"

namespace arbiter::builder {

/// How much of one resource a program takes.
struct Gauge {
  QString name;  ///< "alu_instructions"
  QString title; ///< "ALU instructions"
  int used = 0, limit = 0;
  int nativeUsed = 0, nativeLimit = 0;
  QStringList reasons; ///< why the native number is what it is

  [[nodiscard]] bool over() const { return used > limit; }
  [[nodiscard]] bool overNative() const { return nativeUsed > nativeLimit; }
};

/// What one line of the text costs on the card.
struct LineCost {
  double slotCount = 0;
  int textures = 0;
  int node = 0;
  bool gone = true; ///< the compiler leaves all of it out
};

/// A pass of the card between dependent reads.
struct NodeLine {
  QStringList textures; ///< "TEX line 10"
  int pairs = 0;
  QString reason;
};

/// What `arbiter check --json`, and the language server's arbiter/report, say of one program.
struct Report {
  QString status; ///< "valid", "invalid", "over_native"
  QString profile;
  QList<Gauge> gauges;       ///< empty of a program that does not load
  QMap<int, LineCost> lines; ///< by line, from 1
  QList<NodeLine> nodes;
  double cycles = 0; ///< a fragment; 0 where the card has no model
  QString bound;     ///< the unit that decides them

  /// \param file one element of "files"
  [[nodiscard]] static Report of(const QJsonObject &file);

  /// Moves the costs with their lines, until there is a report of the edited text: one that is
  /// wrong has none. \param text after the edit
  void follow(const Edit &edit, const QString &text);
};

} // namespace arbiter::builder
