#include "output/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "gl/device_error.h"

namespace antumbra {

struct Window::State {
  GLFWwindow* window = nullptr;
  Events events;
  bool dragging = false;
  double x = 0.0, y = 0.0;
};

namespace {

std::string lastProblem() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

}  // namespace

Window::Window(const std::string& title, int width, int height)
    : state_(std::make_unique<State>()) {
  if (!glfwInit())
    throw DeviceError(
        fmt::format("no window can be opened: {}. Tried GLFW on the display named by DISPLAY or "
                    "WAYLAND_DISPLAY; `antumbra render` needs no display",
                    lastProblem()));
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  state_->window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (!state_->window) {
    std::string const why = lastProblem();
    glfwTerminate();
    throw DeviceError(
        fmt::format("no window can be opened: {}. Tried an OpenGL 4.5 core context", why));
  }
  glfwMakeContextCurrent(state_->window);
  glfwSetWindowUserPointer(state_->window, state_.get());
  glfwSetKeyCallback(state_->window, [](GLFWwindow* w, int key, int, int action, int) {
    auto* s = static_cast<State*>(glfwGetWindowUserPointer(w));
    if (action != GLFW_RELEASE && s->events.onKey) s->events.onKey(key);
  });
  glfwSetMouseButtonCallback(state_->window, [](GLFWwindow* w, int button, int action, int) {
    auto* s = static_cast<State*>(glfwGetWindowUserPointer(w));
    if (button != GLFW_MOUSE_BUTTON_LEFT) return;
    s->dragging = action == GLFW_PRESS;
    glfwGetCursorPos(w, &s->x, &s->y);
  });
  glfwSetCursorPosCallback(state_->window, [](GLFWwindow* w, double x, double y) {
    auto* s = static_cast<State*>(glfwGetWindowUserPointer(w));
    if (s->dragging && s->events.onDrag) s->events.onDrag(x - s->x, y - s->y);
    s->x = x;
    s->y = y;
  });
  glfwSetScrollCallback(state_->window, [](GLFWwindow* w, double, double steps) {
    auto* s = static_cast<State*>(glfwGetWindowUserPointer(w));
    if (s->events.onWheel) s->events.onWheel(steps);
  });
  glfwSetFramebufferSizeCallback(state_->window, [](GLFWwindow* w, int newWidth, int newHeight) {
    auto* s = static_cast<State*>(glfwGetWindowUserPointer(w));
    if (newWidth > 0 && newHeight > 0 && s->events.onResize)
      s->events.onResize(newWidth, newHeight);
  });
}

Window::~Window() {
  glfwDestroyWindow(state_->window);
  glfwTerminate();
}

void Window::listen(Events events) { state_->events = std::move(events); }
bool Window::open() const { return !glfwWindowShouldClose(state_->window); }
void Window::close() { glfwSetWindowShouldClose(state_->window, GLFW_TRUE); }
void Window::setTitle(const std::string& title) {
  glfwSetWindowTitle(state_->window, title.c_str());
}
void Window::showAndPoll() {
  glfwSwapBuffers(state_->window);
  glfwPollEvents();
}
int Window::width() const {
  int w = 0, h = 0;
  glfwGetFramebufferSize(state_->window, &w, &h);
  return w;
}
int Window::height() const {
  int w = 0, h = 0;
  glfwGetFramebufferSize(state_->window, &w, &h);
  return h;
}

}  // namespace antumbra
