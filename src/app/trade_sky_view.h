// What `antumbra trade sky` measures on: the air of a scene's view, as fixed directions of its
// pixels, and their colour by the reference path tracer.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/scene_session.h"
#include "app/sky_methods.h"

namespace antumbra {

// The body whose air the scene shows, without what is beyond it, and directions into that air.
struct AirView {
  std::string scene;  // file
  PlannedBody body;
  Projection picture;
  // The camera above a sphere of the body's equatorial radius, in the space in which the body is
  // that sphere; the Sun as a disc of its size. Wavelengths: those of the reference.
  SkyQuestion question;
  std::vector<glm::ivec2> pixels;  // of the directions, from the lower left
  double illuminanceFactor = 1.0;  // (1 au / distance of the Sun)^2
  Angle sunZenith;
};

// `count` pixels of the picture by the R2 sequence (Roberts 2018), less those without air and
// within one degree of the Sun. Throws InputError where the scene shows no air, too little of it,
// or an eclipse falls on it.
AirView airViewOf(const SceneSession::Moment& moment, std::size_t count);

// Linear sRGB in cd/m2 of each direction, and the standard error of its luminance over that.
struct ReferenceSky {
  std::vector<glm::dvec3> colours;
  std::vector<double> relativeErrors;
  double meanRelativeError() const;
};

// By the path tracer at each view's settings. With `file`, read from there where it exists, else
// written to it; throws InputError where it was made for something else. `progress` hears which
// view is traced and the share of it that is done.
std::vector<ReferenceSky> referenceSkies(const std::vector<AirView>& views, const std::string& file,
                                         const std::function<void(std::size_t, double)>& progress);

// The colours of radiances (L / E0 by direction, wavelengths innermost).
std::vector<glm::dvec3> coloursOf(const AirView& view, const std::vector<Length>& wavelengths,
                                  const std::vector<double>& radiances);

struct SkyError {
  double luminance = 0.0;  // mean of |relative error|
  double worst = 0.0;      // the largest, with its sign
  std::size_t worstDirection = 0;
  double deltaE = 0.0;  // mean CIEDE2000, white at twice the direction's luminance
  double worstDeltaE = 0.0;
};
SkyError errorAgainst(const ReferenceSky& reference, const std::vector<glm::dvec3>& colours);

}  // namespace antumbra
