// An OpenGL 4.5 core context without any display, through EGL: a hardware device where the machine
// has one (EGL_EXT_platform_device, as NVIDIA offers), else Mesa's surfaceless platform.
#pragma once

#include <memory>
#include <string>

namespace antumbra::gl {

class HeadlessContext {
 public:
  // Makes a context and makes it current on this thread. The environment variable ANTUMBRA_EGL may
  // force `device` or `surfaceless`. Throws DeviceError naming every platform that was tried and
  // why it failed, or InputError for another value of the variable.
  HeadlessContext();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// What the current context reports.
struct DeviceDescription {
  std::string renderer;
  std::string version;
  bool software = false;  // timer queries say nothing there: time by wall clock
  int maxTextureSize = 0;
  int maxViewport = 0;
};
DeviceDescription describeDevice();

// Sets up state that every pass relies on: seamless cube maps, clip depth from 0 to 1, and in debug
// builds a message callback that stops on errors.
void prepareContext();

}  // namespace antumbra::gl
