#include "engine/simulate/device/cuda.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <mutex>
#include <utility>

#include "engine/base/math/floating_point.hpp"
#include "engine/base/subprocess/fork.hpp"
#include "engine/simulate/device/kernel_text.hpp"

namespace stepwire::device {

namespace {

// The part of the driver's interface that is used here, declared as cuda.h does. Each thread has a stream of
// its own (functions with _ptds and _ptsz), so that the groups of several threads overlap.
using Result = int;
using DeviceNumber = int;
using Address = unsigned long long;
using Handle = void*;

constexpr unsigned threads_of_block = 128;
constexpr int major_capability = 75;  // attribute of a device
constexpr int least_major = 7;        // kernels are compiled for sm_70

/// Functions of the driver.
struct Driver {
  Result (*init)(unsigned flags) = nullptr;
  Result (*error_string)(Result, const char** text) = nullptr;
  Result (*device_count)(int* count) = nullptr;
  Result (*device_get)(DeviceNumber* device, int ordinal) = nullptr;
  Result (*device_name)(char* name, int length, DeviceNumber) = nullptr;
  Result (*device_attribute)(int* value, int attribute, DeviceNumber) = nullptr;
  Result (*retain_context)(Handle* context, DeviceNumber) = nullptr;
  Result (*release_context)(DeviceNumber) = nullptr;
  Result (*set_current)(Handle context) = nullptr;
  Result (*synchronize)(Handle stream) = nullptr;
  Result (*memory_info)(std::size_t* free, std::size_t* total) = nullptr;
  Result (*allocate)(Address* memory, std::size_t bytes) = nullptr;
  Result (*release)(Address memory) = nullptr;
  Result (*write)(Address to, const void* from, std::size_t bytes) = nullptr;
  Result (*read)(void* to, Address from, std::size_t bytes) = nullptr;
  Result (*load_module)(Handle* module, const void* image) = nullptr;
  Result (*unload_module)(Handle module) = nullptr;
  Result (*get_function)(Handle* function, Handle module, const char* name) = nullptr;
  Result (*launch)(Handle function, unsigned, unsigned, unsigned, unsigned, unsigned, unsigned, unsigned,
                   Handle stream, void** arguments, void** extra) = nullptr;

  /// Returns the text of an error.
  std::string text(Result result) const {
    const char* text = nullptr;
    if (error_string(result, &text) != 0 || !text) return fmt::format("error {}", result);
    return text;
  }
  /// Throws DeviceError unless a call has succeeded.
  void require(Result result, const char* what) const {
    if (result != 0) throw DeviceError(fmt::format("the device cannot {}: {}", what, text(result)));
  }
};

/// Finds the functions of a loaded driver. Returns the name of a missing one; an empty text if all are there.
std::string find_functions(void* library, Driver& driver) {
  std::string missing;
  const auto find = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(::dlsym(library, name));
    if (!function && missing.empty()) missing = name;
  };
  find(driver.init, "cuInit");
  find(driver.error_string, "cuGetErrorString");
  find(driver.device_count, "cuDeviceGetCount");
  find(driver.device_get, "cuDeviceGet");
  find(driver.device_name, "cuDeviceGetName");
  find(driver.device_attribute, "cuDeviceGetAttribute");
  find(driver.retain_context, "cuDevicePrimaryCtxRetain");
  find(driver.release_context, "cuDevicePrimaryCtxRelease_v2");
  find(driver.set_current, "cuCtxSetCurrent");
  find(driver.synchronize, "cuStreamSynchronize_ptsz");
  find(driver.memory_info, "cuMemGetInfo_v2");
  find(driver.allocate, "cuMemAlloc_v2");
  find(driver.release, "cuMemFree_v2");
  find(driver.write, "cuMemcpyHtoD_v2_ptds");
  find(driver.read, "cuMemcpyDtoH_v2_ptds");
  find(driver.load_module, "cuModuleLoadData");
  find(driver.unload_module, "cuModuleUnload");
  find(driver.get_function, "cuModuleGetFunction");
  find(driver.launch, "cuLaunchKernel_ptsz");
  return missing;
}

/// Loads the driver. The library stays loaded, since its threads may outlive this object.
std::string load_driver(Driver& driver) {
  const std::lock_guard lock(subprocess::loader_mutex());
  const FloatingPointState kept;
  void* library = ::dlopen("libcuda.so.1", RTLD_NOW | RTLD_LOCAL);
  if (!library) return "libcuda.so.1 is not there; the driver of an NVIDIA GPU has it";
  const std::string missing = find_functions(library, driver);
  return missing.empty() ? "" : fmt::format("the driver of the GPU is too old: it has no {}", missing);
}

class CudaKernel : public Kernel {
 public:
  CudaKernel(const Driver& driver, Handle context, const std::string& ptx)
      : driver_(driver), context_(context) {
    driver_.require(driver_.set_current(context_), "be used");
    driver_.require(driver_.load_module(&module_, ptx.c_str()), "load the kernel");
    if (const Result result = driver_.get_function(&function_, module_, kernel_name); result != 0) {
      driver_.unload_module(module_);
      driver_.require(result, "find the kernel");
    }
  }
  ~CudaKernel() override {
    if (driver_.set_current(context_) == 0) driver_.unload_module(module_);
  }

