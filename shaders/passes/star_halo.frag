// The halo of a point source in the eye, faded to nothing at the edge of its square.
#include "interface/view.glsl"
#include "shared/glare.glsl"

uniform float magnification;
uniform float agingFourth;
uniform float pigmentation;

flat in vec2 starPixel;
flat in vec3 starLight;
flat in vec3 starPlace;
flat in float haloPixels;

out vec4 luminance;  // cd/m^2 in linear sRGB, added

void main() {
  ViewRay ray = viewRayOf(gl_FragCoord.xy);
  float away = length(gl_FragCoord.xy + viewTileOrigin - starPixel) / haloPixels;
  if (ray.inside == 0.0 || away >= 1.0) discard;
  vec3 unit = normalize(ray.direction);
  float sine = length(cross(unit, starPlace)) * magnification;
  float fade = 1.0 - away * away;
  luminance = vec4(starLight * (magnification * magnification * fade * fade *
                                eyeHalo(sine * sine, agingFourth, pigmentation)),
                   0.0);
}
