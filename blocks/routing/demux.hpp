#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Splits a vector into up to eight pieces: y1 has the first sizes[0] elements of u, y2 the next sizes[1],
/// ...
struct Demux {
  Numbers sizes{1.0};
  Input<> u{};
  Output<> y1{}, y2{}, y3{}, y4{}, y5{}, y6{}, y7{}, y8{};

  void outputs() { fill(y1, y2, y3, y4, y5, y6, y7, y8); }

  void configure(Configure& is);
  static void declare(Declare<Demux>& is);

 private:
  /// Fills the pieces by successive loops; a list of the outputs would prevent lanes.
  template <class... Pieces>
  void fill(Pieces&... pieces) {
    Index next = 0;
    const auto take = [&](Output<>& y) {
      for (Index k = 0; k < y.size(); ++k) y[k] = u[next++];
    };
    (take(pieces), ...);
  }
};

}  // namespace stepwire
