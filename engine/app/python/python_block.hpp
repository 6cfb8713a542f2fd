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

/// A block whose methods are those of an object of Python's. Each run makes an object of its own as it
/// starts.
struct PythonBlock {
  static constexpr std::size_t most = 16;  ///< ports, states and parameters of each kind

  std::shared_ptr<const PythonClass> of{};
  std::array<Input<>, most> inputs{};
  std::array<Output<>, most> results{};
  std::array<State<>, most> states{};
  std::array<DiscreteState<>, most> memory{};
  std::array<Value, most> values{};  ///< of the parameters
  Diagnostic failed{};
  Time t{};
  Period period{};
  double now = 0.0, between = 0.0;       ///< both as arguments
  std::shared_ptr<Instance> instance{};  ///< none in a copy
  std::string why{};                     ///< it failed; empty: it works

  PythonBlock() = default;
  /// A copy has no object until it starts.
  PythonBlock(const PythonBlock& other);
  PythonBlock& operator=(const PythonBlock&) = delete;

  void outputs();
  void derivatives();
  void update();
  void start();
  /// Tries the object: what its __init__ raises is refused.
  void configure(Configure& is);
  static void declare(Declare<PythonBlock>& is);

 private:
  void connect(std::size_t method);
  void call(std::size_t method);
  void fail();
};

}  // namespace stepwire::python
