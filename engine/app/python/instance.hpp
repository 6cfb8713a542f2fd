#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "engine/app/python/python_class.hpp"

namespace stepwire::python {

/// Destination of a result of a method.
struct Target {
  double* numbers;
  Eigen::Index size;
  const char* name;
  Eigen::Index rows = 0;  ///< rows of a matrix in column-major order; 0 for a vector
};

/// Source of an argument of a method.
struct Given {
  const double* numbers;
  Eigen::Index size;
  Eigen::Index rows = 0;  ///< as in Target
};

/// Python object of a block, with the methods that a run calls.
/// The caller must hold the interpreter lock. Calls that raise a Python exception return false or nullptr.
class Instance {
 public:
  /// Makes the object. Its parameters are set as attributes before __init__ is called.
  static std::shared_ptr<Instance> make(const PythonClass& of, const Value* parameters);

  /// Sets sources of the arguments and destinations of the results, for all later calls.
  void connect(std::size_t method, std::vector<Given> given, std::vector<Target> targets);
  /// Calls a method and stores its results.
  bool call(std::size_t method);

 private:
  /// Array argument, which is refilled before each call.
  struct Buffer {
    Held array;
    double* numbers = nullptr;
  };
  struct Bound {
    Held method;
    const char* shown = "";
    std::vector<Given> given{};
    std::vector<Target> targets{};
    std::vector<Buffer> buffers{};
    std::vector<_object*> arguments{};  ///< arguments of the current call
  };

  bool bind(const PythonClass& of);
  static bool fill(Bound& bound);

  Held object_;
  std::array<Bound, 3> methods_;
};

/// Describes an exception: "ValueError: a negative mass (Drag.outputs, drag.py:12)". The caller must hold the
/// interpreter lock.
std::string text_of(_object* exception);

}  // namespace stepwire::python
