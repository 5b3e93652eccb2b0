// Sums of the small target over one cell: light, and its first moments and count.
layout(binding = 0) uniform sampler2D small;
uniform int targetSide;
uniform int cellsAcross;

layout(location = 0) out vec4 light;   // red, green, blue, luminance
layout(location = 1) out vec4 moment;  // u and v weighted by luminance, pixels seen, 0

void main() {
  int side = targetSide / cellsAcross;
  ivec2 first = ivec2(gl_FragCoord.xy) * side;
  light = vec4(0.0);
  moment = vec4(0.0);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      ivec2 at = first + ivec2(x, y);
      vec4 b = texelFetch(small, at, 0);
      if (b.w <= 0.0) continue;
      vec2 uv = 2.0 * (vec2(at) + 0.5) / float(targetSide) - 1.0;
      light += b;
      moment += vec4(uv * b.w, 1.0, 0.0);
    }
}
