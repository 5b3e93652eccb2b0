// A window on the screen with an OpenGL 4.5 context, by GLFW, and what its user does there.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace antumbra {

class Window {
 public:
  struct Events {
    std::function<void(int key)> onKey;                   // GLFW key, on press and repeat
    std::function<void(double dx, double dy)> onDrag;     // pixels, left button held
    std::function<void(double steps)> onWheel;            // positive: away from the user
    std::function<void(int width, int height)> onResize;  // framebuffer pixels
  };
  // Throws DeviceError if there is no display, or no OpenGL 4.5 on it.
  Window(const std::string& title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  void listen(Events events);
  bool open() const;
  void close();
  void setTitle(const std::string& title);
  // Shows what was drawn and handles what the user did since.
  void showAndPoll();
  int width() const;  // framebuffer pixels
  int height() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace antumbra
