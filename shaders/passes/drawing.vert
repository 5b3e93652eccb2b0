// Triangles in pixels of the whole picture, y up.
layout(location = 0) in vec2 pixel;
layout(location = 1) in vec4 shape;
layout(location = 2) in vec4 colour;
uniform vec2 tileOrigin;
uniform vec2 targetSize;
out vec4 shapeHere;
flat out vec4 inkHere;
void main() {
  shapeHere = shape;
  inkHere = colour;
  gl_Position = vec4((pixel - tileOrigin) / targetSize * 2.0 - 1.0, 0.5, 1.0);
}
