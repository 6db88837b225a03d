#pragma once
#include <QElapsedTimer>
#include <QSet>
#include <QTimer>
#include <functional>
#include <optional>

#include "apps/builder/model/render/renderer.h"

namespace arbiter::builder {

/// Draws the newest scene, whatever happens to the drawing process. One scene is in progress at a
/// time, and the newest waiting one is next. A process that ends is restarted. A text that ended it
/// twice, or blocked it for long, is held: it is not drawn again until it changes or drawAnyway()
/// is called. Held texts are remembered across sessions.
class RendererSession : public QObject {
  Q_OBJECT
public:
  enum class State { Idle, Drawing, Held };
  using Factory = std::function<Renderer *(QObject *parent)>;

  /// \param factories the kinds of renderer, the best first; the next one is used if one is not
  /// installed
  /// \param memory the file that remembers held texts; empty: none
  RendererSession(QList<Factory> factories, const QString &memory, QObject *parent = nullptr);
  ~RendererSession() override;

  /// Requests the newest scene.
  void want(const Scene &scene);
  void setOptions(const RenderOptions &options);
  [[nodiscard]] const RenderOptions &options() const { return m_options; }
  /// Returns the options in use: options(), with the document's where those are empty.
  [[nodiscard]] const RenderOptions &effectiveOptions() const { return m_started; }
  bool setParameter(const LiveValue &value);
  void setPaused(bool paused);
  [[nodiscard]] bool isPaused() const { return m_paused; }
  /// Stops the animation's own time: it then advances only by step(), whether paused or not.
  void setHeldBack(bool heldBack);
  void step(double seconds);
  void setTime(double seconds);
  void setSteps(int steps);
  bool bench(int frames);

  /// Stops the drawing in progress and holds its text.
  void stop();
  /// Draws the held text.
  void drawAnyway();

  [[nodiscard]] State state() const { return m_state; }
  [[nodiscard]] const Frame &lastGood() const { return m_lastGood; }
  [[nodiscard]] std::optional<Scene> lastGoodScene() const { return m_lastGoodScene; }
  [[nodiscard]] qint64 processId() const { return m_renderer ? m_renderer->processId() : 0; }
  [[nodiscard]] int restarts() const { return m_restarts; }

  void setPatience(int milliseconds) { m_patience.setInterval(milliseconds); }

Q_SIGNALS:
  void drew(const arbiter::builder::Frame &frame);
  void answered(const arbiter::builder::SceneAnswer &answer);
  void benched(int frames, double milliseconds, double median);
  /// Reports how long a slow scene has taken so far.
  void busy(double milliseconds);
  /// Reports that this revision is held; the text tells why.
  void held(qint64 revision, const QString &why);
  void restarted(const QString &why);

private:
  void startRenderer();
  void dropRenderer();
  void sendNext();
  void ended(const QString &why);
  void take(const SceneAnswer &answer);
  void takeFrame(const Frame &frame);
  void hold(const Scene &scene, const QString &why);
  void setState(State state) { m_state = state; }
  void remember();

  QList<Factory> m_factories;
  QString m_memory;
  Renderer *m_renderer = nullptr;
  RenderOptions m_options;
  QString m_folder; ///< the folder that the renderer was started with
  /// The options it was started with: m_options, with the document's where those are empty
  RenderOptions m_started;

  std::optional<Scene> m_waiting;  ///< the newest, not sent yet
  std::optional<Scene> m_underWay; ///< sent, not answered
  std::optional<Scene> m_lastHeld;
  std::optional<Scene> m_lastGoodScene;
  Frame m_lastGood;
  State m_state = State::Idle;
  bool m_paused = false, m_heldBack = false;

  QSet<QByteArray> m_held; ///< hashes of held texts
  QByteArray m_suspect;    ///< the hash of the text that last ended the renderer
  int m_restarts = 0;
  QElapsedTimer m_since; ///< since the scene in progress was sent
  QTimer m_patience;
  QTimer m_tick;
  QTimer m_restart;
};

} // namespace arbiter::builder
