#include "engine/base/expression/expression_function.hpp"

#include <utility>

namespace stepwire::expression {
namespace {

class ExpressionSource final : public Function::Source {
 public:
  ExpressionSource(Expression expression, std::vector<std::size_t> places)
      : expression_(std::move(expression)), places_(std::move(places)) {}

  double operator()(const double* v) const override { return expression_(v, places_); }
  std::string cpp() const override {
    return expression_.cpp([&](std::size_t i) { return element_of_v(places_[i]); });
  }

 private:
  Expression expression_;
  std::vector<std::size_t> places_;
};

}  // namespace

Function function_of(Expression expression, std::vector<std::size_t> places) {
  return Function(std::make_shared<ExpressionSource>(std::move(expression), std::move(places)));
}

}  // namespace stepwire::expression
