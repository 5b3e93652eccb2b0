// What the keys and the mouse of `antumbra view` do to the camera and the clock. Pure: no window.
#pragma once

#include <string>

#include "quantity/quantity.h"
#include "scene/scene.h"

namespace antumbra {

class ViewControls {
 public:
  explicit ViewControls(const Scene& scene);

  void togglePause();        // space
  void step(int direction);  // ',' back, '.' forward: one second of playback at the present rate
  void changeRate(int direction);  // '[' slower, ']' faster; below 1 s/s the clock runs backwards
  // Drag by pixels: the sky follows the mouse.
  void drag(double dx, double dy);
  // Zoom by wheel steps: the field shrinks by a tenth per step away from the user.
  void zoom(double steps);
  void resize(int width, int height);
  // Wall time that has passed since the last call.
  void advance(Duration wall);

  // The scene with the camera as the user has turned it.
  Scene scene() const;
  Duration timeOffset() const { return offset_; }
  double rate() const;  // seconds of the scene per second
  bool paused() const { return paused_; }
  std::string status() const;
  // The camera's horizontal direction when the user first turns away from a target.
  void lookFrom(Angle azimuth, Angle altitude);

 private:
  Scene scene_;
  bool paused_ = true;
  int rateStep_ = 1;  // index into the rates, negative backwards
  Duration offset_;
};

}  // namespace antumbra
