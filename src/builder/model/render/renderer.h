#pragma once
#include <QHash>
#include <QImage>
#include <QJsonObject>
#include <QObject>
#include <array>
#include <optional>

#include "builder/model/language/problem.h"

namespace arbiter::builder {

/// How documents are drawn; empty is the renderer's own choice.
struct RenderOptions {
  QString profile, numerics, backend;
  bool bare = false; ///< the host's own implementation, without the layer
  bool operator==(const RenderOptions &) const = default;
};

/// A document to be drawn.
struct Scene {
  QString text;
  QString name;                  ///< "twirl.fp": for messages, and what the text's kind is told by
  QString folder;                ///< where the files that it names are looked for
  QHash<QString, QString> files; ///< texts in place of files of these names
  qint64 revision = 0;           ///< the document's
};

/// A picture. Rows from the top, 4 bytes a pixel.
struct Frame {
  QImage image;
  qint64 revision = 0;
  qint64 number = 0;
  double time = 0;         ///< seconds, of the animation
  double milliseconds = 0; ///< that drawing it took
  int steps = 0;           ///< with feedback: the frames so far, which it follows from; else 0
};

/// What a renderer says of a scene.
struct SceneAnswer {
  qint64 revision = 0;
  bool ok = false;
  bool superseded = false; ///< a newer one came first; nothing was done
  bool animated = false;
  double milliseconds = 0;
  QList<Problem> problems;
};

/// A component of a parameter, set while a scene is drawn.
struct LiveValue {
  QString stage = QStringLiteral("fragment"); ///< or "vertex"
  QString kind = QStringLiteral("local");     ///< or "env"
  int index = 0;
  std::array<std::optional<double>, 4> value; ///< components without one stay
};

/// A process that draws documents. It may end at any time: all that it knows is sent again.
class Renderer : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  virtual void start(const RenderOptions &options, const QString &folder) = 0;
  /// One at a time: the next is sent when this one is answered.
  virtual void draw(const Scene &scene) = 0;
  /// \returns false where live values are not offered: the scene's text must say them then.
  virtual bool setParameter(const LiveValue &) { return false; }
  virtual void setPaused(bool) {}
  virtual void step(double /*seconds*/) {}
  /// Time of the animation from now on; paused, one frame is drawn.
  virtual void setTime(double /*seconds*/) {}
  /// With feedback: goes on, or begins anew, until so many frames are drawn. A frame comes for each
  /// call; its steps say how far it came.
  virtual void setSteps(int /*steps*/) {}
  /// So many frames as fast as they go; answered by benched(), where that is offered.
  virtual bool bench(int /*frames*/) { return false; }
  /// Ends the process at once.
  virtual void kill() = 0;
  [[nodiscard]] virtual qint64 processId() const = 0;
  /// False of a process that ended before it could draw anything: no text is at fault then.
  [[nodiscard]] virtual bool wasReady() const { return true; }

Q_SIGNALS:
  void drew(const arbiter::builder::Frame &frame);
  void answered(const arbiter::builder::SceneAnswer &answer);
  void benched(int frames, double milliseconds, double median);
  /// A scene has been compiling for so long.
  void busy(double milliseconds);
  void ended(const QString &why);
  /// This kind of renderer is not in this installation.
  void unsupported();
};

} // namespace arbiter::builder
