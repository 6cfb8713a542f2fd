// Driver for cards of Comedi: converters, digital lines and counters of encoders.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <tuple>
#include <utility>

#include "engine/drivers/comedi/encoder.hpp"
#include "engine/drivers/comedi/ni_counter.hpp"
#include "engine/drivers/support/table.hpp"

namespace {

using stepwire::comedi::Library;
using stepwire::comedi::Sample;
using stepwire::support::Channels;
using stepwire::support::Settings;
namespace comedi = stepwire::comedi;

enum class Kind { adc, dac, in, out, encoder, index };

/// One wire of the card.
struct Wire {
  Kind kind;
  unsigned int subdevice = 0, channel = 0, range = 0;
  comedi::Range* span = nullptr;
  Sample most = 0;
  unsigned int number = 0;  ///< of an encoder of the card, or that of its index
  std::size_t encoder = 0;  ///< place among the encoders
};

/// Card that is closed at the end.
class Card {
 public:
  Card(const std::string& library, const std::string& file)
      : calls(library), device(calls.open(file.c_str())) {
    if (!device)
      throw std::runtime_error("the card " + file +
                               " cannot be opened; 'comedi_config' binds it to its driver, and its "
                               "file needs the permission to write");
  }
  ~Card() { calls.close(device); }
  Card(const Card&) = delete;
  Card& operator=(const Card&) = delete;

  /// Returns the channels of the first subdevices of these types, counted on over all of them.
  std::pair<unsigned int, unsigned int> place(const std::vector<int>& types, unsigned int index,
                                              const std::string& name) const {
    for (int one = 0; one < calls.subdevices(device); ++one) {
      const auto subdevice = static_cast<unsigned int>(one);
      if (std::find(types.begin(), types.end(), calls.type(device, subdevice)) == types.end()) continue;
      const auto count = static_cast<unsigned int>(std::max(0, calls.channels(device, subdevice)));
      if (index < count) return {subdevice, index};
      index -= count;
    }
    throw std::runtime_error("the card has no channel '" + name + "'");
  }

  /// Returns the channel of a counter. Those of NI have a subdevice each.
  std::pair<unsigned int, unsigned int> place_of_counter(unsigned int index, const std::string& name) const {
    if (!has_ni_counters()) return place({comedi::counter}, index, name);
    for (int one = 0; one < calls.subdevices(device); ++one) {
      const auto subdevice = static_cast<unsigned int>(one);
      const bool is_counter = calls.type(device, subdevice) == comedi::counter &&
                              calls.channels(device, subdevice) == comedi::NiCounter::channels;
      if (is_counter && index-- == 0) return {subdevice, 0};
    }
    throw std::runtime_error("the card has no channel '" + name + "'");
  }
  bool has_ni_counters() const { return comedi::NiCounter::is_one(calls.driver_name(device)); }

  Library calls;
  comedi::Device* device;
};

class ComediDevice {
 public:
  explicit ComediDevice(const Settings& settings)
      : card_(settings.text("library", "libcomedi.so.0"), settings.text("device", "/dev/comedi0")),
        multiplication_(multiplication_of(settings)),
        span_(settings.number("range", 10.0)),
        reference_(
            static_cast<unsigned int>(settings.word("reference", {"ground", "common", "differential"}))) {
    check_multiplication();
    if (!(span_ > 0.0)) Settings::refuse("range", "must be above 0");
    take_index(settings);
    for (const std::string& name : names_in(settings.text("inputs", ""))) add(name, STEPWIRE_INPUT);
    for (const std::string& name : names_in(settings.text("outputs", ""))) add(name, STEPWIRE_OUTPUT);
    for (Wire& wire : in_)
      if (wire.kind == Kind::index) wire.encoder = encoder_of(wire.number);
    const auto with_index = std::count_if(encoders_.begin(), encoders_.end(),
                                          [](const comedi::Encoder& one) { return one.has_index(); });
    if (with_index != static_cast<std::ptrdiff_t>(turns_.size()))
      Settings::refuse("index", "names encoders among 'inputs', such as enc0");
  }

