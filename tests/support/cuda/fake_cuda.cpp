// Driver of a GPU whose memory and kernels are those of this process, for tests of `run --device gpu` without
// one. The compiler beside this file writes the path of a library in place of PTX.
//
// $FAKE_CUDA chooses a fault. With `none` there is no GPU, and with `old` it is too old. With `full` there is
// no memory, and with `late` there is memory for one group. With `broken` a kernel fails, and with `slow` it
// takes 20 ms longer.

#include <dlfcn.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

#include "engine/simulate/device/piece.hpp"

namespace {

constexpr int success = 0, out_of_memory = 2, invalid_image = 200, not_found = 500, launch_failed = 719;
constexpr int allocations_of_a_group = 5;

std::atomic<int> allocations = 0;

bool is(const char* fault) {
  const char* chosen = std::getenv("FAKE_CUDA");
  return chosen && std::strcmp(chosen, fault) == 0;
}

}  // namespace

extern "C" {

int cuInit(unsigned) {
  return success;
}
int cuGetErrorString(int result, const char** text) {
  *text = result == out_of_memory   ? "out of memory"
          : result == launch_failed ? "unspecified launch failure"
                                    : "another error";
  return success;
}
int cuDeviceGetCount(int* count) {
  *count = is("none") ? 0 : 1;
  return success;
}
int cuDeviceGet(int* device, int) {
  *device = 0;
  return success;
}
int cuDeviceGetName(char* name, int length, int) {
  std::strncpy(name, "Fake GPU", static_cast<std::size_t>(length));
  return success;
}
int cuDeviceGetAttribute(int* value, int, int) {
  *value = is("old") ? 6 : 8;
  return success;
}
int cuDevicePrimaryCtxRetain(void** context, int) {
  static int own;
  *context = &own;
  return success;
}
int cuDevicePrimaryCtxRelease_v2(int) {
  return success;
}
int cuCtxSetCurrent(void*) {
  return success;
}
int cuStreamSynchronize_ptsz(void*) {
  return is("broken") ? launch_failed : success;
}
int cuMemGetInfo_v2(std::size_t* free, std::size_t* total) {
  *free = *total = std::size_t{1} << 30;
  return success;
}
int cuMemAlloc_v2(unsigned long long* memory, std::size_t bytes) {
  const int count = allocations++;
  if (is("full") || (is("late") && count >= allocations_of_a_group)) return out_of_memory;
  *memory = reinterpret_cast<unsigned long long>(std::malloc(bytes));
  return success;
}
int cuMemFree_v2(unsigned long long memory) {
  std::free(reinterpret_cast<void*>(memory));
  return success;
}
int cuMemcpyHtoD_v2_ptds(unsigned long long to, const void* from, std::size_t bytes) {
  std::memcpy(reinterpret_cast<void*>(to), from, bytes);
  return success;
}
int cuMemcpyDtoH_v2_ptds(void* to, unsigned long long from, std::size_t bytes) {
  std::memcpy(to, reinterpret_cast<const void*>(from), bytes);
  return success;
}
int cuModuleLoadData(void** module, const void* image) {
  const std::string path(static_cast<const char*>(image));
  *module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  return *module ? success : invalid_image;
}
int cuModuleUnload(void*) {
  return success;
}
int cuModuleGetFunction(void** function, void* module, const char* name) {
  *function = ::dlsym(module, name);
  return *function ? success : not_found;
}
int cuLaunchKernel_ptsz(void* function, unsigned, unsigned, unsigned, unsigned, unsigned, unsigned, unsigned,
                        void*, void** arguments, void**) {
  if (is("slow")) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const auto run = reinterpret_cast<void (*)(stepwire::device::Piece)>(function);
  run(*static_cast<const stepwire::device::Piece*>(arguments[0]));
  return success;
}
}
