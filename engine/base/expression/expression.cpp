#include "engine/base/expression/expression.hpp"

#include <array>
#include <functional>

#include "engine/base/expression/cpp_text.hpp"
#include "engine/base/expression/draws.hpp"
#include "engine/base/expression/measure.hpp"
#include "engine/base/expression/program.hpp"

namespace stepwire::expression {
namespace {

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
    } else if (instruction->kind != Instruction::Kind::branch || stack.pop() == 0.0) {
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
  return cpp_text(*program_, variable);
}

std::string Expression::cpp_condition(const VariableText& variable) const {
  return cpp_condition_text(*program_, variable);
}

}  // namespace stepwire::expression