  const Channels& channels() const { return channels_; }

  void start(std::int64_t, const double* safe) {
    safe_.assign(safe, safe + out_.size());
    for (Wire& wire : in_) {
      if (wire.kind == Kind::in)
        require(card_.calls.configure(card_.device, wire.subdevice, wire.channel, comedi::config_input));
      if (wire.kind == Kind::encoder) begin(wire);
    }
    for (const Wire& wire : out_)
      if (wire.kind == Kind::out)
        require(card_.calls.configure(card_.device, wire.subdevice, wire.channel, comedi::config_output));
  }

  int read(double* values) {
    for (std::size_t i = 0; i < in_.size(); ++i)
      if (in_[i].kind != Kind::index && !read_one(in_[i], values[i])) return STEPWIRE_FAILED;
    for (std::size_t i = 0; i < in_.size(); ++i)
      if (in_[i].kind == Kind::index) values[i] = encoders_[in_[i].encoder].seen() ? 1.0 : 0.0;
    return STEPWIRE_OK;
  }
  int write(const double* values) {
    bool written = true;  // of all, also behind one that fails
    for (std::size_t i = 0; i < out_.size(); ++i) written = write_one(out_[i], values[i]) && written;
    return written ? STEPWIRE_OK : STEPWIRE_FAILED;
  }
  int safe() { return write(safe_.data()); }
  void stop() {}
  void report(char* text, std::size_t size) const {
    const auto used = static_cast<std::size_t>(
        std::snprintf(text, size, "card of the driver %s", card_.calls.driver_name(card_.device)));
    if (!encoders_.empty() && used < size)
      std::snprintf(text + used, size - used, "; its counters count %d %s of each line", multiplication_,
                    multiplication_ == 1 ? "edge" : "edges");
  }

 private:
  static std::vector<std::string> names_in(const std::string& list) {
    std::vector<std::string> names;
    for (std::size_t at = 0; at < list.size();) {
      const std::size_t end = std::min(list.find(',', at), list.size());
      names.push_back(Channels::name_and_unit(list.substr(at, end - at)).first);
      at = end + 1;
    }
    return names;
  }
  static void require(int result) {
    if (result < 0) throw std::runtime_error("the card refuses its configuration");
  }
  static int multiplication_of(const Settings& settings) {
    const std::int64_t number = settings.whole("multiplication", 1);
    if (number != 1 && number != 2 && number != 4) Settings::refuse("multiplication", "is 1, 2 or 4");
    return static_cast<int>(number);
  }
  void check_multiplication() const {
    if (multiplication_ != 1 && std::string(card_.calls.driver_name(card_.device)) == "s626")
      Settings::refuse("multiplication",
                       "is 1 for the s626, whose kernel driver counts one edge of each line");
  }

