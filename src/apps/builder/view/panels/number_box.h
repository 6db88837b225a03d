#pragma once
#include <QDoubleSpinBox>
#include <QWheelEvent>

#include "apps/builder/model/panels/parameters.h"

namespace arbiter::builder {

/// A number field that keeps the text's spelling instead of a fixed count of digits. The wheel
/// changes it only while it has the focus, so that scrolling a panel changes nothing.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

public:
  NumberBox(double low, double high, const QString &name) {
    setDecimals(9);
    setRange(low, high);
    setStepType(AdaptiveDecimalStepType);
    setKeyboardTracking(false);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(name);
    setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("-0000.000")) + 30);
  }

  [[nodiscard]] QString textFromValue(double value) const override {
    return Parameters::numberText(value);
  }
  [[nodiscard]] double valueFromText(const QString &text) const override { return text.toDouble(); }
  QValidator::State validate(QString &text, int &) const override {
    bool ok = false;
    const double value = text.toDouble(&ok);
    if (ok)
      return value >= minimum() && value <= maximum() ? QValidator::Acceptable
                                                      : QValidator::Intermediate;
    static const QString kPartial = QStringLiteral("+-.0123456789eE");
    for (const QChar c : text)
      if (!kPartial.contains(c))
        return QValidator::Invalid;
    return QValidator::Intermediate;
  }
  [[nodiscard]] QSize sizeHint() const override { return minimumSizeHint(); }
  [[nodiscard]] QSize minimumSizeHint() const override {
    return {minimumWidth(), QDoubleSpinBox::minimumSizeHint().height()};
  }

protected:
  void wheelEvent(QWheelEvent *event) override {
    if (hasFocus())
      QDoubleSpinBox::wheelEvent(event);
    else
      event->ignore();
  }
};

} // namespace arbiter::builder
