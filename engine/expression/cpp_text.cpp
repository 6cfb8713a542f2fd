#include "engine/expression/cpp_text.hpp"

#include <vector>

#include "engine/expression/cpp_piece.hpp"
#include "engine/expression/fold.hpp"

namespace stepwire {
namespace {

struct MakeCpp {
  const Program& program;
  const VariableText& text_of;

  CppPiece variable(std::size_t i) const { return {text_of(i)}; }
  CppPiece number(std::size_t i) const { return cpp_number(program.numbers[i]); }
  CppPiece sign(std::string_view sign, const CppPiece& a) const { return cpp_sign(sign, a); }
  CppPiece operation(std::string_view sign, Binding binding, const CppPiece& a, const CppPiece& b,
                     std::size_t) const {
    return cpp_operation(sign, binding, a, b);
  }
  CppPiece choice(const CppPiece& condition, const CppPiece& a, const CppPiece& b) const {
    return cpp_choice(condition, a, b);
  }
  CppPiece call(std::string_view function, const std::vector<CppPiece>& values, std::size_t) const {
    return cpp_call(function, values);
  }
};

CppPiece cpp_of(const Program& program, const VariableText& variable) {
  const MakeCpp make{program, variable};
  return Fold<CppPiece, MakeCpp>(program, make).run();
}

}  // namespace

std::string cpp_text(const Program& program, const VariableText& variable) {
  return cpp_of(program, variable).text;
}

std::string cpp_condition_text(const Program& program, const VariableText& variable) {
  return cpp_truth(cpp_of(program, variable)).text;
}

}  // namespace stepwire
