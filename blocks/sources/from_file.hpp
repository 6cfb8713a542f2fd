#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "blocks/records/band_limited.hpp"
#include "blocks/sources/own_time.hpp"
#include "blocks/sources/samples.hpp"
#include "engine/model/block/tree.hpp"
#include "engine/model/signal/file_path.hpp"
#include "engine/model/signal/texts.hpp"

namespace stepwire {

/// Prepared columns of a data file as a signal: y(t) is the record at t + start, held, linear, or
/// band-limited between rows.
struct FromFile : OwnTime {
  enum class Interpolation { linear, hold, band_limited };
  enum class AfterEnd { refuse, hold, repeat };
  enum class Missing { refuse, hold, skip };
  enum class Decimal { detect, comma, point };
  static constexpr double open = std::numeric_limits<double>::infinity();

  FilePath file{};
  Texts column{}, unit{};
  Text time = Text::literal<"time">();
  double sample_time = 0.0, from = -open, to = open, start_ = -open;
  Decimal decimal = Decimal::detect;
  Missing missing = Missing::refuse;
  bool sort = false;
  Tree prepare_{};
  Interpolation interpolation = Interpolation::linear;
  AfterEnd after_end = AfterEnd::refuse;
  Output<> y{};
  Diagnostic ended{};
  Samples samples;
  BandLimited smooth;   ///< of the columns, if band-limited
  double offset = 0.0;  ///< instant of the record at time 0 of the run [s]

  /// Computes the outputs with the tolerance of reached(): at an instant, a stage reads the value that begins
  /// there.
  void outputs() { play(8.0 * std::numeric_limits<double>::epsilon() * std::abs(own() + offset)); }
  /// Computes the outputs with a larger tolerance: times in files are rounded, and a held row must begin at a
  /// tick rather than just after it.
  void outputs_at_instant() { play(samples.slack()); }
  double next_edge() const {
    if (interpolation == Interpolation::band_limited) return open;
    const double at = place(own() + offset + samples.slack());
    const Index row = samples.row_at(at), last = samples.rows() - 1;
    const double gone = own() + offset - (at - samples.slack());  // previous periods
    if (at < samples.begin()) return began() + (samples.begin() - offset);
    if (row < last) return began() + (gone + samples.time[row + 1] - offset);
    if (after_end != AfterEnd::repeat) return open;
    return began() + (gone + samples.begin() + samples.period() - offset);
  }
  void play(double slack) {
    if (interpolation == Interpolation::band_limited) {
      const double turns = (own() + offset - samples.begin()) / samples.period();
      for (Index k = 0; k < y.size(); ++k) y[k] = smooth(k, turns);
    } else if (interpolation == Interpolation::hold) {
      const Index row = samples.row_at(place(own() + offset + slack));
      for (Index k = 0; k < y.size(); ++k) y[k] = samples.value(k, row);
    } else {
      straight(place(own() + offset), slack);
    }
  }
  void update() {
    if (ends() && own() + offset > samples.end() + samples.slack()) ended.raise(t);
    if (restart) keep_origin();
  }

  void configure(Configure& is);
  static void declare(Declare<FromFile>& is);

 private:
  bool ends() const { return after_end == AfterEnd::refuse && interpolation != Interpolation::band_limited; }
  double place(double instant) const {
    return after_end == AfterEnd::repeat ? samples.wrapped(instant) : instant;
  }

  /// Interpolates linearly. The successor of the last row is the first one if repeated, else itself. The
  /// larger tolerance applies to jumps, so that a jump is not late, like a held row.
  void straight(double instant, double slack) {
    const Index soon = samples.row_at(instant + slack), last = samples.rows() - 1;
    const Index row = samples.is_jump(soon) ? soon : samples.row_at(instant);
    const Index next = row < last ? row + 1 : after_end == AfterEnd::repeat ? 0 : last;
    const double length = row < last ? samples.time[next] - samples.time[row] : samples.interval;
    const double share = std::clamp((instant - samples.time[row]) / length, 0.0, 1.0);
    for (Index k = 0; k < y.size(); ++k) {
      const double here = samples.value(k, row);
      y[k] = here + share * (samples.value(k, next) - here);
    }
  }
};

}  // namespace stepwire
