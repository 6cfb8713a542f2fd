#include "engine/base/expression/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "engine/base/expression/draws.hpp"
#include "engine/base/expression/fold.hpp"
#include "engine/base/expression/measure.hpp"
#include "engine/base/expression/operation.hpp"
#include "engine/base/expression/program.hpp"

namespace stepwire::expression {
namespace {

/// A C++ subexpression and its precedence.
struct CppPiece {
  std::string text;
  Binding binding = Binding::atom;
  bool truth = false;  ///< a bool, which must not enter arithmetic: C++ would divide whole numbers
};

/// Namespaces of the functions that formulas can call: language.hpp, <cmath> for exact results,
/// elementary.hpp.
std::string_view space_of(std::string_view function) {
  constexpr std::array<std::string_view, 7> own{"sign",    "mod",    "min",      "max",
                                                "uniform", "normal", "lognormal"};
  constexpr std::array<std::string_view, 5> exact{"sqrt", "abs", "floor", "ceil", "round"};
  if (std::ranges::find(own, function) != own.end()) return "language";
  return std::ranges::find(exact, function) != exact.end() ? "std" : "fn";
}

/// Returns the text, parenthesised where it binds weaker than `least`.
std::string in(Binding least, const CppPiece& piece) {
  return piece.binding < least ? "(" + piece.text + ")" : piece.text;
}

CppPiece number(const CppPiece& piece) {
  return piece.truth ? CppPiece{"language::number(" + piece.text + ")"} : piece;
}

/// Returns the C++ condition that a piece is not 0.
CppPiece cpp_truth(const CppPiece& piece) {
  if (piece.truth) return piece;
  return {in(Binding::sum, piece) + " != 0.0", Binding::comparison, true};
}

/// Parenthesises && inside of ||, since compilers warn about it.
CppPiece logic(std::string_view sign, Binding binding, const CppPiece& a, const CppPiece& b) {
  const std::string left = in(a.binding == binding ? binding : Binding::comparison, cpp_truth(a));
  return {fmt::format("{} {} {}", left, sign, in(Binding::comparison, cpp_truth(b))), binding, true};
}

CppPiece comparison(std::string_view sign, const CppPiece& a, const CppPiece& b) {
  return {fmt::format("{} {} {}", in(Binding::sum, number(a)), sign, in(Binding::sum, number(b))),
          Binding::comparison, true};
}

CppPiece arithmetic(std::string_view sign, Binding binding, const CppPiece& a, const CppPiece& b) {
  const auto stronger = static_cast<Binding>(static_cast<int>(binding) + 1);
  return {fmt::format("{} {} {}", in(binding, number(a)), sign, in(stronger, number(b))), binding};
}

/// Parenthesises a repeated minus, since "--" is another operator.
CppPiece prefix(std::string_view sign, const CppPiece& a) {
  if (sign == "!" && a.truth) return {"!" + in(Binding::prefix, a), Binding::prefix, true};
  if (sign == "!") return {in(Binding::sum, a) + " == 0.0", Binding::comparison, true};
  return {"-" + in(Binding::atom, number(a)), Binding::prefix};
}

CppPiece call(std::string_view function, const std::vector<CppPiece>& values) {
  std::string list;
  for (const CppPiece& value : values) list += (list.empty() ? "" : ", ") + number(value).text;
  if (function == "min" || function == "max") list = "{" + list + "}";
  return {fmt::format("{}::{}({})", space_of(function), function, list)};
}

CppPiece choice(const CppPiece& condition, const CppPiece& a, const CppPiece& b) {
  return {fmt::format("{} ? {} : {}", in(Binding::either, condition), in(Binding::either, a), b.text),
          Binding::condition, a.truth};
}

CppPiece cpp_number(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return {std::move(text), std::signbit(value) ? Binding::prefix : Binding::atom};
}

CppPiece cpp_operation(const Operation& operation, const std::vector<CppPiece>& values) {
  const Binding binding = operation.binding;
  const std::string_view name = operation.name;
  if (binding == Binding::atom) return call(name, values);
  if (binding == Binding::power) return call("pow", values);
  if (binding == Binding::prefix) return prefix(name, values[0]);
  if (binding == Binding::comparison) return comparison(name, values[0], values[1]);
  return binding < Binding::comparison ? logic(name, binding, values[0], values[1])
                                       : arithmetic(name, binding, values[0], values[1]);
}

CppPiece cpp_choice(const CppPiece& condition, const CppPiece& a, const CppPiece& b) {
  if (!a.truth || !b.truth) return choice(cpp_truth(condition), number(a), number(b));
  return choice(cpp_truth(condition), a, b);
}

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

/// Translates an expression. Compilers round constant calls of <cmath> differently, so generated code is
/// compiled without folding them.
CppPiece cpp_of(const Program& program, const VariableText& variable) {
  return fold<CppPiece>(program, MakeCpp{variable});
}

/// Evaluation stack whose top is in a register. The interpreter compares instruction kinds one after another:
/// the branch predictor makes that faster than a jump table.
struct Stack {
  double* end;        ///< one past the values below the top
  double last = 0.0;  ///< unused until the first value is pushed

