// Solid angle of a pixel of the current view, sr.
#ifndef INTERFACE_PIXEL_SOLID_ANGLE_GLSL
#define INTERFACE_PIXEL_SOLID_ANGLE_GLSL
#include "interface/view.glsl"
#include "shared/pixel_scale.glsl"

// `ray` is viewRayOf(fragCoord).direction.
float pixelSolidAngleOf(vec2 fragCoord, vec3 ray) {
#if defined(PROJECTION_FISHEYE)
  vec2 p = (fragCoord + viewTileOrigin) / viewImageSize * 2.0 - 1.0;
  return fisheyePixelSolidAngle(length(p), viewExtent.x, viewImageSize.x, viewImageSize.y);
#elif defined(PROJECTION_EQUIRECTANGULAR)
  return equirectangularPixelSolidAngle(ray, viewImageSize.x, viewImageSize.y);
#else
  return perspectivePixelSolidAngle(ray, viewExtent.x, viewExtent.y, viewImageSize.x,
                                    viewImageSize.y);
#endif
}
#endif
