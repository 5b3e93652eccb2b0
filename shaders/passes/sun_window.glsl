// The part of the Sun's plane that the small target shows.
uniform vec2 windowMiddle;
uniform vec2 windowAlong;
uniform vec2 windowAcross;
uniform float targetSide;  // pixels

vec2 windowPoint(vec2 fragCoord) {
  vec2 uv = 2.0 * fragCoord / targetSide - 1.0;
  return windowMiddle + uv.x * windowAlong + uv.y * windowAcross;
}
