// A disc of a few pixels, whose light has been shared out among them (renderer/plan/disc_sprite.hpp).
#include "prelude.glsl"
#include "lib/refraction.glsl"
#include "lib/extinction.glsl"
#include "lib/disc.glsl"
#include "disc_block.glsl"

// The C++ twin is vesper::SpritePixel.
struct SpritePixel {
  vec4 luminance;
  float cover;
};
layout(std430, binding = 0) readonly buffer Sprite { SpritePixel pixels[]; }; // of the only box, by rows

layout(location = 0, index = 0) out vec4 luminance;
layout(location = 0, index = 1) out vec4 cover; // share of what lies behind that is hidden

void main() {
  vec4 box = block.boxes[0];
  ivec2 at = ivec2(gl_FragCoord.xy + vec2(0.0, block.strip.x) - box.xy);
  SpritePixel pixel = pixels[at.y * int(box.z - box.x) + at.x];
  luminance = pixel.luminance;
  cover = vec4(pixel.cover);
}
