// The air of one body: coefficients, tables and their look-ups. Programs are compiled with
//   AIR_LAYERS        groups of four wavelengths
//   AIR_CONSTITUENTS  constituents, smooth phase functions first
//   AIR_SMOOTH        how many of them scatter smoothly (molecules) or not at all
//   AIR_DARK          how many of those, the first, do not scatter at all
//   AIR_DEGREE        of the harmonics in which scattered light is held
//   AIR_HAZY          the medium has forward peaks apart
//   AIR_BENT          sunlight comes along bent rays (src/passes/bent_sun_texels.h)
//   AIR_PHASE_LEVELS  of the phase functions' blur by forward peaks on the way
//
// With AIR_HAZY forward peaks (src/medium/forward_peak.h) count as no scattering: depths, the source and what it
// scatters are those of the rest, and sunlight scattered once keeps its peak, blurred. Toward the Sun a depth tells
// what is left of sunlight and of what peaks have turned of it (src/passes/peak_sunlight.h). True depths,
// for light that must not be turned at all, lie behind the others.
// Mirrors `AirBlock` in src/passes/air_tables.cpp.
#ifndef INTERFACE_AIR_GLSL
#define INTERFACE_AIR_GLSL
#include "shared/air_geometry.glsl"
#include "shared/phase_place.glsl"

#define AIR_PEAKED (AIR_CONSTITUENTS - AIR_SMOOTH)
#define AIR_DENSITY_ROWS ((AIR_CONSTITUENTS + 3) / 4)
#ifndef AIR_DEGREE
#define AIR_DEGREE 2
#endif
#ifndef AIR_PHASE_LEVELS  // a body without air
#define AIR_PHASE_LEVELS 1
#endif
#ifdef AIR_BENT
#define AIR_DENSITY_HEIGHT (AIR_DENSITY_ROWS + 1 + AIR_LAYERS)
#else
#define AIR_DENSITY_HEIGHT (AIR_DENSITY_ROWS + 1)
#endif
#define AIR_HARMONICS ((AIR_DEGREE + 1) * (AIR_DEGREE + 2) / 2)

layout(std140, binding = 1) uniform Air {
  vec4 airShape;  // ground radius m, top m, lowest Sun cosine of the source table, Sun's radius rad
  vec4 airReach;  // from a point of the ground along its horizon to the top, m; 1 / that; 1 / top;
                  // light of a value of the source table
  vec4 airBent;   // bent sunlight: 1 / reach of its table, lowest cosine at the ground, 1 / (1 - that)
  vec4 airGroundAlbedo[AIR_LAYERS];
  vec4 airScattering[AIR_LAYERS * AIR_CONSTITUENTS];  // 1/m at density 1
  vec4 airExtinction[AIR_LAYERS * AIR_CONSTITUENTS];
  // Legendre moments of the rest, by degree, layer and constituent.
  vec4 airPhaseMoments[(AIR_DEGREE + 1) * AIR_LAYERS * AIR_CONSTITUENTS];
  vec4 airRedWeights[AIR_LAYERS];  // cd/m2 of linear sRGB per L/E0
  vec4 airGreenWeights[AIR_LAYERS];
  vec4 airBlueWeights[AIR_LAYERS];
  vec4 airAlbedoRed[AIR_LAYERS];  // spectral albedo of a surface from its linear sRGB colour
  vec4 airAlbedoGreen[AIR_LAYERS];
  vec4 airAlbedoBlue[AIR_LAYERS];
};
// Gauss-Legendre nodes and weights on [0, 1]: a set of many, then one of few.
layout(std140, binding = 3) uniform Quadrature {
  ivec4 nodeCount;  // x: of the many, y: of the few
  vec4 nodes[128];  // position, weight
};

layout(binding = 2) uniform sampler2D airDensities;  // over sqrt(height/top), four a row; in
                                                     // the last row x: level of the source there,
                                                     // y: sqrt(height/top) of a level, z: its
                                                     // slope over the level; with AIR_BENT
                                                     // rows of sunlight on the ground follow
layout(binding = 3) uniform sampler2DArray airDepths;  // of the rest by layer, then true ones;
                                                       // with AIR_BENT or AIR_HAZY all again
                                                       // toward the Sun
