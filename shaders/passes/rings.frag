// Draws the rings of a planet from pixel direction: light scattered once toward the camera, in the
// planet's shadow, and (second source of the blend) the transmittance of what lies behind. The half
// beyond the planet is drawn before it, the near half after. Blend with GL_ONE, GL_SRC1_COLOR.
#include "interface/view.glsl"
#include "interface/body.glsl"
#include "shared/eclipse.glsl"
#include "shared/rings.glsl"
layout(location = 0, index = 0) out vec4 light;
layout(location = 0, index = 1) out vec4 transmittance;

// Mirrors `RingBlock` in src/passes/rings.cpp.
layout(std140, binding = 12) uniform Rings {
  ShadowPair ringPair;  // the globe's shadow, from its centre
  vec4 ringShape;       // inner and outer radius, m; sine of the Sun's height over the plane; its side
  vec4 ringPhaseLaw;    // exponent, norm
  LimbDarkening ringLaws[AIR_LAYERS];
};
// rgb: albedo; a: normal optical depth, over the radius.
layout(binding = 12) uniform sampler2D ringProfile;
uniform float ringSide;  // 1: the half beyond the planet's centre, -1: the near one

const int kTaps = 6;

void main() {
  ViewRay view = viewRayOf(gl_FragCoord.xy);
  BodyRay ray = bodyRayOf(view.direction);
  float fall = ray.direction.z;
  if (view.inside < 0.5 || abs(fall) < 1e-7) discard;
  float fromNearest = -ray.nearest.z / fall;
  if (fromNearest * ringSide < 0.0 || ray.toNearest + fromNearest <= 0.0) discard;
  vec3 point = ray.nearest + ray.direction * fromNearest;
  float radius = length(point.xy);
  // What a pixel covers of the radius.
  vec3 straight = ray.direction * vec3(1.0, 1.0, bodyShape.y);
  float scale = length(straight);
  straight /= scale;
  float outward = dot(straight.xy, point.xy) / radius;
  float footprint = bodyShape.z * (ray.toNearest + fromNearest) * scale *
                    sqrt(1.0 + outward * outward / (straight.z * straight.z));
  float inner = ringShape.x, outer = ringShape.y;
  if (radius < inner - footprint || radius > outer + footprint) discard;

  float sunSine = ringShape.z, viewSine = abs(straight.z);
  bool lit = straight.z * ringShape.w < 0.0;
  vec3 toCamera = -straight, toSun = bodyTrueSun.xyz;
  float phase = atan(length(cross(toCamera, toSun)), dot(toCamera, toSun));
  float scattered = ringPhase(phase, ringPhaseLaw.x, ringPhaseLaw.y);
  int texels = textureSize(ringProfile, 0).x;
  float lod = max(log2(footprint / float(kTaps) * float(texels) / (outer - inner)), 0.0);
  vec3 reflected = vec3(0.0);
  float passed = 0.0;
  for (int tap = 0; tap < kTaps; ++tap) {
    float at = radius + footprint * ((float(tap) + 0.5) / float(kTaps) - 0.5);
    float x = (at - inner) / (outer - inner);
    if (x < 0.0 || x > 1.0) {
      passed += 1.0;
      continue;
    }
    vec4 here = textureLod(ringProfile, vec2(x, 0.5), lod);
    reflected += here.rgb * ringScattering(here.a, sunSine, viewSine, lit);
    passed += exp(-here.a / viewSine);
  }
  reflected *= scattered / float(kTaps);
  passed /= float(kTaps);

  ShadowPlace place = placeInShadow(ringPair, vec3(point.xy, 0.0));
  bool shaded = ringPair.casterBehind + place.along > 0.0;
  DiscPair discs = discsAt(ringPair, place);
  vec4 sum[AIR_LAYERS];
  for (int layer = 0; layer < AIR_LAYERS; ++layer) {
    vec4 spectral = max(airAlbedoRed[layer] * reflected.r + airAlbedoGreen[layer] * reflected.g +
                            airAlbedoBlue[layer] * reflected.b, vec4(0.0));
    sum[layer] = spectral / kPi;
    if (shaded) sum[layer] *= visibleFraction(discs, ringLaws[layer]);
  }
  light = vec4(max(colourOf(sum), vec3(0.0)) * bodySun.w, 0.0);
  transmittance = vec4(vec3(passed), 1.0);
}
