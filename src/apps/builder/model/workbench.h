#pragma once
#include <QObject>

#include "apps/builder/model/language/gauges.h"
#include "apps/builder/model/language/lsp_client.h"
#include "apps/builder/model/panels/parameters.h"
#include "apps/builder/model/panels/tool_run.h"
#include "apps/builder/model/panels/trace.h"
#include "apps/builder/model/panels/words.h"
#include "apps/builder/model/render/compare.h"
#include "apps/builder/model/render/session.h"
#include "apps/builder/model/text/open_file.h"

namespace arbiter::builder {

/// Paths that the window uses.
struct Places {
  QString arbiter;  ///< the command
  QString journals; ///< a folder
  QString held;     ///< the file that remembers texts that stopped the renderer
  QString gallery;  ///< a folder of documents; empty: none

  /// Returns the paths beside the executable, in its build tree or installation, and in the user's
  /// state folder.
  [[nodiscard]] static Places standard();
};

/// The relation of the picture to the text.
enum class PictureState {
  None,    ///< nothing has been drawn yet
  Newest,  ///< it shows the text
  Waiting, ///< the text is being drawn
  Wrong,   ///< the text is invalid; an older one is shown
  Held,    ///< the text stopped the renderer; an older one is shown
};

/// One document with all its services: the window without widgets.
class Workbench : public QObject {
  Q_OBJECT
public:
  explicit Workbench(Places places, QObject *parent = nullptr);

  [[nodiscard]] const Places &places() const { return m_places; }
  [[nodiscard]] OpenFile &file() { return m_file; }
  [[nodiscard]] Document &document() { return m_file.document(); }
  [[nodiscard]] LspClient &language() { return m_lsp; }
  [[nodiscard]] RendererSession &renderer() { return m_session; }
  /// Returns the session of the picture that the newest is compared with, drawn in another process.
  [[nodiscard]] RendererSession &other() { return m_other; }
  [[nodiscard]] Parameters &parameters() { return m_parameters; }
  [[nodiscard]] Trace &trace() { return m_trace; }

  /// Starts the language server and draws. Call it once, with or without an open document.
  void start();
  void setProfile(const QString &profile);
  void setNumerics(const QString &numerics);
  void setBackend(const QString &backend);

  [[nodiscard]] const QList<Problem> &problems() const { return m_problems; }
  [[nodiscard]] const Report &report() const { return m_report; }
  [[nodiscard]] PictureState pictureState() const { return m_pictureState; }
  [[nodiscard]] const QImage &picture() const { return m_frame.image; }
  [[nodiscard]] const Frame &frame() const { return m_frame; }
  /// Returns "revision 41 is wrong; revision 40 is drawn" or the like.
  [[nodiscard]] QString statusText() const;

  /// Traces a pixel of the picture, counted from the left and the bottom.
  void debugPixel(QPoint pixel);
  [[nodiscard]] std::optional<QPoint> debuggedPixel() const { return m_pixel; }
  /// Sets A to a register's values after a row of the trace, over the whole picture: [0,1] is black
  /// to white.
  void watchRow(int row);

  /// Takes the newest picture as A, with its text and options. Everything drawn from now on is B.
  void pin();
  void unpin();
  [[nodiscard]] bool isPinned() const { return !m_pinned.isNull(); }
  [[nodiscard]] const QImage &pinned() const { return m_pinned; }
  /// Draws the text with other options as A, at each change.
  void compareWith(const RenderOptions &options);
  [[nodiscard]] const QString &pinnedName() const { return m_pinnedName; }

  /// Returns the document to draw, with the values of held sliders and of a held camera.
  [[nodiscard]] Scene scene() const;

  /// Turns an orbiting camera by degrees and scales its distance. The picture follows at once, the
  /// text at releaseCamera(). \returns false if there is no such camera
  bool turnCamera(double yaw, double pitch, double distance = 1);
  /// Releases the camera: the text gets its values, as one undo step.
  void releaseCamera();

Q_SIGNALS:
  void problemsChanged();
  void reportChanged();
  void pictureChanged();
  void pinnedChanged();
  void statusChanged();
  void traceFailed(const QString &why);
  /// Reports a message for the user.
  void notice(const QString &message);

private:
  void edited();
  void draw();
  void takeOther(const Frame &frame);
  void endFollowing();
  void letGo();
  void followTime();
  void followSteps();
  void stepTogether();
  void sliderMoved(int line, int component, double value);
  void diagnosed(qint64 revision, const QList<Problem> &problems);
  void answered(const SceneAnswer &answer);
  void setState(PictureState state);
  void mergeProblems();
  [[nodiscard]] QString uri() const;
  [[nodiscard]] QStringList debugWords(QPoint pixel) const;
  struct Turn {
    double yaw = 0, pitch = 0, distance = 1;
  };

  Places m_places;
  OpenFile m_file;
  LspClient m_lsp;
  RendererSession m_session;
  /// Draws A; it is paused, and its time is set to that of each frame of B
  RendererSession m_other;
  bool m_otherIsAsked = false; ///< a frame of A was requested and has not come
  double m_otherTime = -1;     ///< time of the last requested frame of A, in seconds
  int m_otherSteps = 0;        ///< with feedback: steps of the newest frame of A; 0: none has come
  QTimer m_together;           ///< with feedback: both continue when both frames are there
  bool m_stepIsAsked = false;  ///< a step of B was requested and has not come
  QElapsedTimer m_since;       ///< with feedback: since the last frame of either
  Parameters m_parameters;
  Trace m_trace;
  ToolRun m_debugTool;
  ToolRun m_watchTool;
  QTimer m_redraw; ///< one draw for all changes within one turn of the event loop

  QList<Problem> m_ofLanguage, m_ofRenderer, m_problems;
  Report m_report;
  Frame m_frame;
  PictureState m_pictureState = PictureState::None;
  QString m_why; ///< the reason of Held
  double m_busy = 0;
  std::optional<QPoint> m_pixel;
  QImage m_pinned;
  QString m_pinnedName;
  std::optional<Turn> m_turn; ///< a held camera's rotation relative to the text's
  std::optional<RenderOptions> m_otherOptions;
  qint64 m_drawNumber = 0;            ///< counts scenes; held sliders draw one revision many times
  QHash<qint64, qint64> m_revisionOf; ///< the document's revision, by draw number
};

} // namespace arbiter::builder
