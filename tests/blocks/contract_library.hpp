#pragma once

#include <string>
#include <vector>

namespace stepwire {

/// A source that is compiled and loaded as compiled code of a run is.
class ContractLibrary {
 public:
  /// Fails the test where the source cannot be compiled or loaded.
  ContractLibrary(const std::string& source, const std::string& optimisation);
  ~ContractLibrary();
  ContractLibrary(const ContractLibrary&) = delete;
  ContractLibrary& operator=(const ContractLibrary&) = delete;

  /// Sets a pointer to an exported function.
  template <class Function>
  void find(const std::string& name, Function*& function) const {
    function = reinterpret_cast<Function*>(address(name));
  }

  /// Names of the functions and objects that it takes from others, and of those that it offers: of C++ ones
  /// with their namespaces.
  const std::vector<std::string>& undefined() const { return undefined_; }
  const std::vector<std::string>& exported() const { return exported_; }

 private:
  void* address(const std::string& name) const;

  void* library_ = nullptr;
  std::vector<std::string> undefined_, exported_;
};

/// Whether there is a C++ compiler; warns where there is none.
bool has_compiler();

}  // namespace stepwire
