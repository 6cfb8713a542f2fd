#include "engine/simulate/realtime/cyclictest.hpp"

#include <catch2/catch.hpp>
#include <sstream>

namespace stepwire::realtime {

namespace {

// As cyclictest 2.4 prints it.
const std::string printed = R"(# /dev/cpu_dma_latency set to 0us
# Histogram
000000 000000
000001 000000
000002 000010
000003 000080
000004 000008
# Total: 000000098
# Min Latencies: 00002
# Avg Latencies: 00003
# Max Latencies: 00061
# Histogram Overflows: 00002
# Histogram Overflow at cycle number:
# Thread 0: 00470 00472
)";

CyclictestHistogram read(int times) {
  CyclictestHistogram histogram;
  for (int i = 0; i < times; ++i) {
    std::istringstream lines(printed);
    for (std::string line; std::getline(lines, line);) histogram.add_line(line + "\n");
  }
  return histogram;
}

}  // namespace

TEST_CASE("the histogram of cyclictest is read with its overflows, and adds up over slices") {
  for (const int times : {1, 3}) {
    const CyclictestHistogram histogram = read(times);
    CHECK(histogram.count() == 100 * times);
    CHECK(histogram.quantile(0.1) == 2);
    CHECK(histogram.quantile(0.5) == 3);
    CHECK(histogram.quantile(0.98) == 4);
    CHECK(histogram.quantile(0.99) == 61);
    CHECK(histogram.max() == 61);
  }
}

}  // namespace stepwire::realtime
