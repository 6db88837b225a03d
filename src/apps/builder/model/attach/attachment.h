#pragma once
#include <QObject>
#include <QPoint>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "apps/builder/model/attach/attached.h"
#include "apps/builder/model/language/problem.h"
#include "apps/builder/model/panels/tool_run.h"
#include "apps/builder/model/render/control_client.h"

namespace arbiter::builder {

/// Inspects and changes a running application through its socket. detach() undoes all changes in
/// the application, and so does the end of this process.
class Attachment : public QObject {
  Q_OBJECT
public:
  /// \param arbiter the command, for pixels (`arbiter ctl trace`)
  explicit Attachment(const QString &arbiter, QObject *parent = nullptr);
  ~Attachment() override;

  /// Attaches to a process; reports a failure by troubled().
  void attach(const ListeningProcess &process);
  void detach();
  [[nodiscard]] bool isAttached() const { return m_client != nullptr; }
  [[nodiscard]] const ListeningProcess &process() const { return m_process; }

  /// Turns periodic updates of the lists on while they are visible.
  void setWatched(bool watched);
  void refresh();

  [[nodiscard]] const QList<AttachedProgram> &programs() const { return m_programs; }
  [[nodiscard]] const QList<AttachedParameter> &parameters() const { return m_parameters; }
  [[nodiscard]] const QList<AttachedTexture> &textures() const { return m_textures; }
  [[nodiscard]] const QImage &picture() const { return m_picture; }

  // --- One program ---

  /// Selects a program; textCame() delivers its text.
  void select(const QString &id);
  [[nodiscard]] const QString &selected() const { return m_selected; }
  /// Returns the application's own text of the selected program.
  [[nodiscard]] const QString &ownText() const { return m_ownText; }
  /// Makes the application draw with the text from its next frame on, if it is valid; judged()
  /// reports that. If several texts wait, only the newest is sent.
  void setText(const QString &text);
  /// Returns the diagnostics of the last text that was sent.
  [[nodiscard]] const QList<Problem> &problems() const { return m_problems; }
  [[nodiscard]] bool isRight() const { return m_right; }
  /// Restores the application's own text.
  void putBack();
  void setEnabled(bool enabled);
  void setParameter(const QString &name, const std::array<double, 4> &value);
  void letGo(const QString &name);

  // --- The whole ---

  /// Measures pixels and time of each program in the next frame.
  void measure();
  /// Writes every text that is drawn with to a folder, for `arbiter run --replace FOLDER`;
  /// exported() reports it.
  void exportTo(const QString &folder);
  /// Traces a pixel of the frame, counted from the left and from the bottom.
  void tracePixel(QPoint pixel);
  /// Returns the pixel of the last trace.
  [[nodiscard]] std::optional<QPoint> tracedPixel() const { return m_pixel; }

Q_SIGNALS:
  void attachedChanged();
  void programsChanged();
  void parametersChanged();
  void texturesChanged();
  void pictureChanged();
  /// Delivers the selected program's text that is drawn with.
  void textCame(const QString &text);
  void judged();
  void exported(const QString &folder, int programs);
  /// Delivers a document of `arbiter ctl trace --json`.
  void traced(const QJsonObject &json);
  void busy(double milliseconds);
  /// Reports a message for the user.
  void troubled(const QString &why);

private:
  using Take = std::function<void(const QJsonObject &result)>;
  void ask(const QString &method, const QJsonObject &params, const Take &take);
  void takePrograms(const QJsonObject &answer);
  void takeTextures(const QJsonObject &answer);
  void takeVerdict(const QJsonObject &answer, const QString &text);
  void sendText();
  void exportNext(const QString &folder, QStringList left, int done);
  void lost(const QString &why);

  ToolRun m_tracer;
  std::unique_ptr<ControlClient> m_client;
  ListeningProcess m_process;
  QTimer m_again;
  QList<AttachedProgram> m_programs;
  QList<AttachedParameter> m_parameters;
  QList<AttachedTexture> m_textures;
  QImage m_picture;
  QString m_selected, m_ownText;
  QList<Problem> m_problems;
  bool m_right = true;
  std::optional<QString> m_waiting; ///< a text to send when the previous one is answered
  bool m_sending = false;
  qint64 m_revision = 0;
  int m_round = 0;
  std::optional<QPoint> m_pixel;
  QHash<QString, MeasuredCost> m_measured;
};

} // namespace arbiter::builder
