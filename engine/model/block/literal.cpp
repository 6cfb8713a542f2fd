#include "engine/model/block/literal.hpp"

#include <fmt/format.h>

namespace stepwire {

std::string LiteralWriter::function(const std::string& expression) {
  if (expression.empty()) return "Function()";
  const bool reads = expression.find("v[") != std::string::npos;  // an unused name would cause a warning
  return fmt::format("Function([](const double*{}) -> double {{ return {}; }})", reads ? " v" : "",
                     expression);
}

std::string Literal<Numbers>::text(const Numbers& value, LiteralWriter& writer) {
  if (value.empty()) return "Numbers()";
  if (value.size() == 1) return fmt::format("Numbers(1, {})", writer.number(value[0]));
  const std::string place = writer.numbers(value.data(), value.size());
  return fmt::format("Numbers::view({}, {})", place, writer.whole(value.size()));
}

std::string Literal<PerElement>::text(const PerElement& value, LiteralWriter& writer) {
  if (value.size() == 1) return writer.number(value[0]);
  std::vector<double> counted{-static_cast<double>(value.size())};
  counted.insert(counted.end(), value.begin(), value.end());
  return fmt::format("PerElement::view({})",
                     writer.numbers(counted.data(), static_cast<Index>(counted.size())));
}

std::string Literal<Matrix>::text(const Matrix& value, LiteralWriter& writer) {
  const std::string rows = writer.whole(value.rows()), columns = writer.whole(value.columns());
  return fmt::format("Matrix({}, {}, {})", rows, columns, Literal<Numbers>::text(value.elements(), writer));
}

std::string Literal<Function>::text(const Function& value, LiteralWriter& writer) {
  return writer.function(value.source() ? value.source()->cpp() : "");
}

std::string Literal<Rational>::text(const Rational& value, LiteralWriter& writer) {
  return fmt::format("Rational{{{}, {}, {}}}", Literal<Numbers>::text(value.a, writer),
                     Literal<Numbers>::text(value.c, writer), writer.number(value.direct));
}

}  // namespace stepwire
