// The air of one body: coefficients, tables and their look-ups. Programs are compiled with
//   AIR_LAYERS        groups of four wavelengths
//   AIR_CONSTITUENTS  constituents, smooth phase functions first
//   AIR_SMOOTH        how many of them scatter smoothly (molecules) or not at all
// Mirrors `AirBlock` in src/passes/air_tables.cpp.
#ifndef INTERFACE_AIR_GLSL
#define INTERFACE_AIR_GLSL
#include "shared/air_geometry.glsl"

#define AIR_PEAKED (AIR_CONSTITUENTS - AIR_SMOOTH)
#define AIR_DENSITY_ROWS ((AIR_CONSTITUENTS + 3) / 4)

layout(std140, binding = 1) uniform Air {
  vec4 airShape;  // ground radius m, top m, lowest Sun cosine of the source table, Sun's radius rad
  vec4 airGroundAlbedo[AIR_LAYERS];
  vec4 airScattering[AIR_LAYERS * AIR_CONSTITUENTS];  // 1/m at density 1
  vec4 airExtinction[AIR_LAYERS * AIR_CONSTITUENTS];
  vec4 airPhaseMoment1[AIR_LAYERS * AIR_CONSTITUENTS];  // Legendre moments
  vec4 airPhaseMoment2[AIR_LAYERS * AIR_CONSTITUENTS];
  vec4 airRedWeights[AIR_LAYERS];  // cd/m2 of linear sRGB per L/E0
  vec4 airGreenWeights[AIR_LAYERS];
  vec4 airBlueWeights[AIR_LAYERS];
  vec4 airAlbedoRed[AIR_LAYERS];  // spectral albedo of a surface from its linear sRGB colour
  vec4 airAlbedoGreen[AIR_LAYERS];
  vec4 airAlbedoBlue[AIR_LAYERS];
};
// Gauss-Legendre nodes and weights on [0, 1].
layout(std140, binding = 3) uniform Quadrature {
  ivec4 nodeCount;  // x
  vec4 nodes[64];   // position, weight
};

layout(binding = 2) uniform sampler2D airDensities;  // over sqrt(height/top); four a row
layout(binding = 3) uniform sampler2DArray airDepths;
layout(binding = 4) uniform sampler2DArray airSource;  // seven a layer: six moments, irradiance
layout(binding = 5) uniform sampler2D airPhases;       // over sqrt((1 - cosine)/2), a row each

AirShell airShell() {
  AirShell shell;
  shell.radius = airShape.x;
  shell.top = airShape.y;
  return shell;
}

// Texel centres of [0, 1].
vec2 onTexels(vec2 place, ivec2 size) { return (place * vec2(size - 1) + 0.5) / vec2(size); }

struct AirDensities {
  float of[AIR_DENSITY_ROWS * 4];
};

AirDensities densitiesAt(float height) {
  float x = sqrt(clamp(height / airShape.y, 0.0, 1.0));
  int count = textureSize(airDensities, 0).x;
  AirDensities d;
  for (int row = 0; row < AIR_DENSITY_ROWS; ++row) {
    float y = (float(row) + 0.5) / float(AIR_DENSITY_ROWS);
    vec4 four = textureLod(airDensities, vec2((x * float(count - 1) + 0.5) / float(count), y), 0.0);
    d.of[row * 4] = four.x;
    d.of[row * 4 + 1] = four.y;
    d.of[row * 4 + 2] = four.z;
    d.of[row * 4 + 3] = four.w;
  }
  return d;
}

// Phase function of a constituent, 1/sr.
vec4 phaseOf(int constituent, int layer, float cosine) {
  ivec2 size = textureSize(airPhases, 0);
  float x = sqrt(clamp(0.5 - 0.5 * cosine, 0.0, 1.0));
  float y = (float(layer * AIR_CONSTITUENTS + constituent) + 0.5) / float(size.y);
  return textureLod(airPhases, vec2((x * float(size.x - 1) + 0.5) / float(size.x), y), 0.0);
}

vec2 depthPlace(float height, float cosine) {
  return onTexels(depthCoordinates(airShell(), height, cosine), textureSize(airDepths, 0).xy);
}
vec4 depthAt(vec2 place, int layer) { return textureLod(airDepths, vec3(place, float(layer)), 0.0); }

// Share of the Sun's disc above the ground's horizon: linear over the disc.
float sunAboveHorizon(float height, float sunCosine) {
  float edge = horizonCosine(airShell(), max(height, 0.0));
  float size = max(airShape.w, 1e-7);
  return clamp(0.5 + 0.5 * (sunCosine - edge) / size, 0.0, 1.0);
}

vec3 colourOf(vec4 light[AIR_LAYERS]) {
  vec3 rgb = vec3(0.0);
  for (int layer = 0; layer < AIR_LAYERS; ++layer)
    rgb += vec3(dot(airRedWeights[layer], light[layer]), dot(airGreenWeights[layer], light[layer]),
                dot(airBlueWeights[layer], light[layer]));
  return rgb;
}
#endif
