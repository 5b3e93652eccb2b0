// What a picture needs, and why: the bodies worth drawing, the points, the shadows that are live,
// the tables and the passes, each with its reason, and what was left out. Pure: no OpenGL, no
// clock.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "eclipse/corona_light.h"
#include "plan/overlay_plan.h"
#include "plan/planned_body.h"
#include "scene/placed_scene.h"
#include "scene/scene.h"

namespace antumbra {

// A body below half a pixel.
struct PlannedPoint {
  std::string name;
  Direction<CameraAxes> direction;
  double illuminance = 0.0;  // lx, outside any air
  double colorIndexBv = 0.0;
};

struct PlannedSun {
  Direction<CameraAxes> direction;
  Angle angularRadius;
  Length distance;
  Length radius;                // by the scene's convention
  Direction<CameraAxes> north;  // of its rotation
  bool inPicture = false;       // some of its disc falls into the picture
  bool hiddenByBody = false;    // with all its corona
  std::string hiddenBy;
  PixelBounds bounds;  // of its disc
};

// A body that may cover a part of the Sun's disc, in the picture or outside.
struct SunCoverer {
  Displacement<CameraAxes> centre;
  Direction<CameraAxes> pole;
  Length equatorialRadius;
  Length polarRadius;
};

struct RenderPlan {
  Projection picture;
  std::vector<PlannedBody> bodies;  // discs, far to near; the camera's own body last
  std::vector<PlannedPoint> points;
  PlannedSun sun;
  std::vector<SunCoverer> sunCoverers;
  bool drawSun = false;
  bool queryOcclusion = false;
  // The corona that lights what lies in shadows; none where nothing does or the scene forbids it.
  std::shared_ptr<const CoronaLight> coronaLight;
  PlannedOverlays overlays;       // above the tone-mapped picture
  bool glareFromOutside = false;  // the Sun before the camera but outside the picture

  std::vector<Reason> drawn;    // bodies and points
  std::vector<Reason> tables;   // atmosphere tables to have resident, by medium
  std::vector<Reason> shadows;  // live caster-receiver pairs
  std::vector<Reason> passes;   // in order
  std::vector<Reason> sky;      // how `antumbra sky` is asked for the light of the camera's own air
  std::vector<Reason> leftOut;

  // After `picture`'s size has changed: every rectangle and size in pixels follows.
  void rescaleBounds(const Projection& before);
};

RenderPlan makeRenderPlan(const Scene& scene, const PlacedScene& placed);

}  // namespace antumbra
