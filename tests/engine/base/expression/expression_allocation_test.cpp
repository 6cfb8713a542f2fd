#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <new>

#include "engine/base/expression/expression.hpp"

namespace {

thread_local long allocations = 0;

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* const memory = std::malloc(size ? size : 1)) return memory;
  throw std::bad_alloc();
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size ? size : 1);
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

TEST_CASE("an evaluation allocates nothing, not even the first one or that of a copy") {
  const stepwire::Expression expression(
      "x > -4 mm && !(y < 2) ? max(sin(x), hypot(x, y), 3) : mod(y, 2*pi) / 0 + min(x, y)^2");
  const stepwire::Expression copy(expression);
  std::array<double, 2> values{0.001, 3.0};
  double sum = 0.0;
  const long before = allocations;
  for (int i = 0; i < 100; ++i) {
    values[1] = i * 0.1;
    sum += expression(values) + copy(values);
  }
  const long after = allocations;
  CHECK(after == before);
  CHECK(sum != 0.0);
}
