// Library with the functions of liblsl for the driver under test. Its streams are in memory. A call that
// would wait notes for how long, and returns at once.
#include "tests/support/lsl/fake_lsl.hpp"

#include <algorithm>

namespace {

FakeLayer layer;

constexpr std::int32_t timed_out = -1, stream_lost = -2, wrong_argument = -3;

}  // namespace

extern "C" {

FakeLayer* fake_layer() {
  return &layer;
}

FakeStream* lsl_create_streaminfo(const char* name, const char* type, std::int32_t channels, double rate,
                                  int format, const char* source) {
  ++layer.infos;
  return new FakeStream{name, type, source, channels, rate, format, 0.0, false, {}};
}
void lsl_destroy_streaminfo(FakeStream* info) {
  --layer.infos;
  delete info;
}
std::int32_t lsl_get_channel_count(FakeStream* info) {
  return info->channels;
}
int lsl_get_channel_format(FakeStream* info) {
  return info->format;
}

FakeStream* lsl_create_outlet(FakeStream* info, std::int32_t, std::int32_t) {
  ++layer.open_outlets;
  return &layer.outlets.emplace_back(*info);
}
void lsl_destroy_outlet(FakeStream*) {
  --layer.open_outlets;
}
std::int32_t lsl_push_sample_d(FakeStream* outlet, const double* values) {
  outlet->samples.push_back({layer.clock, {values, values + outlet->channels}});
  return outlet->lost ? stream_lost : 0;
}

std::int32_t lsl_resolve_byprop(FakeStream** found, std::uint32_t size, const char* property,
                                const char* value, std::int32_t least, double timeout) {
  std::uint32_t count = 0;
  for (const FakeStream& one : layer.streams) {
    const std::string of = property;
    const std::string& has = of == "name" ? one.name : of == "type" ? one.type : one.source;
    if (has != value || count == size) continue;
    ++layer.infos;
    found[count++] = new FakeStream(one);
  }
  if (count < static_cast<std::uint32_t>(least)) layer.timeouts.push_back(timeout);
  return static_cast<std::int32_t>(count);
}
FakeStream* lsl_create_inlet(FakeStream* info, std::int32_t, std::int32_t, std::int32_t) {
  ++layer.inlets;
  return &*std::find_if(layer.streams.begin(), layer.streams.end(),
                        [info](const FakeStream& one) { return one.source == info->source; });
}
void lsl_destroy_inlet(FakeStream*) {
  --layer.inlets;
}
void lsl_open_stream(FakeStream* stream, double timeout, std::int32_t* error) {
  layer.timeouts.push_back(timeout);
  *error = stream->lost ? timed_out : 0;
}
/// Samples are those of a stream that was opened, the oldest one first. 0: there is none.
double lsl_pull_sample_d(FakeStream* stream, double* values, std::int32_t count, double timeout,
                         std::int32_t* error) {
  *error = stream->lost ? stream_lost : count != stream->channels ? wrong_argument : 0;
  if (*error != 0) return 0.0;
  if (stream->samples.empty()) {
    layer.timeouts.push_back(timeout);
    return 0.0;
  }
  const FakeStream::Sample sample = stream->samples.front();
  stream->samples.pop_front();
  std::copy(sample.values.begin(), sample.values.end(), values);
  return sample.stamp;
}
double lsl_time_correction(FakeStream* stream, double, std::int32_t* error) {
  ++layer.corrections;
  *error = 0;
  return -stream->ahead;
}
double lsl_local_clock() {
  return layer.clock;
}
}
