// Where a shadow meets the Earth's ellipsoid (WGS84), in metres along the axes of Itrs.
//
// A cone and the ellipsoid are convex: they are apart exactly if a tangent plane of the cone
// separates them. The plane's distance from the geocentre follows from the ellipsoid's support
// function, so that first and last contacts are exact for the true cone and the true ellipsoid.
#pragma once

#include <optional>

#include "geodesy/site.h"
#include "shared/as_cpp.h"

namespace antumbra {

struct ConeClearance {
  double metres = 0.0;  // between cone and ellipsoid; negative where they overlap (to first order)
  glm::dvec3 touchPoint;  // of the ellipsoid, nearest the cone
};

// A cone about the pair's axis with `radius` at the foot and `gain` per metre along the axis.
ConeClearance coneClearance(const glsl::ShadowPair& pair, double radius, double gain);
ConeClearance penumbraClearance(const glsl::ShadowPair& pair);
// Of the umbra, or of the antumbra where the umbra's apex lies before the foot.
ConeClearance umbraClearance(const glsl::ShadowPair& pair);
ConeClearance axisClearance(const glsl::ShadowPair& pair);

// The point where the axis enters the ellipsoid.
std::optional<glm::dvec3> axisOnEllipsoid(const glsl::ShadowPair& pair);

Site siteOf(const glm::dvec3& itrs);
glm::dvec3 itrsMetres(const Site& site);
// Direction of a displacement along Itrs in the horizon of a site.
HorizontalDirection horizontalOf(const glm::dvec3& displacement, const Site& site);

}  // namespace antumbra
