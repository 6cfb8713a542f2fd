// Driver for streams of the Lab Streaming Layer: an inlet for inputs, an outlet for outputs.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "engine/drivers/lsl/library.hpp"
#include "engine/drivers/support/table.hpp"

namespace {

using stepwire::lsl::Library;
using stepwire::support::Channels;
using stepwire::support::Settings;
namespace lsl = stepwire::lsl;

constexpr double nanoseconds = 1e9;
constexpr std::int32_t seconds_buffered = 10;
constexpr int most_samples = 1024;  // of one read
constexpr std::size_t most_streams = 8;

/// Inlet or outlet that is destroyed at the end.
template <class Handle>
struct Owned {
  explicit Owned(void (*destroys)(Handle)) : destroy(destroys) {}
  ~Owned() { reset(nullptr); }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  void reset(Handle next) {
    if (handle) destroy(handle);
    handle = next;
  }

  Handle handle = nullptr;
  void (*destroy)(Handle);
};

class LslDevice {
 public:
  explicit LslDevice(const Settings& settings)
      : calls_(settings.text("library", "")),
        inlet_(calls_.destroy_inlet),
        outlet_(calls_.destroy_outlet),
        name_(settings.text("write", "stepwire")),
        type_(settings.text("type", "Control")),
        wait_(static_cast<double>(settings.time("wait", 2e9)) / nanoseconds),
        stale_(static_cast<double>(settings.time("stale", 100e6)) / nanoseconds) {
    channels_.add_list(settings.text("inputs", ""), STEPWIRE_INPUT);
    if (settings.has("read")) find(settings.text("read"));
    if (!settings.has("read") && channels_.count(STEPWIRE_INPUT) > 0)
      throw std::runtime_error("inputs need the setting 'read', the stream that has them: name=Robot");
    channels_.add_list(settings.text("outputs", ""), STEPWIRE_OUTPUT);
    if (channels_.table().empty()) throw std::runtime_error("neither 'read' nor 'outputs' gives a channel");
  }

  const Channels& channels() const { return channels_; }

  void start(std::int64_t period, const double* safe) {
    safe_.assign(safe, safe + channels_.count(STEPWIRE_OUTPUT));
    if (!safe_.empty()) create_outlet(period);
    if (inlet_.handle) await_sample();
  }

  int read(double* values) {
    for (int i = 0; i < most_samples && inlet_.handle; ++i) {
      const Pulled pulled = pull(0.0);
      if (pulled == Pulled::lost) return STEPWIRE_FAILED;
      if (pulled == Pulled::none) break;
    }
    std::copy(values_.begin(), values_.end(), values);
    if (!inlet_.handle) return STEPWIRE_OK;
    const double age = calls_.local_clock() - stamp_ - correction_;
    oldest_ = std::max(oldest_, age);
    return age > stale_ ? STEPWIRE_STALE : STEPWIRE_OK;
  }
  int write(const double* values) {
    if (!outlet_.handle) return STEPWIRE_OK;
    return calls_.push(outlet_.handle, values) == 0 ? STEPWIRE_OK : STEPWIRE_FAILED;
  }
  int safe() { return write(safe_.data()); }
  void stop() {}
  void report(char* text, std::size_t size) const {
    if (inlet_.handle)
      std::snprintf(text, size, "%llu samples; the oldest values were %.3f ms old; clocks differ by %.3f ms",
                    static_cast<unsigned long long>(seen_), 1e3 * oldest_, 1e3 * correction_);
    else
      std::snprintf(text, size, "outlet %s", name_.c_str());
  }

 private:
  enum class Pulled { sample, none, lost };

  /// Finds the one stream with a property of a value: "name=Robot".
  void find(const std::string& text) {
    const auto equals = text.find('=');
    const std::string property = text.substr(0, equals);
    if (equals == std::string::npos || (property != "name" && property != "type" && property != "source_id"))
      Settings::refuse("read",
                       "is a property of a stream with its value: name=Robot, type=EEG or source_id=42");
    std::array<lsl::Info, most_streams> found{};
    const std::int32_t count = calls_.resolve(found.data(), most_streams, property.c_str(),
                                              text.substr(equals + 1).c_str(), 1, wait_);
    std::string trouble;
    if (count < 1)
      trouble = "there is no stream with " + text;
    else if (count > 1)
      trouble = "there are several streams with " + text + "; name or source_id may tell them apart";
    else
      trouble = open(found.front());
    for (const lsl::Info info : found)
      if (info) calls_.destroy_info(info);
    if (!trouble.empty()) throw std::runtime_error(trouble);
  }