layout(binding = 4) uniform sampler2DArray airSource;  // a layer: harmonics, irradiance
// Over phasePlace() of the cosine; by layer and constituent, rows over the blur, then that by moments.
layout(binding = 5) uniform sampler2D airPhases;

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
    float y = (float(row) + 0.5) / float(AIR_DENSITY_HEIGHT);
    vec4 four = textureLod(airDensities, vec2(root, y), 0.0);
    d.of[row * 4] = four.x;
    d.of[row * 4 + 1] = four.y;
    d.of[row * 4 + 2] = four.z;
    d.of[row * 4 + 3] = four.w;
  }
  return d;
}
vec2 densityTexels() { return texelsOf(textureSize(airDensities, 0)).xz; }

// Phase function of a constituent, 1/sr. `blur`: blurPlace() of the way.
vec4 phaseOf(int constituent, int layer, float cosine, float blur) {
  ivec2 size = textureSize(airPhases, 0);
  float x = phasePlace(cosine);
#ifdef AIR_HAZY
  float row = float((layer * AIR_CONSTITUENTS + constituent) * (AIR_PHASE_LEVELS + 1)) + blur;
#else
  float row = float(layer * AIR_CONSTITUENTS + constituent);
#endif
  return textureLod(airPhases, vec2((x * float(size.x - 1) + 0.5) / float(size.x), (row + 0.5) / float(size.y)), 0.0);
}
// The one that the source is made with.
vec4 phaseByMoments(int constituent, int layer, float cosine) {
  return phaseOf(constituent, layer, cosine, float(AIR_PHASE_LEVELS));
}

