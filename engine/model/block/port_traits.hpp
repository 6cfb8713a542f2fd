#pragma once

#include <string>
#include <type_traits>

#include "engine/model/signal/input.hpp"
#include "engine/model/signal/signal.hpp"

namespace stepwire {

namespace detail {

template <class T>
struct PortSize;
template <int n>
struct PortSize<Input<n>> : std::integral_constant<int, n> {};
template <>
struct PortSize<Inputs> : std::integral_constant<int, any_size> {};
template <int n>
struct PortSize<Output<n>> : std::integral_constant<int, n> {};
template <int n>
struct PortSize<State<n>> : std::integral_constant<int, n> {};
template <int n>
struct PortSize<DiscreteState<n>> : std::integral_constant<int, n> {};

/// Returns the shape of a port: its fixed size, else the declared shape, else "n".
template <class Port>
std::string shape_of(const std::string& given) {
  if constexpr (PortSize<Port>::value == any_size) {
    return given.empty() ? "n" : given;
  } else {
    return std::to_string(PortSize<Port>::value);
  }
}

template <class Port>
inline constexpr int unbound_size = PortSize<Port>::value == any_size ? 0 : PortSize<Port>::value;

template <class T>
struct IsContinuous : std::false_type {};
template <int n>
struct IsContinuous<State<n>> : std::true_type {};

}  // namespace detail

}  // namespace stepwire
