// Library with the functions of libcomedi for the driver under test. Its card is in memory and follows the
// kernel driver of the s626. It has 16 inputs of 16 bits, +-5 and +-10 V, and 4 outputs of 14 bits, +-10 V.
// It has 48 lines and 6 counters of 24 bits, too. By another name it is a card of NI: two counters of 32 bits
// in a subdevice each, behind a counter of another kind.
#include "tests/support/comedi/fake_comedi.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "engine/drivers/shared/segment.h"

namespace {

/// Wires from the card to a rig in software.
class Rig {
 public:
  bool joined() const { return segment_ != nullptr; }
  /// Waits for the rig of this name, some seconds at most.
  bool join(const char* name) {
    for (int tries = 0; tries < 1000 && !joined(); ++tries) {
      const int file = ::shm_open(name, O_RDWR | O_CLOEXEC, 0);
      if (file >= 0 && ::lseek(file, 0, SEEK_END) == static_cast<off_t>(sizeof(stepwire_segment))) map(file);
      if (file >= 0) ::close(file);
      if (!joined()) ::usleep(10'000);
    }
    return joined();
  }
  /// Returns what the rig shows on a channel of this kind; `otherwise` without a wire.
  double sensed(const char* kind, unsigned int channel, double otherwise) const {
    double values[STEPWIRE_SEGMENT_MOST];
    const std::uint32_t count = joined() ? segment_->to_client.count : 0;
    const std::uint32_t at = joined() ? place(segment_->to_client_labels, count, kind, channel) : 0;
    std::int64_t time = 0;
    if (at == count || stepwire_get(&segment_->to_client, values, count, &time) == 0) return otherwise;
    return values[at];
  }
  void command(const char* kind, unsigned int channel, double value) {
    const std::uint32_t count = joined() ? segment_->to_host.count : 0;
    const std::uint32_t at = joined() ? place(segment_->to_host_labels, count, kind, channel) : 0;
    if (at == count) return;
    commands_[at] = value;
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    stepwire_put(&segment_->to_host, commands_, count,
                 std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec);
  }

 private:
  void map(int file) {
    void* const memory =
        ::mmap(nullptr, sizeof(stepwire_segment), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (memory == MAP_FAILED) return;
    auto* const segment = static_cast<stepwire_segment*>(memory);
    if (__atomic_load_n(&segment->magic, __ATOMIC_ACQUIRE) == STEPWIRE_SEGMENT_MAGIC)
      segment_ = segment;
    else
      ::munmap(memory, sizeof(stepwire_segment));
  }
  static std::uint32_t place(const stepwire_label* labels, std::uint32_t count, const char* kind,
                             unsigned int channel) {
    std::uint32_t at = 0;
    while (at < count && !(std::strncmp(labels[at].name, kind, 3) == 0 &&
                           std::strtoul(labels[at].name + 3, nullptr, 10) == channel))
      ++at;
    return at;
  }

  stepwire_segment* segment_ = nullptr;
  double commands_[STEPWIRE_SEGMENT_MOST] = {};
};

FakeCard card;
Rig rig;
FakeRange spans[] = {{-5.0, 5.0, 0}, {-10.0, 10.0, 0}};

constexpr int types[] = {1, 2, 5, 5, 5, 6}, counts[] = {16, 4, 16, 16, 16, 6};
constexpr int types_of_ni[] = {1, 2, 5, 6, 6, 6}, counts_of_ni[] = {16, 2, 8, 1, 3, 3};

bool is_ni() {
  return std::strncmp(card.name, "ni_", 3) == 0;
}
FakeCounter& counter_of(unsigned int subdevice) {
  return card.ni[subdevice - 4];
}
/// Takes a request to a counter. The driver of the s626 takes any for a number of the counter.
bool takes(unsigned int subdevice, unsigned int channel, unsigned int request) {
  if (!is_ni()) card.counter[channel] = request;
  return is_ni() && subdevice >= 4 && !card.unplugged;
}

}  // namespace

extern "C" {

FakeCard* fake_comedi_card() {
  return &card;
}

void* comedi_open(const char* file) {
  if (std::strcmp(file, "/dev/comedi0") != 0) return nullptr;
  const char* const name = std::getenv("FAKE_COMEDI_RIG");
  if (name && !rig.join(name)) return nullptr;
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
  return (is_ni() ? types_of_ni : types)[subdevice];
}
int comedi_get_n_channels(void*, unsigned int subdevice) {
  return (is_ni() ? counts_of_ni : counts)[subdevice];
}
unsigned int comedi_get_maxdata(void*, unsigned int subdevice, unsigned int) {
  if (is_ni() && subdevice >= 4) return 0xffffffffu;
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
  if (is_ni() && subdevice >= 4) return *raw = counter_of(subdevice).number, 1;
  if (subdevice == 5) {
    const double lines = rig.sensed("enc", channel, card.counter[channel]);
    return *raw = static_cast<unsigned int>(std::llround(lines)) & 0xffffffu, 1;
  }
  const double volts = rig.sensed("adc", channel, card.volts_in[channel]);
  *raw = comedi_from_phys(std::clamp(volts, spans[range].min, spans[range].max), &spans[range], 0xffff);
  return 1;
}
int comedi_data_write(void*, unsigned int subdevice, unsigned int channel, unsigned int, unsigned int,
                      unsigned int raw) {
  if (card.unplugged) return -1;
  if (is_ni() && subdevice >= 4) {
    if (channel == 0) counter_of(subdevice).number = raw;
    if (channel == 1) counter_of(subdevice).reload = raw;
    return 1;
  }
  card.volts_out[channel] = comedi_to_phys(raw, &spans[1], 0x3fff);
  rig.command("dac", channel, card.volts_out[channel]);
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
int comedi_reset(void*, unsigned int subdevice) {
  if (!takes(subdevice, 0, 34)) return 0;
  counter_of(subdevice).armed = false;
  return 0;
}
int comedi_set_gate_source(void*, unsigned int subdevice, unsigned int channel, unsigned int, unsigned int) {
  return takes(subdevice, channel, 2001), 0;
}
int comedi_set_other_source(void*, unsigned int subdevice, unsigned int channel, unsigned int other,
                            unsigned int source) {
  if (takes(subdevice, channel, 2005) && !card.counts_encoders) return -1;
  counter_of(subdevice).lines[other] = source;
  return 0;
}
int comedi_set_counter_mode(void*, unsigned int subdevice, unsigned int channel, unsigned int mode) {
  if (takes(subdevice, channel, 4097)) counter_of(subdevice).mode = mode;
  return card.unplugged ? -1 : 0;
}
int comedi_arm(void*, unsigned int subdevice, unsigned int) {
  if (takes(subdevice, 0, 31)) counter_of(subdevice).armed = true;
  return 0;
}
}
