#pragma once

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace stepwire::comedi {

/// Types of comedilib.h, as far as the driver uses them.
struct Device;
using Sample = unsigned int;
struct Range {
  double min, max;
  unsigned int unit;
};

enum SubdeviceType {
  unused = 0,
  analog_in = 1,
  analog_out = 2,
  digital_in = 3,
  digital_out = 4,
  digital = 5,
  counter = 6
};
inline constexpr unsigned int unit_volt = 0, ground = 0, common = 1, differential = 2, config_input = 0,
                              config_output = 1;

/// Functions of libcomedi, loaded while the program runs, so that nothing is linked.
class Library {
 public:
  explicit Library(const std::string& name) : object_(::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (!object_)
      throw std::runtime_error("the library " + name +
                               " cannot be loaded; the Debian package libcomedi0 has it (" + ::dlerror() +
                               ")");
    load(open, "comedi_open");
    load(close, "comedi_close");
    load(driver_name, "comedi_get_driver_name");
    load(subdevices, "comedi_get_n_subdevices");
    load(type, "comedi_get_subdevice_type");
    load(channels, "comedi_get_n_channels");
    load(most, "comedi_get_maxdata");
    load(ranges, "comedi_get_n_ranges");
    load(range, "comedi_get_range");
    load(read, "comedi_data_read");
    load(write, "comedi_data_write");
    load(configure, "comedi_dio_config");
    load(read_bit, "comedi_dio_read");
    load(write_bit, "comedi_dio_write");
    load(to_physical, "comedi_to_phys");
    load(from_physical, "comedi_from_phys");
    load(reset, "comedi_reset");
    load(set_gate, "comedi_set_gate_source");
    load(set_other, "comedi_set_other_source");
    load(set_counter_mode, "comedi_set_counter_mode");
    load(arm, "comedi_arm");
  }

  Device* (*open)(const char*);
  int (*close)(Device*);
  const char* (*driver_name)(Device*);
  int (*subdevices)(Device*);
  int (*type)(Device*, unsigned int);
  int (*channels)(Device*, unsigned int);
  Sample (*most)(Device*, unsigned int, unsigned int);
  int (*ranges)(Device*, unsigned int, unsigned int);
  Range* (*range)(Device*, unsigned int, unsigned int, unsigned int);
  int (*read)(Device*, unsigned int, unsigned int, unsigned int, unsigned int, Sample*);
  int (*write)(Device*, unsigned int, unsigned int, unsigned int, unsigned int, Sample);
  int (*configure)(Device*, unsigned int, unsigned int, unsigned int);
  int (*read_bit)(Device*, unsigned int, unsigned int, unsigned int*);
  int (*write_bit)(Device*, unsigned int, unsigned int, unsigned int);
  double (*to_physical)(Sample, Range*, Sample);
  Sample (*from_physical)(double, Range*, Sample);
  int (*reset)(Device*, unsigned int);
  int (*set_gate)(Device*, unsigned int, unsigned int, unsigned int, unsigned int);
  int (*set_other)(Device*, unsigned int, unsigned int, unsigned int, unsigned int);
  int (*set_counter_mode)(Device*, unsigned int, unsigned int, unsigned int);
  int (*arm)(Device*, unsigned int, unsigned int);

 private:
  template <class Function>
  void load(Function& function, const char* name) {
    function = reinterpret_cast<Function>(::dlsym(object_, name));
    if (!function) throw std::runtime_error(std::string("libcomedi lacks the function ") + name);
  }

  void* object_;  ///< stays loaded
};

}  // namespace stepwire::comedi