  /// Takes the encoders with an index pulse. Other cards get no request for one, because the driver of the
  /// s626 refuses none and sets its counter to the code of the request.
  void take_index(const Settings& settings) {
    const std::vector<std::string> names = names_in(settings.text("index", ""));
    const std::vector<std::string> lines = names_in(settings.text("lines", ""));
    if (names.empty() && lines.empty()) return;
    const std::string driver = card_.calls.driver_name(card_.device);
    if (!names.empty() && !card_.has_ni_counters())
      throw std::runtime_error(
          "the setting 'index' needs a card of NI (ni_pcimio, ni_660x); the kernel driver " + driver +
          " does not use the index pulse");
    if (names.empty() || (lines.size() != 1 && lines.size() != names.size()))
      Settings::refuse("lines",
                       "is the number of lines of a turn of the encoders in 'index': one for all or each");
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string& text = lines[lines.size() == 1 ? 0 : i];
      char* end = nullptr;
      const double turn = std::strtod(text.c_str(), &end);
      if (*end != '\0' || !(turn >= 1.0 && turn < 1e6) || turn != std::floor(turn))
        Settings::refuse("lines", "is a whole number from 1 on");
      turns_.emplace_back(names[i], turn);
    }
  }
  double turn_of(const std::string& name) const {
    for (const auto& [encoder, lines] : turns_)
      if (encoder == name) return lines * multiplication_;
    return 0.0;
  }
  std::size_t encoder_of(unsigned int number) const {
    for (const Wire& wire : in_)
      if (wire.kind == Kind::encoder && wire.number == number && encoders_[wire.encoder].has_index())
        return wire.encoder;
    const std::string digits = std::to_string(number);
    throw std::runtime_error("'index" + digits + "' needs enc" + digits + " among 'inputs' and in 'index'");
  }
  /// Begins to count.
  void begin(const Wire& wire) {
    comedi::Encoder& encoder = encoders_[wire.encoder];
    if (card_.has_ni_counters())
      comedi::NiCounter(card_.calls, card_.device, wire.subdevice, wire.number)
          .begin(encoder.beginning(), multiplication_, encoder.has_index());
    Sample number = 0;
    require(card_.calls.read(card_.device, wire.subdevice, wire.channel, 0, 0, &number));
    encoder.begin(number);
  }

  void add(const std::string& name, int direction) {
    const auto digits = name.find_first_of("0123456789");
    const std::string kind = name.substr(0, digits);
    const auto index = digits == std::string::npos
                           ? 0u
                           : static_cast<unsigned int>(std::strtoul(name.c_str() + digits, nullptr, 10));
    const bool is_input = direction == STEPWIRE_INPUT;
    if (is_input && kind == "adc")
      add_analog(name, index, direction);
    else if (!is_input && kind == "dac")
      add_analog(name, index, direction);
    else if (is_input && kind == "enc")
      add_encoder(name, index);
    else if (is_input && kind == "index")
      add_index(name, index);
    else if (kind == (is_input ? "di" : "do"))
      add_line(name, index, direction);
    else
      throw std::runtime_error("'" + name + "' is no " +
                               (is_input ? "input; such as adc0, enc0, di0" : "output; such as dac0, do0"));
  }

  void add_analog(const std::string& name, unsigned int index, int direction) {
    const bool is_input = direction == STEPWIRE_INPUT;
    Wire wire{is_input ? Kind::adc : Kind::dac};
    std::tie(wire.subdevice, wire.channel) =
        card_.place({is_input ? comedi::analog_in : comedi::analog_out}, index, name);
    choose_range(wire, name);
    wire.most = card_.calls.most(card_.device, wire.subdevice, wire.channel);
    channels_.add(name, direction, "analog", "V", wire.span->min, wire.span->max, "");
    (is_input ? in_ : out_).push_back(wire);
  }

  /// Chooses the smallest range in volt around the wanted span. An output has the largest one without it.
  void choose_range(Wire& wire, const std::string& name) const {
    const int count = card_.calls.ranges(card_.device, wire.subdevice, wire.channel);
    for (unsigned int i = 0; static_cast<int>(i) < count; ++i) {
      comedi::Range* const one = card_.calls.range(card_.device, wire.subdevice, wire.channel, i);
      const bool holds = one->unit == comedi::unit_volt && (one->max >= span_ || wire.kind == Kind::dac);
      const double width = one->max - one->min;
      const bool is_better =
          !wire.span || (width < wire.span->max - wire.span->min) == (wire.kind == Kind::adc);
      if (!holds || !is_better) continue;
      wire.span = one;
      wire.range = i;
    }
    if (!wire.span) throw std::runtime_error("the channel '" + name + "' has no range of that many volt");
  }

