// Ink of a drawing, in sRGB as displayed. Lines: across the middle in pixels, half width, length along
// a dashed line (-1: full). Areas (-2): 0 inside, 1 outside. LETTERS: coverage from an atlas.
in vec4 shapeHere;
flat in vec4 inkHere;
#ifdef LETTERS
layout(binding = 0) uniform sampler2D letters;
#endif
out vec4 ink;

void main() {
#ifdef LETTERS
  float cover = texelFetch(letters, ivec2(shapeHere.xy), 0).r;
#else
  float cover = 1.0 - shapeHere.x;
  if (shapeHere.z > -1.5) {
    float halfWidth = shapeHere.y;
    cover = clamp(halfWidth + 0.5 - abs(shapeHere.x), 0.0, 1.0) * min(1.0, 2.0 * halfWidth);
    // Dashes of six pixels in ten, in proportion to the width of wide lines.
    float period = 10.0 * max(1.0, halfWidth);
    if (shapeHere.z >= 0.0 && mod(shapeHere.z, period) > 0.6 * period) cover = 0.0;
  }
#endif
  ink = vec4(inkHere.rgb, inkHere.a * cover);
}
