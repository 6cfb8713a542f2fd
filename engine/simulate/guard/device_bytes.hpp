#pragma once

#include <vector>

#include "engine/base/messages/bytes.hpp"
#include "engine/simulate/guard/bank.hpp"

namespace stepwire::guard {

/// Writes or reads the settings of devices, depending on the kind of stream.
template <class Stream>
void devices_through(Stream& stream, std::vector<DeviceSettings>& devices) {
  messages::list(stream, devices, [&](DeviceSettings& one) {
    messages::all(stream, one.name, one.driver, one.file, one.outputs);
    messages::list(stream, one.settings,
                   [&](auto& setting) { messages::all(stream, setting.first, setting.second); });
  });
}

}  // namespace stepwire::guard
