// How a level adds to the veil.
layout(binding = 0) uniform sampler2D spread;
layout(binding = 1) uniform sampler2D veil;
layout(binding = 2) uniform sampler2D far_veil;

// What the level spreads, once more with binomial weights.
vec4 smooth_spread(ivec2 texel, int level) {
  ivec2 size = level_size(level);
  vec4 sum = vec4(0.0);
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      vec2 mirror;
      ivec2 from = in_picture(min(texel, size - 1) + ivec2(x, y), size, mirror);
      sum += (x == 0 ? 0.5 : 0.25) * (y == 0 ? 0.5 : 0.25) * texelFetch(spread, from, level);
    }
  }
  return sum;
}

// What comes from the levels above.
vec4 coarser_veil(vec2 place, int level) {
  vec4 sum = level < eye.cell_level ? textureLod(veil, place, float(level + 1)) : vec4(0.0);
  return level == eye.cell_level - 1 ? sum + textureLod(far_veil, place, 0.0) : sum;
}
