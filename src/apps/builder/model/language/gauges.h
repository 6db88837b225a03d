#pragma once
#include <QJsonObject>
#include <QList>
#include <QMap>
#include <QString>

#include "apps/builder/model/text/edit.h"

namespace arbiter::builder {

/// A program's use of one resource.
struct Gauge {
  QString name;  ///< "alu_instructions"
  QString title; ///< "ALU instructions"
  int used = 0, limit = 0;
  int nativeUsed = 0, nativeLimit = 0;
  QStringList reasons; ///< the reasons for the native number

  [[nodiscard]] bool over() const { return used > limit; }
  [[nodiscard]] bool overNative() const { return nativeUsed > nativeLimit; }
};

/// The native cost of one line of the text.
struct LineCost {
  double slotCount = 0;
  int textures = 0;
  int node = 0;
  bool gone = true; ///< the compiler removes the whole line
};

/// A native pass between dependent reads.
struct NodeLine {
  QStringList textures; ///< "TEX line 10"
  int pairs = 0;
  QString reason;
};

/// The report on one program by `arbiter check --json`, or by the language server's arbiter/report.
struct Report {
  QString status; ///< "valid", "invalid", "over_native"
  QString profile;
  QList<Gauge> gauges;       ///< empty if the program does not load
  QMap<int, LineCost> lines; ///< by line, from 1
  QList<NodeLine> nodes;
  double cycles = 0; ///< for each fragment; 0 if the card has no model
  QString bound;     ///< the unit that limits them

  /// Reads a report. \param file one element of "files"
  [[nodiscard]] static Report of(const QJsonObject &file);

  /// Moves the costs with their lines until the edited text has a report; an invalid one gets none.
  /// \param text after the edit
  void follow(const Edit &edit, const QString &text);
};

} // namespace arbiter::builder
