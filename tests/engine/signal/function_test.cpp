#include "engine/signal/function.hpp"

#include <catch2/catch.hpp>

using namespace stepwire;

namespace {

/// Its number of calls so far, times the first number.
class Counter final : public Function::Source {
 public:
  double operator()(const double* v) override { return ++calls_ * v[0]; }
  std::unique_ptr<Source> copy() const override { return std::make_unique<Counter>(*this); }
  std::string cpp() const override { return "calls * v[0]"; }

 private:
  double calls_ = 0.0;
};

}  // namespace

TEST_CASE("a function is code, or what a source evaluates, or 0") {
  const double v[] = {3.0, 4.0};
  const Function code([](const double* of) -> double { return of[0] - of[1]; });
  const Function source(std::make_unique<Counter>());
  CHECK(code(v) == -1.0);
  CHECK(source(v) == 3.0);
  CHECK(Function()(v) == 0.0);
  CHECK(source.source()->cpp() == "calls * v[0]");
  CHECK_FALSE(code.source());
}

TEST_CASE("each copy of a function has a source of its own") {
  const double v[] = {1.0};
  const Function first(std::make_unique<Counter>());
  first(v);
  Function second = first, third;
  third = first;
  CHECK(second(v) == 2.0);
  CHECK(second(v) == 3.0);
  CHECK(third(v) == 2.0);
  CHECK(first(v) == 2.0);
  third = std::move(second);
  CHECK(third(v) == 4.0);
}
