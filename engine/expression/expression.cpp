#include "engine/expression/expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <utility>

#include "engine/expression/cpp_text.hpp"
#include "engine/expression/draws.hpp"
#include "engine/expression/function.hpp"
#include "engine/expression/measure.hpp"
#include "engine/expression/program.hpp"

namespace stepwire {

/// The parser library reads the variables where `values` holds them, so neither is ever moved.
struct Expression::Parser {
  Parser(std::string_view from, Program checked)
      : text(from), program(std::move(checked)), values(program.variables.size()) {
    compile();
  }
  Parser(const Parser& other) : text(other.text), program(other.program), values(other.values) { compile(); }
  Parser& operator=(const Parser&) = delete;

  void compile() {
    try {
      define_language(parser);
      for (std::size_t i = 0; i < program.numbers.size(); ++i) {
        parser.DefineConst("c" + std::to_string(i), program.numbers[i]);
      }
      for (std::size_t i = 0; i < values.size(); ++i) parser.DefineVar("v" + std::to_string(i), &values[i]);
      parser.SetExpr(program.code);
      parser.Eval();  // the first evaluation compiles; the others only walk the result
    } catch (const mu::ParserError& error) {
      throw ExpressionError("the expression cannot be read: " + error.GetMsg(), 0);
    }
  }

  std::string text;
  Program program;
  std::vector<double> values;
  mu::Parser parser;
};

Expression::Expression(std::string_view text) : Expression(text, nullptr) {}

Expression::Expression(std::string_view text, const std::function<bool(std::string_view)>& known)
    : parser_(std::make_unique<Parser>(text, translate(text, known))) {}

Expression::Expression(const Expression& other) : parser_(std::make_unique<Parser>(*other.parser_)) {}

Expression& Expression::operator=(const Expression& other) {
  if (this != &other) parser_ = std::make_unique<Parser>(*other.parser_);
  return *this;
}

Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;

const std::string& Expression::text() const {
  return parser_->text;
}

const std::vector<std::string>& Expression::variables() const {
  return parser_->program.variables;
}

std::string Expression::renamed(const std::vector<std::string>& names) const {
  std::string result;
  std::size_t copied = 0;
  for (const Program::Use& use : parser_->program.uses) {
    result += text().substr(copied, use.position - copied) + names[use.variable];
    copied = use.position + variables()[use.variable].size();
  }
  return result + text().substr(copied);
}

Measure Expression::measure(const std::vector<Measure>& variables) const {
  return measure_of(parser_->program, variables);
}

void Expression::check_draws(std::span<const std::optional<double>> values) const {
  stepwire::check_draws(parser_->program, values);
}

double Expression::operator()(std::span<const double> values) const {
  const std::size_t count = std::min(values.size(), parser_->values.size());
  std::copy_n(values.begin(), count, parser_->values.begin());
  return parser_->parser.Eval();
}

double Expression::operator()(const double* numbers, std::span<const std::size_t> places) const {
  double* const values = parser_->values.data();
  for (std::size_t i = 0; i < places.size(); ++i) values[i] = numbers[places[i]];
  return parser_->parser.Eval();
}

std::string element_of_v(std::size_t i) {
  return "v[" + std::to_string(i) + "]";
}

std::string Expression::cpp(const VariableText& variable) const {
  return cpp_text(parser_->program, variable);
}

std::string Expression::cpp_condition(const VariableText& variable) const {
  return cpp_condition_text(parser_->program, variable);
}

}  // namespace stepwire
