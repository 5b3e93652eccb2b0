// Triangles before the Sun, projected into the small target.
layout(location = 0) in vec3 corner;  // m from the camera, camera axes

uniform mat3 windowFromCamera;  // rows: u, v, depth along the Sun's axis

void main() {
  vec3 p = windowFromCamera * corner;
  gl_Position = vec4(p.xy, 0.75 * p.z, p.z);
}
