#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

/// Stream of the fake liblsl. Its own clock is `ahead` seconds before that of this machine.
struct FakeStream {
  struct Sample {
    double stamp;
    std::vector<double> values;
  };

  std::string name, type, source;
  std::int32_t channels = 1;
  double rate = 0.0;
  int format = 2;
  double ahead = 0.0;
  bool lost = false;
  std::deque<Sample> samples;
};

/// State of the fake liblsl, as a test sees it.
struct FakeLayer {
  double clock = 100.0;  ///< of this machine [s]
  std::deque<FakeStream> streams;
  std::deque<FakeStream> outlets;  ///< samples hold what was pushed
  int infos = 0, inlets = 0, open_outlets = 0, corrections = 0;
  std::vector<double> timeouts;  ///< of the calls that may wait
};
