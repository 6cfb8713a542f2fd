#include "engine/base/math/function.hpp"

#include <catch2/catch.hpp>

namespace stepwire {

namespace {

/// `factor` times the first number.
class Times final : public Function::Source {
 public:
  explicit Times(double factor) : factor_(factor) {}
  double operator()(const double* v) const override { return factor_ * v[0]; }
  std::string cpp() const override { return "factor * v[0]"; }

 private:
  double factor_;
};

}  // namespace

TEST_CASE("a function is code, or what a source evaluates, or 0") {
  const double v[] = {3.0, 4.0};
  const Function code([](const double* of) -> double { return of[0] - of[1]; });
  const Function source(std::make_shared<Times>(2.0));
  CHECK(code(v) == -1.0);
  CHECK(source(v) == 6.0);
  CHECK(Function()(v) == 0.0);
  CHECK(source.source()->cpp() == "factor * v[0]");
  CHECK_FALSE(code.source());
}

TEST_CASE("a copy of a function has its source, whatever becomes of the other") {
  const double v[] = {1.0};
  Function first(std::make_shared<Times>(2.0));
  Function second = first, third;
  third = first;
  CHECK(second.source() == first.source());
  first = Function(std::make_shared<Times>(5.0));
  CHECK(first(v) == 5.0);
  CHECK(second(v) == 2.0);
  CHECK(third(v) == 2.0);
}

}  // namespace stepwire
