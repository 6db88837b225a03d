#pragma once
#include <QHash>
#include <QImage>
#include <QJsonObject>
#include <QObject>
#include <array>
#include <optional>

#include "apps/builder/model/language/problem.h"

namespace arbiter::builder {

/// Options for drawing documents; an empty one is the renderer's choice.
struct RenderOptions {
  QString profile, numerics, backend;
  bool bare = false; ///< uses the host's implementation, without the layer
  bool operator==(const RenderOptions &) const = default;
};

/// A document to draw.
struct Scene {
  QString text;
  QString name;                  ///< "twirl.fp", for messages and for the kind of the text
  QString folder;                ///< the folder of the files that it names
  QHash<QString, QString> files; ///< texts that replace files of these names
  qint64 revision = 0;           ///< the document's
};

/// A picture. Rows go from top to bottom, with 4 bytes a pixel.
struct Frame {
  QImage image;
  qint64 revision = 0;
  qint64 number = 0;
  double time = 0;         ///< of the animation, in seconds
  double milliseconds = 0; ///< time that drawing took
  int steps = 0;           ///< with feedback: the number of frames so far; else 0
};

/// A renderer's answer to a scene.
struct SceneAnswer {
  qint64 revision = 0;
  bool ok = false;
  bool superseded = false; ///< a newer scene came first, and nothing was done
  bool animated = false;
  double milliseconds = 0;
  QList<Problem> problems;
};

/// A component of a parameter that is set while a scene is drawn.
struct LiveValue {
  QString stage = QStringLiteral("fragment"); ///< or "vertex"
  QString kind = QStringLiteral("local");     ///< or "env"
  int index = 0;
  std::array<std::optional<double>, 4> value; ///< components without a value stay
};

/// A process that draws documents. It may end at any time, and then gets all its state again.
class Renderer : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  virtual void start(const RenderOptions &options, const QString &folder) = 0;
  /// Draws a scene. The next one is sent when this one is answered.
  virtual void draw(const Scene &scene) = 0;
  /// Sets a live value. \returns false if the renderer does not support it; the scene's text must
  /// then contain the value.
  virtual bool setParameter(const LiveValue &) { return false; }
  virtual void setPaused(bool) {}
  virtual void step(double /*seconds*/) {}
  /// Sets the animation's time; if paused, draws one frame.
  virtual void setTime(double /*seconds*/) {}
  /// With feedback: continues, or restarts, until that many frames are drawn. Each call yields a
  /// frame, whose steps tell how far it got.
  virtual void setSteps(int /*steps*/) {}
  /// Draws that many frames as fast as possible, and reports by benched(). Returns false if
  /// unsupported.
  virtual bool bench(int /*frames*/) { return false; }
  /// Ends the process at once.
  virtual void kill() = 0;
  [[nodiscard]] virtual qint64 processId() const = 0;
  /// Returns false if the process ended before it could draw anything; the text is not at fault
  /// then.
  [[nodiscard]] virtual bool wasReady() const { return true; }

Q_SIGNALS:
  void drew(const arbiter::builder::Frame &frame);
  void answered(const arbiter::builder::SceneAnswer &answer);
  void benched(int frames, double milliseconds, double median);
  /// Reports how long a scene has been compiling.
  void busy(double milliseconds);
  void ended(const QString &why);
  /// Reports that this installation lacks this kind of renderer.
  void unsupported();
};

} // namespace arbiter::builder
