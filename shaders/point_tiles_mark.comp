// Marks the picture's tiles that boxes touch.
#include "prelude.glsl"
#define TILES readonly
#include "point_tiles.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Values { vec4 values[]; };
layout(std430, binding = 1) writeonly buffer Marks { uint marks[]; };
layout(location = 0) uniform int picture_columns;
layout(location = 1) uniform uvec3 boxes; // how many, the first one's value, values from one to the next

void main() {
  if (gl_GlobalInvocationID.x >= boxes.x) {
    return;
  }
  // Whole pixels: low x, low y, high x, high y, high excluded.
  ivec4 box = ivec4(values[boxes.y + boxes.z * gl_GlobalInvocationID.x]);
  if (box.x >= box.z || box.y >= box.w) {
    return;
  }
  ivec2 last = (box.zw - 1) / point_tile;
  for (int row = box.y / point_tile.y; row <= last.y; ++row) {
    for (int column = box.x / point_tile.x; column <= last.x; ++column) {
      marks[row * picture_columns + column] = 1u;
    }
  }
}
