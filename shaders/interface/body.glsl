// One spheroid with its surface and its air, along any ray. All work is done in the scaled space in
// which the spheroid is a sphere of its equatorial radius; directions there err by the flattening
// (Earth: 0.2 deg at most) for phase functions, heights by as much (0.3 %). Horizon and limb are
// exact. Compiled with
//   AIR               the body has air (otherwise only the colours of interface/air.glsl are used)
//   AIR_SKY           the camera is low in the air: its sky lies in a table
//   SHADOW_PAIRS n    casters whose shadow may be seen
//   RING_SHADOW       its rings may stand before the Sun
//   BODY_SUNLIT, BODY_DUSK, BODY_NIGHT, BODY_SKY: all rays show that (src/passes/body_tiles.h)
//   AIR_SAMPLES       only what the air sends, for a grid of one sample to some pixels
//   AIR_SAMPLED       what the air sends comes from that grid
//   SURFACE_MAP, WATER_MASK, NIGHT_MAP, SURFACE_LUNAR, ILLUSTRATIVE
// Mirrors `BodyBlock` in src/passes/bodies.cpp.
#ifndef INTERFACE_BODY_GLSL
#define INTERFACE_BODY_GLSL
#ifdef AIR
#define AIR_FEW_HARMONICS
#include "interface/air_march.glsl"
#else
#include "interface/air.glsl"
#include "interface/shadows.glsl"
#endif
#ifdef AIR_SKY
#include "interface/air_sky.glsl"
#endif
#include "shared/surface.glsl"
#if defined(BODY_SUNLIT) || defined(BODY_DUSK) || defined(BODY_NIGHT)
#define BODY_GROUND
#endif
#if defined(NIGHT_MAP) && !defined(BODY_SUNLIT)
#define SURFACE_EMITS
#endif

layout(std140, binding = 2) uniform Body {
  vec4 scaledFromCamera[3];    // columns
  vec4 scaledCrossFromCross[3];  // cofactor matrix of the same
  vec4 bodyCentre;      // from the camera as `prepareDirection` has it; w: its scale, m
  vec4 bodyUp;          // scaled space: unit vector from the centre to the camera; w: its distance, m
  vec4 bodyHeights;     // camera above the ground; its r^2 - R^2; its r^2 - top^2; 1 where far
  vec4 bodySun;         // scaled space: unit vector to the Sun; w: (1 au / distance)^2
  vec4 bodyTrueSun;     // true body-fixed unit vector; w: Sun's radius, rad
  vec4 bodyShape;       // radius m, polar over equatorial radius, pixel angle rad
  vec4 bodyAlbedo;      // linear sRGB without a map
  vec4 bodyMapFactor;   // on the map's linear values; w: map texels a turn
  vec4 bodyNight;       // x: luminance of a white texel at night, cd/m2; y: phase factor (lunar)
  vec4 bodyShine;       // scaled space: unit vector to the brightest neighbour; w: its light over the Sun's
};
#ifdef SURFACE_MAP
layout(binding = 0) uniform sampler2D surfaceMap;
#endif
#ifdef WATER_MASK
layout(binding = 1) uniform sampler2D waterMask;
#endif
#ifdef NIGHT_MAP
layout(binding = 9) uniform sampler2D nightMap;
#endif

#if defined(AIR_SAMPLES) || defined(AIR_SAMPLED)
uniform vec3 sampleGrid;  // pixels a side; of the picture's pixels at its lower left corner, in samples
vec2 pictureOfSample(vec2 place) { return (place + sampleGrid.yz) * sampleGrid.x; }
#endif
#ifdef AIR_SAMPLED
layout(binding = 14) uniform sampler2D airLights;  // cd/m2
layout(binding = 15) uniform sampler2D airTransmittances;
vec2 placeInSamples(vec2 pixel) {
  return (pixel / sampleGrid.x - sampleGrid.yz) / vec2(textureSize(airLights, 0));
}
vec3 sampledLight(vec2 pixel) { return textureLod(airLights, placeInSamples(pixel), 0.0).rgb; }
vec3 sampledTransmittance(vec2 pixel) { return textureLod(airTransmittances, placeInSamples(pixel), 0.0).rgb; }
vec3 sampled;  // the pixel's
#endif

