// Scene luminance to 8-bit sRGB: exposure, tone curve, transfer, and a dither of one step so that
// twilight gradients do not band. Exact black and exact white stay what they are.
#include "shared/night_vision.glsl"
#include "shared/tone_curve.glsl"

layout(binding = 0) uniform sampler2D image;  // linear sRGB, cd/m^2
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

void main() {
  vec3 scene = texelFetch(image, ivec2(gl_FragCoord.xy), 0).rgb * channelGains;
  if (rodThreshold >= 0.0) scene = nightColour(scene, rodThreshold);
  vec3 c = displayColour(scene, perCandela);
  vec3 s = vec3(srgbEncoded(c.x), srgbEncoded(c.y), srgbEncoded(c.z));
  // A bound of 0.499 steps keeps 0 at 0 and 255 at 255 after rounding.
  float noise = gradientNoise(gl_FragCoord.xy + tileOrigin) * 0.998;
  encoded = vec4(s + noise * ditherSteps / 255.0, 1.0);
}
