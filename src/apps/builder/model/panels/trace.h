#pragma once
#include <QColor>
#include <QJsonObject>
#include <QList>
#include <QObject>
#include <QString>
#include <array>

namespace arbiter::builder {

/// A vec4 of a trace, whose components are numbers, "nan", "inf" or "-inf".
struct TraceValue {
  std::array<double, 4> value = {};
  bool known = false;

  [[nodiscard]] static TraceValue of(const QJsonValue &json);
  /// Returns the components of a mask ("xy"; all if empty), five digits each.
  [[nodiscard]] QString text(const QString &mask = {}) const;
  /// Returns the value as a picture shows it: clamped to [0,1], and black if it is no number.
  [[nodiscard]] QColor color() const;
};

struct TraceOperand {
  QString text;
  TraceValue value;
  QString unwritten; ///< components that no instruction has written before
};

/// An instruction as it was executed for the pixel.
struct TraceRow {
  int line = 1;
  QString text;
  QString opcode;
  QString destination; ///< as in the program, with its mask
  QString name;        ///< of the register
  QString mask;
  TraceValue value;  ///< in the first arithmetic
  TraceValue second; ///< in the second one, if it differs
  double error = 0;
  QList<TraceOperand> operands;
  TraceValue texel, coordinate;
  int unit = -1;     ///< of the sampled texel; -1: no sample
  QStringList flags; ///< "nan", "inf", "unwritten", "over1"
  bool discarded = false;
};

/// A trace of one pixel by `arbiter debug --json`, and the current row. Programs are straight
/// lines, so that a step is one row, and every register's value is known after any row.
class Trace : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  /// Loads a document of `arbiter debug --json`. The current row stays if the new trace has as many
  /// rows.
  /// \returns false, and keeps the old trace, if it has none
  bool take(const QJsonObject &json);
  void clear();

  [[nodiscard]] const QList<TraceRow> &rows() const { return m_rows; }
  [[nodiscard]] int current() const { return m_current; }
  [[nodiscard]] const QString &verdict() const { return m_verdict; }
  [[nodiscard]] bool isEqual() const { return m_equal; }
  [[nodiscard]] bool isDiscarded() const { return m_discarded; }
  [[nodiscard]] const QString &numerics() const { return m_numerics; }
  [[nodiscard]] const QString &secondNumerics() const { return m_secondNumerics; }
  /// Returns the inputs: name, value.
  [[nodiscard]] const QList<std::pair<QString, TraceValue>> &inputs() const { return m_inputs; }
  /// Returns the registers after the current row: name, value. The one that the row wrote is first.
  [[nodiscard]] QList<std::pair<QString, TraceValue>> registers() const;

  void step(int by) { moveTo(m_current + by); }
  void moveTo(int row);
  /// Goes to the first row of a line of the text, or of the next line that has one.
  void runToLine(int line);
  /// Goes to the next row that has a flag, and wraps around at the end. \returns false if none has
  /// it
  bool nextFlag(const QString &flag);

Q_SIGNALS:
  void changed();
  void moved(int row);

private:
  QList<TraceRow> m_rows;
  QList<std::pair<QString, TraceValue>> m_inputs;
  int m_current = -1;
  QString m_verdict, m_numerics, m_secondNumerics;
  bool m_equal = false;
  bool m_discarded = false;
};

} // namespace arbiter::builder
