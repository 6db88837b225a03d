#pragma once
#include <QList>
#include <QObject>
#include <array>
#include <optional>
#include <vector>

#include "apps/builder/model/text/document.h"
#include "apps/scene/panel/panel.h"

namespace arbiter::builder {

/// A component of a parameter, with the place of its number in the text.
struct Component {
  double value = 0;
  qsizetype at = -1; ///< of its number in the text, in UTF-16 units; -1: not written
  qsizetype length = 0;
  int index = 0; ///< 0 to 3: x, y, z, w
};

/// One parameter of a `#@` line.
struct ParameterLine {
  QString space; ///< "local", "env" or "attrib"
  int index = 0;
  int rows = 1;  ///< indices that it occupies; more than one for a matrix
  QString label; ///< the text's label, or "local[0]"
  QList<Component> components;
  double low = 0, high = 1; ///< of the slider
  bool hasRange = false;
  bool color = false; ///< shown as a color
  bool fixed = false; ///< computed by a word (rotate, camera), so that it has no slider
  QString animation;  ///< "sine 5s"; empty: none
  QString motion;     ///< "sine"; empty: none
  double period = 5;  ///< of the animation, in seconds
  int line = 1;       ///< in the text, from 1
};

/// The parameters of a document's `#@` lines, for a panel of sliders. A held slider does not change
/// the text, but liveText() has its value. When it is released, only the number in the text is
/// replaced, as one undo step.
class Parameters : public QObject {
  Q_OBJECT
public:
  explicit Parameters(Document &document, QObject *parent = nullptr);

  [[nodiscard]] const QList<ParameterLine> &lines() const { return m_lines; }

  /// Moves a slider to \p value and holds it.
  void drag(int line, int component, double value);
  /// Releases held sliders: the text gets their values.
  void release();
  [[nodiscard]] bool isHeld() const { return !m_held.isEmpty(); }
  /// Returns the displayed value: the held one, or the text's.
  [[nodiscard]] double value(int line, int component) const;
  /// Returns the value that is drawn at a time of the animation: the held one, or the animated one.
  [[nodiscard]] double valueAt(int line, int component, double seconds) const;
  /// Sets the values at once, as one step; a color has several components.
  void set(int line, const QList<double> &values);
  /// Sets the range of the sliders, or adds one. Requires low < high.
  void setRange(int line, double low, double high);
  /// Changes the animation, removes it (an empty word) or adds one.
  /// \param motion one of motionsOf() \param seconds of its period, > 0
  void setMotion(int line, const QString &motion, double seconds);
  /// Adds a line for a local parameter that no other line has: "local[3].x".
  void add();
  /// Returns the words of animations, without "turn" unless the line's value has x, y and z.
  [[nodiscard]] QStringList motionsOf(int line) const;
  /// Returns the document's text with the held values.
  [[nodiscard]] QString liveText() const;

  /// Returns a number as a short text that reads back as the same float.
  [[nodiscard]] static QString numberText(double value);

Q_SIGNALS:
  /// Reports that lines were added, removed or moved.
  void linesChanged();
  /// Reports that a held value moved.
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
