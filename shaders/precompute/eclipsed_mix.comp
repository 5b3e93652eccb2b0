// The grid of a shadow from those of the nodes around it.
layout(local_size_x = 8, local_size_y = 4) in;
layout(binding = 0) uniform sampler3D node0;
layout(binding = 1) uniform sampler3D node1;
layout(binding = 2) uniform sampler3D node2;
layout(rgba32f, binding = 0) writeonly uniform image3D grid;
uniform vec3 weights;  // a node of weight 0 is any other
uniform int firstSlab;

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  ivec3 size = textureSize(node0, 0);
  if (texel.x >= size.x || texel.y >= size.y) return;
  imageStore(grid, texel + ivec3(0, 0, firstSlab),
             weights.x * texelFetch(node0, texel, 0) + weights.y * texelFetch(node1, texel, 0) +
                 weights.z * texelFetch(node2, texel, 0));
}
