#pragma once

/// Card of the fake libcomedi, as a test sees it.
struct FakeCard {
  const char* name = "s626";
  int opened = 0;
  bool unplugged = false;
  double volts_in[16] = {}, volts_out[4] = {};
  unsigned int counter[6] = {};
  bool lines[3][16] = {}, is_output[3][16] = {};
};

struct FakeRange {
  double min, max;
  unsigned int unit;
};
