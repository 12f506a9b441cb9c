// How a level adds to the veil.
layout(binding = 0) uniform sampler2D spread;
layout(binding = 1) uniform sampler2D veil;
layout(binding = 2) uniform sampler2D far_veil;

// What the level spreads, smoothed with (1, 8, 18, 8, 1) / 36 along both axes: the weights of 1/6, 4/6, 1/6 twice, two
// texels at a time.
vec4 smooth_spread(vec2 place, int level) {
  vec2 step = 10.0 / 9.0 / vec2(textureSize(spread, level));
  vec4 sum = vec4(0.0);
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      sum += (x == 0 ? 0.5 : 0.25) * (y == 0 ? 0.5 : 0.25) * textureLod(spread, place + step * vec2(x, y), float(level));
    }
  }
  return sum;
}

// The far part on its own level, sharpened by as much as interpolation from level to level will smooth it (variance 1/4).
vec4 far_here(vec2 place) {
  vec2 step = 1.0 / vec2(textureSize(far_veil, 0));
  vec4 around = textureLod(far_veil, place + vec2(step.x, 0.0), 0.0) + textureLod(far_veil, place - vec2(step.x, 0.0), 0.0) +
                textureLod(far_veil, place + vec2(0.0, step.y), 0.0) + textureLod(far_veil, place - vec2(0.0, step.y), 0.0);
  vec4 here = textureLod(far_veil, place, 0.0);
  return max(here + 0.125 * (4.0 * here - around), 0.0);
}

// What comes from the levels above.
vec4 coarser_veil(vec2 place, int level) {
  vec4 sum = level < eye.cell_level ? textureLod(veil, place, float(level + 1)) : vec4(0.0);
  return level == eye.cell_level - 1 ? sum + far_here(place) : sum;
}
