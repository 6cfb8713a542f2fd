// A program that links the core alone: none of the library's blocks, no matio.
#include <cstdio>

#include <stepwire/model.hpp>
#include <stepwire/registry.hpp>
#include <stepwire/simulate.hpp>

#include "yard/drag.hpp"

int main() {
  stepwire::Registry own;
  own.add<yard::Drag>("yard");
  const auto model = stepwire::load(CONSUMER_DIR "/drag.yaml", std::move(own));
  const auto result = stepwire::simulate(model);
  const bool right = result["drag"].size() == 11 && result["drag"].back() == -12.0;  // -3 2 |2|
  std::puts(right ? "the core runs alone" : "the drag is wrong");
  return right ? 0 : 1;
}
