#pragma once
#include <QWidget>

namespace arbiter::builder {

class CodeEditor;

/// Left of the text: line numbers, marks of problems; and what each line costs on the card.
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
