#pragma once
#include <QList>
#include <QObject>
#include <array>
#include <optional>
#include <vector>

#include "builder/model/text/document.h"
#include "scene/panel/panel.h"

namespace arbiter::builder {

/// One component of a parameter, as its number stands in the text.
struct Component {
  double value = 0;
  qsizetype at = -1; ///< of its number in the text, in UTF-16 units; -1: it is not written
  qsizetype length = 0;
  int index = 0; ///< 0 to 3: x, y, z, w
};

/// One parameter of a `#@` line.
struct ParameterLine {
  QString space; ///< "local", "env" or "attrib"
  int index = 0;
  int rows = 1;  ///< indexes that it has: more than one is a matrix
  QString label; ///< as the text calls it, or "local[0]"
  QList<Component> components;
  double low = 0, high = 1; ///< of the slider
  bool hasRange = false;
  bool colour = false; ///< shown as one
  bool fixed = false;  ///< made by a word (rotate, camera): no slider
  QString animation;   ///< "sine 5s"; empty: none
  QString motion;      ///< "sine"; empty: none
  double period = 5;   ///< seconds of it
  int line = 1;        ///< in the text, from 1
};

/// The parameters of a document's `#@` lines, as a panel of sliders changes them. A slider that is
/// held changes no text: liveText() has its value. When it is let go the number in the text is
/// written anew, as one undo step, and nothing else.
class Parameters : public QObject {
  Q_OBJECT
public:
  explicit Parameters(Document &document, QObject *parent = nullptr);

  [[nodiscard]] const QList<ParameterLine> &lines() const { return m_lines; }

  /// A slider is at \p value, and held.
  void drag(int line, int component, double value);
  /// It is let go there: the text has the value. Nothing held is left.
  void release();
  [[nodiscard]] bool isHeld() const { return !m_held.isEmpty(); }
  /// The value shown: the held one, or the text's.
  [[nodiscard]] double value(int line, int component) const;
  /// The value that is drawn with at a time of the animation: the held one, or what the text's has
  /// become.
  [[nodiscard]] double valueAt(int line, int component, double seconds) const;
  /// Sets at once, as one step; several components (a colour) too.
  void set(int line, const QList<double> &values);
  /// Makes the range of the sliders another, or writes the first one. Requires low < high.
  void setRange(int line, double low, double high);
  /// Makes the animation another, takes it away (an empty word) or writes the first one.
  /// \param motion one of motionsOf() \param seconds of its period, > 0
  void setMotion(int line, const QString &motion, double seconds);
  /// A line for one more local parameter, that no other line has: "local[3].x".
  void add();
  /// The words of animations, without "turn" unless the line's value has x, y and z.
  [[nodiscard]] QStringList motionsOf(int line) const;
  /// The document's text with the held values in place of its own.
  [[nodiscard]] QString liveText() const;

  /// A number as a text spells it: short, and the same float when it is read.
  [[nodiscard]] static QString numberText(double value);

Q_SIGNALS:
  /// Lines came, went or moved.
  void linesChanged();
  /// A held value moved.
  void dragged(int line, int component, double value);

private:
  struct Held {
    int line = 0;
    int component = 0;
    double value = 0;
  };

  void read();
  [[nodiscard]] QList<Edit> heldEdits() const;

  Document &m_document;
  QList<ParameterLine> m_lines;
  std::vector<scene::Parameter> m_parsed; ///< of each line
  QList<Held> m_held;
};

} // namespace arbiter::builder