  void push(double value) {
    *end++ = last;
    last = value;
  }

  double pop() {
    const double value = last;
    last = *--end;
    return value;
  }

  void operate(const Instruction& instruction) {
    using enum Instruction::Kind;
    if (instruction.kind == sum) return combine(std::plus());
    if (instruction.kind == difference) return combine(std::minus());
    if (instruction.kind == product) return combine(std::multiplies());
    if (instruction.kind == quotient) return combine(std::divides());
    *end = last;
    end -= instruction.count - 1;
    last = instruction.operation->value(end, instruction.count);
  }

  template <class Of>
  void combine(Of of) {
    last = of(*--end, last);
  }
};

/// Interprets a program; `variable(i)` returns the value of variable i.
template <class Variable>
double evaluate(const Program& program, const Variable& variable) {
  std::array<double, longest_text / 2 + 1> values;  // operators separate operands, which bounds the depth
  Stack stack{values.data()};
  const Instruction* const first = program.code.data();
  for (const Instruction* instruction = first; instruction != first + program.code.size(); ++instruction) {
    if (instruction->kind == Instruction::Kind::variable) {
      stack.push(variable(instruction->index));
    } else if (instruction->kind == Instruction::Kind::number) {
      stack.push(program.numbers[instruction->index].value);
    } else if (instruction->operation) {
      stack.operate(*instruction);
    } else if (instruction->kind == Instruction::Kind::strict_branch && std::isnan(stack.last)) {
      instruction = first + first[instruction->index].index;  // behind the second value
    } else if (instruction->kind == Instruction::Kind::jump ||
               instruction->kind == Instruction::Kind::choice || stack.pop() == 0.0) {
      instruction = first + instruction->index;
    }
  }
  return stack.last;
}

}  // namespace

Expression::Expression(std::string_view text) : Expression(text, nullptr) {}

Expression::Expression(std::string_view text, const std::function<bool(std::string_view)>& known)
    : program_(std::make_shared<Program>(translate(text, known))) {}

Expression Expression::hiding_constants(std::string_view text,
                                        const std::function<bool(std::string_view)>& hides) {
  Expression result("0");
  result.program_ = std::make_shared<Program>(translate(text, nullptr, Values::numbers, hides));
  return result;
}

Expression Expression::strict() const {
  Program program = *program_;
  for (Instruction& instruction : program.code) {
    instruction.operation = expression::strict(instruction.operation);
    if (instruction.kind == Instruction::Kind::branch) instruction.kind = Instruction::Kind::strict_branch;
  }
  Expression result = *this;
  result.program_ = std::make_shared<const Program>(std::move(program));
  return result;
}

const std::string& Expression::text() const {
  return program_->text;
}

const std::vector<std::string>& Expression::variables() const {
  return program_->variables;
}

std::string Expression::renamed(const std::vector<std::string>& names) const {
  std::string result;
  std::size_t copied = 0;
  for (const Program::Use& use : program_->uses) {
    result += text().substr(copied, use.position - copied) + names[use.variable];
    copied = use.position + variables()[use.variable].size();
  }
  return result + text().substr(copied);
}

Measure Expression::measure(const std::vector<Measure>& variables) const {
  return measure_of(*program_, variables);
}

void Expression::check_draws(std::span<const std::optional<double>> values) const {
  stepwire::expression::check_draws(*program_, values);
}

double Expression::operator()(std::span<const double> values) const {
  return evaluate(*program_, [&](std::size_t i) { return values[i]; });
}

double Expression::operator()(const double* numbers, std::span<const std::size_t> places) const {
  return evaluate(*program_, [&](std::size_t i) { return numbers[places[i]]; });
}

std::string element_of_v(std::size_t i) {
  return "v[" + std::to_string(i) + "]";
}

std::string Expression::cpp(const VariableText& variable) const {
  return cpp_of(*program_, variable).text;
}

std::string Expression::cpp_condition(const VariableText& variable) const {
  return cpp_truth(cpp_of(*program_, variable)).text;
}

}  // namespace stepwire::expression