  void step(const Piece& piece) override {
    driver_.require(driver_.set_current(context_), "be used");
    Piece argument = piece;
    void* arguments[] = {&argument};
    const auto blocks = static_cast<unsigned>((piece.count + threads_of_block - 1) / threads_of_block);
    driver_.require(
        driver_.launch(function_, blocks, 1, 1, threads_of_block, 1, 1, 0, nullptr, arguments, nullptr),
        "start the kernel");
    driver_.require(driver_.synchronize(nullptr), "run the kernel");
  }

 private:
  const Driver& driver_;
  Handle context_, module_ = nullptr, function_ = nullptr;
};

class CudaDevice : public Device {
 public:
  CudaDevice(const Driver& driver, DeviceNumber device) : driver_(driver), device_(device) {
    driver_.require(driver_.retain_context(&context_, device_), "be opened");
    char name[256] = "";
    driver_.device_name(name, sizeof name, device_);
    name[sizeof name - 1] = '\0';
    name_ = name;
  }
  ~CudaDevice() override { driver_.release_context(device_); }

  std::string name() const override { return name_; }
  std::size_t free_memory() override {
    std::size_t free = 0, total = 0;
    use();
    driver_.require(driver_.memory_info(&free, &total), "tell its memory");
    return free;
  }
  void* allocate(std::size_t bytes) override {
    Address memory = 0;
    use();
    driver_.require(driver_.allocate(&memory, bytes), "reserve memory");
    return reinterpret_cast<void*>(memory);
  }
  void release(void* memory) noexcept override {
    if (driver_.set_current(context_) == 0) driver_.release(reinterpret_cast<Address>(memory));
  }
  void write(void* memory, const void* from, std::size_t bytes) override {
    if (bytes == 0) return;
    use();
    driver_.require(driver_.write(reinterpret_cast<Address>(memory), from, bytes), "take numbers");
  }
  void read(void* to, const void* memory, std::size_t bytes) override {
    if (bytes == 0) return;
    use();
    driver_.require(driver_.read(to, reinterpret_cast<Address>(memory), bytes), "return numbers");
  }
  std::unique_ptr<Kernel> load(const std::string& ptx) override {
    return std::make_unique<CudaKernel>(driver_, context_, ptx);
  }

 private:
  /// Makes the context that of this thread.
  void use() { driver_.require(driver_.set_current(context_), "be used"); }

  const Driver driver_;
  const DeviceNumber device_;
  Handle context_ = nullptr;
  std::string name_;
};

/// Returns the reason why the first device cannot be used; an empty text if it can.
std::string why_not_usable(const Driver& driver, DeviceNumber& device) {
  int count = 0, major = 0;
  if (const Result result = driver.init(0); result != 0)
    return fmt::format("the driver of the GPU does not start: {}", driver.text(result));
  if (driver.device_count(&count) != 0 || count == 0 || driver.device_get(&device, 0) != 0)
    return "the driver finds no GPU";
  driver.device_attribute(&major, major_capability, device);
  if (major < least_major) return "the GPU is older than those of compute capability 7.0";
  return "";
}

}  // namespace

std::unique_ptr<Device> open_cuda(std::string& why) {
  Driver driver;
  DeviceNumber device = 0;
  why = load_driver(driver);
  if (why.empty()) why = why_not_usable(driver, device);
  if (!why.empty()) return nullptr;
  try {
    return std::make_unique<CudaDevice>(driver, device);
  } catch (const DeviceError& error) {
    why = error.what();
    return nullptr;
  }
}

}  // namespace stepwire::device
