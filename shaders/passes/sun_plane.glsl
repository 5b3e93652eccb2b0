// The plane that touches the sky at the Sun's centre (src/passes/sun_plane.h): the solar disc is its
// unit circle, outlines of bodies are conics.
#ifndef PASSES_SUN_PLANE_GLSL
#define PASSES_SUN_PLANE_GLSL
#include "shared/limb_darkening.glsl"

uniform vec3 sunAxis;      // unit vector to the Sun's centre, camera axes
uniform vec3 sunPrepared;  // the same as prepareDirection of src/gl/view_block.h makes it
uniform vec3 sunAcross;    // axes of the plane over the tangent of the Sun's angular radius
uniform vec3 sunUp;
uniform float sunTangent;
uniform vec3 sunMeanLuminance;      // cd/m^2, linear sRGB
uniform vec4 sunLimbDarkening[13];  // the structure's fields in order: red, green, blue, luminance
uniform int silhouetteCount;
uniform vec4 silhouettes[36];  // three for each body

LimbDarkening sunLaw() {
  LimbDarkening law;
  law.exponent = sunLimbDarkening[0];
  law.brightness0 = sunLimbDarkening[1];
  law.brightness1 = sunLimbDarkening[2];
  law.brightness2 = sunLimbDarkening[3];
  law.brightness3 = sunLimbDarkening[4];
  law.brightness4 = sunLimbDarkening[5];
  law.brightness5 = sunLimbDarkening[6];
  law.ring0 = sunLimbDarkening[7];
  law.ring1 = sunLimbDarkening[8];
  law.ring2 = sunLimbDarkening[9];
  law.ring3 = sunLimbDarkening[10];
  law.ring4 = sunLimbDarkening[11];
  law.ring5 = sunLimbDarkening[12];
  return law;
}

// The plane's point on a pixel's ray (viewRayOf), from the difference to the Sun's direction, which
// keeps a pixel of any field; z is 1, or 0 where the ray points away from the Sun.
vec3 sunPlanePoint(vec3 ray) {
  // A perspective's ray has z = -1; `sunPrepared` lies in the same plane when the Sun is ahead.
  vec3 offset = ray - sunPrepared;
  float along = dot(ray, sunAxis);
  return vec3(dot(offset, sunAcross) / along, dot(offset, sunUp) / along, along > 0.0 ? 1.0 : 0.0);
}

// What the bodies leave free of a short line outwards from the disc's centre, between two distances
// from it, by interpolating each outline's quadric between the ends: from x to y, nothing where both
// ends are hidden.
vec2 uncoveredBetween(vec2 outward, float from, float to) {
  vec2 free = vec2(from, to);
  for (int i = 0; i < silhouetteCount; ++i) {
    vec4 a = silhouettes[3 * i];
    vec4 b = silhouettes[3 * i + 1];
    vec3 front = vec3(a.w, b.w, silhouettes[3 * i + 2].x);
    mat3 quadric = mat3(a.x, a.y, b.x, a.y, a.z, b.y, b.x, b.y, b.z);
    vec3 p = vec3(outward * from, 1.0);
    vec3 q = vec3(outward * to, 1.0);
    float atFrom = dot(front, p) > 0.0 ? dot(p, quadric * p) : -1.0;
    float atTo = dot(front, q) > 0.0 ? dot(q, quadric * q) : -1.0;
    float crossing = mix(from, to, atFrom / (sign(atFrom) * max(abs(atFrom - atTo), 1e-20)));
    if (atFrom > 0.0) free.x = atTo > 0.0 ? to : max(free.x, crossing);
    else if (atTo > 0.0) free.y = min(free.y, crossing);
  }
  return vec2(free.x, max(free.x, free.y));
}

// Share of a small square of side `step` around a point that the bodies leave free. Distances to an
// outline by its gradient; two bodies that meet within the square count as the fuller of both.
float uncoveredAt(vec2 point, float step) {
  float free = 1.0;
  vec3 p = vec3(point, 1.0);
  for (int i = 0; i < silhouetteCount; ++i) {
    vec4 a = silhouettes[3 * i];
    vec4 b = silhouettes[3 * i + 1];
    float front = dot(vec3(a.w, b.w, silhouettes[3 * i + 2].x), p);
    // The quadric's product with p, half its gradient.
    vec3 g = vec3(a.x * p.x + a.y * p.y + b.x, a.y * p.x + a.z * p.y + b.y,
                  b.x * p.x + b.y * p.y + b.z);
    float inside = dot(g, p) / max(2.0 * length(g.xy), 1e-12);  // solar radii, near the outline
    float covered = front > 0.0 ? clamp(inside / step + 0.5, 0.0, 1.0) : 0.0;
    free = min(free, 1.0 - covered);
  }
  return free;
}

// For the alpha of a pixel: what is added to 1 so that it becomes the share that the bodies leave free,
// where an outline crosses it. The display shows both sides of such a pixel (display.frag).
float edgeMark(float free) { return free > 0.0 ? free - 1.0 : 0.0; }

// Brightness of the photosphere at a point, relative to the disc's mean: red, green, blue,
// luminance.
vec4 photosphereAt(LimbDarkening law, vec2 point) {
  float squared = dot(point, point);
  // Cosine from the solar normal: the sphere's, not the plane's.
  float cosineSquared = (1.0 - squared) / (1.0 + squared * sunTangent * sunTangent);
  return solarBrightness(law, sqrt(max(cosineSquared, 0.0)));
}

// The same as the mean over a ring between two distances from the centre: in closed form near the limb,
// where the brightness falls steeply within a sample.
vec4 photosphereBetween(LimbDarkening law, vec2 ring) {
  vec2 depth = 1.0 - ring;
  vec2 cosineSquared = depth * (1.0 + ring);
  float area = cosineSquared.x - cosineSquared.y;
  if (area <= max(0.05 * cosineSquared.x, 1e-7))
    return photosphereAt(law, vec2(0.5 * (ring.x + ring.y), 0.0));
  return (lightOutsideRing(law, cosineSquared.x) - lightOutsideRing(law, cosineSquared.y)) / area;
}
#endif
