#include "engine/block/literal.hpp"

#include <fmt/format.h>

namespace stepwire {

namespace {

/// How many there are, as a whole number.
std::string count_text(Index count, LiteralWriter& writer) {
  const std::string number = writer.number(static_cast<double>(count));
  const bool is_written = number.find_first_not_of("0123456789.") == std::string::npos;
  return is_written ? number.substr(0, number.find('.')) : fmt::format("static_cast<Index>({})", number);
}

}  // namespace

std::string Literal<Numbers>::text(const Numbers& value, LiteralWriter& writer) {
  if (value.empty()) return "Numbers()";
  if (value.size() == 1) return fmt::format("Numbers(1, {})", writer.number(value[0]));
  const std::string first = writer.numbers(value.data(), value.size());
  return fmt::format("Numbers::view({}, {})", first, count_text(value.size(), writer));
}

std::string Literal<PerElement>::text(const PerElement& value, LiteralWriter& writer) {
  if (value.size() == 1) return writer.number(value[0]);
  std::vector<double> counted{-static_cast<double>(value.size())};
  counted.insert(counted.end(), value.begin(), value.end());
  return fmt::format("PerElement::view({})",
                     writer.numbers(counted.data(), static_cast<Index>(counted.size())));
}

std::string Literal<Matrix>::text(const Matrix& value, LiteralWriter& writer) {
  const std::string rows = count_text(value.rows(), writer), columns = count_text(value.columns(), writer);
  return fmt::format("Matrix({}, {}, {})", rows, columns, Literal<Numbers>::text(value.elements(), writer));
}

std::string Literal<Function>::text(const Function& value, LiteralWriter&) {
  if (!value.source()) return "Function()";
  const std::string code = value.source()->cpp();
  const bool reads = code.find("v[") != std::string::npos;  // a name that nothing reads is warned of
  return fmt::format("Function([](const double*{}) -> double {{ return {}; }})", reads ? " v" : "", code);
}

std::string Literal<Rational>::text(const Rational& value, LiteralWriter& writer) {
  return fmt::format("Rational{{{}, {}, {}}}", Literal<Numbers>::text(value.a, writer),
                     Literal<Numbers>::text(value.c, writer), writer.number(value.direct));
}

}  // namespace stepwire
