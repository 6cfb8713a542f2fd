#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>

#include "engine/app/python/python_class.hpp"
#include "engine/model/block/block.hpp"
#include "engine/model/block/value.hpp"

namespace stepwire::python {

class Instance;

/// Block whose methods are those of a Python object. Each run makes its own object at the start.
struct PythonBlock {
  static constexpr std::size_t most = 16;  ///< largest number of ports, states or parameters of each kind

  std::shared_ptr<const PythonClass> of{};
  std::array<Input<>, most> inputs{};
  std::array<Output<>, most> results{};
  std::array<State<>, most> states{};
  std::array<DiscreteState<>, most> memory{};
  std::array<Value, most> values{};  ///< parameter values
  Diagnostic failed{};
  Time t{};
  Period period{};
  double now = 0.0, between = 0.0;       ///< copies of t and period, as arguments of the methods
  std::shared_ptr<Instance> instance{};  ///< nullptr in a copy.
  std::string why{};                     ///< Reason of the failure; empty before it.

  PythonBlock() = default;
  /// Copies all but the object, which start() makes.
  PythonBlock(const PythonBlock& other);
  PythonBlock& operator=(const PythonBlock&) = delete;

  void outputs();
  void derivatives();
  void update();
  void start();
  /// Constructs the object once, so that an exception in its __init__ is reported at loading.
  void configure(Configure& is);
  static void declare(Declare<PythonBlock>& is);

 private:
  void connect(std::size_t method);
  void call(std::size_t method);
  void fail();
};

}  // namespace stepwire::python
