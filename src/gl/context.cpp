#include "gl/context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <vector>

#include "document/input_error.h"
#include "gl/api.h"
#include "gl/device_error.h"

namespace antumbra::gl {

struct HeadlessContext::State {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

namespace {

const char* eglErrorName(EGLint error) {
  switch (error) {
    case EGL_SUCCESS:
      return "no reason given";
    case EGL_NOT_INITIALIZED:
      return "EGL_NOT_INITIALIZED";
    case EGL_BAD_ALLOC:
      return "EGL_BAD_ALLOC";
    case EGL_BAD_CONFIG:
      return "EGL_BAD_CONFIG";
    case EGL_BAD_MATCH:
      return "EGL_BAD_MATCH";
    case EGL_BAD_PARAMETER:
      return "EGL_BAD_PARAMETER";
    case EGL_BAD_DISPLAY:
      return "EGL_BAD_DISPLAY";
    default:
      return "an EGL error";
  }
}

bool hasWord(const char* list, const char* word) {
  return list && std::strstr(list, word) != nullptr;
}

EGLContext contextOn(EGLDisplay display) {
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return EGL_NO_CONTEXT;
  if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               4,
                               EGL_CONTEXT_MINOR_VERSION,
                               5,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
#ifndef NDEBUG
                               EGL_CONTEXT_OPENGL_DEBUG,
                               EGL_TRUE,
#endif
                               EGL_NONE};
  EGLContext const context =
      eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT) return context;
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    eglDestroyContext(display, context);
    return EGL_NO_CONTEXT;
  }
  return context;
}

#ifndef NDEBUG
void APIENTRY onMessage(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message,
                        const void*) {
  if (type != GL_DEBUG_TYPE_ERROR) return;
  fmt::print(stderr, "OpenGL: {}\n", message);
  std::abort();
}
#endif

}  // namespace

HeadlessContext::HeadlessContext() : state_(std::make_unique<State>()) {
  const char* forced = std::getenv("ANTUMBRA_EGL");
  std::string const only = forced ? forced : "";
  if (!only.empty() && only != "device" && only != "surfaceless")
    throw InputError(fmt::format("ANTUMBRA_EGL: found \"{}\"; allowed: device, surfaceless", only));
  auto const getDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  std::string tried;
  auto const attempt = [&](EGLDisplay display, const std::string& name) {
    EGLContext const context = contextOn(display);
    if (context == EGL_NO_CONTEXT) {
      tried += fmt::format("\n  {}: {}", name, eglErrorName(eglGetError()));
      return false;
    }
    state_->display = display;
    state_->context = context;
    return true;
  };

  if (!getDisplay) throw DeviceError("no usable graphics device: EGL_EXT_platform_base is missing");
  // Hardware first: EGL devices that are not Mesa's software device.
  auto const queryDevices =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  auto const queryDeviceString = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(
      eglGetProcAddress("eglQueryDeviceStringEXT"));
  if (only != "surfaceless" && queryDevices && queryDeviceString) {
    EGLDeviceEXT devices[16];
    EGLint count = 0;
    queryDevices(16, devices, &count);
    for (int i = 0; i < count; ++i) {
      if (hasWord(queryDeviceString(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software"))
        continue;
      if (attempt(getDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr),
                  fmt::format("EGL device {}", i)))
        return;
    }
    if (count == 0) tried += "\n  EGL devices: none found";
  }
  if (only != "device") {
    if (attempt(getDisplay(EGL_PLATFORM_SURFACELESS_MESA,
                           reinterpret_cast<void*>(EGL_DEFAULT_DISPLAY), nullptr),
                "EGL surfaceless (Mesa)"))
      return;
  }
  throw DeviceError(fmt::format(
      "no usable graphics device: an OpenGL 4.5 core context could not be made. Tried:{}\n"
      "Install libgl1-mesa-dri and libegl-mesa0 for the software renderer.",
      tried.empty() ? "\n  EGL devices: only software ones found" : tried));
}

HeadlessContext::~HeadlessContext() {
  if (state_->context == EGL_NO_CONTEXT) return;
  eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(state_->display, state_->context);
  eglTerminate(state_->display);
}

DeviceDescription describeDevice() {
  DeviceDescription d;
  d.renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  d.version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  d.software = hasWord(d.renderer.c_str(), "llvmpipe") || hasWord(d.renderer.c_str(), "softpipe");
  GLint viewport[2] = {};
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &d.maxTextureSize);
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  d.maxViewport = std::min(viewport[0], viewport[1]);
  return d;
}

void prepareContext() {
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
#ifndef NDEBUG
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(onMessage, nullptr);
#endif
}

}  // namespace antumbra::gl
