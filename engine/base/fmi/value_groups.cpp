#include "engine/base/fmi/value_groups.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stepwire::fmi {

namespace {

/// Converts a number to the nearest value of a type; integers are rounded and clamped to its range.
template <class Value>
Value nearest(double number) {
  if constexpr (std::is_floating_point_v<Value>) {
    return static_cast<Value>(number);
  } else if constexpr (std::is_same_v<Value, bool>) {
    return number != 0.0;
  } else {
    constexpr auto lowest = std::numeric_limits<Value>::lowest(), largest = std::numeric_limits<Value>::max();
    const double whole = std::round(number);
    if (!(whole > static_cast<double>(lowest))) return lowest;
    return whole < static_cast<double>(largest) ? static_cast<Value>(whole) : largest;
  }
}

/// Calls a function with a value of the corresponding C++ type.
template <class Function>
void with_type(Type type, const Function& of) {
  switch (type) {
    case Type::float64: return of(double{});
    case Type::float32: return of(float{});
    case Type::int8: return of(std::int8_t{});
    case Type::uint8: return of(std::uint8_t{});
    case Type::int16: return of(std::int16_t{});
    case Type::uint16: return of(std::uint16_t{});
    case Type::int32: return of(std::int32_t{});
    case Type::uint32: return of(std::uint32_t{});
    case Type::int64: return of(std::int64_t{});
    case Type::uint64: return of(std::uint64_t{});
    case Type::boolean: return of(bool{});
    case Type::wide_boolean: return of(int{});
    case Type::other: return;
  }
}

}  // namespace

ValueGroups::ValueGroups(const std::vector<const Variable*>& variables, Which which) {
  for (const Variable* variable : variables) {
    if (which == Which::continuous && variable->discrete) {
      count_ += variable->size;
      continue;
    }
    auto group = std::ranges::find(groups_, variable->type, &Group::type);
    if (group == groups_.end()) group = groups_.insert(groups_.end(), Group{variable->type, {}, {}, {}});
    group->references.push_back(variable->reference);
    for (std::size_t i = 0; i < variable->size; ++i)
      group->places.push_back({count_++, variable->factor, variable->offset});
    group->room.resize(group->places.size());
  }
}

bool ValueGroups::get(Calls& calls, double* numbers) {
  for (Group& group : groups_) {
    const std::size_t size = group.places.size();
    if (!calls.get(group.type, group.references.data(), group.references.size(), group.room.data(), size))
      return false;
    with_type(group.type, [&](auto zero) {
      const auto* values = reinterpret_cast<const decltype(zero)*>(group.room.data());
      for (std::size_t i = 0; i < size; ++i) {
        const Place& place = group.places[i];
        const double scaled = place.factor * static_cast<double>(values[i]);
        numbers[place.number] = place.offset == 0.0 ? scaled : place.offset + scaled;  // preserves -0
      }
    });
  }
  return true;
}

bool ValueGroups::set(Calls& calls, const double* numbers) {
  for (Group& group : groups_) {
    const std::size_t size = group.places.size();
    with_type(group.type, [&](auto zero) {
      auto* values = reinterpret_cast<decltype(zero)*>(group.room.data());
      for (std::size_t i = 0; i < size; ++i) {
        const Place& place = group.places[i];
        const bool flag = group.type == Type::wide_boolean;
        const double number = (numbers[place.number] - place.offset) / place.factor;
        values[i] = nearest<decltype(zero)>(flag ? number != 0.0 : number);
      }
    });
    if (!calls.set(group.type, group.references.data(), group.references.size(), group.room.data(), size))
      return false;
  }
  return true;
}

}  // namespace stepwire::fmi
