// Histograms over the cells of a picture, in whole numbers, so that their order does not matter: of luminance as it is seen,
// then of scotopic luminance, then the weight of all cells. A cell counts for the two bins next to its luminance.
#include "prelude.glsl"
#include "lib/visibility.glsl"
#include "lib/mesopic.glsl"
#include "lib/tone.glsl"

layout(local_size_x = 64) in;
layout(location = 0) uniform int cells;
layout(location = 1) uniform float counts; // of a cell with the weight 1
layout(std430, binding = 0) readonly buffer Cells { vec4 sums[]; };
layout(std430, binding = 1) buffer Histogram { uint bins[]; };

void count(int first, float luminance, float weight) {
  float place = tone_bin(luminance);
  int low = int(floor(place));
  uint above = uint((place - float(low)) * weight + 0.5);
  uint below = uint(weight + 0.5) - above;
  if (low >= 0) {
    atomicAdd(bins[first + low], below);
  }
  if (low >= -1 && low + 1 < tone_bins) {
    atomicAdd(bins[first + low + 1], above);
  }
}

void main() {
  int cell = int(gl_GlobalInvocationID.x);
  if (cell >= cells || sums[cell].z <= 0.0) {
    return;
  }
  vec4 sum = sums[cell];
  float photopic = sum.x / sum.z;
  float scotopic = sum.y / sum.z;
  float weight = sum.z * counts;
  count(0, mesopic_luminance(photopic, scotopic, local_cone_share(photopic, scotopic)), weight);
  count(tone_bins, scotopic, weight);
  atomicAdd(bins[2 * tone_bins], uint(weight + 0.5));
}
