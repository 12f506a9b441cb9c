// What the stages of the eye know of the picture: renderer/gpu/eye_optics.cpp fills it.
//
// A pyramid of the picture: a texel of level 0 is a block of 4 x 4 pixels, each further level halves. Sizes are padded to
// whole cells (texels of the coarsest level); what lies past the picture holds nothing.
layout(std140, binding = 0) uniform EyeBlock {
  vec4 optics; // of EyeScatter: narrow, wide, pigmented, skirt
  vec4 media;  // iris, parabola, wall; angles seen over angles in the scene
  vec2 size;   // pixels of the picture
  float focal;
  int cell_level;
  int columns; // of cells
  int lights;  // cells and unseen sources
  int wraps;   // whether the left edge continues the right one
  int glare;
  int acuity;
} eye;

const float block_side = 4.0;
const int finest_veil = 1; // level from which on light is scattered: 8 x 8 pixels

// Standard deviation of what a level draws, in its texels: a quadratic B-spline spreads the light (variance 1/4), weights
// of 1/6, 4/6, 1/6 smooth it twice (1/3 each), and linear interpolation from level to level ends in another B-spline (1/4).
// The fourth cumulant of those weights is 0, which keeps the whole round.
const float level_sigma = sqrt(7.0 / 6.0);

EyeScatter eye_scatter_here() {
  EyeScatter scatter;
  scatter.narrow = eye.optics.x;
  scatter.wide = eye.optics.y;
  scatter.pigmented = eye.optics.z;
  scatter.skirt = eye.optics.w;
  scatter.iris = eye.media.x;
  scatter.parabola = eye.media.y;
  scatter.wall = eye.media.z;
  return scatter;
}

PixelFrame eye_frame() { return PixelFrame(PROJECTION, eye.size, eye.focal); }

float texel_side(int level) { return block_side * float(1 << level); } // pixels

// Where the light of a block comes from, in blocks from its middle, by its sum over pixels and that times their places.
vec2 block_centre(float light, vec2 moment) {
  return light > 0.0 ? clamp((moment / light + 0.5) / block_side - 0.5, -0.5, 0.5) : vec2(0.0);
}

// Where a level begins in a picture that has all of them, one above the other: it is twice as high as level 0.
ivec2 level_origin(int level, ivec2 all) { return ivec2(0, all.y - (all.y >> level)); }

// Texels of a level that hold some of the picture.
ivec2 level_size(int level) { return ivec2(ceil(eye.size / texel_side(level))); }

// The part of a texel that lies in the picture.
float coverage(ivec2 texel, int level) {
  vec2 inside = clamp(eye.size / texel_side(level) - vec2(texel), 0.0, 1.0);
  return inside.x * inside.y;
}

// Degrees as seen.
float degrees_per_pixel(vec2 pixel) { return eye.media.w * eye_degrees_per_pixel(pixel, eye_frame()); }

// Softness of the far part of the light at a place.
float softness(vec2 pixel) { return texel_side(eye.cell_level) * degrees_per_pixel(pixel); }

// A row or column and those beside it. The last ones stand for those past the edge.
ivec3 beside(int number, int size) { return clamp(number + ivec3(-1, 0, 1), 0, size - 1); }

// The same of columns, which may go on across the seam.
ivec3 columns_beside(int column, int size) {
  ivec3 columns = beside(column, size);
  columns.x = eye.wraps != 0 && column == 0 ? size - 1 : columns.x;
  columns.z = eye.wraps != 0 && column == size - 1 ? 0 : columns.z;
  return columns;
}