#ifdef RING_SHADOW
// Mirrors `ShadowBlock` in src/passes/rings.cpp.
layout(std140, binding = 13) uniform RingShadow {
  vec4 ringShadowRadii;  // of the table's ends, m; log2 of its narrowest disc (m), rows an octave
  vec4 ringShadowSun;    // x: angular radius of the Sun, rad
};
// Light that passes the rings: x: radius, y: log of half the width of the Sun's disc across them.
layout(binding = 13) uniform sampler2D ringShadow;

// Share of sunlight that passes the rings on its way to a point of the globe (true axes, m from the
// centre), over the Sun's disc and the pixel's footprint (m) together.
float sunlightThroughRings(vec3 point, float footprint) {
  vec3 sun = bodyTrueSun.xyz;
  float way = -point.z / sun.z;
  vec2 at = point.xy + sun.xy * way;
  float radius = length(at);
  float x = (radius - ringShadowRadii.x) / (ringShadowRadii.y - ringShadowRadii.x);
  if (way <= 0.0 || x <= 0.0 || x >= 1.0) return 1.0;
  float outward = dot(sun.xy, at) / (radius * sun.z);
  float blur = way * ringShadowSun.x;
  float width = sqrt((blur * blur + 0.25 * footprint * footprint) * (1.0 + outward * outward));
  ivec2 size = textureSize(ringShadow, 0);
  float row = clamp((log2(max(width, 1.0)) - ringShadowRadii.z) * ringShadowRadii.w, 0.0,
                    float(size.y - 1));
  return textureLod(ringShadow, (vec2(x * float(size.x - 1), row) + 0.5) / vec2(size), 0.0).r;
}
#endif

struct BodyLight {
  vec3 light;          // cd/m2, toward the camera
  vec3 transmittance;  // of what lies behind
};

// Where a ray goes, measured from the body.
struct BodyRay {
  vec3 direction;    // scaled space, unit
  vec3 nearest;      // far: closest point to the centre, m
  float rise;        // near: r mu at the camera, m
  float groundRoot;  // R^2 - b^2 with b the closest distance to the centre
  float topRoot;     // the same of the air's top
  float toNearest;   // distance from the camera to the closest point, m
};

vec3 scaledOf(vec3 v) {
  return scaledFromCamera[0].xyz * v.x + scaledFromCamera[1].xyz * v.y + scaledFromCamera[2].xyz * v.z;
}

// `ray` in camera axes, as viewRayOf has it.
BodyRay bodyRayOf(vec3 ray) {
  BodyRay found;
  vec3 d = scaledOf(ray);
  float scale = 1.0 / length(d);
  found.direction = d * scale;
  vec3 up = bodyUp.xyz;
  found.rise = bodyUp.w * dot(up, found.direction);
  found.toNearest = -found.rise;
  float radius = bodyShape.x;
  if (bodyHeights.w > 0.5) {
    // cross(ray, centre) from differences of tangents in a perspective.
    vec3 across;
#if defined(PROJECTION_FISHEYE) || defined(PROJECTION_EQUIRECTANGULAR)
    across = cross(ray, bodyCentre.xyz);
#else
    vec2 t = bodyCentre.xy - ray.xy * -bodyCentre.z;
    across = vec3(t.y, -t.x, ray.x * t.y - ray.y * t.x);
#endif
    across = scaledCrossFromCross[0].xyz * across.x + scaledCrossFromCross[1].xyz * across.y +
             scaledCrossFromCross[2].xyz * across.z;
    found.nearest = cross(found.direction, across * (scale * bodyCentre.w));
    float b = length(found.nearest);
    found.groundRoot = (radius - b) * (radius + b);
#ifdef AIR
    float top = radius + airShape.y;
    found.topRoot = (top - b) * (top + b);
#endif
  } else {
    found.nearest = up * bodyUp.w - found.direction * found.rise;
    found.groundRoot = found.rise * found.rise - bodyHeights.y;
    found.topRoot = found.rise * found.rise - bodyHeights.z;
  }
  return found;
}

