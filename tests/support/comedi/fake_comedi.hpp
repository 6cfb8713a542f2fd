#pragma once

/// Counter of a card of NI with an encoder on it, whose place is counted in quarters of a line.
struct FakeCounter {
  bool armed = false;
  unsigned int mode = 0, number = 0, reload = 7, lines[3] = {};
  long place = 0;

  /// Turns the encoder, whose index pulse is at each multiple of `turn` quarters.
  void move(long quarters, long turn) {
    const long quarters_of_edge[] = {0, 4, 2, 1};
    const long every = quarters_of_edge[mode >> 16 & 3];
    const auto edges = [every](long at) { return at >= 0 ? at / every : -((-at + every - 1) / every); };
    for (const long way = quarters > 0 ? 1 : -1; quarters != 0; quarters -= way) {
      place += way;
      if (!armed || every == 0) continue;
      number += static_cast<unsigned int>(edges(place) - edges(place - way));
      if ((mode & 0x400000u) != 0 && place % turn == 0) number = reload;
    }
  }
};

/// Card of the fake libcomedi, as a test sees it: an s626, or one of NI by its name. Where the environment has
/// FAKE_COMEDI_RIG, its wires go to the rig in software behind the shared memory of that name. Outputs of the
/// rig such as adc0 and enc0 are what its channels read. An input such as dac0 gets what is written.
struct FakeCard {
  const char* name = "s626";
  int opened = 0;
  bool unplugged = false, counts_encoders = true;
  double volts_in[16] = {}, volts_out[4] = {};
  unsigned int counter[6] = {};
  bool lines[3][16] = {}, is_output[3][16] = {};
  FakeCounter ni[2];
};

struct FakeRange {
  double min, max;
  unsigned int unit;
};