vec4 depthTexels() { return texelsOf(textureSize(airDepths, 0).xy); }
vec2 depthPlace(float height, float cosine) {
  return onTexels(depthCoordinates(airShell(), height, cosine), depthTexels());
}
vec4 depthAt(vec2 place, int layer) { return textureLod(airDepths, vec3(place, float(layer)), 0.0); }
// Of a constituent without its forward peak, 1/m at density 1.
vec4 restExtinction(int i) { return airExtinction[i] - airScattering[i] * (1.0 - airPhaseMoments[i]); }
// The layer of the true depths.
int trueLayer(int layer) {
#ifdef AIR_HAZY
  return layer + AIR_LAYERS;
#else
  return layer;
#endif
}
// Toward the Sun, whose depth holds all that dims it: with AIR_BENT its disc's setting and the thinning
// of bent light too.
vec2 sunDepthPlace(AirShell shell, DepthRow row, float sunRise, vec4 texels) {
#ifdef AIR_BENT
  return onTexels(sunCoordinatesOf(shell, row, sunRise, airBent.x), texels);
#else
  return onTexels(depthCoordinatesOf(shell, row, sunRise), texels);
#endif
}
int sunLayer(int layer) {
#if defined(AIR_HAZY)
  return layer + 2 * AIR_LAYERS;
#elif defined(AIR_BENT)
  return layer + AIR_LAYERS;
#else
  return layer;
#endif
}
vec4 sunDepthAt(vec2 place, int layer) { return depthAt(place, sunLayer(layer)); }
#ifdef AIR_BENT
// Irradiance of the horizontal ground by the Sun itself, over E0.
vec4 bentSunOnGround(float sunCosine, int layer) {
  float x = sqrt(clamp((sunCosine - airBent.y) * airBent.z, 0.0, 1.0));
  float count = float(textureSize(airDensities, 0).x);
  float y = (float(AIR_DENSITY_ROWS + 1 + layer) + 0.5) / float(AIR_DENSITY_HEIGHT);
  return textureLod(airDensities, vec2((x * (count - 1.0) + 0.5) / count, y), 0.0);
}
#endif
// The same for the tables, which know the Sun as a point where it is not bent.
vec4 sunOnGround(float sunCosine, int layer) {
#ifdef AIR_BENT
  return bentSunOnGround(sunCosine, layer);
#else
  return max(sunCosine, 0.0) * exp(-sunDepthAt(depthPlace(0.0, sunCosine), layer));
#endif
}
// The row of levels in the densities' table.
vec3 levelRow(float x) {
  float count = float(textureSize(airDensities, 0).x);
  float y = (float(AIR_DENSITY_ROWS) + 0.5) / float(AIR_DENSITY_HEIGHT);
  return textureLod(airDensities, vec2((x * (count - 1.0) + 0.5) / count, y), 0.0).xyz;
}
// What a cell of the source stands for. Levels lie dense where the air is.
HeightAndCosine sourceCell(ivec2 texel, ivec2 size) {
  vec2 place = vec2(texel) / vec2(size - 1);
  HeightAndCosine at;
  at.cosine = sourceSunCosine(sunSpan(airShape.z), place.x);
#ifdef AIR_HAZY
  float root = levelRow(place.y).y;
#else
  float root = place.y;
#endif
  // The topmost cells lie a little inside, for their rays to have air to cross.
  at.height = airShape.y * min(root * root, 0.9999);
  return at;
}
// Where samples lie on a leg: in haze by level, otherwise as the cube of u toward the low end. Either
// way the path's length near a tangent point is even in u.
struct LegSpan {
  float level;
  float levels;  // from the low end to the high
  float root;
};
struct LegNode {
  float height;
  float step;  // of height over u
};
LegSpan legSpan(AirLeg leg) {
  LegSpan span;
  span.level = 0.0;
  span.levels = 0.0;
  span.root = 0.0;
#ifdef AIR_HAZY
  span.level = levelRow(rootHeight(airShell(), leg.lowHeight)).x;
  span.levels = max(levelRow(rootHeight(airShell(), leg.highHeight)).x - span.level, 1e-6);
  span.root = levelRow(span.level).y;
#endif
  return span;
}
LegNode nodeOnLeg(AirLeg leg, LegSpan span, float u) {
  LegNode node;
  float whole = leg.highHeight - leg.lowHeight;
#ifdef AIR_HAZY
  vec3 row = levelRow(span.level + span.levels * u * u);
  node.height = leg.lowHeight + clamp(airShape.y * (row.y - span.root) * (row.y + span.root), 1e-6 * u * u * whole, whole);
  node.step = airShape.y * 2.0 * row.y * row.z * span.levels * 2.0 * u;
#else
  node.height = leg.lowHeight + whole * u * u * u;
  node.step = whole * 3.0 * u * u;
#endif
  return node;
}
// u of a height on the leg.
float nodeOfHeight(AirLeg leg, LegSpan span, float height) {
#ifdef AIR_HAZY
  float level = levelRow(rootHeight(airShell(), height)).x;
  return sqrt(clamp((level - span.level) / span.levels, 0.0, 1.0));
#else
  return clamp(pow((height - leg.lowHeight) / max(leg.highHeight - leg.lowHeight, 1e-6), 1.0 / 3.0), 0.0, 1.0);
#endif
}
// Slices of the source table.
int harmonicSlice(int layer, int harmonic) { return layer * (AIR_HARMONICS + 1) + harmonic; }
int irradianceSlice(int layer) { return harmonicSlice(layer, AIR_HARMONICS); }
// Mean radiance and irradiance are held by their eighth roots, harmonics over the mean: twilight falls
// by a factor of four from one cell to the next, and linear steps of the light itself would make it a
// quarter too bright between them, in every order again. With roots 3 %; and no light at all remains
// none. The solver for thick air takes differences of either sign: there all is held as it is.
vec4 rootOfLight(vec4 light) {
#ifdef AIR_THICK
  return light;
#else
  return pow(max(light, vec4(0.0)), vec4(0.125));
#endif
}
vec4 lightOfRoot(vec4 held) {
#ifdef AIR_THICK
  return held;
#else
  vec4 square = held * held, fourth = square * square;
  return fourth * fourth;
#endif
}
vec4 overMean(vec4 harmonic, vec4 mean) {
#ifdef AIR_THICK
  return harmonic;
#else
  return mix(vec4(0.0), harmonic / max(mean, vec4(1e-30)), greaterThan(mean, vec4(1e-30)));
#endif
}
// A slice of the source table as it is held.
vec4 sourceAt(vec2 place, int slice) {
  return textureLod(airSource, vec3(place, float(slice)), 0.0);
}
// Mean radiance and irradiance over E0, 1/sr and 1.
vec4 sourceMean(vec2 place, int layer) {
  return airReach.w * lightOfRoot(sourceAt(place, harmonicSlice(layer, 0)));
}
vec4 sourceIrradiance(vec2 place, int layer) {
  return airReach.w * lightOfRoot(sourceAt(place, irradianceSlice(layer)));
}

// Where the source table holds a height (by its root, rootHeight) and a Sun.
float sourceLevel(float root) {
#ifdef AIR_HAZY
  return levelRow(root).x;
#else
  return root;
#endif
}
vec4 sourceTexels() { return texelsOf(textureSize(airSource, 0).xy); }
vec2 sourcePlaceOf(float height, float sunCosine) {
  vec2 place = vec2(sourceColumn(sunSpan(airShape.z), sunCosine), sourceLevel(rootHeight(airShell(), height)));
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
