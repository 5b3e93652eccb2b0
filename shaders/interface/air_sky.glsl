// The sky about a camera low in the air, as tables over direction: zenith angle, dense toward the
// horizon on either side of it, and azimuth from the Sun's. The light of each peaked constituent
// lies apart, without its phase function, so that the aureole is as sharp as the pixels.
#ifndef INTERFACE_AIR_SKY_GLSL
#define INTERFACE_AIR_SKY_GLSL
#include "interface/air.glsl"

layout(std140, binding = 6) uniform AirSky {
  vec4 skyUp;      // scaled space: unit vector to the zenith; w: height of the camera, m
  vec4 skySunward; // horizontal unit vector toward the Sun's azimuth; w: cosine of its zenith angle
  vec4 skySide;    // up x sunward; w: 1 where the table covers the whole turn, 0 half of it
  vec4 skyDip;     // x: dip of the horizon, rad; y: value of a radiance in the tables; z: 1 / y
};
layout(binding = 6) uniform sampler2DArray skyJoint;
layout(binding = 7) uniform sampler2DArray skyPeaked;

// Elevation and azimuth at [0, 1]^2; y below one half is below the horizon.
vec2 skyAngles(ivec2 texel, ivec2 size) {
  int half_ = size.y / 2;
  bool down = texel.y < half_;
  float x = float(down ? half_ - 1 - texel.y : texel.y - half_) / float(half_ - 1);
  float dip = skyDip.x;
  float elevation = down ? -dip - x * x * (0.5 * kPi - dip) : -dip + x * x * (0.5 * kPi + dip);
  float turn = float(texel.x) / float(size.x - 1);
  return vec2(elevation, skySide.w > 0.5 ? (2.0 * turn - 1.0) * kPi : turn * kPi);
}

vec2 skyPlace(vec3 direction, bool down) {
  ivec2 size = textureSize(skyJoint, 0).xy;
  float z = dot(direction, skyUp.xyz);
  vec2 level = vec2(dot(direction, skySunward.xyz), dot(direction, skySide.xyz));
  float above = atan(z, length(level)) + skyDip.x;
  float x = down ? sqrt(clamp(-above / (0.5 * kPi - skyDip.x), 0.0, 1.0))
                 : sqrt(clamp(above / (0.5 * kPi + skyDip.x), 0.0, 1.0));
  float half_ = float(size.y / 2);
  float row = down ? half_ - 0.5 - x * (half_ - 1.0) : half_ + 0.5 + x * (half_ - 1.0);
  float azimuth = atan(level.y, level.x) / kPi;
  float turn = skySide.w > 0.5 ? 0.5 + 0.5 * azimuth : abs(azimuth);
  return vec2((turn * float(size.x - 1) + 0.5) / float(size.x), row / float(size.y));
}

// The blur of the phase functions in that direction.
float blurOnSky(vec2 place) {
#ifdef AIR_HAZY
  return textureLod(skyPeaked, vec3(place, float(AIR_LAYERS * AIR_PEAKED)), 0.0).x;
#else
  return 0.0;
#endif
}

vec4 skyLight(vec2 place, int layer, float sunAlong, float blur) {
  vec4 light = textureLod(skyJoint, vec3(place, float(layer)), 0.0);
  for (int c = 0; c < AIR_PEAKED; ++c)
    light += phaseOf(AIR_SMOOTH + c, layer, sunAlong, blur) *
             textureLod(skyPeaked, vec3(place, float(layer * AIR_PEAKED + c)), 0.0);
  return light * skyDip.z;
}
#endif
