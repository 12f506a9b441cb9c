// Corners of the stars' billboards, which star.comp has placed.
#include "prelude.glsl"
#include "star_block.glsl"

layout(location = 0) in vec4 light;
layout(location = 1) in vec4 pixel_and_scale;
layout(location = 2) in vec4 box;
layout(location = 3) in vec4 glare;

flat out vec2 star_pixel;
flat out vec2 star_scale;
flat out vec4 star_light;
flat out float star_glare;

void main() {
  star_pixel = pixel_and_scale.xy;
  star_scale = pixel_and_scale.zw;
  star_light = light;
  star_glare = glare.x;
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? box.x : box.z, (gl_VertexID & 2) == 0 ? box.y : box.w);
  // Row 0 of the picture is row 0 of the framebuffer, or of its first strip.
  vec2 framebuffer = vec2(float(block.size.x), block.strip.y);
  corner = clamp(corner - vec2(0.0, block.strip.x), vec2(0.0), framebuffer);
  gl_Position = vec4(2.0 * corner / framebuffer - 1.0, 0.0, 1.0);
}
