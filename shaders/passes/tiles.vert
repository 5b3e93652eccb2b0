// Rectangles given by their corners in pixels of the whole picture.
layout(location = 0) in vec2 corner;
uniform vec2 tileOrigin;
uniform vec2 targetSize;
void main() { gl_Position = vec4((corner - tileOrigin) / targetSize * 2.0 - 1.0, 1.0, 1.0); }
