#include "tests/support/literal_text.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "engine/model/block/literal.hpp"

namespace stepwire {

namespace {

class PlainWriter final : public LiteralWriter {
 public:
  std::string whole(std::int64_t value) override { return std::to_string(value); }
  std::string natural(std::uint64_t value) override { return std::to_string(value) + "u"; }
  std::string number(double value) override { return fmt::format("{}", value); }
  std::string flag(bool value) override { return value ? "true" : "false"; }
  std::string enumerator(int value, const std::string& type) override {
    return fmt::format("{}({})", type, value);
  }
  std::string numbers(const double* values, Index size) override {
    return fmt::format("{{{}}}", fmt::join(values, values + size, ", "));
  }
};

}  // namespace

std::string literal_text(const BlockType& type, const void* block, const std::string& member) {
  PlainWriter writer;
  for (const MemberSpec& spec : type.members)
    if (spec.member == member) return spec.literal(block, writer);
  FAIL(type.name << " declares no member " << member);
  return "";
}

}  // namespace stepwire
