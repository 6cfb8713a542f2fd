// A foreign program that uses the installed library. `consumer generate DIR` writes the cart as C++. With
// `consumer compare CSV` the recording of that generated program is compared with the library. Without
// arguments all checks run.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <new>

#include <stepwire/registry.hpp>

#include "checks.hpp"
#include "yard/drag.hpp"

static int failures = 0;

void check(bool holds, const char* what, int line) {
  if (holds) return;
  ++failures;
  std::fprintf(stderr, "line %d does not hold: %s\n", line, what);
}

sw::Model cart(const sw::NamedTexts& settings) {
  sw::Registry known = sw::blocks();
  known.add<yard::Drag>("yard");
  return sw::load(CONSUMER_DIR "/cart.yaml", std::move(known), settings);
}

/// The numbers of a file whose cells have no quotes, but for its first line.
static std::vector<std::vector<double>> rows_of(const char* path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(file, line)) {
    rows.emplace_back();
    for (const char* at = line.c_str(); *at;) {
      char* end = nullptr;
      rows.back().push_back(std::strtod(at, &end));
      at = *end == ',' ? end + 1 : end;
    }
  }
  return rows;
}

static void compare(const char* path) {
  const sw::Result result = sw::simulate(cart());
  const auto rows = rows_of(path);
  CHECK(rows.size() == 1001);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    CHECK(rows[k][0] == result["time"][k]);
    CHECK(rows[k][1] == result["cart.position"][k]);
    CHECK(rows[k][2] == result["drag"][k]);
  }
}

int main(int count, char** arguments) {
  if (count == 3 && !std::strcmp(arguments[1], "generate")) {
    sw::generate(cart(), arguments[2]);
  } else if (count == 3 && !std::strcmp(arguments[1], "compare")) {
    compare(arguments[2]);
  } else {
    for (const auto part : {check_model, check_steps, check_values, check_snapshots, check_observers,
                            check_sweep, check_compiled})
      part();
  }
  if (failures == 0) std::puts("all holds");
  return failures == 0 ? 0 : 1;
}
