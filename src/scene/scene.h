// A scene: when, from where, towards what, and how it is to look. Read from configs/scenes/*.toml.
//
//   title = "…"
//   time = "2027-08-02T10:06:50Z"            # or a contact: "C2 2027-08-02 @25.687,32.640"
//   bodies = ["Sun", "Earth", "Moon"]        # optional; default: every catalogued body
//   [camera]
//   body = "Earth"                           # whose surface the place is given on
//   latitude = "25.687 deg"                  # geodetic, on that body's spheroid
//   longitude = "32.640 deg"                 # east positive
//   height = "76 m"                          # above the spheroid
//   target = "Sun"                           # a body's name, "nadir" or "zenith"; or, instead,
//   azimuth = "90 deg"                       #   from north through east
//   altitude = "10 deg"                      #   above the horizontal
//   up = "zenith"                            # "zenith" (default), "north", or "azimuth"
//   up_azimuth = "0 deg"                     #   for up = "azimuth": what points up in the picture
//   roll = "0 deg"                           # turns the picture counter-clockwise
//   tilt = "0 deg"                           # dome: leans the axis toward the picture's lower edge
//   [picture]
//   projection = "perspective"               # "fisheye", "equirectangular"
//   field = "40 deg"
//   width = 1280
//   height = 720
//   [display]
//   exposure = "auto"                        # or "fixed", with
//   white = 4000.0                           #   the luminance shown as white, cd/m2
//   compensation = 0.0                       # stops, brighter when positive
//   look = "natural"                         # or "illustrative"
//   limiting_magnitude = 6.5                 # faintest stars drawn, V
//   observer = "camera"                      # or "eye": adapts in time, sees with rods in the dark
//   brackets = [-2, 0, 2]                    # camera: a PNG for each, stops, brighter if positive
//   [sun]                                    # corona, prominences: scene/sun_settings.h
//   activity = 0.5
//   [air]
//   Earth = "earth_volcanic"                 # a medium of catalogs/atmospheres, or "none", in
//                                            #   place of its own: seen, and bending light
//   [surface]
//   Earth = 0.3                              # grey and matt, of this albedo, in place of its maps
//   [shadows]
//   convention = "iau"                       # or "nasa": radii of Sun and Moon
//   limb_darkening = "hestroffer"            # "neckel", "none"
//   [overlays]                               # curves, cones, clock: scene/overlay_settings.h
//   central_line = true
//   [animation]
//   frames = 12
//   [[keyframe]]                             # interpolated smoothly between; heights geometrically
//   frame = 0
//   height = "20000 km"
//   (latitude, longitude, azimuth, altitude, field, time_offset)
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "quantity/quantity.h"
#include "scene/overlay_settings.h"
#include "scene/sun_settings.h"
#include "time/instant.h"
#include "view/projection.h"

namespace antumbra {

struct CameraPlacement {
  std::string body = "Earth";
  std::string bodyWhere = "[camera] body";  // opens messages about it
  std::string heightWhere = "[camera] height";
  std::string targetWhere = "[camera] target";
  Angle latitude;
  Angle longitude;
  Length height;
  std::string target;  // empty: azimuth and altitude hold
  Angle azimuth;
  Angle altitude;
  enum class Up { Zenith, North, Azimuth };
  Up up = Up::Zenith;
  Angle upAzimuth;
  Angle roll;
  Angle tilt;
};

struct DisplaySettings {
  bool automaticExposure = true;
  double whiteLuminance = 4000.0;  // cd/m2, when fixed
  double compensationStops = 0.0;
  bool illustrative = false;
  double limitingMagnitude = 6.5;
  bool eye = false;                   // adaptation in time (tonemap/eye_adaptation.h)
  std::vector<double> bracketsStops;  // of a camera; empty: one exposure
};

struct ShadowSettings {
  std::string convention = "iau";
  std::string limbDarkening = "hestroffer";
};

struct Keyframe {
  int frame = 0;
  std::optional<Length> height;
  std::optional<Angle> latitude, longitude, azimuth, altitude, field;
  std::optional<Duration> timeOffset;
};

struct Scene {
  std::string title;
  std::string file;
  std::string time;                 // as written
  std::string timeWhere;            // opens messages about it
  std::vector<std::string> bodies;  // empty: all
  CameraPlacement camera;
  Projection picture;
  DisplaySettings display;
  ShadowSettings shadows;
  OverlaySettings overlays;
  SunSettings sun;
  std::map<std::string, std::string> air;  // by body's name: medium, empty for none
  std::map<std::string, double> surface;   // by body's name: albedo of a plain, matt surface
  std::string quality = "balanced";
  int frames = 1;
  std::vector<Keyframe> keyframes;

  // The scene as it stands at one frame of its animation: keyframes applied, none left.
  // Precondition: 0 <= frame < frames.
  Scene atFrame(int frame) const;
  // Time offset of a frame from `time`.
  Duration offsetAt(int frame) const;
};

// Throws InputError with file and line for unknown keys, wrong units, NaN, impossible values.
Scene readScene(const std::filesystem::path& file);
Scene readScene(const Table& table);

}  // namespace antumbra
