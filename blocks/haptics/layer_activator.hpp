#pragma once

#include <algorithm>

#include "blocks/haptics/layer_events.hpp"
#include "engine/model/block/block.hpp"
#include "engine/model/block/tree.hpp"

namespace stepwire {

/// Activates one of several layers of a resistance map. Events on the path of the end-effector switch between
/// them:
///
///     y = sum of w_k u_k,  w = (1 - s) w(at the switch) + s (1 for the active layer, else 0),
///
/// where s increases from 0 to 1 over the blend time. A switch therefore changes y from one tick to the next
/// by at most (period/blend) times the largest difference of two layers.
struct LayerActivator {
  Tree switches;
  double blend = 0.05;
  std::int64_t initial = 1;
  Inputs u{}, regions{};
  Input<2> position{};
  Output<> y{}, weights{};
  Output<1> layer{}, switched{};
  DiscreteState<> mixed{};              ///< weights of the layers at the last switch
  DiscreteState<1> active{}, share{};   ///< index of the active layer; s
  DiscreteState<1> count{};             ///< number of switches
  DiscreteState<> reached{}, waited{};  ///< for each switch: events so far; ticks since
  DiscreteState<2> last_position{};
  DiscreteState<> last_distances{};
  DiscreteState<1> begun{};
  Period period{};

  Numbers ways{};    ///< `way_size` numbers for each switch
  Numbers events{};  ///< numbers of each LayerEvent, sequence by sequence

  /// Numbers of a switch: its source and target layer, its first event, and its number of events.
  enum WayNumber { from, to, first_event, event_count, way_size };

  void outputs() {
    weights.each([&](Index k) { return weight(k); });
    y.each([&](Index i) {
      double sum = 0.0;
      for (Index k = 0; k < u.count(); ++k)
        if (weight(k) > 0.0) sum += weight(k) * u[k][i];
      return sum;
    });
    layer = active + 1.0;
    switched = count;
  }

  void update() {
    share = blend > 0.0 ? std::min(1.0, share + period / blend) : 1.0;
    const double was = active;
    for (Index k = 0; k < reached.size() && active == was; ++k)
      if (number(k, from) == was) follow(k);
    remember();
  }

  void start() {
    active = static_cast<double>(initial - 1);
    share = 1.0;
  }
  void configure(Configure& is);
  static void declare(Declare<LayerActivator>& is);

 private:
  double number(Index k, WayNumber which) const { return ways[k * way_size + which]; }

  double weight(Index k) const {
    const double goal = static_cast<double>(k) == active ? 1.0 : 0.0;
    return share >= 1.0 ? goal : (1.0 - share) * mixed[k] + share * goal;
  }

  /// Checks for the next event of a sequence; at most one event per tick.
  void follow(Index k) {
    waited[k] = waited[k] + 1.0;
    const auto next = static_cast<Index>(number(k, first_event) + reached[k]);
    const LayerEvent event{events.data() + next * LayerEvent::size};
    if (!event.happens(moment(event, waited[k] * period))) return;
    reached[k] = reached[k] + 1.0;
    waited[k] = 0.0;
    if (reached[k] == number(k, event_count)) activate(number(k, to));
  }

  /// Returns the data for an event; at the first tick without motion.
  LayerMoment moment(const LayerEvent& event, double since) const {
    const Vector2 now{position[0], position[1]};
    LayerMoment is{now, now, 0.0, 0.0, since};
    if (event.concerns_region()) is.distance_before = is.distance_now = regions.first(event.region());
    if (begun == 0.0) return is;
    is.before = {last_position[0], last_position[1]};
    if (event.concerns_region()) is.distance_before = last_distances[event.region()];
    return is;
  }

  void activate(double next) {
    mixed.each([&](Index k) { return weight(k); });
    active = next;
    share = blend > 0.0 ? 0.0 : 1.0;
    count = count + 1.0;
    reached.each([](Index) { return 0.0; });
    waited.each([](Index) { return 0.0; });
  }

  void remember() {
    last_position[0] = position[0];
    last_position[1] = position[1];
    for (Index i = 0; i < regions.count(); ++i) last_distances[i] = regions.first(i);
    begun = 1.0;
  }
};

}  // namespace stepwire