// East longitude and geodetic latitude to map coordinates.
vec2 mapPlace(vec3 normal) {
  return vec2(atan(normal.y, normal.x) / (2.0 * kPi) + 0.5,
              0.5 + atan(normal.z, length(normal.xy) * bodyShape.y) / kPi);
}

// Light that leaves the surface at `normal` (scaled space) toward the camera, L/E0 by layer, and the
// light that the surface emits (cd/m2).
struct SurfaceLight {
  vec4 reflected[AIR_LAYERS];
  vec3 emitted;
};

SurfaceLight surfaceLight(vec3 normal, vec3 direction, float footprint) {
  SurfaceLight surface;
  surface.emitted = vec3(0.0);
  float sunCosine = dot(normal, bodySun.xyz);
#if defined(SURFACE_MAP) || defined(WATER_MASK) || defined(NIGHT_MAP)
  vec2 place = mapPlace(normal);
  float texels = footprint * bodyMapFactor.w / (2.0 * kPi * bodyShape.x);
  float lod = max(log2(max(texels, 1e-6)), 0.0);
#endif
#ifdef BODY_NIGHT
  for (int layer = 0; layer < AIR_LAYERS; ++layer) surface.reflected[layer] = vec4(0.0);
#else
  vec3 position = normal * bodyShape.x;
  vec3 albedo = bodyAlbedo.xyz;
#ifdef SURFACE_MAP
  albedo = textureLod(surfaceMap, place, lod).rgb * bodyMapFactor.rgb;
#endif
  float viewCosine = max(-dot(normal, direction), 1e-3);
  vec4 direct[AIR_LAYERS];  // across its way
#ifdef AIR_BENT
  vec4 onGround[AIR_LAYERS];
#endif
#ifdef RING_SHADOW
  float passed = sunlightThroughRings(position * vec3(1.0, 1.0, bodyShape.y), footprint);
#endif
  for (int layer = 0; layer < AIR_LAYERS; ++layer) {
    vec4 sun = vec4(1.0);
    vec4 share = vec4(1.0);
#if defined(AIR_BENT)
    sun = exp(-sunDepthAt(sunDepthPlace(airShell(), depthRow(airShell(), 0.0), sunCosine * bodyShape.x,
                                        depthTexels()), layer));
#elif defined(AIR)
    sun = exp(-sunDepthAt(depthPlace(0.0, max(sunCosine, 0.0)), layer));
#endif
#if defined(SHADOW_PAIRS) && !defined(UNECLIPSED)
    share *= visibleSunlight(position, layer);
#endif
#ifdef RING_SHADOW
    share *= passed;
#endif
    direct[layer] = sun * share;
#ifdef AIR_BENT
    onGround[layer] = share * bentSunOnGround(sunCosine, layer);
#endif
  }
  // A disc half below the horizon lights the ground a little.
  float lit = sunOnHorizontal(sunCosine, bodyTrueSun.w);
#ifdef AIR
  vec2 sourcePlace_ = sourcePlaceOf(0.0, sunCosine);
#endif
  float glint = 0.0;
#ifdef WATER_MASK
  float water = textureLod(waterMask, place, lod).r;
  vec3 up = normalize(vec3(normal.xy, normal.z / bodyShape.y));
  if (water > 0.01 && lit > 0.0)
    glint = water * seaGlint(up, -direction, bodySun.xyz, 5.0) * kPi;
#endif
  for (int layer = 0; layer < AIR_LAYERS; ++layer) {
    vec4 spectral = max(airAlbedoRed[layer] * albedo.r + airAlbedoGreen[layer] * albedo.g +
                            airAlbedoBlue[layer] * albedo.b, vec4(0.0));
#ifdef SURFACE_LUNAR
    vec4 light = direct[layer] * lunarReflection(max(sunCosine, 0.0), viewCosine, bodyNight.y);
#elif defined(AIR_BENT)
    vec4 light = onGround[layer];
#else
    vec4 light = direct[layer] * lit;
#endif
#ifndef AIR
    float shineCosine = max(dot(normal, bodyShine.xyz), 0.0);
#ifdef SURFACE_LUNAR
    light += bodyShine.w * lunarReflection(shineCosine, viewCosine, 1.0);
#else
    light += bodyShine.w * shineCosine;
#endif
#endif
#ifdef AIR
    vec4 diffuse = sourceIrradiance(sourcePlace_, layer);
#ifdef ECLIPSED_SOURCE
    diffuse *= eclipsedShare(position, 0.0, 1, layer);
#endif
    light += diffuse;
#endif
    surface.reflected[layer] = (spectral * light + glint * direct[layer]) / kPi;
  }
#endif
#ifdef SURFACE_EMITS
  if (sunCosine < 0.05)
    surface.emitted = textureLod(nightMap, place, lod).rgb * bodyNight.x *
                      smoothstep(0.05, -0.1, sunCosine);
#endif
  return surface;
}

