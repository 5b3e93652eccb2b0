// The air of one body: coefficients, tables and their look-ups. Programs are compiled with
//   AIR_LAYERS        groups of four wavelengths
//   AIR_CONSTITUENTS  constituents, smooth phase functions first
//   AIR_SMOOTH        how many of them scatter smoothly (molecules) or not at all
//   AIR_DARK          how many of those, the first, do not scatter at all
// Mirrors `AirBlock` in src/passes/air_tables.cpp.
#ifndef INTERFACE_AIR_GLSL
#define INTERFACE_AIR_GLSL
#include "shared/air_geometry.glsl"

#define AIR_PEAKED (AIR_CONSTITUENTS - AIR_SMOOTH)
#define AIR_DENSITY_ROWS ((AIR_CONSTITUENTS + 3) / 4)

layout(std140, binding = 1) uniform Air {
  vec4 airShape;  // ground radius m, top m, lowest Sun cosine of the source table, Sun's radius rad
  vec4 airReach;  // from a point of the ground along its horizon to the top, m; 1 / that; 1 / top;
                  // radiance of a value of the source table
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
  shell.widest = airReach.x;
  shell.overWidest = airReach.y;
  shell.overTop = airReach.z;
  return shell;
}

// Texel centres of [0, 1]: x and y are scaled by xy and shifted by zw. Found once a ray: shader
// compilers do not move the divisions out of loops.
vec4 texelsOf(ivec2 size) {
  vec2 shift = 1.0 / vec2(size);
  return vec4(1.0 - shift, 0.5 * shift);
}
vec2 onTexels(vec2 place, vec4 texels) { return place * texels.xy + texels.zw; }

struct AirDensities {
  float of[AIR_DENSITY_ROWS * 4];
};

// `root`: of the height (air_geometry.glsl, rootHeight), on texels.
AirDensities densitiesAt(float root) {
  AirDensities d;
  for (int row = 0; row < AIR_DENSITY_ROWS; ++row) {
    float y = (float(row) + 0.5) / float(AIR_DENSITY_ROWS);
    vec4 four = textureLod(airDensities, vec2(root, y), 0.0);
    d.of[row * 4] = four.x;
    d.of[row * 4 + 1] = four.y;
    d.of[row * 4 + 2] = four.z;
    d.of[row * 4 + 3] = four.w;
  }
  return d;
}
vec2 densityTexels() { return texelsOf(textureSize(airDensities, 0)).xz; }

// Phase function of a constituent, 1/sr.
vec4 phaseOf(int constituent, int layer, float cosine) {
  ivec2 size = textureSize(airPhases, 0);
  float x = sqrt(clamp(0.5 - 0.5 * cosine, 0.0, 1.0));
  float y = (float(layer * AIR_CONSTITUENTS + constituent) + 0.5) / float(size.y);
  return textureLod(airPhases, vec2((x * float(size.x - 1) + 0.5) / float(size.x), y), 0.0);
}

vec4 depthTexels() { return texelsOf(textureSize(airDepths, 0).xy); }
vec2 depthPlace(float height, float cosine) {
  return onTexels(depthCoordinates(airShell(), height, cosine), depthTexels());
}
vec4 depthAt(vec2 place, int layer) { return textureLod(airDepths, vec3(place, float(layer)), 0.0); }

// A slice of the source table, 1/sr.
vec4 sourceAt(vec2 place, int slice) {
  return airReach.w * textureLod(airSource, vec3(place, float(slice)), 0.0);
}
// Where the source table holds a height and a Sun.
vec4 sourceTexels() { return texelsOf(textureSize(airSource, 0).xy); }
vec2 sourcePlaceOf(float height, float sunCosine) {
  vec2 place = vec2(sourceColumn(sunSpan(airShape.z), sunCosine), rootHeight(airShell(), height));
  return onTexels(place, sourceTexels());
}

// Share of the Sun's disc above the ground's horizon, linear over the disc, from the cosine of its
// zenith angle less that of the horizon's.
float sunAboveHorizon(float above) {
  return clamp(0.5 + 0.5 * above / max(airShape.w, 1e-7), 0.0, 1.0);
}

vec3 colourOf(vec4 light[AIR_LAYERS]) {
  vec3 rgb = vec3(0.0);
  for (int layer = 0; layer < AIR_LAYERS; ++layer)
    rgb += vec3(dot(airRedWeights[layer], light[layer]), dot(airGreenWeights[layer], light[layer]),
                dot(airBlueWeights[layer], light[layer]));
  return rgb;
}
#endif
