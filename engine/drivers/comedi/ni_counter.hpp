#pragma once

#include <array>
#include <string>

#include "engine/drivers/comedi/library.hpp"

namespace stepwire::comedi {

/// Counters of the cards of NI with the interface "gpct": a subdevice each, of three channels (the counter
/// and the two registers that reload it). They count encoders only once they are configured and armed.
class NiCounter {
 public:
  static constexpr int channels = 3;

  static bool is_one(const std::string& driver) { return driver == "ni_pcimio" || driver == "ni_660x"; }

  /// `index` is the number of the counter of the card.
  NiCounter(const Library& calls, Device* device, unsigned int subdevice, unsigned int index)
      : calls_(calls), device_(device), subdevice_(subdevice), index_(index) {}

  /// Begins to count with a number. Throws std::runtime_error where the card refuses.
  void begin(Sample number, int multiplication, bool with_index) const {
    require(calls_.reset(device_, subdevice_));
    require(calls_.write(device_, subdevice_, 0, 0, 0, number));
    for (unsigned int reload = 1; reload < channels; ++reload)
      require(calls_.write(device_, subdevice_, reload, 0, 0, 0));
    calls_.set_gate(device_, subdevice_, 0, 0, disabled);
    calls_.set_gate(device_, subdevice_, 0, 1, disabled);
    connect();
    const unsigned int edges = multiplication == 4 ? 3 : static_cast<unsigned int>(multiplication);
    const unsigned int index = with_index ? index_enable | at_high_a_high_b : 0;
    require(calls_.set_counter_mode(device_, subdevice_, 0, edges << edges_shift | by_encoder | index));
    require(calls_.arm(device_, subdevice_, 0));
  }

 private:
  static constexpr unsigned int disabled = 0x8000, edges_shift = 16, at_high_a_high_b = 3u << 20,
                                index_enable = 1u << 22, by_encoder = 2u << 24;

  static void require(int result) {
    if (result < 0)
      throw std::runtime_error(
          "the card's driver refuses to let its counter count an encoder; cards of the M series "
          "and 660x can");
  }
  static unsigned int line(unsigned int pfi) { return pfi < 10 ? pfi + 1 : pfi + 11; }

  /// Connects A, B and index with the lines PFI that the cards of the M series have for them. Counters of
  /// 660x have lines of their own and refuse. A card of the E series refuses, too, and would count no edges.
  void connect() const {
    constexpr std::array<std::array<unsigned int, 3>, 2> pins{{{8, 10, 9}, {3, 11, 4}}};
    if (std::string(calls_.driver_name(device_)) == "ni_660x") return;
    const auto& own = pins[index_ % pins.size()];
    for (unsigned int signal = 0; signal < own.size(); ++signal)
      require(calls_.set_other(device_, subdevice_, 0, signal, line(own[signal])));
  }

  const Library& calls_;
  Device* device_;
  unsigned int subdevice_, index_;
};

}  // namespace stepwire::comedi
