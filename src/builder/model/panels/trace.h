#pragma once
#include <QColor>
#include <QJsonObject>
#include <QList>
#include <QObject>
#include <QString>
#include <array>

namespace arbiter::builder {

/// A vec4 as a trace prints it: numbers, "nan", "inf", "-inf".
struct TraceValue {
  std::array<double, 4> value = {};
  bool known = false;

  [[nodiscard]] static TraceValue of(const QJsonValue &json);
  /// The components of a mask ("xy"; all of them if empty), five digits each.
  [[nodiscard]] QString text(const QString &mask = {}) const;
  /// As a picture shows it: clamped to [0,1]; black where it is no number.
  [[nodiscard]] QColor color() const;
};

struct TraceOperand {
  QString text;
  TraceValue value;
  QString unwritten; ///< components that nothing wrote before
};

/// One instruction as it ran for the pixel.
struct TraceRow {
  int line = 1;
  QString text;
  QString opcode;
  QString destination; ///< as it stands in the program, with its mask
  QString name;        ///< of the register
  QString mask;
  TraceValue value;  ///< of the first arithmetic
  TraceValue second; ///< of the other one, where it differs
  double error = 0;
  QList<TraceOperand> operands;
  TraceValue texel, coordinate;
  int unit = -1;     ///< of the texel; -1: no sample
  QStringList flags; ///< "nan", "inf", "unwritten", "over-one"
  bool discarded = false;
};

/// What `arbiter debug --json` says of one pixel, and the row that is looked at. Programs are
/// straight lines, so stepping is moving by a row, and every register's value after any row is
/// known.
class Trace : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  /// Takes a document of `arbiter debug --json`. The row stays where the new trace has as many.
  /// \returns false, and keeps what was, if it has no trace
  bool take(const QJsonObject &json);
  void clear();

  [[nodiscard]] const QList<TraceRow> &rows() const { return m_rows; }
  [[nodiscard]] int current() const { return m_current; }
  [[nodiscard]] const QString &verdict() const { return m_verdict; }
  [[nodiscard]] bool isEqual() const { return m_equal; }
  [[nodiscard]] bool isDiscarded() const { return m_discarded; }
  [[nodiscard]] const QString &numerics() const { return m_numerics; }
  [[nodiscard]] const QString &secondNumerics() const { return m_secondNumerics; }
  /// Inputs: name, value.
  [[nodiscard]] const QList<std::pair<QString, TraceValue>> &inputs() const { return m_inputs; }
  /// The registers after the current row: name, value; the one that it wrote is first.
  [[nodiscard]] QList<std::pair<QString, TraceValue>> registers() const;

  void step(int by) { moveTo(m_current + by); }
  void moveTo(int row);
  /// To the first row of a line of the text, or of the next line that has one.
  void runToLine(int line);
  /// To the next row that has a flag, round at the end. \returns false if none has
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