  /// Creates the inlet of a stream and its channels. Returns what is wrong with it, "" for nothing.
  std::string open(lsl::Info info) {
    const std::int32_t count = calls_.channel_count(info);
    const std::size_t named = channels_.count(STEPWIRE_INPUT);
    if (calls_.channel_format(info) == lsl::text) return "the stream has texts, not numbers";
    if (named > 0 && named != static_cast<std::size_t>(count))
      return "the stream has " + std::to_string(count) + " channels, and 'inputs' names " +
             std::to_string(named);
    for (std::int32_t i = 0; i < count && named == 0; ++i)
      channels_.add_list("c" + std::to_string(i), STEPWIRE_INPUT);
    values_.assign(channels_.count(STEPWIRE_INPUT), 0.0);
    inlet_.reset(calls_.create_inlet(info, seconds_buffered, 1, 1));
    return inlet_.handle ? "" : "the stream cannot be opened";
  }

  /// The source of the outlet is its name, so that inlets of others find it again after a new start.
  void create_outlet(std::int64_t period) {
    const lsl::Info info =
        calls_.create_info(name_.c_str(), type_.c_str(), static_cast<std::int32_t>(safe_.size()),
                           nanoseconds / static_cast<double>(period), lsl::double64, name_.c_str());
    if (!info) throw std::runtime_error("the outlet " + name_ + " cannot be described");
    outlet_.reset(calls_.create_outlet(info, 0, seconds_buffered));
    calls_.destroy_info(info);
    if (!outlet_.handle) throw std::runtime_error("the outlet " + name_ + " cannot be created");
  }

  /// Waits for a first sample and for the difference of the clocks.
  void await_sample() {
    std::int32_t error = 0;
    calls_.open_stream(inlet_.handle, wait_, &error);
    if (error != 0) throw std::runtime_error("the stream does not open in the time of 'wait'");
    correction_ = calls_.time_correction(inlet_.handle, wait_, &error);
    if (error != 0) throw std::runtime_error("the stream does not tell its time in the time of 'wait'");
    if (pull(wait_) != Pulled::sample)
      throw std::runtime_error("the stream has sent no sample in the time of 'wait'");
  }

  /// Takes the next sample.
  Pulled pull(double timeout) {
    std::int32_t error = 0;
    const double stamp = calls_.pull(inlet_.handle, values_.data(), static_cast<std::int32_t>(values_.size()),
                                     timeout, &error);
    if (error != 0) return Pulled::lost;
    if (stamp == 0.0) return Pulled::none;
    stamp_ = stamp;
    ++seen_;
    return Pulled::sample;
  }

  Library calls_;
  Channels channels_;
  Owned<lsl::Inlet> inlet_;
  Owned<lsl::Outlet> outlet_;
  std::string name_, type_;
  double wait_, stale_;  ///< [s]
  double stamp_ = 0.0, correction_ = 0.0, oldest_ = 0.0;
  std::uint64_t seen_ = 0;
  std::vector<double> values_, safe_;
};

constexpr stepwire_known_setting settings[] = {
    {"read", "stream of the inputs: name=Robot, type=EEG or source_id=42", ""},
    {"inputs", "names with units, in the order of its channels: force in N, angle in rad; c0, c1 without",
     ""},
    {"outputs", "names of the outputs with units: a in V, b", ""},
    {"write", "name of the stream of the outputs", "stepwire"},
    {"type", "type of the stream of the outputs", "Control"},
    {"wait", "largest time to find the stream, and again to its first sample", "2 s"},
    {"stale", "age from which values are stale", "100 ms"},
    {"library", "library of the Lab Streaming Layer in place of liblsl.so", ""},
    {nullptr, nullptr, nullptr}};

}  // namespace

extern "C" const stepwire_driver* stepwire_driver_v1(void) {
  static const stepwire_driver driver =
      stepwire::support::driver_table<LslDevice>("lsl", "streams of the Lab Streaming Layer", settings);
  return &driver;
}
