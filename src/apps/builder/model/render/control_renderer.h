#pragma once
#include <QProcess>
#include <memory>

#include "apps/builder/model/render/control_client.h"
#include "apps/builder/model/render/renderer.h"

namespace arbiter::builder {

/// Draws by `arbiter render`, over a socket that the process inherits (docs/write/control.md).
class ControlRenderer : public Renderer {
  Q_OBJECT
public:
  ControlRenderer(QString program, QObject *parent = nullptr)
      : Renderer(parent), m_program(std::move(program)) {}
  ~ControlRenderer() override;

  void start(const RenderOptions &options, const QString &folder) override;
  void draw(const Scene &scene) override;
  bool setParameter(const LiveValue &value) override;
  void setPaused(bool paused) override;
  void step(double seconds) override;
  void setTime(double seconds) override;
  void setSteps(int steps) override;
  bool bench(int frames) override;
  void kill() override;
  [[nodiscard]] qint64 processId() const override { return m_process ? m_process->processId() : 0; }

  [[nodiscard]] bool wasReady() const override { return m_greeted; }

private:
  void finish(const QString &why);
  void take(const QString &method, const QJsonObject &params);
  void takeFrame(const QImage &image, const QJsonObject &params);
  void answer(const QJsonObject &result, const QJsonObject &error, const Scene &scene);

  QString m_program;
  QProcess *m_process = nullptr;
  std::unique_ptr<ControlClient> m_client;
  bool m_greeted = false;            ///< it has answered, so that it is a renderer
  qint64 m_sent = 0;                 ///< number of scenes sent, which numbers them in the protocol
  QHash<qint64, qint64> m_revisions; ///< the document's revision, by that number
};

} // namespace arbiter::builder
