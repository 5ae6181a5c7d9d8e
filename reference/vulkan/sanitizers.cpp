// What the sanitizers must know of the driver. Linked into every program that draws through Vulkan, in builds with
// -fsanitize alone (see CMakeLists.txt): the presets asan and tsan.
#include <dlfcn.h>

// The loader unloads the driver and the layer, and the sanitizers look for the names in their reports only
// afterwards: what lies in a library that is gone matches no suppression. So nothing is unloaded.
extern "C" int dlclose(void* /*handle*/) noexcept {
  return 0;
}

// The driver, its compiler and the validation layer keep memory of their own until the process ends. Only what they
// allocated themselves is left out; a Vulkan object that we forget is reported by the layer.
// NOLINTNEXTLINE(readability-identifier-naming): the sanitizer's name for it
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libvulkan_lvp.so\n"
         "leak:libVkLayer_khronos_validation.so\n"
         "leak:libLLVM\n";
}

// These libraries are not compiled with the thread sanitizer, which sees no order in what their own threads do. The
// driver's compiler registers its code with libgcc, which leaves a lock by a jump that looks like the compiler's own.
// NOLINTNEXTLINE(readability-identifier-naming): the sanitizer's name for it
extern "C" const char* __tsan_default_suppressions() {
  return "called_from_lib:libvulkan_lvp.so\n"
         "called_from_lib:libVkLayer_khronos_validation.so\n"
         "called_from_lib:libLLVM\n"
         "mutex:__register_frame_info_bases\n"
         "mutex:__deregister_frame_info_bases\n";
}