#ifdef SHADOW_PAIRS
// Flat colours of the illustrative look: rgb and how much they cover.
vec4 illustration(vec3 position, float footprint) {
  vec4 mark = vec4(0.0);
  for (int caster = 0; caster < SHADOW_PAIRS; ++caster) {
    ShadowPair pair = shadowPairs[caster];
    ShadowPlace place = placeInShadow(pair, position * vec3(1.0, 1.0, shadowScale.x));
    DiscPair discs = discsAt(pair, place);
    float umbra = umbraRadiusAt(pair, place);
    float penumbra = penumbraRadiusAt(pair, place);
    if (place.distance > penumbra + footprint || pair.casterBehind + place.along < 0.0) continue;
    // The cones go on through the body, but on its night side there is no shadow.
    vec3 outward = normalize(vec3(position.xy, position.z / shadowScale.x));
    if (dot(outward, bodyTrueSun.xyz) < -bodyTrueSun.w) continue;
    // A step of the footprint along the ground crosses the cone by less where the Sun is low.
    vec3 across = place.away + pair.axis * (umbra > 0.0 ? pair.umbraTangent : -pair.umbraTangent);
    float step_ = footprint * length(across - outward * dot(outward, across));
    float inPenumbra = clamp(0.5 + (penumbra - place.distance) / step_, 0.0, 1.0);
    float inCentre = clamp(0.5 + (abs(umbra) - place.distance) / step_, 0.0, 1.0);
    vec3 centre = umbra > 0.0 ? vec3(0.02, 0.02, 0.08) : vec3(0.75, 0.25, 0.02);
    vec4 here = mix(vec4(0.16, 0.22, 0.55, 0.45), vec4(centre, 0.95), inCentre) *
                vec4(vec3(1.0), inPenumbra);
    float hidden = 1.0 - visibleFractionUniform(discs);
    // Obscuration per metre, for lines of equal width.
    float aside = 0.02 * (penumbra - umbra);
    ShadowPlace beyond = place;
    beyond.distance += aside;
    float beside = 1.0 - visibleFractionUniform(discsAt(pair, beyond));
    float slope = max(abs(hidden - beside) / aside, 1e-12);
    for (int i = 1; i <= 4; ++i) {
      float off = abs(hidden - 0.2 * float(i)) / (slope * step_);
      here = mix(here, vec4(1.0, 0.9, 0.3, 0.95), clamp(1.5 - off, 0.0, 1.0) * (1.0 - inCentre));
    }
    mark = mix(mark, vec4(here.rgb, 1.0), here.a);
    mark.a = max(mark.a, here.a);
  }
  return mark;
}
#endif

