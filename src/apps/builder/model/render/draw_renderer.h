#pragma once
#include <QElapsedTimer>
#include <QProcess>
#include <QTemporaryDir>

#include "apps/builder/model/render/renderer.h"

namespace arbiter::builder {

/// Draws each scene by a process of `arbiter draw`, for installations without `arbiter render`. It
/// draws one frame each, without animation.
class DrawRenderer : public Renderer {
  Q_OBJECT
public:
  DrawRenderer(QString program, QObject *parent = nullptr)
      : Renderer(parent), m_program(std::move(program)) {}
  ~DrawRenderer() override;

  void start(const RenderOptions &options, const QString &folder) override;
  void draw(const Scene &scene) override;
  void kill() override;
  [[nodiscard]] qint64 processId() const override { return m_process ? m_process->processId() : 0; }

private:
  void finished(int code, QProcess::ExitStatus status);

  QString m_program;
  RenderOptions m_options;
  Scene m_scene;
  QTemporaryDir m_folder;
  QProcess *m_process = nullptr;
  QElapsedTimer m_since;
};

} // namespace arbiter::builder
