#pragma once

#include <dlfcn.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace stepwire::lsl {

/// Types and constants of lsl_c.h, as far as the driver uses them.
struct InfoType;
struct InletType;
struct OutletType;
using Info = InfoType*;
using Inlet = InletType*;
using Outlet = OutletType*;
inline constexpr int double64 = 2, text = 3, lost = -2;

/// Functions of liblsl, loaded while the program runs, so that nothing is linked.
class Library {
 public:
  /// Loads the named library; one of its usual names for "". Throws std::runtime_error.
  explicit Library(const std::string& name) : object_(object_of(name)) {
    load(create_info, "lsl_create_streaminfo");
    load(destroy_info, "lsl_destroy_streaminfo");
    load(channel_count, "lsl_get_channel_count");
    load(channel_format, "lsl_get_channel_format");
    load(create_outlet, "lsl_create_outlet");
    load(destroy_outlet, "lsl_destroy_outlet");
    load(push, "lsl_push_sample_d");
    load(resolve, "lsl_resolve_byprop");
    load(create_inlet, "lsl_create_inlet");
    load(destroy_inlet, "lsl_destroy_inlet");
    load(open_stream, "lsl_open_stream");
    load(pull, "lsl_pull_sample_d");
    load(time_correction, "lsl_time_correction");
    load(local_clock, "lsl_local_clock");
  }

  Info (*create_info)(const char* name, const char* type, std::int32_t channels, double rate, int format,
                      const char* source);
  void (*destroy_info)(Info);
  std::int32_t (*channel_count)(Info);
  int (*channel_format)(Info);
  Outlet (*create_outlet)(Info, std::int32_t chunk, std::int32_t most_buffered);
  void (*destroy_outlet)(Outlet);
  std::int32_t (*push)(Outlet, const double*);
  std::int32_t (*resolve)(Info* found, std::uint32_t size, const char* property, const char* value,
                          std::int32_t least, double timeout);
  Inlet (*create_inlet)(Info, std::int32_t most_buffered, std::int32_t chunk, std::int32_t recover);
  void (*destroy_inlet)(Inlet);
  void (*open_stream)(Inlet, double timeout, std::int32_t* error);
  double (*pull)(Inlet, double*, std::int32_t count, double timeout, std::int32_t* error);
  double (*time_correction)(Inlet, double timeout, std::int32_t* error);
  double (*local_clock)();

 private:
  static void* object_of(const std::string& name) {
    for (const char* const one : {"liblsl.so", "liblsl.so.2"})
      if (void* const object = ::dlopen(name.empty() ? one : name.c_str(), RTLD_NOW | RTLD_LOCAL))
        return object;
    const char* const reason = ::dlerror();
    throw std::runtime_error((name.empty() ? "liblsl.so" : name) +
                             " cannot be loaded; packages of the Lab Streaming Layer are at "
                             "https://github.com/sccn/liblsl/releases (" +
                             (reason ? reason : "") + ")");
  }
  template <class Function>
  void load(Function& function, const char* name) {
    function = reinterpret_cast<Function>(::dlsym(object_, name));
    if (!function) throw std::runtime_error(std::string("liblsl lacks the function ") + name);
  }

  void* object_;  ///< stays loaded
};

}  // namespace stepwire::lsl
