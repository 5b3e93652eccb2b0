// The directions over which radiance is averaged: Gauss-Legendre nodes below and above the horizon,
// dense toward it, and equal steps of azimuth over half a turn (the other half is its mirror image)
// or, with WHOLE_TURN, the whole.
struct AirDirection {
  float cosine;
  float sine;
  float azimuth;  // from the Sun's, rad
  float weight;   // solid angle, sr, of it and its mirror image
  bool down;
};

#if defined(AIR_HAZY) && !defined(WHOLE_TURN)
// Denser toward the Sun, where haze sends most: the steps are even in t of azimuth = t - this * sin t.
const float kTowardSun = 0.5;
#endif
// Steps of the cosine grow by exp(kDirectionGrowth) from the horizon to the zenith: the arch of
// twilight, a few degrees high, has two or three of a preset's six directions, where squares leave it
// one and err by half of the light. Haze has more of them, and light from higher up.
#ifdef AIR_HAZY
const float kDirectionGrowth = 1.8;
#else
const float kDirectionGrowth = 3.5;
#endif

uniform ivec2 directionCount;  // zenith angles, half of them below the horizon; azimuths in half a turn (or, with WHOLE_TURN, in all of it)
layout(std140, binding = 4) uniform DirectionNodes {
  vec4 zenithNodes[64];  // position and weight on [0, 1]
};

AirDirection airDirection(int index, float horizon) {
  int zenithIndex = index / directionCount.y;
  int azimuthIndex = index - zenithIndex * directionCount.y;
  int half_ = directionCount.x / 2;
  AirDirection d;
  d.down = zenithIndex < half_;
  vec4 node = zenithNodes[d.down ? zenithIndex : zenithIndex - half_];
  float span = d.down ? -1.0 - horizon : 1.0 - horizon;
#if defined(WHOLE_TURN)  // in an eclipse the light comes from near the horizon
  float warped = node.x * node.x * node.x, slope = 3.0 * node.x * node.x;
#elif defined(AIR_THICK)
  float warped = node.x * node.x, slope = 2.0 * node.x;
#else
  float far = exp(kDirectionGrowth * node.x), farthest = exp(kDirectionGrowth);
  float warped = (far - 1.0) / (farthest - 1.0), slope = kDirectionGrowth * far / (farthest - 1.0);
#endif
  d.cosine = clamp(horizon + span * warped, -1.0, 1.0);
  d.sine = sqrt(max(1.0 - d.cosine * d.cosine, 0.0));
#ifdef WHOLE_TURN
  const float turn = 2.0 * kPi;
#else
  const float turn = kPi;
#endif
  d.azimuth = (float(azimuthIndex) + 0.5) * turn / float(directionCount.y);
  d.weight = abs(span) * slope * node.y * 2.0 * kPi / float(directionCount.y);
#if defined(AIR_HAZY) && !defined(WHOLE_TURN)
  d.weight *= 1.0 - kTowardSun * cos(d.azimuth);
  d.azimuth -= kTowardSun * sin(d.azimuth);
#endif
  return d;
}
