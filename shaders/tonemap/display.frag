// Scene luminance to 8-bit sRGB: exposure, tone curve, transfer, and a dither of one step so that
// twilight gradients do not band. Exact black and exact white stay what they are.
//
// Where an outline stands before a light far above white, the mean of a pixel's light is white as soon as
// a hundredth of it is free, and edges would be stairs. Such pixels say in alpha what share is bright
// (edgeMark of passes/sun_plane.glsl): each side is shown by itself, and the mean is the display's.
// Compiled with EDGES it draws these alone, over the rest: a software renderer computes every branch.
#include "shared/night_vision.glsl"
#include "shared/tone_curve.glsl"

layout(binding = 0) uniform sampler2D image;  // linear sRGB, cd/m^2; alpha: 1, or the bright share
uniform float perCandela;                     // 1 / luminance of display white
uniform vec3 channelGains;                    // adaptation to the scene's white
uniform vec2 tileOrigin;                      // pixels: the dither belongs to the picture
uniform float ditherSteps;                    // 1, or 0 for none
uniform float rodThreshold;                   // cd/m^2; below 0: cones alone (a camera)

out vec4 encoded;

// Interleaved gradient noise (Jimenez 2014, "Next generation post processing in Call of Duty", SIGGRAPH
// course), in (-0.5, 0.5): evenly distributed over any 3x3 pixels.
float gradientNoise(vec2 pixel) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5;
}

vec3 shownColour(vec3 light) {
  vec3 scene = light * channelGains;
  if (rodThreshold >= 0.0) scene = nightColour(scene, rodThreshold);
  return displayColour(scene, perCandela);
}

#ifdef EDGES
// Of the pixels around one, the darkest: what its dark side is like.
vec3 darkestBeside(ivec2 pixel, vec3 darkest) {
  ivec2 last = textureSize(image, 0) - 1;
  for (int i = 0; i < 9; ++i) {
    vec3 light = texelFetch(image, clamp(pixel + ivec2(i % 3, i / 3) - 1, ivec2(0), last), 0).rgb;
    if (luminanceOfColour(light) < luminanceOfColour(darkest)) darkest = light;
  }
  return darkest;
}
#endif

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 image_ = texelFetch(image, pixel, 0);
#ifdef EDGES
  if (image_.a <= 0.0 || image_.a >= 1.0) discard;
  vec3 dark = darkestBeside(pixel, image_.rgb);
  vec3 bright = (image_.rgb - (1.0 - image_.a) * dark) / image_.a;
  vec3 c = mix(shownColour(dark), shownColour(bright), image_.a);
#else
  vec3 c = shownColour(image_.rgb);
#endif
  vec3 s = vec3(srgbEncoded(c.x), srgbEncoded(c.y), srgbEncoded(c.z));
  // A bound of 0.499 steps keeps 0 at 0 and 255 at 255 after rounding.
  float noise = gradientNoise(gl_FragCoord.xy + tileOrigin) * 0.998;
  encoded = vec4(s + noise * ditherSteps / 255.0, 1.0);
}
