// The shadow on the ground in a window of geodetic latitude and longitude, one pixel to an equal step
// of each: for tests that hold the pixels' shadow against predictions. Output: x the first wavelength's
// visible share of sunlight; y the place between the cones (below 0 in the umbra, 1 at the penumbra's
// edge); z metres from the axis.
#define AIR_LAYERS 1
#include "shared/quantities.glsl"
#include "interface/shadows.glsl"
uniform vec4 window;    // west, south, degrees; degrees per pixel along longitude and latitude
uniform vec2 spheroid;  // equatorial radius, m; flattening
out vec4 shown;

void main() {
  vec2 place = radians(window.xy + gl_FragCoord.xy * window.zw);
  float sine = sin(place.y);
  float squash = 1.0 - spheroid.y;
  float e2 = spheroid.y * (2.0 - spheroid.y);
  float across = spheroid.x / sqrt(1.0 - e2 * sine * sine);
  // Scaled space: the polar coordinate divided by 1 - flattening.
  vec3 scaled = across * vec3(cos(place.y) * cos(place.x), cos(place.y) * sin(place.x),
                              squash * sine);
  ShadowPlace axis =
      placeInShadow(shadowPairs[0], scaled * vec3(1.0, 1.0, shadowScale.x));
  float umbra = umbraRadiusAt(shadowPairs[0], axis.along);
  float between = (axis.distance - umbra) / (penumbraRadiusAt(shadowPairs[0], axis.along) - umbra);
  shown = vec4(visibleSunlight(scaled, 0).x, between, axis.distance, 1.0);
}