  void add_encoder(const std::string& name, unsigned int index) {
    Wire wire{Kind::encoder};
    std::tie(wire.subdevice, wire.channel) = card_.place_of_counter(index, name);
    wire.number = index;
    wire.encoder = encoders_.size();
    wire.most = card_.calls.most(card_.device, wire.subdevice, wire.channel);
    encoders_.emplace_back(wire.most, multiplication_, turn_of(name));
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    const char* const from =
        encoders_.back().has_index() ? "lines since the index pulse" : "lines since the start";
    channels_.add(name, STEPWIRE_INPUT, "counter", "", -unlimited, unlimited, from);
    in_.push_back(wire);
  }
  void add_index(const std::string& name, unsigned int number) {
    Wire wire{Kind::index};
    wire.number = number;
    channels_.add(name, STEPWIRE_INPUT, "digital", "", 0.0, 1.0, "1 once the index pulse was seen");
    in_.push_back(wire);
  }
  void add_line(const std::string& name, unsigned int index, int direction) {
    const bool is_input = direction == STEPWIRE_INPUT;
    Wire wire{is_input ? Kind::in : Kind::out};
    std::tie(wire.subdevice, wire.channel) =
        card_.place({is_input ? comedi::digital_in : comedi::digital_out, comedi::digital}, index, name);
    channels_.add(name, direction, "digital", "", 0.0, 1.0, "");
    (is_input ? in_ : out_).push_back(wire);
  }

  bool read_one(const Wire& wire, double& value) {
    Sample raw = 0;
    unsigned int bit = 0;
    if (wire.kind == Kind::in) {
      const bool read = card_.calls.read_bit(card_.device, wire.subdevice, wire.channel, &bit) >= 0;
      value = bit != 0 ? 1.0 : 0.0;
      return read;
    }
    const unsigned int reference = wire.kind == Kind::adc ? reference_ : 0;
    if (card_.calls.read(card_.device, wire.subdevice, wire.channel, wire.range, reference, &raw) < 0)
      return false;
    value = wire.kind == Kind::adc ? card_.calls.to_physical(raw, wire.span, wire.most)
                                   : encoders_[wire.encoder].lines(raw);
    return true;
  }

  bool write_one(const Wire& wire, double value) {
    if (!std::isfinite(value)) return false;
    if (wire.kind == Kind::out)
      return card_.calls.write_bit(card_.device, wire.subdevice, wire.channel, value > 0.5 ? 1 : 0) >= 0;
    const double within = std::clamp(value, wire.span->min, wire.span->max);
    const Sample raw = card_.calls.from_physical(within, wire.span, wire.most);
    return card_.calls.write(card_.device, wire.subdevice, wire.channel, wire.range, comedi::ground, raw) >=
           0;
  }

  Card card_;
  int multiplication_;
  double span_;
  unsigned int reference_;
  Channels channels_;
  std::vector<Wire> in_, out_;
  std::vector<comedi::Encoder> encoders_;
  std::vector<std::pair<std::string, double>> turns_;  ///< lines of a turn of the encoders with an index
  std::vector<double> safe_;
};

constexpr stepwire_known_setting settings[] = {
    {"device", "file of the card", "/dev/comedi0"},
    {"inputs", "adc0 (V), di0, enc0 (lines of an encoder since the start): [adc0, enc0]", ""},
    {"outputs", "dac0 (V), do0: [dac0, do0]", ""},
    {"range", "voltage that the converters of inputs have at least", "10"},
    {"reference", "of analog inputs: ground, common or differential", "ground"},
    {"index", "encoders whose index pulse sets them to 0; cards of NI; index0 is 1 once it was seen: [enc0]",
     ""},
    {"lines", "lines of a turn of these encoders, one for all or for each: 1024", ""},
    {"multiplication", "edges that the card counts for each line of an encoder: 1, 2 or 4", "1"},
    {"library", "library of Comedi", "libcomedi.so.0"},
    {nullptr, nullptr, nullptr}};

void list(char* text, std::size_t size) {
  stepwire::support::list_files("/dev/comedi[0-9]*", text, size);
}

}  // namespace

extern "C" const stepwire_driver* stepwire_driver_v1(void) {
  static const stepwire_driver driver = stepwire::support::driver_table<ComediDevice>(
      "comedi", "cards of Comedi: converters, digital lines, encoders", settings, list);
  return &driver;
}