// What a white light keeps of its colour behind a transmittance.
vec3 colourShare(vec4 through[AIR_LAYERS]) {
  vec4 one[AIR_LAYERS];
  for (int layer = 0; layer < AIR_LAYERS; ++layer) one[layer] = vec4(1.0);
  return clamp(colourOf(through) / colourOf(one), 0.0, 1.0);
}

// What the camera receives along a ray from the body and its air.
BodyLight bodyLight(vec3 cameraRay) {
  BodyLight result;
  result.light = vec3(0.0);
  result.transmittance = vec3(1.0);
  BodyRay ray = bodyRayOf(cameraRay);
  float radius = bodyShape.x;
  bool ahead = ray.toNearest > 0.0;
  // Share of the pixel that the ground covers: its edge is b = R.
  float pixel = bodyShape.z * max(ray.toNearest, 1.0);
  float inside = ray.groundRoot / (2.0 * radius);
  // Parts of the picture that lie wholly on the ground or in the sky leave the other out.
#if defined(BODY_GROUND)
  const float cover = 1.0;
  const bool hits = true;
#elif defined(BODY_SKY)
  const float cover = 0.0;
  const bool hits = false;
#else
  float cover = ahead ? clamp(0.5 + inside / pixel, 0.0, 1.0) : 0.0;
  bool hits = ahead && ray.groundRoot > 0.0;
#endif
#ifdef AIR
  AirShell shell = airShell();
  bool meets = bodyHeights.z < 0.0 || (ahead && ray.topRoot > 0.0);
  if (!meets) return result;
  AirRay air;
  air.direction = ray.direction;
  air.sunAlong = clamp(dot(ray.direction, bodySun.xyz), -1.0, 1.0);
  air.groundRoot = ray.groundRoot;
  if (bodyHeights.z >= 0.0) {
    air.height = shell.top;
    air.rise = -sqrt(ray.topRoot);
    air.start = ray.nearest + ray.direction * air.rise;
    air.sunRise = dot(air.start, bodySun.xyz);
  } else {
    air.height = max(bodyHeights.x, 0.0);
    air.rise = ray.rise;
    air.start = bodyUp.xyz * bodyUp.w;
    air.sunRise = bodyUp.w * dot(bodyUp.xyz, bodySun.xyz);
  }
  AirWay way = wayOf(air);
  WayEnds ends = endsOf(air, way);
#else
  if (cover <= 0.0) return result;
#endif
  vec4 light[AIR_LAYERS];
  for (int layer = 0; layer < AIR_LAYERS; ++layer) light[layer] = vec4(0.0);
  vec3 emitted = vec3(0.0);
  vec4 through[AIR_LAYERS];
#ifdef AIR
#if defined(AIR_SKY) && !defined(BODY_GROUND) && !defined(BODY_SKY)
  // Ground in a part of the pixel beyond whose middle is sky is seen through the air before it alone.
  WayEnds groundEnds = ends;
  if (cover > 0.0 && !way.hitsGround) {
    AirRay grazing = air;
    grazing.groundRoot = 1e-3;
    grazing.rise = min(air.rise, -1e-3);
    groundEnds = endsOf(grazing, wayOf(grazing));
  }
  for (int layer = 0; layer < AIR_LAYERS; ++layer) through[layer] = exp(-depthOfWay(groundEnds, layer));
#else
  for (int layer = 0; layer < AIR_LAYERS; ++layer) through[layer] = exp(-depthOfWay(ends, layer));
#endif
#else
  for (int layer = 0; layer < AIR_LAYERS; ++layer) through[layer] = vec4(1.0);
#endif
  float footprint = 0.0;
  vec3 normal = vec3(0.0, 0.0, 1.0);
#ifndef AIR_SAMPLES
  if (cover > 0.0) {
    float root = sqrt(max(ray.groundRoot, 0.0));
    if (bodyHeights.w > 0.5) {
      normal = normalize(ray.nearest - ray.direction * root);
    } else {
      float distance = bodyHeights.y / (root + ray.toNearest);
      normal = normalize(bodyUp.xyz * bodyUp.w + ray.direction * distance);
    }
    float distance = max(ray.toNearest - root, 0.0);
    float slant = max(root / radius, 0.02);
    footprint = bodyShape.z * distance / sqrt(slant);
    SurfaceLight surface = surfaceLight(normal, ray.direction, footprint);
#if defined(ILLUSTRATIVE) && defined(SHADOW_PAIRS)
    vec4 mark = illustration(normal * radius, max(bodyShape.z * distance, 1.0));
    vec4 lit = vec4(max(dot(normal, bodySun.xyz), 0.02) * 0.35 / kPi);
    for (int layer = 0; layer < AIR_LAYERS; ++layer) {
      vec4 flat_ = lit * (airAlbedoRed[layer] * mark.r + airAlbedoGreen[layer] * mark.g +
                         airAlbedoBlue[layer] * mark.b);
      surface.reflected[layer] = mix(surface.reflected[layer], flat_, mark.a);
    }
#endif
    for (int layer = 0; layer < AIR_LAYERS; ++layer)
      light[layer] = surface.reflected[layer] * through[layer] * cover;
#ifdef SURFACE_EMITS
    emitted = surface.emitted * cover * colourShare(through);
#endif
  }
#endif
#if defined(AIR) && !defined(BODY_NIGHT) && !defined(AIR_SAMPLED)
#ifdef AIR_SKY
  vec2 place = skyPlace(ray.direction, way.hitsGround);
  float blur = blurOnSky(place);
  // The horizon's pixels: the light before the ground and that of the sky beyond, each by its share.
  float own = way.hitsGround ? cover : 1.0 - cover;
  if (own < 1.0) {
    vec2 other = skyPlace(ray.direction, !way.hitsGround);
    float otherBlur = blurOnSky(other);
    for (int layer = 0; layer < AIR_LAYERS; ++layer)
      light[layer] += (1.0 - own) * skyLight(other, layer, air.sunAlong, otherBlur);
  }
  for (int layer = 0; layer < AIR_LAYERS; ++layer)
    light[layer] += own * skyLight(place, layer, air.sunAlong, blur);
#else
  AirLight scattered = lightAlong(air, way, ends, noCuts());
  for (int layer = 0; layer < AIR_LAYERS; ++layer) light[layer] += scattered.joint[layer];
#endif
#endif
#if defined(AIR_SAMPLES)
  result.light = colourOf(light) * bodySun.w;
#elif defined(AIR_SAMPLED)
  result.light = max(colourOf(light) * bodySun.w + sampled, vec3(0.0)) + emitted;
#else
  result.light = max(colourOf(light), vec3(0.0)) * bodySun.w + emitted;
#endif
#ifdef AIR
  if (hits) {
    result.transmittance = vec3(0.0);
  } else {
#if defined(AIR_SKY) && !defined(BODY_GROUND) && !defined(BODY_SKY)
    for (int layer = 0; layer < AIR_LAYERS; ++layer) through[layer] = exp(-depthOfWay(ends, layer));
#endif
#ifdef AIR_HAZY
    // What lies behind is seen past the forward peaks too.
    for (int layer = 0; layer < AIR_LAYERS; ++layer)
      through[layer] = exp(-depthOfWay(ends, trueLayer(layer)));
#endif
    result.transmittance = colourShare(through);
  }
  result.transmittance *= 1.0 - cover;
#else
  result.transmittance = vec3(1.0 - cover);
#endif
  return result;
}
#endif
