#pragma once
#include <QWidget>

namespace arbiter::builder {

class CodeEditor;

/// Shows line numbers, marks of problems and native costs left of the text.
class Gutter : public QWidget {
public:
  explicit Gutter(CodeEditor &editor);

  [[nodiscard]] QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent *event) override;
  void mousePressEvent(QMouseEvent *event) override;
  bool event(QEvent *event) override;

private:
  [[nodiscard]] int lineAt(int y) const;

  CodeEditor &m_editor;
};

} // namespace arbiter::builder
