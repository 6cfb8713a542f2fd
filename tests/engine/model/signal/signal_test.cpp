#include <catch2/catch.hpp>

#include "engine/model/signal/diagnostic.hpp"
#include "engine/model/signal/input.hpp"
#include "engine/model/signal/numbers.hpp"
#include "engine/model/signal/per_element.hpp"
#include "engine/model/signal/signal.hpp"

namespace stepwire {

TEST_CASE("an output writes through to the memory it is bound to, whatever its size") {
  double memory[4] = {};
  Output<> y;
  y.bind(memory + 1, 2);
  y = Numbers{3.0, 3.0};
  CHECK((memory[0] == 0.0 && memory[1] == 3.0 && memory[2] == 3.0 && memory[3] == 0.0));
  y = 5.0;
  CHECK((memory[1] == 5.0 && memory[2] == 5.0));
  Output<1> one;
  one.bind(memory, 1);
  one = 7.0;
  CHECK(memory[0] == 7.0);
}

TEST_CASE("assigning one signal to another copies its numbers, not its place") {
  double a[2] = {1.0, 2.0}, b[2] = {};
  Output<> from, to;
  from.bind(a, 2);
  to.bind(b, 2);
  to = from;
  a[0] = 9.0;
  CHECK((b[0] == 1.0 && b[1] == 2.0));
}

TEST_CASE("an input knows whether it is fed") {
  Input<> u;
  CHECK_FALSE(u.connected());
  const double memory[2] = {1.0, 2.0};
  u.bind(memory, 2);
  CHECK(u.connected());
  CHECK(u.size() == 2);
  CHECK((u[0] == 1.0 && u[1] == 2.0));
}

TEST_CASE("an element of a list that is a single number stands for every element") {
  const double one = 4.0, three[3] = {1.0, 2.0, 3.0};
  const Inputs::Element elements[2] = {{&one, 1}, {three, 3}};
  Inputs u;
  u.bind(elements, 2);
  CHECK(u.count() == 2);
  CHECK(u[0][2] == 4.0);
  CHECK(u[1][2] == 3.0);
}

TEST_CASE("a notice keeps the time at which it was raised first") {
  double first = Diagnostic::never;
  Diagnostic diagnostic;
  diagnostic.bind(&first);
  CHECK_FALSE(diagnostic.raised());
  diagnostic.raise(2.0);
  diagnostic.raise(3.0);
  CHECK(diagnostic.raised());
  CHECK(first == 2.0);
}

TEST_CASE("a view of no elements has none, and owns nothing") {
  const double none[] = {-0.0};
  const PerElement view = PerElement::view(none), copy = view;
  CHECK(view.size() == 0);
  CHECK(copy.begin() == copy.end());
}

}  // namespace stepwire
