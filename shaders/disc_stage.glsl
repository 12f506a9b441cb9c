// The fragment stage of a disc: where a pixel lies on it, and its mean light. The stage that includes this defines
// disc_light. PROJECTION is a number of projection.glsl, CHEAP selects the cheap tier's extinction.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/refraction.glsl"
#include "lib/extinction.glsl"
#include "lib/disc.glsl"
#include "disc_block.glsl"

layout(binding = 0) uniform sampler1D refraction_table;
#ifndef CHEAP
layout(binding = 1) uniform sampler2D extinction_table;
#endif

layout(location = 0, index = 0) out vec4 luminance;
layout(location = 0, index = 1) out vec4 cover; // share of what lies behind that is hidden

// A pixel of the picture, or a cell of one, on the disc.
struct DiscCell {
  vec2 place;  // of its centre
  vec2 across; // its edges
  vec2 down;
  float sin_altitude; // as it is seen
};

// Luminance above the air that a cell adds, and what it hides.
vec4 disc_light(DiscCell cell, out float hidden);
// How much finer than a pixel is worth looking there: 1 where the pixel will do.
int disc_cells(DiscCell pixel);

vec4 behind_air(vec4 light, float sin_altitude) {
#ifdef LAMBERT
  return light; // the yardstick's
#elif defined(CHEAP)
  return modulate_xyzs(light, extinction(block.optical_depth, optical_path(sin_altitude, block.height_km)));
#else
  return light * star_extinction(sin_altitude, light, block.extinction, extinction_table);
#endif
}

// Width of a cell in a direction of the disc.
float width_along(DiscCell cell, vec2 toward) {
  return length(vec2(dot(cell.across, toward), dot(cell.down, toward)));
}

// Whether a pixel may show some of the disc: its corners are half of both its edges away, with a fifth to spare for
// edges that are not straight, and more where it is wider than the disc.
bool meets_disc(DiscCell pixel) {
  float extent = length(pixel.across) + length(pixel.down);
  float reach = 1.0 + (extent < 2.0 ? 0.6 : 1.0) * extent;
  return dot(pixel.place, pixel.place) < reach * reach;
}

// A pixel's edge is cut into that many cells at most.
const int most_cells = 32;

int cells_for(DiscCell pixel) {
  return clamp(int(ceil(block.cells_of_radius * max(length(pixel.across), length(pixel.down)))), 1, most_cells);
}

// False outside of the picture's sphere and behind the disc's.
bool cell_at(vec2 at, float size, out DiscCell cell) {
  PixelFrame frame = PixelFrame(PROJECTION, block.size, block.focal);
  vec3 direction;
  vec3 beside;
  vec3 below;
  bool inside = unproject(at, frame, direction);
  // A quarter of the cell on, so that a cube's face is not left.
  unproject(at + vec2(0.25 * size, 0.0), frame, beside);
  unproject(at + vec2(0.0, 0.25 * size), frame, below);
  cell.sin_altitude = dot(block.disc.zenith, direction);
  float cos_altitude = sqrt(max(1.0 - cell.sin_altitude * cell.sin_altitude, 0.0));
  float bend = refraction_bend(dvec3(cos_altitude, 0.0, cell.sin_altitude), true, block.refraction, refraction_table);
  cell.place = disc_place(direction, bend, block.disc);
  cell.across = disc_step(4.0 * (beside - direction), block.disc);
  cell.down = disc_step(4.0 * (below - direction), block.disc);
  return inside && dot(direction, block.disc.centre) > 0.0;
}

// Sine of the altitude of another place on a pixel's disc.
float sin_altitude_beside(DiscCell pixel, vec2 place) {
  return pixel.sin_altitude +
         (place.y - pixel.place.y) * block.disc.sine * block.disc.scale * block.disc.flattening * block.disc.up_zenith;
}

// One of the cells of a pixel, on a straight line from the pixel's centre where that will do: not where the pixel is
// wider than the disc's radius, nor at the pole of a map, whose pixels are slices of a cake.
bool cell_of(DiscCell pixel, vec2 at, vec2 off, float size, out DiscCell cell) {
  if (PROJECTION == projection_equirectangular || max(length(pixel.across), length(pixel.down)) > 1.0) {
    return cell_at(at + off, size, cell);
  }
  cell.place = pixel.place + off.x * pixel.across + off.y * pixel.down;
  cell.across = size * pixel.across;
  cell.down = size * pixel.down;
  cell.sin_altitude = sin_altitude_beside(pixel, cell.place);
  return true;
}

void main() {
  vec2 at = gl_FragCoord.xy + vec2(0.0, block.strip.x);
  DiscCell pixel;
  bool inside = cell_at(at, 1.0, pixel);
  int cells = disc_cells(pixel);
  if (!inside || cells == 0) {
    discard;
  }
  float hidden;
#ifdef CRESCENT // which takes the mean over a pixel itself
  luminance = behind_air(disc_light(pixel, hidden), pixel.sin_altitude);
  cover = vec4(hidden);
#else
  if (cells == 1) {
    luminance = behind_air(disc_light(pixel, hidden), pixel.sin_altitude);
    cover = vec4(hidden);
    return;
  }
  // The mean over the pixel's solid angle, whose air is that of where its light is.
  PixelFrame frame = PixelFrame(PROJECTION, block.size, block.focal);
  vec4 light = vec4(0.0);
  float altitude = 0.0;
  float covered = 0.0;
  float weights = 0.0;
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      vec2 off = (vec2(column, row) + 0.5) / float(cells) - 0.5;
      DiscCell cell;
      if (cell_of(pixel, at, off, 1.0 / float(cells), cell)) {
        float weight = 1.0 / max(pixels_per_steradian(at + off, frame), 1.0e-6);
        vec4 of_cell = weight * disc_light(cell, hidden);
        light += of_cell;
        altitude += of_cell.y * cell.sin_altitude;
        covered += weight * hidden;
        weights += weight;
      }
    }
  }
  weights = max(weights, 1.0e-30);
  light /= weights;
  altitude /= weights;
  luminance = behind_air(light, light.y > 0.0 ? altitude / light.y : pixel.sin_altitude);
  cover = vec4(covered / weights);
#endif
}
