#pragma once
#include <QObject>
#include <QTimer>
#include <memory>

#include "apps/builder/model/render/session.h"

namespace arbiter::builder {

/// The frames of a document to write to files.
struct SequenceRequest {
  QString folder; ///< created if it does not exist
  QString name;   ///< "twirl": twirl-0000.png, twirl-0001.png, ...
  int first = 0;
  int frames = 1;
  double rate = 60; ///< frames a second of the document
};

/// Writes frames of a document to PNG files, by a renderer of its own, so that the window's
/// continues. Frame N is the picture of `arbiter draw --frame N`.
class SequenceExport : public QObject {
  Q_OBJECT
public:
  /// \param arbiter the command
  explicit SequenceExport(QString arbiter, QObject *parent = nullptr);

  void start(const Scene &scene, const RenderOptions &options, const SequenceRequest &request);
  /// Stops; files that are written stay.
  void cancel();
  [[nodiscard]] bool isRunning() const { return m_session != nullptr; }
  [[nodiscard]] int written() const { return m_written; }
  [[nodiscard]] static QString fileOf(const SequenceRequest &request, int frame);
  void setPatience(int milliseconds) { m_patience.setInterval(milliseconds); }

Q_SIGNALS:
  void progressed(int written, int frames);
  /// Reports the end. \param complaint why not all frames are written; empty: they are, or it was
  /// cancelled
  void finished(const QString &complaint);

private:
  void take(const Frame &frame);
  void answered(const SceneAnswer &answer);
  void end(const QString &complaint);

  QString m_arbiter;
  std::unique_ptr<RendererSession> m_session;
  SequenceRequest m_request;
  int m_written = 0;
  QTimer m_patience; ///< for each frame
};

} // namespace arbiter::builder
