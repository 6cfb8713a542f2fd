#include "engine/simulate/codegen/functions.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stepwire::codegen {

namespace {

constexpr std::size_t longest = 60;  // pieces of code per function

}  // namespace

std::string Functions::attribute() const {
  return small_ ? "[[gnu::always_inline, gnu::flatten, maybe_unused]] inline"
                : "[[gnu::noinline, gnu::flatten, maybe_unused]] inline";
}

void Functions::add(const std::string& name, const std::string& parameters, const std::string& arguments,
                    const std::vector<Code>& code) {
  if (code.size() <= longest || small_) {
    text_ += fmt::format("{} void {}({}) {{\n{}}}\n\n", attribute(), name, parameters,
                         with_conditions(code, 0, code.size()));
    return;
  }
  std::string calls;
  for (std::size_t first = 0, part = 1; first < code.size(); first += longest, ++part) {
    text_ += fmt::format("{} void {}_{}({}) {{\n{}}}\n\n", attribute(), name, part, parameters,
                         with_conditions(code, first, std::min(first + longest, code.size())));
    calls += fmt::format("  {}_{}({});\n", name, part, arguments);
  }
  text_ += fmt::format("inline void {}({}) {{\n{}}}\n\n", name, parameters, calls);
}

}  // namespace stepwire::codegen
