// The driver `comedi` through the functions of libcomedi, which a library of the tests has.
#include <dlfcn.h>
#include <catch2/catch.hpp>

#include "engine/base/driver/open_device.hpp"
#include "engine/base/io/environment_error.hpp"
#include "tests/support/comedi/fake_comedi.hpp"

namespace stepwire::driver {
namespace {

using Catch::Contains;

/// The card of the library, as new.
FakeCard& fresh_card() {
  void* const library = ::dlopen(FAKE_COMEDI, RTLD_NOW | RTLD_LOCAL);
  REQUIRE(library);
  FakeCard& card = *reinterpret_cast<FakeCard* (*)()>(::dlsym(library, "fake_comedi_card"))();
  card = FakeCard();
  return card;
}

Settings with_library(Settings settings) {
  settings.emplace_back("library", FAKE_COMEDI);
  return settings;
}

std::string refusal_of(const Settings& settings) {
  try {
    OpenDevice(load_driver(driver_file("comedi")), settings);
    return "";
  } catch (const io::EnvironmentError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("converters of a Comedi card have volts, in the smallest range that holds what is wanted") {
  FakeCard& card = fresh_card();
  OpenDevice device(load_driver(driver_file("comedi")),
                    with_library({{"inputs", "adc3, adc0"}, {"outputs", "dac1"}, {"range", "5"}}));
  CHECK(device.inputs()[0].most == 5.0);
  CHECK(device.outputs()[0].most == 10.0);
  const double safe = 0.0, wanted = -2.5;
  device.start(1'000'000, &safe);
  card.volts_in[3] = 1.25;
  card.volts_in[0] = -7.0;  // beyond the range: as the card clips it
  double volts[2] = {};
  CHECK(device.read(volts) == STEPWIRE_OK);
  CHECK(volts[0] == Approx(1.25).margin(10.0 / 65535));
  CHECK(volts[1] == -5.0);
  CHECK(device.write(&wanted) == STEPWIRE_OK);
  CHECK(card.volts_out[1] == Approx(-2.5).margin(20.0 / 16383));
  CHECK(device.safe() == STEPWIRE_OK);
  CHECK(card.volts_out[1] == Approx(0.0).margin(20.0 / 16383));
}

TEST_CASE("an encoder counts on over the wrap of its counter, in both directions, from its start") {
  FakeCard& card = fresh_card();
  card.counter[2] = 0xfffffe;
  OpenDevice device(load_driver(driver_file("comedi")), with_library({{"inputs", "enc2"}}));
  device.start(1'000'000, nullptr);
  double lines = 0.0;
  for (const auto& [count, expected] : {std::pair{0xfffffeu, 0.0}, {3u, 5.0}, {0xffff00u, -254.0}}) {
    card.counter[2] = count;
    device.read(&lines);
    CHECK(lines == expected);
  }
}

TEST_CASE("lines are counted over the three groups of the card, and an output is made one") {
  FakeCard& card = fresh_card();
  OpenDevice device(load_driver(driver_file("comedi")),
                    with_library({{"inputs", "di17"}, {"outputs", "do40"}}));
  const double on = 1.0, off = 0.0;
  device.start(1'000'000, &off);
  CHECK(card.is_output[2][8]);
  CHECK_FALSE(card.is_output[1][1]);
  card.lines[1][1] = true;
  double seen = 0.0;
  device.read(&seen);
  CHECK(seen == 1.0);
  device.write(&on);
  CHECK(card.lines[2][8]);
  device.safe();
  CHECK_FALSE(card.lines[2][8]);
}

TEST_CASE("a card that is unplugged fails, and is closed at the end") {
  FakeCard& card = fresh_card();
  {
    OpenDevice device(load_driver(driver_file("comedi")),
                      with_library({{"inputs", "adc0"}, {"outputs", "dac0"}}));
    const double safe = 0.0;
    device.start(1'000'000, &safe);
    card.unplugged = true;
    double volt = 0.0;
    CHECK(device.read(&volt) == STEPWIRE_FAILED);
    CHECK(device.safe() == STEPWIRE_FAILED);
    CHECK(card.opened == 1);
  }
  CHECK(card.opened == 0);
}

TEST_CASE("what a card has not is refused, the multiplication that the s626 does not have among it") {
  fresh_card();
  CHECK_THAT(refusal_of(with_library({{"inputs", "enc0"}, {"multiplication", "4"}})),
             Contains("is 1 for the s626"));
  CHECK_THAT(refusal_of(with_library({{"inputs", "adc16"}})), Contains("the card has no channel 'adc16'"));
  CHECK_THAT(refusal_of(with_library({{"inputs", "dac0"}})), Contains("'dac0' is no input; such as adc0"));
  CHECK_THAT(refusal_of(with_library({{"device", "/dev/comedi7"}})),
             Contains("/dev/comedi7 cannot be opened"));
  CHECK_THAT(refusal_of({{"library", "libnone.so"}}), Contains("the Debian package libcomedi0 has it"));
}

TEST_CASE("a card that counts four edges of a line gives lines") {
  FakeCard& card = fresh_card();
  card.name = "another";
  OpenDevice device(load_driver(driver_file("comedi")),
                    with_library({{"inputs", "enc0"}, {"multiplication", "4"}}));
  device.start(1'000'000, nullptr);
  card.counter[0] = 10;
  double lines = 0.0;
  device.read(&lines);
  CHECK(lines == 2.5);
}

TEST_CASE("a counter of NI is configured for its multiplication and gives the same lines for each") {
  for (const int multiplication : {1, 2, 4}) {
    FakeCard& card = fresh_card();
    card.name = "ni_pcimio";
    OpenDevice device(load_driver(driver_file("comedi")),
                      with_library({{"inputs", "enc1"}, {"multiplication", std::to_string(multiplication)}}));
    CHECK_FALSE(card.ni[1].armed);
    device.start(1'000'000, nullptr);
    CHECK_FALSE(card.ni[0].armed);
    CHECK(card.ni[1].lines[0] == 4);  // PFI 3, 11 and 4, whose numbers begin at 1 and have a gap after 9
    CHECK(card.ni[1].lines[1] == 22);
    CHECK(card.ni[1].lines[2] == 5);
    double lines = 0.0;
    for (const auto& [quarters, expected] : {std::pair{4000, 1000.0}, {-12000, -2000.0}}) {
      card.ni[1].move(quarters, 4096);
      CHECK(device.read(&lines) == STEPWIRE_OK);
      CHECK(lines == expected);
    }
    CHECK_THAT(device.report(), Contains(multiplication == 1 ? "counters count 1 edge of each line"
                                                             : std::to_string(multiplication) + " edges"));
  }
}

TEST_CASE("from the first index pulse on lines count from it, over several turns in both directions") {
  FakeCard& card = fresh_card();
  card.name = "ni_660x";
  card.counts_encoders = false;  // its counters have lines of their own
  OpenDevice device(
      load_driver(driver_file("comedi")),
      with_library(
          {{"inputs", "index0, enc0"}, {"index", "enc0"}, {"lines", "1000"}, {"multiplication", "4"}}));
  device.start(1'000'000, nullptr);
  FakeCounter& counter = card.ni[0];
  counter.place = -400;  // in quarters, before the pulse
  double seen[2] = {};
  const auto check = [&](long quarters, double index, double lines) {
    counter.move(quarters, 4000);
    CHECK(device.read(seen) == STEPWIRE_OK);
    CHECK(seen[0] == index);
    CHECK(seen[1] == lines);
  };
  check(0, 0.0, 0.0);
  check(200, 0.0, 50.0);
  check(300, 1.0, 25.0);  // by the place of the encoder: -400 + 200 + 300 = 100 quarters
  for (int i = 1; i <= 12; ++i) check(1000, 1.0, 25.0 + 250.0 * i);
  for (int i = 11; i >= -12; --i) check(-1000, 1.0, 25.0 + 250.0 * i);
}

TEST_CASE("edges that were lost are found again at the index pulse") {
  FakeCard& card = fresh_card();
  card.name = "ni_pcimio";
  OpenDevice device(load_driver(driver_file("comedi")),
                    with_library({{"inputs", "enc0"}, {"index", "enc0"}, {"lines", "100"}}));
  device.start(1'000'000, nullptr);
  double lines = 0.0;
  card.ni[0].move(400, 400);
  device.read(&lines);
  CHECK(lines == 0.0);
  card.ni[0].move(200, 400);
  card.ni[0].number -= 3;
  device.read(&lines);
  CHECK(lines == 47.0);
  for (const double expected : {77.0, 110.0}) {
    card.ni[0].move(120, 400);
    device.read(&lines);
    CHECK(lines == expected);
  }
}

TEST_CASE("an index that the card cannot use is refused before anything is set") {
  FakeCard& card = fresh_card();
  const Settings index = with_library({{"inputs", "enc0"}, {"index", "enc0"}, {"lines", "1024"}});
  CHECK_THAT(refusal_of(index),
             Contains("'index' needs a card of NI (ni_pcimio, ni_660x); the kernel driver s626"));
  CHECK(card.counter[0] == 0);
  card.name = "ni_pcimio";
  CHECK(refusal_of(index).empty());
  CHECK_THAT(refusal_of(with_library({{"inputs", "enc0"}, {"index", "enc0"}})),
             Contains("'lines' is the number of"));
  CHECK_THAT(refusal_of(with_library({{"inputs", "enc0"}, {"index", "enc0"}, {"lines", "10.5"}})),
             Contains("'lines' is a whole number"));
  CHECK_THAT(refusal_of(with_library({{"inputs", "enc0"}, {"index", "adc0"}, {"lines", "10"}})),
             Contains("'index' names encoders among 'inputs'"));
  CHECK_THAT(refusal_of(with_library({{"inputs", "enc0, index0"}})), Contains("'index0' needs enc0 among"));
  CHECK_THAT(refusal_of(with_library({{"inputs", "enc2"}})), Contains("the card has no channel 'enc2'"));
}

TEST_CASE("a card of NI that cannot count encoders is told at the start") {
  FakeCard& card = fresh_card();
  card.name = "ni_pcimio";
  card.counts_encoders = false;  // as the E series
  OpenDevice device(load_driver(driver_file("comedi")), with_library({{"inputs", "enc0"}}));
  CHECK_THROWS_WITH(device.start(1'000'000, nullptr),
                    Contains("refuses to let its counter count an encoder"));
}

}  // namespace stepwire::driver
