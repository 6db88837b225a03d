#include "fp_compiler/hw/r300/lower/rows.h"

#include <bit>

namespace arbiter::fp::hw::r300 {

namespace {
bool same(const ir::Parameter &a, const ir::Parameter &b) {
  if (a.kind != b.kind)
    return false;
  if (a.kind == ir::ParameterKind::State)
    return a.state == b.state;
  return a.index == b.index;
}
} // namespace

std::uint16_t Rows::add(const Constant &constant, std::uint8_t filled, bool known) {
  m_rows.push_back({constant, filled, known});
  return std::uint16_t(m_rows.size() - 1);
}

std::uint16_t Rows::parameter(std::uint16_t index, std::uint16_t origin) {
  if (m_ofParameter[index] != kNone)
    return m_ofParameter[index];
  for (std::size_t i = 0; i < searched(); ++i)
    if (m_rows[i].constant.kind == Constant::Kind::Parameter && !m_rows[i].known &&
        same(m_program.parameters[m_rows[i].constant.index], m_program.parameters[index]))
      return m_ofParameter[index] = std::uint16_t(i);
  return m_ofParameter[index] = add({Constant::Kind::Parameter, index, {}, origin}, 0xF, false);
}

std::uint16_t Rows::own(Constant::Kind kind, std::uint16_t index, std::uint16_t origin) {
  for (std::size_t i = 0; i < searched(); ++i)
    if (m_rows[i].constant.kind == kind && m_rows[i].constant.index == index)
      return std::uint16_t(i);
  return add({kind, index, {}, origin}, 0xF, false);
}

std::uint16_t Rows::known(std::uint16_t parameter, std::uint16_t origin) {
  if (m_ofParameter[parameter] == kNone)
    m_ofParameter[parameter] = add(
        {Constant::Kind::Parameter, parameter, m_program.parameters[parameter].constant, origin},
        0xF, true);
  return m_ofParameter[parameter];
}

bool Rows::find(const Row &row, const Refs &literals, std::uint8_t components, Place &place) const {
  if (!row.known)
    return false;
  for (std::uint8_t select = 0; select < std::uint8_t(RgbSelect::Zero); ++select)
    for (const bool negate : {false, true}) {
      bool fits = true;
      for (std::size_t c = 0; fits && c < 3; ++c) {
        const std::uint8_t tap = kTaps[select][c];
        const float value = row.constant.value[tap];
        fits = !(components >> c & 1) ||
               ((row.filled >> tap & 1) && sameNumber(literals[c].value, negate ? -value : value));
      }
      if (fits) {
        place.select = select;
        place.negate = negate;
        return true;
      }
    }
  return false;
}

bool Rows::place(Row &row, const Refs &literals, std::uint8_t components, Place &place) const {
  if (row.constant.kind != Constant::Kind::Value)
    return false;
  const std::size_t first = std::size_t(std::countr_zero(components));
  bool equal = true;
  for (std::size_t c = first; c < 3; ++c)
    equal &= !(components >> c & 1) || sameNumber(literals[c].value, literals[first].value);
  if (equal) // fits in any free component
    for (const std::uint8_t c : {3, 2, 1, 0})
      if (!(row.filled >> c & 1)) {
        row.constant.value[c] = literals[first].value;
        row.filled |= std::uint8_t(1 << c);
        place.select = std::uint8_t(std::uint8_t(RgbSelect::Xxx) + c);
        place.negate = false;
        return true;
      }
  for (std::size_t c = 0; c < 3; ++c)
    if ((components >> c & 1) && (row.filled >> c & 1) &&
        !sameNumber(row.constant.value[c], literals[c].value))
      return false;
  for (std::size_t c = 0; c < 3; ++c)
    if (components >> c & 1)
      row.constant.value[c] = literals[c].value;
  row.filled |= components;
  place.select = std::uint8_t(RgbSelect::Xyz);
  place.negate = false;
  return true;
}

Rows::Place Rows::rgb(const Refs &literals, std::uint8_t components, std::uint16_t origin) {
  Place result;
  for (std::size_t i = 0; i < searched(); ++i)
    if (find(m_rows[i], literals, components, result)) {
      result.row = std::uint16_t(i);
      return result;
    }
  std::uint16_t parameter = kNone;
  bool one = true;
  for (std::size_t c = 0; c < 3; ++c)
    if (components >> c & 1) {
      one &= literals[c].index != kNone && (parameter == kNone || parameter == literals[c].index);
      parameter = std::uint16_t(literals[c].index);
    }
  if (one && parameter != kNone && m_ofParameter[parameter] == kNone) {
    const Row whole = {
        {Constant::Kind::Parameter, parameter, m_program.parameters[parameter].constant, origin},
        0xF,
        true};
    if (find(whole, literals, components, result)) {
      result.row = known(parameter, origin);
      return result;
    }
  }
  for (std::size_t i = 0; i < searched(); ++i)
    if (place(m_rows[i], literals, components, result)) {
      result.row = std::uint16_t(i);
      return result;
    }
  result.row = add({Constant::Kind::Value, 0, {}, origin}, 0, true);
  (void)place(m_rows[result.row], literals, components, result);
  return result;
}

Rows::Place Rows::at(const Refs &literals, std::uint8_t components, std::uint8_t select,
                     std::uint16_t origin) {
  const auto holds = [&](const Row &row, bool negate, bool orFree) {
    if (!row.known || (orFree && row.constant.kind != Constant::Kind::Value))
      return false;
    for (std::size_t c = 0; c < 3; ++c) {
      if (!(components >> c & 1))
        continue;
      const std::uint8_t tap = kTaps[select][c];
      const float value = row.constant.value[tap];
      if (row.filled >> tap & 1 ? !sameNumber(negate ? -value : value, literals[c].value) : !orFree)
        return false;
    }
    return true;
  };
  for (std::size_t i = 0; i < searched(); ++i)
    for (const bool negate : {false, true})
      if (holds(m_rows[i], negate, false))
        return {std::uint16_t(i), select, negate};
  std::size_t chosen = 0;
  while (chosen < searched() && !holds(m_rows[chosen], false, true))
    ++chosen;
  if (chosen == searched())
    chosen = add({Constant::Kind::Value, 0, {}, origin}, 0, true);
  for (std::size_t c = 0; c < 3; ++c)
    if (components >> c & 1) {
      m_rows[chosen].constant.value[kTaps[select][c]] = literals[c].value;
      m_rows[chosen].filled |= std::uint8_t(1 << kTaps[select][c]);
    }
  return {std::uint16_t(chosen), select, false};
}

Rows::Place Rows::alpha(const Ref &literal, std::uint16_t origin) {
  Place result;
  const auto within = [&](std::size_t i) {
    const Row &row = m_rows[i];
    // Try the fourth component first: it needs no RGB address.
    for (const std::uint8_t c : {3, 0, 1, 2})
      if (row.known && (row.filled >> c & 1))
        for (const bool negate : {false, true})
          if (sameNumber(negate ? -row.constant.value[c] : row.constant.value[c], literal.value)) {
            result = {std::uint16_t(i), c, negate};
            return true;
          }
    return false;
  };
  for (std::size_t i = 0; i < searched(); ++i)
    if (within(i))
      return result;
  if (literal.index != kNone && m_ofParameter[literal.index] == kNone &&
      within(known(std::uint16_t(literal.index), origin)))
    return result;
  for (std::size_t i = 0; i < searched(); ++i)
    for (const std::uint8_t c : {3, 0, 1, 2})
      if (m_rows[i].constant.kind == Constant::Kind::Value && !(m_rows[i].filled >> c & 1)) {
        m_rows[i].constant.value[c] = literal.value;
        m_rows[i].filled |= std::uint8_t(1 << c);
        return {std::uint16_t(i), c, false};
      }
  result.row = add({Constant::Kind::Value, 0, {}, origin}, 8, true);
  m_rows[result.row].constant.value[3] = literal.value;
  result.select = std::uint8_t(AlphaSelect::W);
  result.negate = false;
  return result;
}

} // namespace arbiter::fp::hw::r300
