#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// A vector into up to eight pieces: y1 has the first sizes[0] elements of u, y2 the next sizes[1], ...
struct Demux {
  Numbers sizes{1.0};
  Input<> u{};
  Output<> y1{}, y2{}, y3{}, y4{}, y5{}, y6{}, y7{}, y8{};

  void outputs() {
    Index next = 0;
    for (Output<>* y : {&y1, &y2, &y3, &y4, &y5, &y6, &y7, &y8})
      for (Index k = 0; k < y->size(); ++k) (*y)[k] = u[next++];
  }

  void configure(Configure& is);
  static void declare(Declare<Demux>& is);
};

}  // namespace stepwire
