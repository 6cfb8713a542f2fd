#pragma once

#include "blocks/sources/own_time.hpp"

namespace stepwire {

/// Time of the run, or since the last restart: y = t.
struct Clock : OwnTime {
  Output<1> y{};

  void outputs() { y = own(); }

  void update() { keep_origin(); }
  void configure(Configure& is);
  static void declare(Declare<Clock>& is);
};

}  // namespace stepwire
