// The view of a pass: which projection, at which size, and which part of it is drawn. The program is
// compiled with one of PROJECTION_PERSPECTIVE, PROJECTION_FISHEYE, PROJECTION_EQUIRECTANGULAR.
// Mirrors `ViewBlock` in src/gl/view_block.h.
#ifndef INTERFACE_VIEW_GLSL
#define INTERFACE_VIEW_GLSL
#include "shared/projection.glsl"

layout(std140, binding = 0) uniform View {
  vec2 viewImageSize;   // pixels of the whole picture
  vec2 viewTileOrigin;  // this target's lower left corner in it, pixels
  vec2 viewExtent;      // perspective: tangents of the half fields; fisheye: half aperture, rad
  float viewPixelAngle; // angle of a pixel at the picture's centre, rad
  float viewUnused;
};

// The ray of a pixel; unnormalised for a perspective (z = -1).
ViewRay viewRayOf(vec2 fragCoord) {
  vec2 p = (fragCoord + viewTileOrigin) / viewImageSize * 2.0 - 1.0;
#if defined(PROJECTION_FISHEYE)
  return fisheyeRay(p.x, p.y, viewExtent.x);
#elif defined(PROJECTION_EQUIRECTANGULAR)
  return equirectangularRay(p.x, p.y);
#else
  return perspectiveRay(p.x, p.y, viewExtent.x, viewExtent.y);
#endif
}

// Where a direction falls in the picture, in pixels of the whole picture; z is 0 outside.
vec3 viewPixelOf(vec3 direction) {
#if defined(PROJECTION_FISHEYE)
  ImagePoint p = fisheyePoint(direction, viewExtent.x);
#elif defined(PROJECTION_EQUIRECTANGULAR)
  ImagePoint p = equirectangularPoint(direction);
#else
  ImagePoint p = perspectivePoint(direction, viewExtent.x, viewExtent.y);
#endif
  return vec3((vec2(p.x, p.y) * 0.5 + 0.5) * viewImageSize, p.inside);
}

// Sine of the angle between a pixel's ray and a direction prepared by `prepareDirection` of
// src/gl/view_block.h (z = -1 ahead in a perspective): differences of tangents keep arcseconds
// in floats at any field.
float viewSineTo(vec3 ray, vec3 prepared) {
#if defined(PROJECTION_FISHEYE) || defined(PROJECTION_EQUIRECTANGULAR)
  return length(cross(ray, prepared));
#else
  vec2 d = prepared.xy - ray.xy * -prepared.z;  // -prepared.z is 1 ahead, -1 behind
  vec3 c = vec3(d.y, -d.x, ray.x * d.y - ray.y * d.x);
  return length(c) / sqrt(dot(ray, ray) * dot(prepared, prepared));
#endif
}
#endif
