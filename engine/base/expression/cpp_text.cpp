#include "engine/base/expression/cpp_text.hpp"

#include <vector>

#include "engine/base/expression/cpp_piece.hpp"
#include "engine/base/expression/fold.hpp"

namespace stepwire::expression {
namespace {

struct MakeCpp {
  const VariableText& text_of;

  CppPiece variable(std::size_t i) const { return {text_of(i)}; }
  CppPiece number(const Program::Number& number) const { return cpp_number(number.value); }
  CppPiece operation(const Operation& operation, const std::vector<CppPiece>& values, std::size_t) const {
    return cpp_operation(operation, values);
  }
  CppPiece choice(const CppPiece& condition, const CppPiece& a, const CppPiece& b) const {
    return cpp_choice(condition, a, b);
  }
};

CppPiece cpp_of(const Program& program, const VariableText& variable) {
  return fold<CppPiece>(program, MakeCpp{variable});
}

}  // namespace

std::string cpp_text(const Program& program, const VariableText& variable) {
  return cpp_of(program, variable).text;
}

std::string cpp_condition_text(const Program& program, const VariableText& variable) {
  return cpp_truth(cpp_of(program, variable)).text;
}

}  // namespace stepwire::expression
