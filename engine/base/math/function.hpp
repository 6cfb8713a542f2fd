#pragma once

#include <memory>
#include <string>
#include <utility>

namespace stepwire {

/// A number that follows from the numbers v[0], v[1], ..., as a block is given it. In a program it is code of
/// C++, which a compiler takes into its place; before there is a program it has a source that evaluates it.
class Function {
 public:
  using Code = double (*)(const double* v);

  /// Any number of threads may evaluate it at once; copies of a function share it.
  class Source {
   public:
    virtual ~Source() = default;
    virtual double operator()(const double* v) const = 0;
    /// The value as an expression of C++ over v: a double or a bool.
    virtual std::string cpp() const = 0;
  };

  /// Always 0.
  Function() = default;
  Function(Code code) : code_(code) {}
  explicit Function(std::shared_ptr<const Source> source) : source_(std::move(source)) {}

  double operator()(const double* v) const { return source_ ? (*source_)(v) : code_(v); }
  /// Null where it is code.
  const Source* source() const { return source_.get(); }

 private:
  Code code_ = [](const double*) { return 0.0; };
  std::shared_ptr<const Source> source_;
};

}  // namespace stepwire
