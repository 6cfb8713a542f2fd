// Library with the functions of libcomedi for the driver under test. Its card is in memory and follows the
// kernel driver of the s626. It has 16 inputs of 16 bits, +-5 and +-10 V, and 4 outputs of 14 bits, +-10 V.
// It has 48 lines and 6 counters of 24 bits, too.
#include "tests/support/comedi/fake_comedi.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace {

FakeCard card;
FakeRange spans[] = {{-5.0, 5.0, 0}, {-10.0, 10.0, 0}};

constexpr int types[] = {1, 2, 5, 5, 5, 6}, counts[] = {16, 4, 16, 16, 16, 6};

}  // namespace

extern "C" {

FakeCard* fake_comedi_card() {
  return &card;
}

void* comedi_open(const char* file) {
  if (std::strcmp(file, "/dev/comedi0") != 0) return nullptr;
  ++card.opened;
  return &card;
}
int comedi_close(void*) {
  return --card.opened, 0;
}
const char* comedi_get_driver_name(void*) {
  return card.name;
}
int comedi_get_n_subdevices(void*) {
  return 6;
}
int comedi_get_subdevice_type(void*, unsigned int subdevice) {
  return types[subdevice];
}
int comedi_get_n_channels(void*, unsigned int subdevice) {
  return counts[subdevice];
}
unsigned int comedi_get_maxdata(void*, unsigned int subdevice, unsigned int) {
  return subdevice == 0 ? 0xffffu : subdevice == 1 ? 0x3fffu : subdevice == 5 ? 0xffffffu : 1u;
}
int comedi_get_n_ranges(void*, unsigned int subdevice, unsigned int) {
  return subdevice == 0 ? 2 : 1;
}
FakeRange* comedi_get_range(void*, unsigned int subdevice, unsigned int, unsigned int range) {
  return &spans[subdevice == 0 ? range : 1];
}
double comedi_to_phys(unsigned int raw, FakeRange* range, unsigned int most) {
  return range->min + (range->max - range->min) * raw / most;
}
unsigned int comedi_from_phys(double value, FakeRange* range, unsigned int most) {
  return static_cast<unsigned int>(std::floor(0.5 + (value - range->min) / (range->max - range->min) * most));
}
int comedi_data_read(void*, unsigned int subdevice, unsigned int channel, unsigned int range, unsigned int,
                     unsigned int* raw) {
  if (card.unplugged) return -1;
  if (subdevice == 5) return *raw = card.counter[channel] & 0xffffffu, 1;
  *raw = comedi_from_phys(std::clamp(card.volts_in[channel], spans[range].min, spans[range].max),
                          &spans[range], 0xffff);
  return 1;
}
int comedi_data_write(void*, unsigned int, unsigned int channel, unsigned int, unsigned int,
                      unsigned int raw) {
  if (card.unplugged) return -1;
  card.volts_out[channel] = comedi_to_phys(raw, &spans[1], 0x3fff);
  return 1;
}
int comedi_dio_config(void*, unsigned int subdevice, unsigned int channel, unsigned int direction) {
  card.is_output[subdevice - 2][channel] = direction == 1;
  return 1;
}
int comedi_dio_read(void*, unsigned int subdevice, unsigned int channel, unsigned int* bit) {
  *bit = card.lines[subdevice - 2][channel] ? 1 : 0;
  return card.unplugged ? -1 : 1;
}
int comedi_dio_write(void*, unsigned int subdevice, unsigned int channel, unsigned int bit) {
  card.lines[subdevice - 2][channel] = bit != 0;
  return card.unplugged ? -1 : 1;
}
}
